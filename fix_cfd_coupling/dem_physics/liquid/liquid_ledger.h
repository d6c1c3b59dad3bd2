// Where the liquid of a run is, and whether all of it is still there.
//
//   films + bridges + wall bridges + wall films = at first + come in - gone
//
// All of one launch, summed over ranks; [m3].
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <string>

#include "fix_cfd_coupling/dem_physics/liquid/grain_bridges.h"

namespace gasgrain::liquid {

// Sums over the grains of a rank, or of all ranks.
struct LiquidTotals {
  double films = 0.0;
  double bridges = 0.0;  // between grains
  double wall_bridges = 0.0;
  double walls = 0.0;
  double came_in = 0.0;  // since the last taking of stock
  double gone = 0.0;     // with grains that left, since then
  double grains = 0.0;
  double grains_came = 0.0;
  double grains_gone = 0.0;
  double count = 0.0;            // of bridges
  double solid = 0.0;            // volume of the grains
  double beyond_pendular = 0.0;  // grains
  double formed = 0.0, broken = 0.0, cut_short = 0.0, lost_sight = 0.0;
  double held_back = 0.0;
  double greatest_saturation = 0.0;  // not a sum

  static constexpr std::size_t size = 17;
  [[nodiscard]] std::array<double, size> values() const {
    return {films,  bridges,     wall_bridges, walls,      came_in,  gone,
            grains, grains_came, grains_gone,  count,      solid,    beyond_pendular,
            formed, broken,      cut_short,    lost_sight, held_back};
  }
  static LiquidTotals of(const std::array<double, size>& v) {
    return {v[0], v[1],  v[2],  v[3],  v[4],  v[5],  v[6],  v[7],  v[8],
            v[9], v[10], v[11], v[12], v[13], v[14], v[15], v[16], 0.0};
  }
  [[nodiscard]] double liquid() const { return films + bridges + wall_bridges + walls; }
};

// The memory of a run; written to restarts as it is.
struct LiquidLedger {
  double at_first = 0.0;
  double came_in = 0.0;
  double gone = 0.0;
  double grains = 0.0;  // that it knows of
  double formed = 0.0, broken = 0.0, cut_short = 0.0, lost_sight = 0.0;
  double held_back = 0.0;
  double deleted = 0.0;  // liquid of grains that somebody deleted, part of gone

  // Liquid that is there and should not be, over the greatest amount that there was.
  [[nodiscard]] double residual(double liquid) const {
    const double scale = at_first + came_in;
    const double expected = at_first + came_in - gone;
    return scale > 0.0 ? (liquid - expected) / scale : liquid;
  }

  // Books what happened since the last time. Grains that are missing although none left took their
  // liquid along: somebody deleted them.
  void book(const LiquidTotals& t) {
    came_in += t.came_in;
    gone += t.gone;
    grains += t.grains_came - t.grains_gone;
    formed += t.formed;
    broken += t.broken;
    cut_short += t.cut_short;
    lost_sight += t.lost_sight;
    held_back += t.held_back;
    if (t.grains < grains) {
      const double missing = at_first + came_in - gone - t.liquid();
      gone += missing;
      deleted += missing;
    }
    grains = t.grains;
  }
};

inline constexpr const char* liquid_columns =
    "step,time,films,bridges,wall_bridges,walls,came_in,gone,residual,bridge_count,formed,broken,"
    "cut_short,lost_sight,saturation,beyond_pendular";

}  // namespace gasgrain::liquid
