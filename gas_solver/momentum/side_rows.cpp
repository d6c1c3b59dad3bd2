#include "gas_solver/momentum/side_rows.h"

#include <algorithm>

#include "coupling/base/listed.h"
#include "gas_solver/boundary/unknown_faces.h"
#include "gas_solver/grid/hydrostatic.h"

namespace gasgrain {
namespace {

// Faces of a component that are unknown and lie beside a side along another axis.
IndexBox beside(IndexBox faces, int side, const IndexBox& own) {
  const int axis = axis_of(side);
  faces.lo[axis] = is_high(side) ? own.hi[axis] - 1 : own.lo[axis];
  faces.hi[axis] = faces.lo[axis] + 1;
  return faces;
}

}  // namespace

SideRows::SideRows(const Domain& domain, const GasInput& input)
    : domain_(domain),
      walls_(input.walls()),
      density_(input.density),
      viscosity_(input.viscosity),
      whole_gradient_(input.model == GasModel::b),
      spacing_(input.grid.spacing()) {
  const Hydrostatic rest(input);
  compressibility_ = rest.compressibility();
  gravity_at_rest_ = rest.gravity_at_rest();
  gravity_body_ = rest.gravity_body();
}

void SideRows::add(const GasState& state, int component, const Quantity& viscosity,
                   const Array3<double>& face_void_fraction, const std::vector<InflowFace>& inflow,
                   const Turbulence* turbulence, Array3<MomentumRow>& rows) const {
  for (const bool high : {false, true}) {
    const int side = side_of(component, high);
    if (domain_.touches(side) && !walls_.sides[side]->normal_velocity_given)
      open(state, side, viscosity, rows);
  }
  for (int side = 0; side < side_count; ++side)
    if (axis_of(side) != component && domain_.touches(side))
      close(component, side, viscosity, face_void_fraction, turbulence, rows);
  add_jets(state, component, inflow, rows);
}

// The control volume is the half cell inside the side: its sides along the component's axis lie h /
// 2 apart, and eps, K and S are those of the cell.
void SideRows::open(const GasState& state, int side, const Quantity& viscosity,
                    Array3<MomentumRow>& rows) const {
  const Quantity density = quantity(state.density, density_);
  const int d = axis_of(side);
  const Array3<double>& eps = state.momentum_void_fraction();
  const CellVector& flux = state.convecting_flux();
  const std::ptrdiff_t s = eps.stride(d);
  const std::ptrdiff_t in = inward(side, s);
  const double outward = is_high(side) ? 1.0 : -1.0;
  const double half = 0.5 * spacing_[d];
  const double excess_weight = 0.5 * compressibility_ * gravity_at_rest_[d];
  const auto row_of = [&](const auto& rho, const auto& mu_of, int i, int j, int k) {
    const auto o = eps.offset(i, j, k);
    const auto cell = o + inner_cell_offset(side, s);
    const double mu = mu_of(cell);
    MomentumRow& row = rows(i, j, k);
    row.coefficient.fill(0.0);
    const double from_inside = std::max(outward * 0.5 * (flux[d][o] + flux[d][o + in]), 0.0);
    row.coefficient[side_of(d, !is_high(side))] =
        from_inside / half + normal_stress * mu * eps[cell] / (half * spacing_[d]);
    double sum = row.coefficient[side_of(d, !is_high(side))];
    for (const int e : plane_axes(d)) {
      const std::ptrdiff_t t = eps.stride(e);
      const double he = spacing_[e];
      const double visc = mu * eps[cell] / (he * he);
      row.coefficient[side_of(e, false)] = std::max(flux[e][cell], 0.0) / he + visc;
      row.coefficient[side_of(e, true)] = std::max(-flux[e][cell + t], 0.0) / he + visc;
      sum += row.coefficient[side_of(e, false)] + row.coefficient[side_of(e, true)];
    }
    const double backflow = std::max(-outward * flux[d][o], 0.0);
    sum += (1.0 - backflow_share) * backflow / half;
    row.inverse_diagonal = state.drag_coefficient[cell] + sum;
    const double p = state.pressure[cell];
    const double gradient = outward * (0.0 - p) / half - excess_weight * p;
    row.source = state.drag_source[d][cell] - (whole_gradient_ ? 1.0 : eps[cell]) * gradient +
                 eps[cell] * rho(cell) * gravity_body_[d];
  };
  visit_apart(
      [&](const auto& rho, const auto& mu_of) {
        for_each_cell(domain_.side_faces(side),
                      [&](int i, int j, int k) { row_of(rho, mu_of, i, j, k); });
      },
      density, viscosity);
}

// What enters along a side carries no velocity along it, and the shear there is the side's own:
// none, or where the gas sticks, with u_1 and u_2 the first two values inside and U the wall's,
//   mu (9 u_1 - u_2 - 8 U) / (3 h),
// exact for a parabola; mu (u_1 - U) / (h / 2) where there is no u_2; or that of a wall law.
void SideRows::close(int component, int side, const Quantity& viscosity,
                     const Array3<double>& face_void_fraction, const Turbulence* turbulence,
                     Array3<MomentumRow>& rows) const {
  const int axis = axis_of(side);
  const std::ptrdiff_t s = face_void_fraction.stride(component);
  const double h = spacing_[axis];
  const double molecular = viscosity_ / (h * h);
  const int inner = side_of(axis, !is_high(side));
  const bool sticks = walls_.sides[side]->sticks;
  const bool wall_law = sticks && turbulence != nullptr && turbulence->has_wall_law();
  const bool parabola = domain_.grid().cells[axis] > 1;
  const double wall = walls_.velocity[side][component];
  const IndexBox faces =
      beside(unknown_faces(domain_, walls_.sides, component), side, domain_.own());
  const auto change_row = [&](const auto& mu, int i, int j, int k) {
    const auto o = face_void_fraction.offset(i, j, k);
    const double eps = face_void_fraction[o];
    MomentumRow& row = rows(i, j, k);
    row.coefficient[side] = 0.0;
    row.inverse_diagonal -= 0.5 * (mu(o - s) + mu(o)) * eps / (h * h);  // of the inner rows
    if (!sticks) return;
    double per_slip = (parabola ? 8.0 / 3.0 : 2.0) * molecular * eps;
    if (wall_law) {
      const Array3<double>& law = turbulence->wall_coefficient(side);
      const auto cell = law.offset(i, j, k);
      per_slip = face_mean(law, cell, law.stride(component)) * eps / h;
    } else if (parabola) {
      row.coefficient[inner] += molecular * eps / 3.0;
      row.inverse_diagonal += molecular * eps / 3.0;
    }
    row.inverse_diagonal += per_slip;
    row.source += per_slip * wall;
  };
  visit_apart(
      [&](const auto& mu) {
        for_each_cell(faces, [&](int i, int j, int k) { change_row(mu, i, j, k); });
      },
      viscosity);
}

// The control volume next to a face of inflow takes the patch's momentum M = rho f U^2 in full,
// whatever share of the face it covers. The flux F_c it shares with that face, the mean of the
// face's F_0 and the next one's, dilutes it where the jet draws gas in (F_c > F_0); where gas
// leaves sideways below (F_c < F_0), it takes the control volume's velocity along: M - max(F_c,
// F_0) u.
void SideRows::add_jets(const GasState& state, int component, const std::vector<InflowFace>& inflow,
                        Array3<MomentumRow>& rows) const {
  const double h = spacing_[component];
  const Array3<double>& flux = state.convecting_flux()[component];
  for (const InflowFace& face : inflow) {
    if (axis_of(face.side) != component) continue;
    const double into = is_high(face.side) ? -1.0 : 1.0;
    const auto o = flux.offset(face.face[0], face.face[1], face.face[2]);
    const auto next = o + inward(face.side, flux.stride(component));
    const double shared = std::max(into * 0.5 * (flux[o] + flux[next]), 0.0);
    Int3 at = face.face;
    at[component] += is_high(face.side) ? -1 : 1;
    MomentumRow& row = rows(at[0], at[1], at[2]);
    row.coefficient[face.side] -= shared / h;
    row.inverse_diagonal += (std::max(shared, face.mass_flux) - shared) / h;
    row.source += into * face.momentum_flux / h;
  }
}

}  // namespace gasgrain
