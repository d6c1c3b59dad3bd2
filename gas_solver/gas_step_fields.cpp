// The fields of the present time, as output wants them.
#include "gas_solver/gas_step.h"

namespace gasgrain {

Array3<double> GasSolver::void_fraction() const {
  Array3<double> field(own());
  for_each_cell(own(),
                [&](int i, int j, int k) { field(i, j, k) = state_.void_fraction(i, j, k); });
  return field;
}

Array3<double> GasSolver::pressure() const {
  Array3<double> field(own());
  for_each_cell(own(), [&](int i, int j, int k) {
    field(i, j, k) = state_.pressure(i, j, k) + hydrostatic_.pressure(i, j, k);
  });
  return field;
}

std::vector<GasSolver::NamedField> GasSolver::further_fields() const {
  std::vector<NamedField> fields;
  if (state_.density.size() > 0) fields.emplace_back("density", &state_.density);
  if (!turbulence_) return fields;
  fields.emplace_back("viscosity", &turbulence_->viscosity());
  if (const KEpsilon* model = turbulence_->k_epsilon()) {
    fields.emplace_back("turbulence_k", &model->k());
    fields.emplace_back("turbulence_epsilon", &model->epsilon());
  }
  return fields;
}

CellVector GasSolver::cell_velocity() const {
  CellVector field{Array3<double>(own()), Array3<double>(own()), Array3<double>(own())};
  for (int d = 0; d < 3; ++d) {
    const Array3<double>& u = state_.velocity[d];
    for_each_cell(own(), [&](int i, int j, int k) {
      const auto o = u.offset(i, j, k);
      field[d](i, j, k) = 0.5 * (u[o] + u[o + u.stride(d)]);
    });
  }
  return field;
}

}  // namespace gasgrain
