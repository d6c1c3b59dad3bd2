#include "gas_solver/momentum/assembly.h"

#include <algorithm>

#include "gas_solver/boundary/unknown_faces.h"

namespace gasgrain {
namespace {

// Share of mu that multiplies a component's derivative along its own axis: 2 - 2/3.
constexpr double normal_stress = 4.0 / 3.0;
constexpr double dilatation = 2.0 / 3.0;

// An axis across the component's own.
struct Across {
  Across(const CellVector& fluxes, const CellVector& lagged, int axis, double spacing)
      : flux(fluxes[axis].data()),
        velocity(lagged[axis].data()),
        stride(fluxes[axis].stride(axis)),
        per_h(1.0 / spacing),
        lo(side_of(axis, false)),
        hi(side_of(axis, true)) {}
  const double* flux;
  const double* velocity;
  std::ptrdiff_t stride;
  double per_h;
  int lo;
  int hi;
};

// Faces of a component that are unknown and lie beside a side along another axis.
IndexBox beside(IndexBox faces, int side, const IndexBox& own) {
  const int axis = axis_of(side);
  faces.lo[axis] = is_high(side) ? own.hi[axis] - 1 : own.lo[axis];
  faces.hi[axis] = faces.lo[axis] + 1;
  return faces;
}

}  // namespace

MomentumAssembly::MomentumAssembly(const Domain& domain, const GasInput& input)
    : domain_(domain),
      density_(input.density),
      viscosity_(input.viscosity),
      whole_gradient_(input.model == GasModel::b),
      sides_(input.sides),
      wall_velocity_(input.wall_velocity),
      gravity_at_rest_(Hydrostatic(input).gravity_at_rest()),
      gravity_body_(Hydrostatic(input).gravity_body()),
      compressibility_(Hydrostatic(input).compressibility()),
      spacing_(input.grid.spacing()),
      convection_(domain, input),
      face_void_fraction_(domain.box(), 1.0) {}

void MomentumAssembly::assemble(const GasState& state, int component, const CellVector& lagged,
                                const std::vector<InflowFace>& inflow, const Turbulence* turbulence,
                                Array3<MomentumRow>& rows) {
  const Quantity viscosity = turbulence != nullptr
                                 ? Quantity{FieldQuantity{turbulence->viscosity().data()}}
                                 : Quantity{ConstantQuantity{viscosity_}};
  convection_.evaluate(state.convecting_flux(), lagged[component], component, inflow);
  std::visit(
      [&](const auto& rho, const auto& mu) {
        inner_rows(state, component, lagged, rho, mu, rows);
        for (const bool high : {false, true}) {
          const int side = side_of(component, high);
          if (domain_.touches(side) && !sides_[side]->normal_velocity_given)
            outlet_rows(state, side, rho, mu, rows);
        }
        for (int side = 0; side < side_count; ++side)
          if (axis_of(side) != component && domain_.touches(side))
            close_side(component, side, mu, turbulence, rows);
      },
      quantity(state.density, density_), viscosity);
  if (state.mass_source.size() > 0) add_mass_sources(state, component, rows);
  add_jets(state, component, inflow, rows);
}

template <class Density, class Viscosity>
void MomentumAssembly::inner_rows(const GasState& state, int component, const CellVector& lagged,
                                  const Density& density, const Viscosity& viscosity,
                                  Array3<MomentumRow>& rows) {
  const int d = component;
  const Array3<double>& cells = state.momentum_void_fraction();
  const std::ptrdiff_t s = cells.stride(d);
  const IndexBox faces = domain_.inner_faces(d);
  for_each_cell(faces.grown(1), [&](int i, int j, int k) {
    const auto o = cells.offset(i, j, k);
    face_void_fraction_[o] = face_mean(cells, o, s);
  });

  // Plain pointers and constants: what the loop reads stays in registers.
  const double* const eps = cells.data();
  const double* const eps_face = face_void_fraction_.data();
  const double* const drag = state.drag_coefficient.data();
  const double* const source = state.drag_source[d].data();
  const double* const p = state.pressure.data();
  const double* const gain = convection_.gain().data();
  const double* const flux = state.convecting_flux()[d].data();
  const auto [e1, e2] = plane_axes(d);
  const Across across1(state.convecting_flux(), lagged, e1, spacing_[e1]);
  const Across across2(state.convecting_flux(), lagged, e2, spacing_[e2]);
  const double per_h = 1.0 / spacing_[d];
  const double body = gravity_body_[d];
  const double excess_weight = 0.5 * compressibility_ * gravity_at_rest_[d];
  const bool whole_gradient = whole_gradient_;
  const int lo = side_of(d, false);
  const int hi = side_of(d, true);

  for (int k = faces.lo[2]; k < faces.hi[2]; ++k)
    for (int j = faces.lo[1]; j < faces.hi[1]; ++j) {
      std::ptrdiff_t o = cells.offset(faces.lo[0], j, k);
      MomentumRow* row = &rows(faces.lo[0], j, k);
      for (int i = faces.lo[0]; i < faces.hi[0]; ++i, ++o, ++row) {
        const double eps_f = eps_face[o];
        const double mu_before = normal_stress * viscosity(o - s);
        const double mu_here = normal_stress * viscosity(o);
        double* const c = row->coefficient.data();
        c[lo] =
            std::max(side_flux(flux, o, s), 0.0) * per_h + mu_before * per_h * per_h * eps[o - s];
        c[hi] =
            std::max(-side_flux(flux, o + s, s), 0.0) * per_h + mu_here * per_h * per_h * eps[o];
        double sum = c[lo] + c[hi];
        double stress = 0;
        // Along an axis e across: d/de (mu du_e/dd) - 2/3 d/dd (mu du_e/de), from `lagged`.
        const auto add = [&](const Across& e) {
          const std::ptrdiff_t t = e.stride;
          // Means over the four cells round an edge.
          const double mu_mid = face_value(viscosity, o, s);
          const double mu_lo =
              0.25 * (mu_mid + face_value(viscosity, o - t, s)) * (eps_f + eps_face[o - t]);
          const double mu_hi =
              0.25 * (mu_mid + face_value(viscosity, o + t, s)) * (eps_f + eps_face[o + t]);
          c[e.lo] = std::max(side_flux(e.flux, o, s), 0.0) * e.per_h + mu_lo * e.per_h * e.per_h;
          c[e.hi] =
              std::max(-side_flux(e.flux, o + t, s), 0.0) * e.per_h + mu_hi * e.per_h * e.per_h;
          sum += c[e.lo] + c[e.hi];
          const double here = e.velocity[o + t] - e.velocity[o];
          const double before = e.velocity[o + t - s] - e.velocity[o - s];
          stress += e.per_h * (mu_hi * (e.velocity[o + t] - e.velocity[o + t - s]) -
                               mu_lo * (e.velocity[o] - e.velocity[o - s]) -
                               dilatation * (viscosity(o) * eps[o] * here -
                                             viscosity(o - s) * eps[o - s] * before));
        };
        add(across1);
        add(across2);
        const double gradient = (p[o] - p[o - s]) * per_h - excess_weight * (p[o] + p[o - s]);
        row->inverse_diagonal = 0.5 * (drag[o - s] + drag[o]) + sum;
        row->source = 0.5 * (source[o - s] + source[o]) -
                      (whole_gradient ? 1.0 : eps_f) * gradient +
                      eps_f * face_value(density, o, s) * body + stress * per_h + gain[o];
      }
    }
}

// The control volume is the half cell inside the side: its sides along the component's axis lie h /
// 2 apart, and eps, K and S are those of the cell.
template <class Density, class Viscosity>
void MomentumAssembly::outlet_rows(const GasState& state, int side, const Density& density,
                                   const Viscosity& viscosity, Array3<MomentumRow>& rows) const {
  const int d = axis_of(side);
  const Array3<double>& eps = state.momentum_void_fraction();
  const CellVector& flux = state.convecting_flux();
  const std::ptrdiff_t s = eps.stride(d);
  const std::ptrdiff_t in = inward(side, s);
  const double outward = is_high(side) ? 1.0 : -1.0;
  const double half = 0.5 * spacing_[d];
  const double excess_weight = 0.5 * compressibility_ * gravity_at_rest_[d];
  for_each_cell(domain_.side_faces(side), [&](int i, int j, int k) {
    const auto o = eps.offset(i, j, k);
    const auto cell = o + inner_cell_offset(side, s);
    const double mu = viscosity(cell);
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
                 eps[cell] * density(cell) * gravity_body_[d];
  });
}

// What enters along a side carries no velocity along it, and the shear there is the side's own:
// none, or where the gas sticks, with u_1 and u_2 the first two values inside and U the wall's,
//   mu (9 u_1 - u_2 - 8 U) / (3 h),
// exact for a parabola; mu (u_1 - U) / (h / 2) where there is no u_2; or that of a wall law.
template <class Viscosity>
void MomentumAssembly::close_side(int component, int side, const Viscosity& viscosity,
                                  const Turbulence* turbulence, Array3<MomentumRow>& rows) const {
  const int axis = axis_of(side);
  const std::ptrdiff_t s = face_void_fraction_.stride(component);
  const double h = spacing_[axis];
  const double molecular = viscosity_ / (h * h);
  const int inner = side_of(axis, !is_high(side));
  const bool sticks = sides_[side]->sticks;
  const bool wall_law = sticks && turbulence != nullptr && turbulence->has_wall_law();
  const bool parabola = domain_.grid().cells[axis] > 1;
  const double wall = wall_velocity_[side][component];
  const IndexBox faces = beside(unknown_faces(domain_, sides_, component), side, domain_.own());
  for_each_cell(faces, [&](int i, int j, int k) {
    const auto o = face_void_fraction_.offset(i, j, k);
    const double eps = face_void_fraction_[o];
    MomentumRow& row = rows(i, j, k);
    row.coefficient[side] = 0.0;
    row.inverse_diagonal -= face_value(viscosity, o, s) * eps / (h * h);  // of inner_rows
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
  });
}

void MomentumAssembly::add_mass_sources(const GasState& state, int component,
                                        Array3<MomentumRow>& rows) const {
  const std::ptrdiff_t s = state.mass_source.stride(component);
  for_each_cell(domain_.inner_faces(component), [&](int i, int j, int k) {
    const auto o = state.mass_source.offset(i, j, k);
    rows(i, j, k).inverse_diagonal +=
        0.5 * (std::max(state.mass_source[o - s], 0.0) + std::max(state.mass_source[o], 0.0));
  });
}

// The control volume next to a face of inflow takes the patch's momentum M = rho f U^2 in full,
// whatever share of the face it covers. The flux F_c it shares with that face, the mean of the
// face's F_0 and the next one's, dilutes it where the jet draws gas in (F_c > F_0); where gas
// leaves sideways below (F_c < F_0), it takes the control volume's velocity along: M - max(F_c,
// F_0) u.
void MomentumAssembly::add_jets(const GasState& state, int component,
                                const std::vector<InflowFace>& inflow,
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
