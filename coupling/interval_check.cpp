#include "coupling/interval_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "coupling/exchange/sphere.h"

namespace gasgrain {
namespace {

constexpr double never = std::numeric_limits<double>::infinity();

// Rounded down to two digits, at least 1.
long round_number_below(double value) {
  constexpr double round_off = 1e-9;
  const double number = std::max(1.0, value * (1.0 + round_off));
  const double unit = std::max(1.0, std::pow(10.0, std::floor(std::log10(number)) - 1.0));
  return static_cast<long>(std::floor(number / unit) * unit);
}

// Below it every bed up to 80 % of solids is within the limit.
constexpr double a_of_no_interest = 0.05;

}  // namespace

double drag_swing(double a, double solids, double density_ratio) {
  const double kappa = solids / (1.0 - solids);
  const double h = 1.0 / std::tanh(0.5 * a);
  const double s = -std::expm1(-a) / a;
  const double g = h * (1.0 - s) - s;
  return a * h * (kappa - 1.0) + a * kappa * (1.0 + kappa) * g + 2.0 * kappa * (a - 1.0) +
         2.0 * density_ratio * kappa * g;
}

double drag_limit(double solids, double density_ratio) {
  double low = a_of_no_interest;
  double high = 1e3;  // where E and s are as good as 0
  if (drag_swing(high, solids, density_ratio) <= 0.0) return never;
  constexpr double precision = 1e-4;
  while (high - low > precision * high) {
    const double middle = 0.5 * (low + high);
    (drag_swing(middle, solids, density_ratio) > 0.0 ? high : low) = middle;
  }
  return low;
}

IntervalNeed::IntervalNeed() : longest_of_drag(never) {}

void IntervalNeed::join(const IntervalNeed& other) {
  crossing_rate = std::max(crossing_rate, other.crossing_rate);
  longest_of_drag = std::min(longest_of_drag, other.longest_of_drag);
}

bool IntervalNeed::too_long(double interval) const {
  return cells_crossed(interval) > most_cells_crossed || interval > longest_of_drag;
}

double IntervalNeed::advised() const {
  const double crossing = crossing_rate > 0.0 ? advised_cells_crossed / crossing_rate : never;
  return std::min(crossing, advised_share_of_drag_limit * longest_of_drag);
}

std::string in_words(const IntervalNeed& need, double interval) {
  std::string text;
  if (const double cells = need.cells_crossed(interval); cells > most_cells_crossed)
    text = fmt::format("in {:.3g} s the fastest grain crosses {:.2f} cells of the gas.", interval,
                       cells);
  if (interval > need.longest_of_drag)
    text += fmt::format(
        "{}in intervals of {:.3g} s gas and grains of a dense bed throw each other to and fro: "
        "their drag (m / K) and void fraction allow {:.2g} s.",
        text.empty() ? "" : " Also ", interval, need.longest_of_drag);
  return text;
}

std::string every_to_write(double advised, double dt) {
  if (advised < dt)
    return fmt::format("Even 'every 1' is too long: lower 'timestep' to {:.2g}.", advised);
  return fmt::format("Write 'every {}'.", round_number_below(advised / dt));
}

namespace {

// Of a rank's parcels, the mean [kg]; 0 of grains.
double mean_parcel_mass(const ParticleView& particles) {
  if (particles.parcel_size == nullptr || particles.count == 0) return 0.0;
  double sum = 0.0;
  for (std::size_t p = 0; p < particles.count; ++p) sum += particles.N(p) * particles.mass[p];
  return sum / static_cast<double>(particles.count);
}

}  // namespace

IntervalNeed interval_need(const ParticleView& particles, const ExchangeRecords& records,
                           const IntervalGas& gas) {
  IntervalNeed need;
  // What a droplet leaves of itself follows the gas at once, and is too little to throw it about.
  constexpr double share_of_no_weight = 1e-3;
  const double least_mass = share_of_no_weight * mean_parcel_mass(particles);
  const Vec3 per_cell = gas.grid.spacing().cwiseInverse();
  for (std::size_t p = 0; p < particles.count; ++p) {
    const double rate = particles.v(p).cwiseAbs().cwiseProduct(per_cell).maxCoeff();
    need.crossing_rate = std::max(need.crossing_rate, rate);
    if (gas.void_fraction == nullptr) continue;
    const double K = records.K(p);
    const double mass = particles.mass[p];
    if (K * gas.interval < a_of_no_interest * mass || particles.N(p) * mass < least_mass) continue;
    const Array3<double>& eps = *gas.void_fraction;
    Int3 cell;
    for (int d = 0; d < 3; ++d)
      cell[d] =
          std::clamp(gas.grid.cell_of(particles.x(p)[d], d), eps.box().lo[d], eps.box().hi[d] - 1);
    const double solids = 1.0 - eps(cell[0], cell[1], cell[2]);
    const double ratio = gas.density * sphere_volume(particles.radius[p]) / mass;
    // The limit itself is sought only where it is near.
    if (drag_swing(K * gas.interval / mass, solids, ratio) <= 0.0) continue;
    need.longest_of_drag = std::min(need.longest_of_drag, drag_limit(solids, ratio) * mass / K);
  }
  return need;
}

}  // namespace gasgrain
