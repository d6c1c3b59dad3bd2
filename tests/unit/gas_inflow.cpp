// Inflow that changes in time.
#include <gtest/gtest.h>

#include "tests/gas_cases.h"

namespace gasgrain {
namespace {

using namespace gas_cases;

TEST(gas_inflow, flow_through_a_patch_follows_its_table) {
  GasInput input = box({3, 3, 6}, Vec3(0.03, 0.03, 0.06), column);
  input.inflows = {whole_side(input, 4, 2.0)};
  input.inflows[0].table_times = {2e-3, 4e-3, 6e-3};
  input.inflows[0].table_factors = {0.5, 1.0, 0.0};
  const double full = input.density * 0.03 * 0.03 * 2.0;
  GasSolver gas(input, self());
  for (const double factor : {0.5, 0.5, 0.75, 1.0, 0.5, 0.0, 0.0})
    EXPECT_NEAR(gas.advance(1e-3).mass_inflow, factor * full, 1e-12 * full) << gas.time();
}

}  // namespace
}  // namespace gasgrain
