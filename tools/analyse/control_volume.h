// What a cube holds of two phases of grains: volumes, momenta by density, and the force on the big
// ones; a sphere that the cube's faces cut counts by its exact share.
#pragma once

#include <vector>

#include "coupling/base/vec3.h"

namespace gasgrain {

struct MovingGrain {
  int id = 0;
  Vec3 position = Vec3::Zero();  // m
  Vec3 velocity = Vec3::Zero();  // m/s
  double radius = 0.0;           // m
  Vec3 force = Vec3::Zero();     // N; of big ones
};

// Volume [m3] of a sphere within the cube.
double volume_within(const MovingGrain& grain, const Vec3& centre, double side);

struct PhaseContent {
  double volume = 0.0;              // m3
  Vec3 volume_flow = Vec3::Zero();  // sum of volume times velocity [m4/s]
  Vec3 force = Vec3::Zero();        // N; of a cut grain its share

  void add(const PhaseContent& other);
  [[nodiscard]] Vec3 velocity() const;  // 0 of nothing
};

PhaseContent content_of(const std::vector<MovingGrain>& grains, const Vec3& centre, double side);

}  // namespace gasgrain
