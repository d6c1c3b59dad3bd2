// gasgrain-liggghts: Debian's LIGGGHTS library with our styles registered. Takes the options of
// `liggghts`; alone it runs any input script; beside gasgrain-gas in one launch, or with a gas
// inside, it couples.
#include <mpi.h>

#include <csignal>
#include <cstring>
#include <exception>
#include <string>

#include "coupling/base/error.h"
#include "coupling/base/file_locks.h"
#include "coupling/transport/launch.h"
#include "fix_cfd_coupling/fixes/host_error.h"
#include "fix_cfd_coupling/fixes/host_session.h"
#include "fix_cfd_coupling/liggghts/mpi_redirect.h"
// The host's headers lean on each other's order.
#include "lammps.h"
// --
#include "input.h"

namespace {

bool has_input_script(int argc, char** argv) {
  for (int a = 1; a + 1 < argc; ++a)
    if (std::strcmp(argv[a], "-in") == 0 || std::strcmp(argv[a], "-i") == 0) return true;
  return false;
}

// Open MPI passes SIGUSR1 of mpirun on to every rank: the wish to stop with a checkpoint.
extern "C" void wish_to_stop(int) {
  gasgrain::session().stop_wanted = 1;
}

void run(int argc, char** argv) {
  const gasgrain::Launch launch(gasgrain::Program::dem);
  if (launch.has_partner() && !has_input_script(argc, argv))
    gasgrain::fail("a launch with a partner needs '-in SCRIPT': standard input is not passed on.");
  gasgrain::session().local = launch.local();
  gasgrain::session().partner = launch.partner();
  gasgrain::redirect_world_to(launch.local().handle());
  std::signal(SIGUSR1, wish_to_stop);

  LAMMPS_NS::LAMMPS* host = nullptr;
  try {
    host = new LAMMPS_NS::LAMMPS(argc, argv, launch.local().handle());
    host->input->file();
  } catch (const gasgrain::ScriptQuit&) {
    // `quit` in the script, or an option such as -help that ends the host while it is made.
  }
  delete host;
  if (launch.has_partner() && !gasgrain::session().greeted)
    gasgrain::fail(
        "the script ended without meeting its partner: it has no line such as\n"
        "  fix gas all couple/gas every 100 drag koch_hill pressure_gradient");
}

}  // namespace

int main(int argc, char** argv) {
  gasgrain::open_files_without_semaphores();  // of a gas inside
  MPI_Init(&argc, &argv);
  try {
    run(argc, argv);
  } catch (const std::exception& e) {
    gasgrain::stop_everything(e.what());
  }
  gasgrain::end_normally();
  return 0;
}
