#include "gas_solver/momentum/assembly.h"
#include "coupling/base/listed.h"

#include <algorithm>

namespace gasgrain {
namespace {

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

}  // namespace

MomentumAssembly::MomentumAssembly(const Domain& domain, const GasInput& input)
    : domain_(domain),
      density_(input.density),
      viscosity_(input.viscosity),
      whole_gradient_(input.model == GasModel::b),
      sides_(domain, input),
      gravity_at_rest_(Hydrostatic(input).gravity_at_rest()),
      gravity_body_(Hydrostatic(input).gravity_body()),
      compressibility_(Hydrostatic(input).compressibility()),
      spacing_(input.grid.spacing()),
      convection_(domain, input),
      face_void_fraction_(domain.box(), 1.0) {}

void MomentumAssembly::assemble(const GasState& state, int component, const CellVector& lagged,
                                const std::vector<InflowFace>& inflow, const Turbulence* turbulence,
                                Array3<MomentumRow>& rows) {
  const Array3<double> no_field;
  const Quantity viscosity =
      quantity(turbulence != nullptr ? turbulence->viscosity() : no_field, viscosity_);
  convection_.evaluate(state.convecting_flux(), lagged[component], component, inflow);
  visit_apart(
      [&](const auto& rho, const auto& mu) { inner_rows(state, component, lagged, rho, mu, rows); },
      quantity(state.density, density_), viscosity);
  if (state.mass_source.size() > 0) add_mass_sources(state, component, rows);
  sides_.add(state, component, viscosity, face_void_fraction_, inflow, turbulence, rows);
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

void MomentumAssembly::add_mass_sources(const GasState& state, int component,
                                        Array3<MomentumRow>& rows) const {
  const std::ptrdiff_t s = state.mass_source.stride(component);
  for_each_cell(domain_.inner_faces(component), [&](int i, int j, int k) {
    const auto o = state.mass_source.offset(i, j, k);
    rows(i, j, k).inverse_diagonal +=
        0.5 * (std::max(state.mass_source[o - s], 0.0) + std::max(state.mass_source[o], 0.0));
  });
}

}  // namespace gasgrain
