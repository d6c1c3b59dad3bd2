// How an error of the host, of our styles, or of the script reaches the user: one message that
// names the script, the line and its text, and the nearest valid name; then every rank of both
// programs ends.
#pragma once

#include <string>

namespace LAMMPS_NS {
class LAMMPS;
}

namespace gasgrain {

// Thrown by the command `quit`.
struct ScriptQuit {};

// The host that runs now, for messages; null before it exists.
void set_host(LAMMPS_NS::LAMMPS* host);
LAMMPS_NS::LAMMPS* current_host();

// 'in.liggghts:17: ' of the command that the host works on (rank 0 knows it; others give '').
std::string script_place();

// Prints the message on rank 0 and ends the launch with status 1. Called by all DEM ranks.
[[noreturn]] void stop_everything(const std::string& message);

// The same for an error that only this rank met.
[[noreturn]] void stop_everything_from_here(const std::string& message);

// Of each host alone.
// What our side of it is called, as 'gasgrain-liggghts'.
const char* program_name();
// What is added to a message of the host's own, as ' Did you mean ...?'; '' where nothing helps.
std::string hint(const std::string& message);
// Ends every rank of all programs of the launch with status 1.
[[noreturn]] void abort_launch();

}  // namespace gasgrain
