// Rolling friction of a viscoelastic sphere: a torque in proportion to how fast it rolls.
//
//   M_i = -k |F_n| R* w
//
// w is relative_rolling() [rad/s], R* |w| the rolling velocity. A sphere that rolls on a plane
// slows down as exp(-k |F_n| t / (7/5 m R)). At rest there is no torque: it gives no angle of
// repose.
//
// Source: N.V. Brilliantov, T. Poeschel, Europhys. Lett. 42 (1998) 511; Alobaid (2013), eq 5.110,
//   third line.
// Inputs: k [s], R* reduced radius [m] (R at a wall), F_n normal force [N], w [rad/s]. Output:
//   torque on i [N m]; on j the opposite one. By the source k is the time constant A of the
//   viscoelastic normal force of the same material.
// Assumptions: rolling slow beside the speed of sound and the relaxation of the material.
// Range: any rolling. Stable in an explicit step dt up to dt < 2 I / (k |F_n| R*), I the moment of
//   inertia that turns (7/5 m R^2 of a sphere that rolls on a plane).
// Deviations: the sign of eq 5.110, which drives, is turned; its velocity: relative_rolling.h.
#pragma once

#include "fix_cfd_coupling/dem_physics/adhesion/input_faults.h"
#include "fix_cfd_coupling/dem_physics/rolling/relative_rolling.h"

namespace gasgrain::rolling {

struct RollingViscous {
  double time_constant = 0.0;  // k [s]

  Vec3 torque(const Vec3& rolling, double normal_force, double reduced_radius) const {
    return -time_constant * std::abs(normal_force) * reduced_radius * rolling;
  }
};

inline void check(const RollingViscous& law) {
  InputFaults("Viscous rolling friction")
      .not_negative("time constant", law.time_constant, "s",
                    "give it in s; give 0 to switch it off")
      .refuse();
}

}  // namespace gasgrain::rolling
