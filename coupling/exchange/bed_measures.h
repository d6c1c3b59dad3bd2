// Measures of a bed: kinetic energy and the height under which a share of its solids lies.
//
// A rank measures its own particles; the values() of all ranks are then summed by the
// caller. Heights come from a histogram with fixed bins over the box,
// so that they can be found after the sum, without gathering particles.
#pragma once

#include <vector>

#include "coupling/exchange/particle_view.h"

namespace gasgrain {

class BedMeasures {
 public:
  static constexpr int default_bins = 2000;

  // Heights are taken along `axis`, binned between `bottom` and `top` [m].
  BedMeasures(int axis, double bottom, double top, int bins = default_bins);

  // Adds the particles of a rank. Without angular velocities their energy of rotation is left out.
  void add(const ParticleView& particles);

  [[nodiscard]] double count() const { return values_[0]; }    // of particles
  [[nodiscard]] double parcels() const { return values_[6]; }  // equal to it where there are none
  [[nodiscard]] double translation_energy() const { return values_[1]; }  // sum m v^2 / 2 [J]
  [[nodiscard]] double rotation_energy() const { return values_[2]; }     // sum m r^2 w^2 / 5 [J]
  [[nodiscard]] double kinetic_energy() const { return values_[1] + values_[2]; }
  [[nodiscard]] Vec3 momentum() const { return {values_[3], values_[4], values_[5]}; }  // [N s]
  [[nodiscard]] double solid_volume() const;                                            // [m3]

  // Height [m] of the tops (centre + radius) of particles under which lies `share` of the solid
  // volume; linear within a bin, so good to (top - bottom) / bins. The bottom when there are no
  // particles.
  [[nodiscard]] double height(double share = 0.995) const;

  // Everything that was added up; may be summed over ranks in place.
  [[nodiscard]] std::vector<double>& values() { return values_; }

 private:
  static constexpr int scalars_ = 7;

  int axis_;
  double bottom_;
  double bin_size_;
  std::vector<double> values_;  // count, energies, momentum, parcels, then the volume in each bin
};

}  // namespace gasgrain
