// Two "DEM" and two "gas" ranks in one program, joined by an intercommunicator as in a launch.
#include <gtest/gtest.h>

#include "coupling/base/communicator.h"
#include "coupling/base/decomposition.h"
#include "coupling/transport/protocol.h"
#include "coupling/transport/route.h"

namespace gasgrain {
namespace {

class Fields : public testing::Test {
 protected:
  void SetUp() override {
    const Communicator world(MPI_COMM_WORLD);
    ASSERT_EQ(world.size(), 4);
    is_gas_ = world.rank() >= 2;
    MPI_Comm local = MPI_COMM_NULL;
    MPI_Comm_split(world.handle(), is_gas_ ? 1 : 0, world.rank(), &local);
    local_ = Communicator(local);
    MPI_Intercomm_create(local, 0, world.handle(), is_gas_ ? 0 : 2, 1, &partner_);
    grid_.cells = {8, 4, 6};
    grid_.periodic = {true, false, false};
    box_ = is_gas_ ? decompose(grid_, 2)[local_.rank()]
                   : IndexBox{{4 * local_.rank() - 1, 0, 0}, {4 * local_.rank() + 5, 4, 6}};
    transport_ = RouteTransport(
        partner_, make_routes(grid_, box_, swap_boxes(partner_, box_), is_gas_), is_gas_);
  }
  void TearDown() override {
    MPI_Comm_free(&partner_);
    MPI_Comm local = local_.handle();
    MPI_Comm_free(&local);
  }

  bool is_gas_ = false;
  Communicator local_;
  MPI_Comm partner_ = MPI_COMM_NULL;
  BoxGrid grid_;
  IndexBox box_;
  RouteTransport transport_;
};

TEST_F(Fields, deposits_of_overlapping_tiles_add_up_and_nothing_is_lost) {
  Array3<double> field(box_, is_gas_ ? 0.0 : 1.0 + local_.rank());
  if (is_gas_)
    transport_.receive({&field}, solids_tag);
  else
    transport_.send({&field}, solids_tag);
  double mine = 0.0;
  for (const double value : field) mine += value;
  const double all = local_.sum(mine);
  // Both tiles have 6 x 4 x 6 cells, one layer beyond their half on either (periodic) side.
  if (is_gas_) {
    EXPECT_DOUBLE_EQ(all, 6 * 4 * 6 * (1.0 + 2.0));
  }
}

TEST_F(Fields, lent_values_reach_every_cell_of_a_tile_across_the_periodic_side) {
  const auto value = [&](int i, int j, int k) { return ((i + 8) % 8) + 10.0 * j + 100.0 * k; };
  Array3<double> field(box_, -1.0);
  if (is_gas_) {
    for_each_cell(box_, [&](int i, int j, int k) { field(i, j, k) = value(i, j, k); });
    transport_.send({&field}, lent_tag);
  } else {
    transport_.receive({&field}, lent_tag);
    for_each_cell(box_, [&](int i, int j, int k) { EXPECT_EQ(field(i, j, k), value(i, j, k)); });
  }
}

TEST_F(Fields, only_the_fields_named_are_on_the_wire) {
  Array3<double> one(box_);
  Array3<double> two(box_);
  transport_.take_bytes();
  if (is_gas_)
    transport_.receive({&one}, solids_tag);
  else
    transport_.send({&one}, solids_tag);
  const long single = transport_.take_bytes();
  if (is_gas_)
    transport_.receive({&one, &two}, drag_tag);
  else
    transport_.send({&one, &two}, drag_tag);
  EXPECT_EQ(transport_.take_bytes(), 2 * single);
  if (!is_gas_) {
    EXPECT_EQ(single, static_cast<long>(box_.size() * sizeof(double)));
  }
}

// Every rank holds a tile and a gas box, as with a gas inside the DEM ranks, and is the receiver of
// its own messages; they are too long to be buffered by MPI.
TEST(FieldsInside, started_sends_reach_ranks_that_send_first_and_receive_then) {
  const Communicator world(MPI_COMM_WORLD);
  BoxGrid grid;
  grid.cells = {64, 64, 64};
  grid.periodic = {true, false, false};
  const std::vector<IndexBox> boxes = decompose(grid, world.size());
  const auto tile_of = [](int rank) {
    return IndexBox{{16 * rank - 1, 0, 0}, {16 * rank + 17, 64, 64}};
  };
  std::vector<IndexBox> tiles;
  for (int r = 0; r < world.size(); ++r) tiles.push_back(tile_of(r));
  const IndexBox tile = tiles[world.rank()];
  const IndexBox box = boxes[world.rank()];
  RouteTransport dem(world.handle(), make_routes(grid, tile, boxes, false), false, Sends::started);
  RouteTransport gas(world.handle(), make_routes(grid, box, tiles, true), true, Sends::started);
  const auto value = [](int i, int j, int k) { return ((i + 64) % 64) + 0.5 * j + 100.0 * k; };
  for (int again = 0; again < 3; ++again) {
    Array3<double> solids(tile, 1.0);
    Array3<double> taken(box, 0.0);
    dem.send({&solids}, solids_tag);
    gas.receive({&taken}, solids_tag);
    double mine = 0.0;
    for (const double each : taken) mine += each;
    EXPECT_DOUBLE_EQ(world.sum(mine), 4.0 * 18 * 64 * 64);

    Array3<double> lent(box);
    Array3<double> sampled(tile, -1.0);
    for_each_cell(box, [&](int i, int j, int k) { lent(i, j, k) = value(i, j, k); });
    gas.send({&lent}, lent_tag);
    dem.send({&solids}, drag_tag);
    dem.receive({&sampled}, lent_tag);
    gas.receive({&taken}, drag_tag);
    for_each_cell(tile, [&](int i, int j, int k) {
      ASSERT_EQ(sampled(i, j, k), value(i, j, k)) << i << ' ' << j << ' ' << k;
    });
  }
  dem.finish_sends();
  gas.finish_sends();
}

}  // namespace
}  // namespace gasgrain
