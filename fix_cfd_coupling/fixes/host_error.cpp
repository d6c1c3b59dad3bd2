#include "fix_cfd_coupling/fixes/host_error.h"

#include <chrono>
#include <cstdio>
#include <thread>

#include "fix_cfd_coupling/fixes/host_session.h"
#include "fix_cfd_coupling/fixes/script_line.h"
// --
#include "lammps.h"

namespace gasgrain {
namespace {

LAMMPS_NS::LAMMPS* the_host = nullptr;

void print_message(const std::string& message) {
  std::fprintf(stderr, "\n%s: error: %s%s%s\n\n", program_name(), script_place().c_str(),
               with_fault(message).c_str(), hint(message).c_str());
  std::fflush(nullptr);
}

}  // namespace

void set_host(LAMMPS_NS::LAMMPS* host) {
  the_host = host;
}

LAMMPS_NS::LAMMPS* current_host() {
  return the_host;
}

std::string script_place() {
  return the_host == nullptr ? "" : place_in_script(the_host->infile);
}

void stop_everything(const std::string& message) {
  // An error that all ranks meet is rank 0's to tell; it ends this rank before the time is over.
  if (!session().local.is_root()) std::this_thread::sleep_for(std::chrono::seconds(3));
  print_message(message);
  abort_launch();
}

void stop_everything_from_here(const std::string& message) {
  print_message(message);
  abort_launch();
}

}  // namespace gasgrain
