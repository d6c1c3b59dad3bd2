// The script's gravity.
#pragma once

#include <cstring>

#include "coupling/base/vec3.h"
// --
#include "fix.h"
#include "modify.h"

namespace gasgrain {

// [m/s2]; 0 where the script has none. The first `fix gravity` counts.
inline Vec3 gravity_of(const LAMMPS_NS::Modify& modify) {
  for (int n = 0; n < modify.nfix; ++n) {
    if (std::strcmp(modify.fix[n]->style, "gravity") != 0) continue;
    int dimension = 0;
    const auto* g = static_cast<const double*>(modify.fix[n]->extract("gvec", dimension));
    if (g != nullptr) return {g[0], g[1], g[2]};
  }
  return Vec3::Zero();
}

}  // namespace gasgrain
