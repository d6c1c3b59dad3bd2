#include "gas_solver/boundary/inflow.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace gasgrain {
namespace {

IndexBox all_faces(const BoxGrid& grid, int side) {
  IndexBox faces = grid.all();
  const int axis = axis_of(side);
  faces.lo[axis] = is_high(side) ? grid.cells[axis] : 0;
  faces.hi[axis] = faces.lo[axis] + 1;
  return faces;
}

}  // namespace

Rectangle face_rectangle(const BoxGrid& grid, int side, const Int3& face) {
  const auto plane = plane_axes(axis_of(side));
  const Vec3 h = grid.spacing();
  Rectangle r;
  for (int d = 0; d < 2; ++d) {
    const int axis = plane[d];
    r.lo[d] = grid.lo[axis] + face[axis] * h[axis];
    r.hi[d] = grid.lo[axis] + (face[axis] + 1) * h[axis];
  }
  return r;
}

Rectangle side_rectangle(const BoxGrid& grid, int side) {
  const auto plane = plane_axes(axis_of(side));
  return {{grid.lo[plane[0]], grid.lo[plane[1]]}, {grid.hi[plane[0]], grid.hi[plane[1]]}};
}

double InflowPatch::factor(double time) const {
  if (table_times.empty()) return ramp > 0 ? std::clamp(time / ramp, 0.0, 1.0) : 1.0;
  const auto later = std::upper_bound(table_times.begin(), table_times.end(), time);
  const auto n = static_cast<std::size_t>(later - table_times.begin());
  if (n == 0) return table_factors.front();
  if (n == table_times.size()) return table_factors.back();
  const double share = (time - table_times[n - 1]) / (table_times[n] - table_times[n - 1]);
  return table_factors[n - 1] + share * (table_factors[n] - table_factors[n - 1]);
}

Inflow::Inflow(const Domain& domain, std::vector<InflowPatch> patches, double constant_density)
    : domain_(domain), patches_(std::move(patches)), constant_density_(constant_density) {
  std::map<std::pair<int, Int3>, std::size_t> known;
  for (std::size_t n = 0; n < patches_.size(); ++n) {
    const InflowPatch& patch = patches_[n];
    const IndexBox mine = domain.side_faces(patch.side);
    double covered = 0;
    std::vector<std::pair<Int3, double>> areas;
    for_each_cell(all_faces(domain.grid(), patch.side), [&](int i, int j, int k) {
      const Int3 face{i, j, k};
      const double area =
          common_area(patch.outline, face_rectangle(domain.grid(), patch.side, face));
      covered += area;
      if (area > 0 && mine.contains(i, j, k)) areas.emplace_back(face, area);
    });
    for (const auto& [face, area] : areas) {
      const auto [place, is_new] = known.try_emplace({patch.side, face}, faces_.size());
      if (is_new) faces_.push_back({patch.side, face, 0, 0, 0});
      const double face_area = face_rectangle(domain.grid(), patch.side, face).area();
      parts_.push_back({place->second, n, area / face_area * (patch.outline.area() / covered)});
    }
  }
}

const std::vector<InflowFace>& Inflow::at(double time, const Array3<double>& density) {
  for (InflowFace& face : faces_) face.volume_flux = face.mass_flux = face.momentum_flux = 0;
  for (const Part& part : parts_) {
    const InflowPatch& patch = patches_[part.patch];
    InflowFace& face = faces_[part.face];
    double rho = constant_density_;
    if (density.size() > 0) {
      const auto o = density.offset(face.face[0], face.face[1], face.face[2]);
      rho = density[o + inner_cell_offset(face.side, density.stride(axis_of(face.side)))];
    }
    const double velocity = patch.full_velocity(rho) * patch.factor(time);
    face.volume_flux += part.fraction * velocity;
    face.mass_flux += part.fraction * rho * velocity;
    face.momentum_flux += part.fraction * rho * velocity * velocity;
  }
  return faces_;
}

double Inflow::courant_rate() const {
  const Vec3 h = domain_.grid().spacing();
  double rate = 0;
  for (const InflowFace& face : faces_)
    rate = std::max(rate, face.volume_flux / h[axis_of(face.side)]);
  return rate;
}

}  // namespace gasgrain
