// Particle-centre method: all of a particle belongs to the cell that holds its centre.
//
//   w = 1 in that cell.
//
// Source: F. Alobaid, thesis, TU Darmstadt (2013), section 7.1 and figure 7.1(b).
// Assumptions: cells of several particle diameters; the void fraction jumps by a whole particle
// when
//   a centre crosses a face.
#pragma once

#include <string_view>

#include "coupling/base/tile_frame.h"

namespace gasgrain {

struct VoidFractionCentre {
  static constexpr std::string_view name = "centre";

  // Greatest share of a particle that changes cells when it moves across a face along one axis.
  static constexpr double greatest_jump = 1.0;

  // Cells beyond the particle's own that may be touched, along an axis.
  static int reach(const BoxGrid& /*grid*/, int /*axis*/, double /*radius*/) { return 0; }

  template <class F>
  static void for_each_weight(const TileFrame& frame, const Vec3& x, double /*radius*/, F&& f) {
    f(frame.cell(frame.in_cells(x[0], 0), 0), frame.cell(frame.in_cells(x[1], 1), 1),
      frame.cell(frame.in_cells(x[2], 2), 2), 1.0);
  }
};

}  // namespace gasgrain
