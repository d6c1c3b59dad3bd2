// Fully developed turbulent flow between plates: the standard k-epsilon model with wall functions
// against the log law and Dean's friction law.
#include <gtest/gtest.h>

#include "gas_solver/turbulence/launder_spalding.h"
#include "tests/gas_cases.h"

namespace gasgrain {
namespace {

using namespace gas_cases;

constexpr double height = 0.1;  // between the plates [m]
constexpr double friction_velocity = 0.6;

struct Channel {
  std::vector<double> velocity;  // by cell from one plate to the other [m/s]
  std::vector<double> k;
  double bulk = 0;  // [m/s]
  double viscosity = 0;
  double wall_stress = 0;  // [Pa]
  [[nodiscard]] double y_plus(int cell) const {
    return (cell + 0.5) * height / static_cast<double>(velocity.size()) * friction_velocity * 1.2 /
           viscosity;
  }
};

// Body force rho g = 2 tau_w / height along the periodic axis `along`, plates across `across`.
Channel channel(int cells, int along, int across, double viscosity) {
  Sides sides = walls;
  sides[2 * along] = sides[2 * along + 1] = &periodic_side;
  const int third = 3 - along - across;
  sides[2 * third] = sides[2 * third + 1] = &wall_free_slip;
  Int3 n{1, 1, 1};
  n[across] = cells;
  Vec3 size = Vec3::Constant(0.01);
  size[across] = height;
  GasInput input = box(n, size, sides);
  input.gravity = 2 * friction_velocity * friction_velocity / height * Vec3::Unit(along);
  input.viscosity = viscosity;
  input.step = 6e-3;
  input.courant_max = 1e6;
  input.tolerance = 1e-10;
  input.turbulence.model = TurbulenceModel::k_epsilon;
  GasSolver gas(input, self());
  gas.state().velocity[along].fill(12.0);
  long clamped = 0;
  for (int s = 0; s < 1500; ++s) clamped += gas.advance(input.step).turbulence_clamped;
  EXPECT_EQ(clamped, 0);
  Channel result;
  result.viscosity = viscosity;
  for (int c = 0; c < cells; ++c) {
    Int3 at{0, 0, 0};
    at[across] = c;
    result.velocity.push_back(gas.state().velocity[along](at[0], at[1], at[2]));
    result.k.push_back(gas.turbulence()->k_epsilon()->k()(at[0], at[1], at[2]));
    result.bulk += result.velocity.back() / cells;
  }
  result.wall_stress =
      gas.turbulence()->wall_coefficient(side_of(across, false))(0, 0, 0) * result.velocity.front();
  return result;
}

constexpr double viscosity_at_2000 = 1.8e-5;  // friction Reynolds number of half the height: 2000

TEST(gas_turbulent_channel, wall_stress_balances_the_force) {
  const Channel flow = channel(20, 0, 2, viscosity_at_2000);
  const double expected = 1.2 * friction_velocity * friction_velocity;
  std::printf("tau_w %.6g, expected %.6g\n", flow.wall_stress, expected);
  // Steady to this share after 9 s: the bulk velocity settles within U / (1.75 g) = 1 s.
  EXPECT_NEAR(flow.wall_stress, expected, 1e-4 * expected);
}

TEST(gas_turbulent_channel, velocity_obeys_the_log_law) {
  for (const int cells : {16, 20, 32}) {
    const Channel flow = channel(cells, 0, 2, viscosity_at_2000);
    for (int c = 0; c < cells / 2; ++c) {
      const double law =
          std::log(launder_spalding::wall_e * flow.y_plus(c)) / launder_spalding::kappa;
      const double u_plus = flow.velocity[c] / friction_velocity;
      std::printf("%d cells: y+ %7.1f  u+ %.3f  log law %.3f (%+.2f %%)  k+ %.3f\n", cells,
                  flow.y_plus(c), u_plus, law, 100 * (u_plus / law - 1),
                  flow.k[c] / (friction_velocity * friction_velocity));
      // The log layer ends at about 0.3 of the half height.
      if (flow.y_plus(c) > 0.3 * 2000) continue;
      EXPECT_NEAR(u_plus, law, 0.03 * law) << cells << " cells, " << flow.y_plus(c);
    }
  }
}

TEST(gas_turbulent_channel, friction_is_deans_at_several_reynolds_numbers) {
  // R. B. Dean, J. Fluids Eng. 100 (1978) 215: C_f = 0.073 Re^(-1/4), Re of bulk velocity and whole
  // height, 6e3 < Re < 6e5.
  for (const double re_friction : {1000.0, 2000.0, 5000.0}) {
    const double viscosity = 1.2 * friction_velocity * 0.5 * height / re_friction;
    const Channel flow = channel(20, 0, 2, viscosity);
    const double friction = 2 * std::pow(friction_velocity / flow.bulk, 2);
    const double re = 1.2 * flow.bulk * height / viscosity;
    const double dean = 0.073 * std::pow(re, -0.25);
    std::printf("Re %.3g: C_f %.5f, Dean %.5f (%+.1f %%)\n", re, friction, dean,
                100 * (friction / dean - 1));
    EXPECT_NEAR(friction, dean, 0.1 * dean);
  }
}

TEST(gas_turbulent_channel, axes_are_alike) {
  const Channel first = channel(16, 0, 2, viscosity_at_2000);
  for (const auto& [along, across] : {std::pair{1, 0}, {2, 1}, {0, 1}}) {
    const Channel other = channel(16, along, across, viscosity_at_2000);
    for (int c = 0; c < 16; ++c)
      // Sweeps to 1e-10 of their change.
      EXPECT_NEAR(other.velocity[c], first.velocity[c], 1e-6 * first.bulk);
  }
}

}  // namespace
}  // namespace gasgrain
