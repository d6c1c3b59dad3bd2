// Force of a standing bridge on grain i, and its torques: capillary_force(), and where the scene
// has a viscosity viscous_force().
//
//   F = -F_cap n - c_n v_n n - c_t v_t,   T_i = -l_i n x F_t,   T_j = -l_j n x F_t
//   n from j to i; v = v_i - v_j - (l_i w_i + l_j w_j) x n, of which v_n along n and v_t across
//   l_i = r_i + gap r_i / (r_i + r_j): both act at one point, so that angular momentum stays
//
// Viscous coefficients that a step cannot take explicitly are held back to
//   1 / (3.5 dt (b_i / m_i + b_j / m_j)),   b bridges of a grain
// 3.5 / m = 1 / m + r^2 / I, by which a tangential force moves the surface of a sphere. Each bridge
// of a grain moves each other one's contact along the normal by 1 / m and along both tangents by up
// to 5 / m, so that dt times a row of their matrix sums to less than 2: the explicit step is stable
// whatever the viscosity and the number of bridges. How often this acts is counted.
#pragma once

#include <Eigen/Geometry>

#include <algorithm>
#include <variant>

#include "coupling/base/vec3.h"
#include "fix_cfd_coupling/dem_physics/bridge/viscous.h"
#include "fix_cfd_coupling/dem_physics/liquid/liquid_settings.h"
#include "fix_cfd_coupling/dem_physics/liquid/stored_bridge.h"

namespace gasgrain::liquid {

struct BridgeMotion {
  double gap;               // [m]
  Vec3 normal;              // from j to i
  Vec3 velocity;            // of i less that of j [m/s]
  Vec3 spin_i, spin_j;      // [1/s]
  double lever_i, lever_j;  // [m]
  double step_over_mass;    // dt (b_i / m_i + b_j / m_j) [s/kg]
};

struct BridgeForce {
  Vec3 on_i;      // [N]
  Vec3 torque_i;  // [N m]
  Vec3 torque_j;
};

// Attraction [N]; at contact in overlap.
inline double capillary_force(const LiquidSettings& s, const bridge::LiquidBridge& b, double gap) {
  const double open_gap = std::max(gap, 0.0);
  return std::visit([&](auto law) -> double { return decltype(law)::force(b, open_gap); }, s.law);
}

// What the bridge remembers of its contact: to be found when it forms and when a run begins.
inline void know_contact(const LiquidSettings& s, const bridge::LiquidBridge& b,
                         StoredBridge& stored) {
  stored.pull = capillary_force(s, b, 0.0);
  if (!s.viscous()) return;
  stored.damping_normal = viscous_normal(b, s.viscosity, 0.0, s.minimum_separation);
  stored.damping_tangential = viscous_tangential(b, s.viscosity, 0.0, s.minimum_separation);
}

// shape() makes the bridge::LiquidBridge, which is needed of surfaces apart only.
template <class Shape>
double pull_of(const LiquidSettings& s, const StoredBridge& stored, const Shape& shape,
               double gap) {
  return gap > 0.0 ? capillary_force(s, shape(), gap) : stored.pull;
}

template <class Shape>
inline BridgeForce viscous_force(const LiquidSettings& s, const StoredBridge& stored,
                                 const Shape& shape, const BridgeMotion& m, double& held_back) {
  double c_n = stored.damping_normal;
  double c_t = stored.damping_tangential;
  if (m.gap > s.minimum_separation) {
    const bridge::LiquidBridge b = shape();
    c_n = viscous_normal(b, s.viscosity, m.gap, s.minimum_separation);
    c_t = viscous_tangential(b, s.viscosity, m.gap, s.minimum_separation);
  }
  constexpr double sphere = 3.5;
  const double inverse_of_most = sphere * m.step_over_mass;
  if (std::max(c_n, c_t) * inverse_of_most > 1.0) {
    held_back += 1.0;
    c_n = std::min(c_n, 1.0 / inverse_of_most);
    c_t = std::min(c_t, 1.0 / inverse_of_most);
  }
  const Vec3 v = m.velocity - (m.lever_i * m.spin_i + m.lever_j * m.spin_j).cross(m.normal);
  const double v_n = v.dot(m.normal);
  const Vec3 tangential = -c_t * (v - v_n * m.normal);
  const Vec3 turning = m.normal.cross(tangential);
  return {tangential - c_n * v_n * m.normal, -m.lever_i * turning, -m.lever_j * turning};
}

}  // namespace gasgrain::liquid
