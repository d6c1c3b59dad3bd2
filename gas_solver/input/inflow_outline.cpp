#include "gas_solver/input/inflow_outline.h"

#include "coupling/base/error.h"
#include "gas_solver/grid/domain.h"

namespace gasgrain {

Outline read_outline(InputTable& table, const Rectangle& side) {
  const std::string shape = table.choice("shape", std::string("whole"),
                                         {inflow_shape_names.begin(), inflow_shape_names.end()});
  const auto is = [&](InflowShape other) {
    return shape == inflow_shape_names[static_cast<int>(other)];
  };
  const bool whole = is(InflowShape::whole);
  const bool round = is(InflowShape::circle);
  const std::vector<double> center = table.when(!whole, R"(shape = "rectangle" or "circle")")
                                         .two_numbers("center", Range::any(), "m");
  std::vector<double> size = table.when(!whole && !round, R"(shape = "rectangle")")
                                 .two_numbers("size", Range::positive(), "m");
  const double diameter = table.when(round, R"(shape = "circle")")
                              .number("diameter", std::nullopt, Range::positive(), "m");
  if (round && diameter > 0) size = {diameter, diameter};
  if (whole) return {side, false};
  if (center.empty() || size.empty()) return {{side.lo, side.lo}, false};
  Outline outline{{}, round};
  for (int d = 0; d < 2; ++d) {
    outline.bounds.lo[d] = center[d] - 0.5 * size[d];
    outline.bounds.hi[d] = center[d] + 0.5 * size[d];
  }
  return outline;
}

bool contains(const Rectangle& outer, const Rectangle& inner) {
  bool inside = true;
  for (int d = 0; d < 2; ++d) {
    const double round_off = 1e-9 * (outer.hi[d] - outer.lo[d]);
    inside =
        inside && inner.lo[d] >= outer.lo[d] - round_off && inner.hi[d] <= outer.hi[d] + round_off;
  }
  return inside;
}

std::string extent_text(const Rectangle& r, int side) {
  const auto plane = plane_axes(axis_of(side));
  return fmt::format("{} {:.6g} to {:.6g}, {} {:.6g} to {:.6g} m", "xyz"[plane[0]], r.lo[0],
                     r.hi[0], "xyz"[plane[1]], r.lo[1], r.hi[1]);
}

}  // namespace gasgrain
