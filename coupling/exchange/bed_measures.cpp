#include "coupling/exchange/bed_measures.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "coupling/base/error.h"
#include "coupling/exchange/sphere.h"

namespace gasgrain {

BedMeasures::BedMeasures(int axis, double bottom, double top, int bins)
    : axis_(axis),
      bottom_(bottom),
      bin_size_((top - bottom) / bins),
      values_(scalars_ + bins, 0.0) {
  if (!(top > bottom) || bins < 1)
    fail("bed heights need bins between a bottom and a top above it: {} bins from {:g} m to {:g} m",
         bins, bottom, top);
}

void BedMeasures::add(const ParticleView& particles) {
  const double last_bin = static_cast<double>(values_.size()) - scalars_ - 1.0;
  for (std::size_t p = 0; p < particles.count; ++p) {
    const double radius = particles.radius[p];
    const double N = particles.N(p);
    const double mass = N * particles.mass[p];
    values_[0] += N;
    values_[6] += 1.0;
    values_[1] += 0.5 * mass * particles.v(p).squaredNorm();
    if (particles.angular_velocity != nullptr)
      values_[2] += 0.2 * mass * radius * radius *
                    Eigen::Map<const Vec3>(particles.angular_velocity + 3 * p).squaredNorm();
    for (int d = 0; d < 3; ++d) values_[3 + d] += mass * particles.velocity[3 * p + d];
    const double top = particles.position[3 * p + axis_] + radius;
    if (!std::isfinite(top) || !std::isfinite(values_[1]))
      fail(
          "the position or velocity of a particle is not a number (local index {}): the DEM step "
          "is "
          "too long for the contacts' stiffness, or two particles were put into one place.",
          p);
    const double bin = std::clamp((top - bottom_) / bin_size_, 0.0, last_bin);
    values_[scalars_ + static_cast<std::size_t>(bin)] += N * sphere_volume(radius);
  }
}

double BedMeasures::solid_volume() const {
  return std::accumulate(values_.begin() + scalars_, values_.end(), 0.0);
}

double BedMeasures::height(double share) const {
  const double wanted = share * solid_volume();
  double below = 0.0;
  for (std::size_t n = scalars_; n < values_.size(); ++n) {
    if (values_[n] > 0.0 && below + values_[n] >= wanted) {
      const double within = (wanted - below) / values_[n];
      return bottom_ + (static_cast<double>(n - scalars_) + within) * bin_size_;
    }
    below += values_[n];
  }
  return bottom_;
}

}  // namespace gasgrain
