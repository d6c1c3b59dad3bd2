#include "gas_solver/momentum/finish_rows.h"

#include "coupling/base/listed.h"
#include "gas_solver/operators/quantity.h"

namespace gasgrain {
namespace {

double weighted_neighbours(const MomentumRow& row, const Array3<double>& u, std::ptrdiff_t o) {
  double sum = 0;
  for (int d = 0; d < 3; ++d) {
    const std::ptrdiff_t t = u.stride(d);
    sum += row.coefficient[side_of(d, false)] * u[o - t] +
           row.coefficient[side_of(d, true)] * u[o + t];
  }
  return sum;
}

}  // namespace

RowFinish::RowFinish(const Domain& domain, const GasInput& input)
    : domain_(domain),
      sides_(input.sides),
      density_(input.density),
      theta_(time_weight(input.scheme)),
      whole_gradient_(input.model == GasModel::b),
      method_(input.pressure_velocity) {
  if (method_ == PressureVelocity::projection) return;
  relax_ = input.relax_velocity;
  mobility_ = make_vector(domain.box());
}

void RowFinish::finish(const GasState& state, int component, const MomentumStep& step,
                       const Array3<double>& face_void_fraction, Array3<MomentumRow>& rows) {
  const Array3<double>& eps = state.momentum_void_fraction();
  const std::ptrdiff_t s = eps.stride(component);
  const double per_step = 1.0 / step.length;
  visit_apart(
      [&](const auto& rho) {
        const double* const eps_face = face_void_fraction.data();
        finish_faces(
            domain_.inner_faces(component), component, state, step,
            [&](std::ptrdiff_t o) { return face_value(rho, o, s) * per_step * eps_face[o]; },
            [&](std::ptrdiff_t o) { return eps_face[o]; }, rows);
        for (const bool high : {false, true}) {
          const int side = side_of(component, high);
          if (!domain_.touches(side) || sides_[side]->normal_velocity_given) continue;
          const std::ptrdiff_t inside = inner_cell_offset(side, s);
          finish_faces(
              domain_.side_faces(side), component, state, step,
              [&](std::ptrdiff_t o) { return rho(o + inside) * per_step * eps[o + inside]; },
              [&](std::ptrdiff_t o) { return eps[o + inside]; }, rows);
        }
      },
      quantity(state.density, density_));
}

void RowFinish::share_mobility(Halo& halo) {
  if (method_ != PressureVelocity::projection)
    halo.exchange({&mobility_[0], &mobility_[1], &mobility_[2]});
}

template <class Mass, class Share>
void RowFinish::finish_faces(const IndexBox& faces, int component, const GasState& state,
                             const MomentumStep& step, const Mass& mass, const Share& share,
                             Array3<MomentumRow>& rows) {
  const Array3<double>& before = step.before[component];
  const Array3<double>& iterate = state.velocity[component];
  const bool mean_in_time = theta_ < 1.0;
  const bool relaxed = relax_ < 1.0;
  const bool keeps_mobility = method_ != PressureVelocity::projection;
  for_each_cell(faces, [&](int i, int j, int k) {
    const auto o = before.offset(i, j, k);
    MomentumRow& row = rows(i, j, k);
    const double m = mass(o);
    double diagonal = row.inverse_diagonal;  // R
    double source = row.source + m * before[o];
    if (mean_in_time) {
      source -= (1 - theta_) * (diagonal * before[o] - weighted_neighbours(row, before, o));
      for (double& c : row.coefficient) c *= theta_;
      diagonal *= theta_;
    }
    diagonal += m;
    if (relaxed) {
      diagonal /= relax_;
      source += (1 - relax_) * diagonal * iterate[o];
    }
    if (keeps_mobility) {
      double denominator = diagonal;
      if (method_ == PressureVelocity::simplec)
        for (const double c : row.coefficient) denominator -= c;
      mobility_[component][o] = (whole_gradient_ ? 1.0 : share(o)) / denominator;
    }
    row.source = source;
    row.inverse_diagonal = 1.0 / diagonal;
  });
}

}  // namespace gasgrain
