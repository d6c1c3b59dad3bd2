// A checkpoint written on one number of ranks and gone on from on another.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdio>

#include "tests/gas_cases.h"

namespace gasgrain {
namespace {

using namespace gas_cases;

// Of the flow's greatest velocity and pressure. Steps are solved to 1e-12 of the flow, by sweeps
// and cycles whose order differs between the numbers of ranks.
constexpr double tolerance = 1e-10;

std::string common_file() {
  // One name for both ranks, none for another run of this program.
  long pid = getpid();
  MPI_Bcast(&pid, 1, MPI_LONG, 0, MPI_COMM_WORLD);
  return testing::TempDir() + "gas_restart_test." + std::to_string(pid) + ".h5";
}

double greatest(const Array3<double>& field, const IndexBox& box) {
  double most = 0;
  for_each_cell(box, [&](int i, int j, int k) { most = std::max(most, std::abs(field(i, j, k))); });
  return most;
}

double difference(const Array3<double>& part, const Array3<double>& whole, const IndexBox& box,
                  double scale) {
  double most = 0;
  for_each_cell(box, [&](int i, int j, int k) {
    most = std::max(most, std::abs(part(i, j, k) - whole(i, j, k)));
  });
  return most / scale;
}

void expect_same(const GasSolver& some, const GasSolver& other) {
  EXPECT_EQ(some.time(), other.time());
  double speed = 0;
  for (int d = 0; d < 3; ++d)
    speed = std::max(speed, greatest(other.cell_velocity()[d], other.own()));
  const IndexBox common = intersection(some.own(), other.own());
  for (int d = 0; d < 3; ++d)
    EXPECT_LT(difference(some.cell_velocity()[d], other.cell_velocity()[d], common, speed),
              tolerance);
  EXPECT_LT(difference(some.pressure(), other.pressure(), common,
                       greatest(other.pressure(), other.own())),
            tolerance);
}

class gas_restart : public testing::TestWithParam<Int3> {};

TEST_P(gas_restart, checkpoint_of_one_rank_goes_on_on_two) {
  const Communicator world(MPI_COMM_WORLD);
  const std::string file = common_file();
  const GasInput input = spout(GetParam(), 20, 1e-12);
  GasSolver whole(input, self());
  run_spout(whole, 0, 3);
  if (world.is_root())
    whole.write_checkpoint(file);
  else
    whole.write_checkpoint(file + ".of_the_other_rank");  // writing begins the solver anew
  MPI_Barrier(MPI_COMM_WORLD);
  GasSolver two(input, world);
  two.read_checkpoint(file);
  run_spout(whole, 3, 7);
  run_spout(two, 3, 7);
  expect_same(two, whole);
  std::remove((world.is_root() ? file : file + ".of_the_other_rank").c_str());
}

TEST_P(gas_restart, checkpoint_of_two_ranks_goes_on_on_one) {
  const Communicator world(MPI_COMM_WORLD);
  const std::string file = common_file();
  const GasInput input = spout(GetParam(), 20, 1e-12);
  GasSolver whole(input, world);
  run_spout(whole, 0, 3);
  whole.write_checkpoint(file);
  GasSolver one(input, self());
  one.read_checkpoint(file);
  run_spout(whole, 3, 7);
  run_spout(one, 3, 7);
  expect_same(whole, one);
  MPI_Barrier(MPI_COMM_WORLD);
  if (world.is_root()) std::remove(file.c_str());
}

// Cut across z, x and y.
INSTANTIATE_TEST_SUITE_P(cuts, gas_restart,
                         testing::Values(Int3{6, 5, 14}, Int3{15, 5, 14}, Int3{6, 15, 14}));

}  // namespace
}  // namespace gasgrain
