// The liquid of the scene as contact laws see it: what their loops read lies here as plain data,
// what they ask for when a run begins, or when a bridge forms or breaks across a periodic face, the
// host's fix answers.
#pragma once

#include <string>

#include "coupling/base/vec3.h"
#include "fix_cfd_coupling/dem_physics/liquid/grain_bridges.h"
#include "fix_cfd_coupling/dem_physics/liquid/wall_bridges.h"

namespace gasgrain::liquid {

class SceneLiquid {
 public:
  // The pair style has bridges: their place in the history of a contact. Returns the greatest gap
  // of a bridge, over r_i + r_j, for which the host's lists are made; 0: there is no liquid at all.
  virtual double join_pairs(int history_offset) = 0;
  // The wall of this ID has bridges.
  virtual WallBridges& join_wall(const std::string& wall_id) = 0;
  // From k to i, the same to the last digit whoever owns them.
  [[nodiscard]] virtual Vec3 between(int i, int k) const = 0;

  [[nodiscard]] bool wet() const { return wet_; }
  [[nodiscard]] bool periodic() const { return periodic_; }
  [[nodiscard]] const LiquidSettings& settings() const { return settings_; }
  GrainFilms& films() { return films_; }
  BridgeCounts& counts() { return counts_; }
  double& held_back() { return held_back_; }

 protected:
  SceneLiquid() = default;
  ~SceneLiquid() = default;

  LiquidSettings settings_;
  GrainFilms films_;
  BridgeCounts counts_;
  bool wet_ = false;
  bool periodic_ = false;
  double held_back_ = 0.0;  // viscous forces that a step could not take, of bridges and steps
};

}  // namespace gasgrain::liquid
