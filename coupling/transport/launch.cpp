#include "coupling/transport/launch.h"

#include <array>
#include <limits>

#include "coupling/base/error.h"

namespace gasgrain {
namespace {

constexpr int join_tag = 7001;

}  // namespace

Launch::Launch(Program program) {
  const Communicator world(MPI_COMM_WORLD);
  int* number = nullptr;
  int given = 0;
  MPI_Comm_get_attr(MPI_COMM_WORLD, MPI_APPNUM, &number, &given);
  const int mine = given != 0 && number != nullptr ? *number : 0;

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

  MPI_Comm local = MPI_COMM_NULL;
  MPI_Comm_split(world.handle(), mine, world.rank(), &local);
  local_ = Communicator(local);
  const int other = 1 - mine;
  if (leader[other] == none) return;
  if (kind[0] == kind[1])
    fail("the launch has two {} programs; join one gasgrain-liggghts with one gasgrain-gas.",
         program == Program::dem ? "DEM" : "gas");
  MPI_Intercomm_create(local, 0, world.handle(), leader[other], join_tag, &partner_);
}

Launch::~Launch() {
  int finalized = 0;
  MPI_Finalized(&finalized);
  if (finalized != 0) return;
  if (partner_ != MPI_COMM_NULL) MPI_Comm_free(&partner_);
  MPI_Comm handle = local_.handle();
  MPI_Comm_free(&handle);
}

}  // namespace gasgrain
