// Rolling friction that grows with how fast a sphere rolls, up to Coulomb's limit.
//
//   M_i = -min(mu, k |w|) |F_n| R* w / |w|
//
// w is relative_rolling() [rad/s]. Fast rolling is resisted by the constant torque mu |F_n| R* (the
// host's `cdt`, Beer and Johnston's law), slow rolling by the viscous one (rolling_viscous.h), so
// that the torque goes through zero instead of flipping its sign from step to step. A grain at rest
// has no torque: on a slope below mu it creeps, with a speed of R tan(slope) / k.
//
// Source: Y.C. Zhou, B.D. Wright, R.Y. Yang, B.H. Xu, A.B. Yu, Physica A 269 (1999) 536; H.P. Zhu,
//   A.B. Yu, Phys. Rev. E 66 (2002) 021302; Alobaid (2013), eq 5.110, fourth line.
// Inputs: mu rolling friction [-], that of the host's coeffRollFrict; k [s]; R* reduced radius [m]
//   (R at a wall); F_n normal force [N]; w [rad/s]. Output: torque on i [N m]; on j the opposite
//   one.
// Range: any rolling; the explicit step as for rolling_viscous.h.
// Deviations: the sources give mu as a length; here it is that length over R*, as in the host. The
//   minimum's arguments in eq 5.110 are printed as a fraction and a velocity of another unit than
//   either, and its velocity is that of relative_rolling.h.
#pragma once

#include <algorithm>

#include "fix_cfd_coupling/dem_physics/adhesion/input_faults.h"
#include "fix_cfd_coupling/dem_physics/rolling/relative_rolling.h"

namespace gasgrain::rolling {

struct RollingLimited {
  double friction = 0.0;       // mu
  double time_constant = 0.0;  // k [s]

  Vec3 torque(const Vec3& rolling, double normal_force, double reduced_radius) const {
    const double rate = rolling.norm();
    // the factor of w, written without w / |w|, which rest has not
    const double factor = time_constant * rate > friction ? friction / rate : time_constant;
    return -factor * std::abs(normal_force) * reduced_radius * rolling;
  }
};

inline void check(const RollingLimited& law) {
  InputFaults("Limited rolling friction")
      .not_negative("friction", law.friction, "", "grains have 0 to 0.5; give 0 to switch it off")
      .require(!(law.friction > 1.0), "friction", law.friction, "", "at most 1",
               "it is the resisting lever over R*, not a length or an angle")
      .require(law.time_constant > 0.0 || law.friction == 0.0, "time constant", law.time_constant,
               "s", "above 0 where there is friction",
               "without it slow grains roll freely; the host's cdt has no such constant")
      .not_negative("time constant", law.time_constant, "s", "give it in s")
      .refuse();
}

}  // namespace gasgrain::rolling
