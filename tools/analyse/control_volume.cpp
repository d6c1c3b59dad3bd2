#include "tools/analyse/control_volume.h"

#include "coupling/exchange/sphere.h"
#include "coupling/exchange/void_fraction/sphere_box_overlap.h"

namespace gasgrain {

double volume_within(const MovingGrain& grain, const Vec3& centre, double side) {
  const Vec3 from_centre = grain.position - centre;
  const double beyond = from_centre.cwiseAbs().maxCoeff() - 0.5 * side;
  if (beyond >= grain.radius) return 0.0;
  if (beyond <= -grain.radius) return sphere_volume(grain.radius);
  const Vec3 half = Vec3::Constant(0.5 * side);
  const double r = grain.radius;
  return r * r * r * sphere_box_overlap((-half - from_centre) / r, (half - from_centre) / r);
}

void PhaseContent::add(const PhaseContent& other) {
  volume += other.volume;
  volume_flow += other.volume_flow;
  force += other.force;
}

Vec3 PhaseContent::velocity() const {
  return volume > 0.0 ? Vec3(volume_flow / volume) : Vec3::Zero();
}

PhaseContent content_of(const std::vector<MovingGrain>& grains, const Vec3& centre, double side) {
  PhaseContent content;
  for (const auto& grain : grains) {
    const double volume = volume_within(grain, centre, side);
    if (volume <= 0.0) continue;
    content.add(
        {volume, volume * grain.velocity, volume / sphere_volume(grain.radius) * grain.force});
  }
  return content;
}

}  // namespace gasgrain
