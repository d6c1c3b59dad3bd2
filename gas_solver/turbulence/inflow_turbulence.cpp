#include "gas_solver/turbulence/inflow_turbulence.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "gas_solver/turbulence/launder_spalding.h"

namespace gasgrain {
namespace {

constexpr double length_per_diameter = 0.07;
constexpr double ambient_viscosity_ratio = 10;  // mu_t / mu

double hydraulic_diameter(const BoxGrid& grid, const InflowPatch& patch) {
  const auto plane = plane_axes(axis_of(patch.side));
  const Rectangle& r = patch.outline.bounds;
  const double a = r.hi[0] - r.lo[0];
  const double b = r.hi[1] - r.lo[1];
  if (patch.outline.round) return a;
  if (grid.cells[plane[0]] == 1) return 2 * b;
  if (grid.cells[plane[1]] == 1) return 2 * a;
  return 2 * a * b / (a + b);
}

// Least distance between opposite sides; of a domain without any, its least extent.
double least_distance(const BoxGrid& grid) {
  constexpr double none = std::numeric_limits<double>::infinity();
  double between_sides = none;
  double extent = none;
  for (int d = 0; d < 3; ++d) {
    if (grid.cells[d] == 1) continue;
    extent = std::min(extent, grid.hi[d] - grid.lo[d]);
    if (!grid.periodic[d]) between_sides = std::min(between_sides, grid.hi[d] - grid.lo[d]);
  }
  const double least = std::min(between_sides < none ? between_sides : extent, none);
  return least < none ? least : (grid.hi - grid.lo).minCoeff();
}

}  // namespace

InflowTurbulence::InflowTurbulence(const GasInput& input)
    : grid_(input.grid), choice_(input.turbulence), patches_(input.inflows) {
  using namespace launder_spalding;
  const double diffusivity = ambient_viscosity_ratio * input.viscosity / input.density;
  double rate = 0;
  for (const InflowPatch& patch : patches_)
    rate = std::max(rate, patch.full_velocity(input.density) / hydraulic_diameter(grid_, patch));
  if (rate == 0) {
    // mu_t = rho C_mu k / rate and rate = C_mu^(3/4) k^(1/2) / l
    const double length = length_per_diameter * least_distance(grid_);
    rate = std::sqrt(c_mu) * diffusivity / (length * length);
  }
  ambient_.k = diffusivity * rate / c_mu;
  ambient_.e = ambient_.k * rate;
}

void InflowTurbulence::update(const std::vector<InflowFace>& faces) {
  if (length_.size() != faces.size()) {
    length_.clear();
    for (const InflowFace& face : faces) length_.push_back(length_at(face));
    k_.resize(faces.size());
    e_.resize(faces.size());
  }
  for (std::size_t n = 0; n < faces.size(); ++n) {
    const InflowFace& face = faces[n];
    const double velocity = face.mass_flux > 0 ? face.momentum_flux / face.mass_flux : 0.0;
    const double fluctuation = choice_.intensity * velocity;
    k_[n] = 1.5 * fluctuation * fluctuation;
    e_[n] = launder_spalding::dissipation(k_[n], length_[n]);
  }
}

// Of the patch that covers most of the face.
double InflowTurbulence::length_at(const InflowFace& face) const {
  if (choice_.length_scale > 0) return choice_.length_scale;
  const Rectangle outline = face_rectangle(grid_, face.side, face.face);
  double most = 0;
  double diameter = least_distance(grid_);
  for (const InflowPatch& patch : patches_) {
    if (patch.side != face.side) continue;
    const double area = common_area(patch.outline, outline);
    if (area <= most) continue;
    most = area;
    diameter = hydraulic_diameter(grid_, patch);
  }
  return length_per_diameter * diameter;
}

}  // namespace gasgrain
