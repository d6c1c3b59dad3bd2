#include "coupling/transport/launch.h"

#include <array>
#include <limits>

#include "coupling/base/error.h"

namespace gasgrain {
namespace {

constexpr int join_tag = 7001;
// Hosts that split the world themselves take small colours: `lmp -m 0`.
constexpr int first_colour = 100;

// Place of this program on the command line of mpirun.
int program_number() {
  int* number = nullptr;
  int given = 0;
  MPI_Comm_get_attr(MPI_COMM_WORLD, MPI_APPNUM, &number, &given);
  return given != 0 && number != nullptr ? *number : 0;
}

}  // namespace

// The split comes before all else: it is also the first thing that a host of the other program
// does.
Launch::Launch(Program program) : owns_local_(true) {
  const Communicator world(MPI_COMM_WORLD);
  MPI_Comm local = MPI_COMM_NULL;
  MPI_Comm_split(world.handle(), first_colour + program_number(), world.rank(), &local);
  local_ = Communicator(local);
  join(program);
}

Launch::Launch(Program program, MPI_Comm local) : local_(local) {
  join(program);
}

void Launch::join(Program program) {
  const Communicator world(MPI_COMM_WORLD);
  const int mine = program_number();

  // Lowest world rank and kind of each of the (at most two) programs of the launch.
  if (world.max(mine) > 1)
    fail(
        "the launch has more than two programs; one DEM program and one gas program are partners.");
  constexpr int none = std::numeric_limits<int>::max();
  std::array<int, 2> leader{none, none};
  std::array<int, 2> kind{0, 0};
  leader[mine] = world.rank();
  kind[mine] = static_cast<int>(program);
  MPI_Allreduce(MPI_IN_PLACE, leader.data(), 2, MPI_INT, MPI_MIN, world.handle());
  MPI_Allreduce(MPI_IN_PLACE, kind.data(), 2, MPI_INT, MPI_MAX, world.handle());

  const int other = 1 - mine;
  if (leader[other] == none) return;
  partner_program_ = static_cast<Program>(kind[other]);
  if ((program == Program::gas) == (partner_program_ == Program::gas))
    fail("the launch has two {} programs; join one gasgrain-liggghts or lmp with one gasgrain-gas.",
         program == Program::gas ? "gas" : "DEM");
  MPI_Intercomm_create(local_.handle(), 0, world.handle(), leader[other], join_tag, &partner_);
}

void Launch::end() const {
  if (has_partner() && partner_program_ == Program::plugin_dem) MPI_Barrier(MPI_COMM_WORLD);
}

Launch::~Launch() {
  int finalized = 0;
  MPI_Finalized(&finalized);
  if (finalized != 0) return;
  if (partner_ != MPI_COMM_NULL) MPI_Comm_free(&partner_);
  if (!owns_local_) return;
  MPI_Comm handle = local_.handle();
  MPI_Comm_free(&handle);
}

}  // namespace gasgrain
