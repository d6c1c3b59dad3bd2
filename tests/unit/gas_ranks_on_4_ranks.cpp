// Runs on one, two and four ranks against each other, with the solver's tolerance set to allow it.
#include <gtest/gtest.h>

#include "tests/gas_cases.h"

namespace gasgrain {
namespace {

using namespace gas_cases;

GasInput slow_spout(const Int3& cells) {
  return endless_spout(cells, 5, 1e-14);
}

void expect_same(const GasInput& input, const Communicator& comm) {
  GasSolver one(input, self());
  GasSolver many(input, comm);
  run_spout(one, 0, 4);
  run_spout(many, 0, 4);
  const double speed = greatest_speed(one);
  double greatest_pressure = 0;
  for (const double p : one.state().pressure)
    greatest_pressure = std::max(greatest_pressure, std::abs(p));
  for (int d = 0; d < 3; ++d)
    for_each_cell(many.domain().faces(d), [&](int i, int j, int k) {
      ASSERT_NEAR(many.state().velocity[d](i, j, k), one.state().velocity[d](i, j, k),
                  1e-10 * speed);
    });
  for_each_cell(many.own(), [&](int i, int j, int k) {
    ASSERT_NEAR(many.state().pressure(i, j, k), one.state().pressure(i, j, k),
                1e-10 * greatest_pressure);
  });
}

void expect_same_on_two_and_four(const GasInput& input) {
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm pair = MPI_COMM_NULL;
  MPI_Comm_split(MPI_COMM_WORLD, rank / 2, rank, &pair);
  {
    SCOPED_TRACE("two ranks");
    expect_same(input, Communicator(pair));
  }
  {
    SCOPED_TRACE("four ranks");
    expect_same(input, Communicator(MPI_COMM_WORLD));
  }
  MPI_Comm_free(&pair);
}

TEST(gas_ranks, one_two_and_four_ranks_agree) {
  // Cut across z, x and y.
  for (const Int3& cells : {Int3{6, 5, 14}, Int3{15, 5, 14}, Int3{6, 15, 14}})
    expect_same_on_two_and_four(slow_spout(cells));
}

TEST(gas_ranks, one_two_and_four_ranks_agree_with_crank_nicolson_and_simplec) {
  GasInput input = slow_spout({8, 6, 14});
  input.scheme = TimeScheme::crank_nicolson;
  expect_same_on_two_and_four(input);
  input.pressure_velocity = PressureVelocity::simplec;
  input.relax_velocity = 0.9;
  input.relax_pressure = 1;
  input.outer_tolerance = 1e-13;
  expect_same_on_two_and_four(input);
}

TEST(gas_ranks, one_two_and_four_ranks_agree_with_an_ideal_gas_in_model_b) {
  GasInput input = ideal_gas(slow_spout({8, 6, 14}));
  input.model = GasModel::b;
  input.mass_sources = {{Vec3(0, 0, 0.05), Vec3(0.02, 0.03, 0.1), 1e-4}};
  expect_same_on_two_and_four(input);
}

}  // namespace
}  // namespace gasgrain
