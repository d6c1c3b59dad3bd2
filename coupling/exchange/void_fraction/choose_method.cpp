#include "coupling/exchange/void_fraction/choose_method.h"

#include <fmt/format.h>

#include "coupling/base/listed.h"

namespace gasgrain {
namespace {

std::string sizes_text(double smallest_radius, double largest_radius, const Vec3& h) {
  const double millimetres = 1e3;
  std::string text = fmt::format("{:.3g}", 2.0 * largest_radius * millimetres);
  if (smallest_radius < (1.0 - 1e-6) * largest_radius)
    text = fmt::format("{:.3g} to {}", 2.0 * smallest_radius * millimetres, text);
  return fmt::format("particles of {} mm in cells of {:.3g} x {:.3g} x {:.3g} mm", text,
                     h[0] * millimetres, h[1] * millimetres, h[2] * millimetres);
}

}  // namespace

MethodChoice choose_method(double smallest_radius, double largest_radius, const BoxGrid& grid) {
  const Vec3 h = grid.spacing();
  const double diameter = 2.0 * largest_radius;
  const std::string sizes = sizes_text(smallest_radius, largest_radius, h);
  const VoidFractionKernel kernel{VoidFractionKernel::default_width, diameter};
  bool wide = true;
  for (int d = 0; d < 3; ++d) wide = wide && kernel.tau(grid, d, largest_radius) == 0.0;
  if (wide)
    return {VoidFractionTrilinear{},
            fmt::format("void_fraction auto: trilinear, for {}: a cell is {:.2g} diameters wide or "
                        "more, enough to average over",
                        sizes, h.minCoeff() / diameter)};
  std::string reason = fmt::format(
      "void_fraction auto: kernel {:g}, for {}: a cell is only {:.2g} diameters wide, and the "
      "void fraction is taken over {:g} diameters about each particle",
      kernel.width, sizes, h.minCoeff() / diameter, kernel.width);
  if (diameter > most_cells_across * h.minCoeff())
    reason += fmt::format(
        ". That is {:.2g} cells across a particle, more than the {:g} it was measured for: drag "
        "laws know nothing of a flow resolved so finely, and coarser cells would do",
        diameter / h.minCoeff(), most_cells_across);
  return {listed<VoidFractionMethod>([&] { return kernel; }), reason};
}

}  // namespace gasgrain
