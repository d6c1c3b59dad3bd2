// A gas that runs away is stopped, and the cell is named.
#include <gtest/gtest.h>

#include "gas_solver/gas_fault.h"
#include "gas_solver/gas_step.h"
#include "gas_solver/operators/runaway.h"

namespace gasgrain {
namespace {

GasInput still_box() {
  GasInput input;
  input.grid.hi = Vec3(0.04, 0.04, 0.08);
  input.grid.cells = {4, 4, 4};  // 10 x 10 x 20 mm
  input.step = 1e-3;
  input.courant_max = 10;
  input.substeps_max = 50;
  return input;
}

std::string fault_of(GasSolver& gas, double interval) {
  try {
    gas.advance(interval);
  } catch (const GasFault& fault) {
    return fault.what();
  }
  return "";
}

TEST(gas_runaway, names_the_cell_of_the_fastest_face_the_time_and_the_keys) {
  GasSolver gas(still_box(), Communicator(MPI_COMM_SELF));
  gas.state().velocity[2](1, 2, 3) = -11000;  // 550 cells a step
  gas.state().velocity[0](2, 1, 0) = 5000;    // 500
  const std::string text = fault_of(gas, 1e-3);
  for (const char* word : {"at t = 0 s", "cell (1, 2, 3) at x = 0.015, y = 0.025, z = 0.06 m",
                           "along z with -1.1e+04 m/s", "crosses 550 cells in a step of 0.001 s",
                           "[time] courant_max x substeps_max = 10 x 50"})
    EXPECT_NE(text.find(word), std::string::npos) << text;
}

TEST(gas_runaway, goes_by_the_step_or_the_interval_whichever_is_shorter) {
  for (const double interval : {1e-3, 0.9e-3}) {
    GasSolver gas(still_box(), Communicator(MPI_COMM_SELF));
    gas.state().velocity[2](1, 2, 3) = 10500;  // 525 cells in 1 ms, 472 in 0.9
    EXPECT_EQ(fault_of(gas, interval).empty(), interval < 1e-3);
  }
}

}  // namespace
}  // namespace gasgrain
