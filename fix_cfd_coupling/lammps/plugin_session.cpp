#include "fix_cfd_coupling/lammps/plugin_session.h"

#include <csignal>
#include <cstdlib>
#include <cstring>
#include <memory>

#include "coupling/base/error.h"
#include "coupling/transport/launch.h"
#include "fix_cfd_coupling/fixes/host_error.h"
#include "fix_cfd_coupling/fixes/host_session.h"
// --
#include "lammps.h"

namespace gasgrain {
namespace {

bool host_has_ended = false;

// Open MPI passes SIGUSR1 of mpirun on to every rank: the wish to stop with a checkpoint.
extern "C" void wish_to_stop(int) {
  session().stop_wanted = 1;
}

// The host frees the communicator of its own when it has done its work, before the barrier of all
// programs; a partner that was never met would not come to that.
int host_ends(MPI_Comm, int, void*, void*) {
  host_has_ended = true;
  set_host(nullptr);
  if (!session().greeted)
    stop_everything(
        "the script ended without meeting its partner: it has no line such as\n"
        "  fix gas all couple/gas every 100 drag koch_hill pressure_gradient");
  return MPI_SUCCESS;
}

// At an error of its own, or at `quit`, the host finalizes MPI, and the partner would wait for
// ever.
int mpi_ends(MPI_Comm, int, void*, void*) {
  if (!host_has_ended) abort_launch();
  return MPI_SUCCESS;
}

void call_when_freed(MPI_Comm comm, MPI_Comm_delete_attr_function* function) {
  int key = MPI_KEYVAL_INVALID;
  MPI_Comm_create_keyval(MPI_COMM_NULL_COPY_FN, function, &key, nullptr);
  MPI_Comm_set_attr(comm, key, nullptr);
}

int programs_of_launch() {
  const char* count = std::getenv("OMPI_NUM_APP_CTX");
  return count == nullptr ? 1 : std::atoi(count);
}

}  // namespace

void begin_session(LAMMPS_NS::LAMMPS& host) {
  static std::unique_ptr<const Launch> launch;
  if (launch) return;
  int relation = MPI_UNEQUAL;
  MPI_Comm_compare(host.world, MPI_COMM_WORLD, &relation);
  const bool has_world = relation == MPI_IDENT || relation == MPI_CONGRUENT;
  if (has_world && programs_of_launch() > 1)
    fail(
        "lmp takes the ranks of the other program for its own. In a launch of two programs, the "
        "first words after lmp must be '-m 0':\n"
        "  mpirun -np 2 lmp -m 0 -in in.lammps : -np 1 gasgrain-gas gas.toml");
  session().local = Communicator(host.world);
  launch = std::make_unique<const Launch>(Program::plugin_dem, host.world);
  session().partner = launch->partner();
  std::signal(SIGUSR1, wish_to_stop);
  if (!launch->has_partner()) return;
  call_when_freed(host.world, host_ends);
  call_when_freed(MPI_COMM_SELF, mpi_ends);
}

const char* program_name() {
  return "gasgrain-lammps";
}

// Its own errors, to which this might add, it tells itself.
std::string hint(const std::string&) {
  return "";
}

void abort_launch() {
  std::fflush(nullptr);
  MPI_Abort(MPI_COMM_WORLD, 1);
  std::_Exit(1);
}

}  // namespace gasgrain
