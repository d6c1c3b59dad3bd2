#include "gas_solver/momentum/assembly.h"

#include <algorithm>

#include "gas_solver/boundary/unknown_faces.h"
#include "gas_solver/operators/limiter_van_leer.h"

namespace gasgrain {
namespace {

// Share of mu that multiplies a component's derivative along its own axis: 2 - 2/3.
constexpr double normal_stress = 4.0 / 3.0;
constexpr double dilatation = 2.0 / 3.0;

// Mass flux through the low side, along `axis`, of the control volume of the face at `o`; `s` is
// the stride along the component's axis. Holds for the component's own axis too.
inline double side_flux(const double* flux, std::ptrdiff_t o, std::ptrdiff_t s) {
  return 0.5 * (flux[o - s] + flux[o]);
}

// An axis across the component's own.
struct Across {
  Across(const GasState& state, int axis, double spacing)
      : flux(state.mass_flux[axis].data()),
        velocity(state.velocity[axis].data()),
        stride(state.void_fraction.stride(axis)),
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
      limited_(input.convection == Convection::tvd),
      sides_(input.sides),
      body_force_(Hydrostatic(input).body_force()),
      spacing_(input.grid.spacing()),
      face_void_fraction_(domain.box(), 1.0),
      addition_(domain.box()),
      gain_(domain.box()) {}

void MomentumAssembly::assemble(const GasState& state, int component, double step,
                                const std::vector<InflowFace>& inflow, Array3<MomentumRow>& rows) {
  if (limited_) limited_convection(state, component);
  inner_rows(state, component, step, rows);
  for (const bool high : {false, true}) {
    const int side = side_of(component, high);
    if (domain_.touches(side) && !sides_[side]->normal_velocity_given)
      outlet_rows(state, side, step, rows);
  }
  close_sides(component, rows);
  add_jets(state, component, inflow, rows);
  for_each_cell(unknown_faces(domain_, sides_, component), [&](int i, int j, int k) {
    double& diagonal = rows(i, j, k).inverse_diagonal;
    diagonal = 1.0 / diagonal;
  });
}

void MomentumAssembly::inner_rows(const GasState& state, int component, double step,
                                  Array3<MomentumRow>& rows) {
  const int d = component;
  const std::ptrdiff_t s = state.void_fraction.stride(d);
  const IndexBox faces = domain_.inner_faces(d);
  for_each_cell(faces.grown(1), [&](int i, int j, int k) {
    const auto o = state.void_fraction.offset(i, j, k);
    face_void_fraction_[o] = face_mean(state.void_fraction, o, s);
  });

  // Plain pointers and constants: what the loop reads stays in registers.
  const double* const eps = state.void_fraction.data();
  const double* const eps_face = face_void_fraction_.data();
  const double* const drag = state.drag_coefficient.data();
  const double* const source = state.drag_source[d].data();
  const double* const p = state.pressure.data();
  const double* const gain = gain_.data();
  const double* const u = state.velocity[d].data();
  const double* const flux = state.mass_flux[d].data();
  const auto [e1, e2] = plane_axes(d);
  const Across across1(state, e1, spacing_[e1]);
  const Across across2(state, e2, spacing_[e2]);
  const double mu = viscosity_;
  const double per_h = 1.0 / spacing_[d];
  const double normal = normal_stress * mu * per_h * per_h;
  const double inertia = density_ / step;
  const double body_force = body_force_[d];
  const int lo = side_of(d, false);
  const int hi = side_of(d, true);

  for (int k = faces.lo[2]; k < faces.hi[2]; ++k)
    for (int j = faces.lo[1]; j < faces.hi[1]; ++j) {
      std::ptrdiff_t o = rows.offset(faces.lo[0], j, k);
      for (int i = faces.lo[0]; i < faces.hi[0]; ++i, ++o) {
        const double eps_f = eps_face[o];
        double* const c = rows[o].coefficient.data();
        c[lo] = std::max(side_flux(flux, o, s), 0.0) * per_h + normal * eps[o - s];
        c[hi] = std::max(-side_flux(flux, o + s, s), 0.0) * per_h + normal * eps[o];
        double sum = c[lo] + c[hi];
        double stress = 0;
        // Along an axis e across: d/de (mu du_e/dd) - 2/3 d/dd (mu du_e/de), from the last step.
        const auto add = [&](const Across& e) {
          const std::ptrdiff_t t = e.stride;
          const double mu_lo = 0.5 * mu * (eps_f + eps_face[o - t]);
          const double mu_hi = 0.5 * mu * (eps_f + eps_face[o + t]);
          c[e.lo] = std::max(side_flux(e.flux, o, s), 0.0) * e.per_h + mu_lo * e.per_h * e.per_h;
          c[e.hi] =
              std::max(-side_flux(e.flux, o + t, s), 0.0) * e.per_h + mu_hi * e.per_h * e.per_h;
          sum += c[e.lo] + c[e.hi];
          const double here = e.velocity[o + t] - e.velocity[o];
          const double before = e.velocity[o + t - s] - e.velocity[o - s];
          stress += e.per_h * (mu_hi * (e.velocity[o + t] - e.velocity[o + t - s]) -
                               mu_lo * (e.velocity[o] - e.velocity[o - s]) -
                               dilatation * mu * (eps[o] * here - eps[o - s] * before));
        };
        add(across1);
        add(across2);
        rows[o].inverse_diagonal = inertia * eps_f + 0.5 * (drag[o - s] + drag[o]) + sum;
        rows[o].source = inertia * eps_f * u[o] + 0.5 * (source[o - s] + source[o]) +
                         eps_f * (body_force - (p[o] - p[o - s]) * per_h) + stress * per_h +
                         gain[o];
      }
    }
}

// What the limiter adds to the fluxes through the low sides, then its net gain of each control
// volume.
void MomentumAssembly::limited_convection(const GasState& state, int component) {
  const double* const u = state.velocity[component].data();
  const std::ptrdiff_t s = gain_.stride(component);
  const IndexBox faces = domain_.inner_faces(component);
  double* const addition = addition_.data();
  double* const gain = gain_.data();
  gain_.fill(0.0);
  for (int axis = 0; axis < 3; ++axis) {
    const double* const flux = state.mass_flux[axis].data();
    const std::ptrdiff_t t = gain_.stride(axis);
    const double per_h = 1.0 / spacing_[axis];
    IndexBox lows = faces;
    ++lows.hi[axis];  // the high sides of the last
    for (int k = lows.lo[2]; k < lows.hi[2]; ++k)
      for (int j = lows.lo[1]; j < lows.hi[1]; ++j) {
        const std::ptrdiff_t first = gain_.offset(lows.lo[0], j, k);
        const std::ptrdiff_t end = first + lows.extent(0);
        // Both directions of flow are computed, one of them times 0: cheaper than a branch.
        for (std::ptrdiff_t o = first; o < end; ++o) {
          const double f = side_flux(flux, o, s) * per_h;
          addition[o] = std::max(f, 0.0) * van_leer_addition(u[o - 2 * t], u[o - t], u[o]) +
                        std::min(f, 0.0) * van_leer_addition(u[o + t], u[o], u[o - t]);
        }
      }
    for (int k = faces.lo[2]; k < faces.hi[2]; ++k)
      for (int j = faces.lo[1]; j < faces.hi[1]; ++j) {
        const std::ptrdiff_t first = gain_.offset(faces.lo[0], j, k);
        const std::ptrdiff_t end = first + faces.extent(0);
        for (std::ptrdiff_t o = first; o < end; ++o) gain[o] += addition[o] - addition[o + t];
      }
  }
}

// The control volume is the half cell inside the side: its sides along the component's axis lie h /
// 2 apart, and eps, K and S are those of the cell.
void MomentumAssembly::outlet_rows(const GasState& state, int side, double step,
                                   Array3<MomentumRow>& rows) const {
  const int d = axis_of(side);
  const Array3<double>& eps = state.void_fraction;
  const Array3<double>& u = state.velocity[d];
  const std::ptrdiff_t s = eps.stride(d);
  const std::ptrdiff_t in = inward(side, s);
  const double outward = is_high(side) ? 1.0 : -1.0;
  const double half = 0.5 * spacing_[d];
  const double inertia = density_ / step;
  for_each_cell(domain_.side_faces(side), [&](int i, int j, int k) {
    const auto o = eps.offset(i, j, k);
    const auto cell = o + inner_cell_offset(side, s);
    MomentumRow& row = rows[o];
    row.coefficient.fill(0.0);
    const double from_inside =
        std::max(outward * 0.5 * (state.mass_flux[d][o] + state.mass_flux[d][o + in]), 0.0);
    row.coefficient[side_of(d, !is_high(side))] =
        from_inside / half + normal_stress * viscosity_ * eps[cell] / (half * spacing_[d]);
    double sum = row.coefficient[side_of(d, !is_high(side))];
    for (const int e : plane_axes(d)) {
      const std::ptrdiff_t t = eps.stride(e);
      const double he = spacing_[e];
      const double visc = viscosity_ * eps[cell] / (he * he);
      row.coefficient[side_of(e, false)] = std::max(state.mass_flux[e][cell], 0.0) / he + visc;
      row.coefficient[side_of(e, true)] = std::max(-state.mass_flux[e][cell + t], 0.0) / he + visc;
      sum += row.coefficient[side_of(e, false)] + row.coefficient[side_of(e, true)];
    }
    const double backflow = std::max(-outward * state.mass_flux[d][o], 0.0);
    sum += (1.0 - backflow_share) * backflow / half;
    row.inverse_diagonal = inertia * eps[cell] + state.drag_coefficient[cell] + sum;
    const double gradient = outward * (0.0 - state.pressure[cell]) / half;
    row.source = inertia * eps[cell] * u[o] + state.drag_source[d][cell] - eps[cell] * gradient;
  });
}

// What enters along a side carries no velocity along it, and the side's own shear is that of
// (0 - u) / (h / 2) where the gas sticks, else none: the coefficient stays in the diagonal, with a
// neighbour of velocity 0.
void MomentumAssembly::close_sides(int component, Array3<MomentumRow>& rows) const {
  const IndexBox unknown = unknown_faces(domain_, sides_, component);
  for (int side = 0; side < side_count; ++side) {
    const int axis = axis_of(side);
    if (axis == component || !domain_.touches(side)) continue;
    const double shear = viscosity_ / (spacing_[axis] * spacing_[axis]);
    const double factor = sides_[side]->sticks ? 2.0 : 0.0;
    for_each_cell(beside(unknown, side, domain_.own()), [&](int i, int j, int k) {
      MomentumRow& row = rows(i, j, k);
      row.inverse_diagonal += (factor - 1.0) * shear * face_void_fraction_(i, j, k);
      row.coefficient[side] = 0.0;
    });
  }
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
  for (const InflowFace& face : inflow) {
    if (axis_of(face.side) != component) continue;
    const Array3<double>& flux = state.mass_flux[component];
    const double into = is_high(face.side) ? -1.0 : 1.0;
    const auto o = flux.offset(face.face[0], face.face[1], face.face[2]);
    const auto next = o + inward(face.side, flux.stride(component));
    const double entering = density_ * face.volume_flux;
    const double shared = std::max(into * 0.5 * (flux[o] + flux[next]), 0.0);
    rows[next].coefficient[face.side] -= shared / h;
    rows[next].inverse_diagonal += (std::max(shared, entering) - shared) / h;
    rows[next].source += into * density_ * face.momentum_flux / h;
  }
}

}  // namespace gasgrain
