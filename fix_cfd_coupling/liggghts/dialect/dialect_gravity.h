// The script's gravity.
#pragma once

#include "coupling/base/vec3.h"
// --
#include "fix_gravity.h"
#include "modify.h"

namespace gasgrain {

// [m/s2]; 0 where the script has none. The first `fix gravity` counts.
inline Vec3 gravity_of(const LAMMPS_NS::Modify& modify) {
  Vec3 g = Vec3::Zero();
  for (int n = 0; n < modify.nfix; ++n)
    if (auto* gravity = dynamic_cast<LAMMPS_NS::FixGravity*>(modify.fix[n])) {
      gravity->get_gravity(g.data());
      return g;
    }
  return g;
}

}  // namespace gasgrain
