// One contact of grain i with grain j, or with a wall, as a host's loop shows it to a contact law:
// plain data, which a compiler takes apart once the law is inlined. What a law does not read costs
// nothing.
//
// Units: SI. Vectors have three components; `delta`, `en` point from j, or from the wall's nearest
// point, to i.
#pragma once

#include <cmath>
#include <cstdint>

#include "coupling/base/vec3.h"
#include "fix_cfd_coupling/dem_physics/contact_time.h"

namespace gasgrain::contact {

// Which part of a wall a grain is at, where the host makes walls of triangles.
class WallParts {
 public:
  // Whether two places are parts of one even surface that lie beside each other.
  [[nodiscard]] virtual bool goes_on(double from, double to) const = 0;

 protected:
  ~WallParts() = default;
};

struct ContactView {
  // Of every contact that the host shows: up to the gap that the law asked it for (reach()).
  int i, j;          // where the host's arrays have the grains; of a wall j means nothing
  int itype, jtype;  // from 1
  bool is_wall;
  bool owns_j;        // j is of this rank; i always is
  double radi, radj;  // [m]; of a wall radj means nothing
  double radsum;      // r_i + r_j [m]; of a wall r_i
  double rsq;         // |delta|^2 [m2]
  const double* delta;
  const double *v_i, *v_j, *omega_i, *omega_j;  // of a wall omega_j is null
  bool updates;            // the history may change: not while forces are only looked at
  double* history;         // this law's own values of this contact; null where there are none
  double dt;               // [s]
  std::int64_t step;       // its number
  double area_ratio;       // of what the wall's force counts
  double place;            // at a wall of triangles: which one
  const WallParts* parts;  // null of a wall of one part

  // Out, of a law with a history, where `updates`: whether the host keeps the contact's values when
  // it makes its lists anew, though the bodies are apart.
  bool keep;
  // Out, of bodies that are apart: a force was added.
  bool acts;

  // Of bodies that touch, after the normal model, whose force is in ContactForces already.
  const double* en;  // unit vector
  double overlap;    // [m], above 0
  double vn;         // velocity of i less that of j along en [m/s]; below 0 on approach
  double meff;       // reduced mass [kg]
  double kn, kt;     // force over overlap [N/m], normal and tangential
  double Fn;         // normal force [N], above 0 pushes; a law may change it for friction's limit

  // Distance of the surfaces [m], below 0 for an overlap.
  [[nodiscard]] double gap() const { return std::sqrt(rsq) - radsum; }
  // R* [m].
  [[nodiscard]] double reduced_radius() const { return is_wall ? radi : effective(radi, radj); }
};

// What a law adds to: force [N] and torque [N m] of the two bodies. What is added to j of a wall
// is lost.
struct ContactForces {
  double *force_i, *torque_i, *force_j, *torque_j;
};

inline Vec3 vec(const double* v) {
  return {v[0], v[1], v[2]};
}
inline void add(const Vec3& what, double* to) {
  for (int d = 0; d < 3; ++d) to[d] += what[d];
}

}  // namespace gasgrain::contact
