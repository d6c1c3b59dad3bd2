#include "gas_solver/coupling_port.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "coupling/base/error.h"
#include "gas_solver/packing_limit.h"
#include "gas_solver/plane_of_spheres.h"

namespace gasgrain {
namespace {

// Everything this solver can lend and take.
constexpr FieldSet all_fields() {
  FieldSet set;
  for (const auto& field : gas_field_list) set.add(field.field);
  return set;
}

GasHello first_words(const GasSolver& solver, const GasInput& input,
                     const std::string& input_file) {
  GasHello hello;
  put_text(hello.version, GASGRAIN_VERSION);
  put_text(hello.input_file, input_file);
  const BoxGrid& grid = solver.grid();
  for (int d = 0; d < 3; ++d) {
    hello.grid_lo[d] = grid.lo[d];
    hello.grid_hi[d] = grid.hi[d];
    hello.periodic[d] = grid.periodic[d] ? 1 : 0;
  }
  hello.cells = grid.cells;
  hello.density = input.density;
  hello.viscosity = input.viscosity;
  hello.plane_of_spheres = input.plane_of_spheres > 0 ? 1 : 0;
  hello.whole_pressure_gradient = input.model == GasModel::b ? 1 : 0;
  hello.lends = hello.takes = all_fields().bits();
  hello.probes =
      static_cast<int>(std::min(input.pressure_probes.size(), hello.probe_heights.size()));
  std::copy_n(input.pressure_probes.begin(), hello.probes, hello.probe_heights.begin());
  return hello;
}

// The means that go to the particles.
struct LentVector {
  GasField field;
  const CellVector& (GasSolver::*mean)() const;
};

constexpr std::array<LentVector, 5> lent_vectors{{
    {GasField::velocity, &GasSolver::mean_velocity},
    {GasField::pressure_gradient, &GasSolver::mean_pressure_gradient},
    {GasField::vorticity, &GasSolver::mean_vorticity},
    {GasField::acceleration, &GasSolver::mean_acceleration},
    {GasField::viscous_force, &GasSolver::mean_viscous_force},
}};

}  // namespace

CouplingPort::CouplingPort(GasSolver& solver, const GasInput& input, const std::string& input_file)
    : solver_(solver),
      local_(solver.domain().comm()),
      plane_of_spheres_(input.plane_of_spheres),
      hello_(first_words(solver, input, input_file)),
      halo_(solver.domain()),
      cost_transport_(solver.costs().task("transport")),
      cost_wait_(solver.costs().task("waiting for the particles")),
      cost_solids_(solver.costs().task("solids above the limit")),
      cost_fields_(solver.costs().task("fields of the grains")) {}

GasHello CouplingPort::hello() const {
  GasHello hello = hello_;
  hello.time = solver_.time();
  return hello;
}

void CouplingPort::meet(const DemHello& dem) {
  lent_ = FieldSet(dem.lent);
  taken_ = FieldSet(dem.taken);
  solver_.ask_for({lent_.has(GasField::vorticity), lent_.has(GasField::acceleration),
                   lent_.has(GasField::viscous_force)});
  FieldSet used = lent_.united(taken_).add(GasField::void_fraction);
  if (taken_.has(GasField::drag_source)) used.add(GasField::drag_coefficient);
  fields_ = FieldStore(used, solver_.own());
}

void CouplingPort::begin(const Command& command) {
  constexpr double tolerance = 1e-3;  // of the interval: sums of steps differ by round-off only
  if (std::abs(command.time - solver_.time()) > tolerance * command.interval)
    fail(
        "the DEM program couples at {} s, the gas is at {} s: a coupling was skipped. Do not use "
        "'run ... pre no' with couple/gas.",
        command.time, solver_.time());
  command_ = command;
}

void CouplingPort::route(const std::vector<IndexBox>& tiles, MPI_Comm channel, Sends sends) {
  transport_.finish_sends();
  transport_ =
      RouteTransport(channel, make_routes(solver_.grid(), solver_.own(), tiles, true), true, sends);
}

GasReport CouplingPort::advance() {
  if (taken_.has(GasField::drag_source)) take_drag();
  GasReport done = solver_.advance(command_.interval);
  send_lent(lent_.without(lent_early));
  return done;
}

void CouplingPort::send_lent(FieldSet fields) {
  const Stopwatch watch(solver_.costs(), cost_transport_);
  for (const LentVector& lent : lent_vectors)
    if (fields.has(lent.field)) fields_.vector(lent.field) = (solver_.*lent.mean)();
  const FieldList list = fields_.components(fields);
  if (!list.empty()) transport_.send(list, lent_tag);
}

void CouplingPort::take_solids() {
  const FieldList taken = fields_.components(taken_.common(taken_early));
  for (Array3<double>* field : taken) field->fill(0.0);
  {
    const Stopwatch watch(solver_.costs(), cost_wait_);
    transport_.receive(taken, solids_tag);
  }
  Array3<double> solids = solids_in_cells();
  {
    const Stopwatch watch(solver_.costs(), cost_solids_);
    moved_cells_ = local_.sum(move_solids_above_limit(solver_.domain(), halo_, solids));
  }
  {
    const Stopwatch watch(solver_.costs(), cost_fields_);
    Array3<double>& void_fraction = fields_.scalar(GasField::void_fraction);
    for_each_cell(solver_.own(),
                  [&](int i, int j, int k) { void_fraction(i, j, k) = 1.0 - solids(i, j, k); });
    solver_.set_void_fraction(void_fraction);
  }
  send_lent(command_.fresh != 0 ? lent_ : lent_.common(lent_early));
}

// The solid fraction of each cell, and the means over the grains that the DEM ranks ask back.
Array3<double> CouplingPort::solids_in_cells() {
  const Stopwatch watch(solver_.costs(), cost_fields_);
  const Array3<double>& solid_volume = fields_.scalar(GasField::solid_volume);
  if (lent_.has(GasField::solids_velocity))
    for (int d = 0; d < 3; ++d) {
      const Array3<double>& flux = fields_.vector(GasField::solid_flux)[d];
      Array3<double>& velocity = fields_.vector(GasField::solids_velocity)[d];
      for (std::size_t n = 0; n < velocity.size(); ++n)
        velocity[n] = solid_volume[n] > 0 ? flux[n] / solid_volume[n] : 0.0;
    }
  if (lent_.has(GasField::sauter_diameter)) {
    const Array3<double>& surface = fields_.scalar(GasField::solid_surface);
    Array3<double>& diameter = fields_.scalar(GasField::sauter_diameter);
    for (std::size_t n = 0; n < diameter.size(); ++n)
      diameter[n] = surface[n] > 0 ? 6.0 * solid_volume[n] / surface[n] : 0.0;
  }
  Array3<double> solids(solver_.domain().box());
  const double cell = solver_.grid().cell_volume();
  for_each_cell(solver_.own(), [&](int i, int j, int k) {
    const double fraction = solid_volume(i, j, k) / cell;
    solids(i, j, k) = plane_of_spheres_ > 0 ? solids_in_space(fraction) : fraction;
  });
  return solids;
}

void CouplingPort::take_drag() {
  const FieldList taken = fields_.components(taken_.without(taken_early));
  for (Array3<double>* field : taken) field->fill(0.0);
  {
    const Stopwatch watch(solver_.costs(), cost_wait_);
    transport_.receive(taken, drag_tag);
  }
  const Stopwatch watch(solver_.costs(), cost_fields_);
  solver_.set_drag(fields_.scalar(GasField::drag_coefficient),
                   fields_.vector(GasField::drag_source));
}

Report CouplingPort::report_of(const GasReport& done) const {
  Report report;
  report.time = done.time;
  report.substeps = done.substeps;
  report.courant_max = done.courant_max;
  report.pressure_iterations = done.pressure_iterations;
  report.continuity_residual = done.continuity_residual;
  report.mass_inflow = done.mass_inflow;
  report.mass_outflow = done.mass_outflow;
  report.backflow_faces = done.backflow_faces;
  report.outer_iterations = done.outer_iterations;
  report.mass_imbalance = done.mass_imbalance;
  report.outer_not_converged = done.outer_not_converged;
  report.turbulence_clamped = done.turbulence_clamped;
  report.turbulence_not_converged = done.turbulence_not_converged;
  report.momentum_not_converged = done.momentum_not_converged;
  report.pressure_not_converged = done.pressure_not_converged;
  report.moved_cells = moved_cells_;
  for (int d = 0; d < 3; ++d) report.drag_impulse[d] = done.drag_impulse[d];
  report.bubble_diameter = done.bubble_diameter;
  report.surface_height = done.surface_height;
  std::copy_n(done.probe_pressure.begin(),
              std::min(done.probe_pressure.size(), report.probe_pressure.size()),
              report.probe_pressure.begin());
  return report;
}

}  // namespace gasgrain
