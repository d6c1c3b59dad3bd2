// Where the programs of a run are: ours beside this one, mpirun on PATH.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace gasgrain {

struct Programs {
  std::filesystem::path dem;     // gasgrain-liggghts
  std::filesystem::path gas;     // gasgrain-gas
  std::filesystem::path mpirun;  // empty when PATH has none
};

// The folder of this executable, or $GASGRAIN_BIN_DIR where that is set.
Programs find_programs();

// A line for each program that is absent or not executable, with the remedy; of the gas's where the
// run has a gas.
std::vector<std::string> program_faults(const Programs& programs, bool gas);

bool is_executable(const std::filesystem::path& file);

}  // namespace gasgrain
