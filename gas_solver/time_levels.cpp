#include "gas_solver/time_levels.h"

#include <utility>

namespace gasgrain {

TimeLevels::TimeLevels(const GasInput& input, const IndexBox& box, GasState& state)
    : middle_(input.scheme == TimeScheme::crank_nicolson),
      keeps_velocity_(middle_ || input.pressure_velocity != PressureVelocity::projection) {
  if (keeps_velocity_) velocity_before_ = make_vector(box);
  if (!middle_) return;
  state.void_fraction_middle = Array3<double>(box, 1.0);
  state.mass_flux_before = make_vector(box);
  state.mass_flux_middle = make_vector(box);
}

void TimeLevels::begin(GasState& state, double step, const Array3<double>& to, double share) {
  std::swap(state.void_fraction_before, state.void_fraction);
  for (std::size_t n = 0; n < to.size(); ++n)
    state.void_fraction[n] = (1 - share) * state.void_fraction_before[n] + share * to[n];
  state.density_before = state.density;
  if (keeps_velocity_) velocity_before_ = state.velocity;
  if (middle_) {
    for (std::size_t n = 0; n < to.size(); ++n)
      state.void_fraction_middle[n] =
          0.5 * (state.void_fraction_before[n] + state.void_fraction[n]);
    const double ahead = last_step > 0 ? 0.5 * step / last_step : 0.0;
    for (int d = 0; d < 3; ++d) {
      const Array3<double>& now = state.mass_flux[d];
      Array3<double>& before = state.mass_flux_before[d];
      for (std::size_t n = 0; n < now.size(); ++n)
        state.mass_flux_middle[d][n] = now[n] + ahead * (now[n] - before[n]);
      before = now;
    }
  }
  last_step = step;
}

void TimeLevels::iterate(GasState& state) const {
  if (!middle_) return;
  for (int d = 0; d < 3; ++d)
    for (std::size_t n = 0; n < state.mass_flux[d].size(); ++n)
      state.mass_flux_middle[d][n] = 0.5 * (state.mass_flux_before[d][n] + state.mass_flux[d][n]);
}

}  // namespace gasgrain
