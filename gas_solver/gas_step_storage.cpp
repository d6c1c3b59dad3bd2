// What a run keeps in a checkpoint, and how it goes on from one.
#include "gas_solver/gas_step.h"
#include "gas_solver/io/checkpoint.h"

namespace gasgrain {
namespace {

// What a run cannot change on its way.
CheckpointChoices choices_of(const GasInput& input) {
  return {{"[gas] law", static_cast<double>(input.law)},
          {"[gas] model", static_cast<double>(input.model)},
          {"[time] scheme", static_cast<double>(input.scheme)},
          {"[turbulence] model", static_cast<double>(input.turbulence.model)}};
}

}  // namespace

void GasSolver::write_checkpoint(const std::string& file) {
  projection_.forget();
  CheckpointWriter out(file, domain_);
  out.choices(choices_of(input_));
  exchange_with(out);
  out.finish();
}

void GasSolver::read_checkpoint(const std::string& file) {
  CheckpointReader in(file, domain_);
  in.require_choices(choices_of(input_));
  exchange_with(in);
  for (Array3<double>* field : {&state_.void_fraction, &state_.drag_coefficient, &state_.pressure,
                                &state_.density, &state_.mass_source, &state_.drag_source[0],
                                &state_.drag_source[1], &state_.drag_source[2]}) {
    if (field->size() == 0) continue;
    halo_.exchange({field});
    fill_ghost_cells(domain_, *field);
  }
  fill_velocity_layers();
  if (turbulence_) turbulence_->restore(state_);
  void_fraction_to_ = state_.void_fraction;
  for (CellVector* flux : {&state_.mass_flux, &state_.mass_flux_before})
    for (int d = 0; d < 3; ++d) {
      if ((*flux)[d].size() == 0) continue;
      halo_.exchange({&(*flux)[d]});
      fill_ghost_fluxes(domain_, d, (*flux)[d]);
    }
  projection_.forget();
}

// Everything a run needs to go on, in the order of the file.
template <class File>
void GasSolver::exchange_with(File& file) {
  constexpr int of_cells = -1;
  file.number("time", time_);
  file.flag("has_void_fraction", has_void_fraction_);
  file.field("void_fraction", of_cells, state_.void_fraction);
  file.field("drag_coefficient", of_cells, state_.drag_coefficient);
  file.field("pressure", of_cells, state_.pressure);
  if (state_.density.size() > 0) file.field("density", of_cells, state_.density);
  if (state_.mass_source.size() > 0) file.field("mass_source", of_cells, state_.mass_source);
  file.number("last_step", levels_.last_step);
  for (int d = 0; d < 3; ++d) {
    const char axis = "xyz"[d];
    file.field(std::string("drag_source_") + axis, of_cells, state_.drag_source[d]);
    file.field(std::string("velocity_") + axis, d, state_.velocity[d]);
    file.field(std::string("mass_flux_") + axis, d, state_.mass_flux[d]);
    if (state_.mass_flux_before[d].size() > 0)
      file.field(std::string("mass_flux_before_") + axis, d, state_.mass_flux_before[d]);
    file.field(std::string("mean_velocity_") + axis, of_cells, means_.velocity[d]);
    file.field(std::string("mean_pressure_gradient_") + axis, of_cells,
               means_.pressure_gradient[d]);
  }
  if (turbulence_) turbulence_->exchange_with(file);
}

}  // namespace gasgrain
