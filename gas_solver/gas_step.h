// The gas solver as its users see it: lend it void fraction and drag, let it advance, take means
// back.
//
// A step of time, in order: void fraction and inflow of its end; prediction of the velocity with
// the old pressure; projection, which carries the drag implicitly (SIMPLE and SIMPLEC repeat these
// two); sums for the means. An interval of the coupling is split into equal steps that respect
// [time] step and courant_max.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "coupling/base/cost_ledger.h"
#include "gas_solver/boundary/inflow.h"
#include "gas_solver/gas_input.h"
#include "gas_solver/grid/gas_state.h"
#include "gas_solver/grid/halo.h"
#include "gas_solver/grid/hydrostatic.h"
#include "gas_solver/measures/front_view.h"
#include "gas_solver/measures/interval_means.h"
#include "gas_solver/measures/probes.h"
#include "gas_solver/momentum/predictor.h"
#include "gas_solver/pressure/projection.h"
#include "gas_solver/time_levels.h"
#include "gas_solver/turbulence/turbulence.h"

namespace gasgrain {

// What an interval did. Flows and faces are those of its last step.
struct GasReport {
  double time = 0;  // at the interval's end [s]
  int substeps = 0;
  double step = 0;                 // shortest of them [s]
  double courant_max = 0;          // greatest |u| dt / h
  int outer_iterations = 0;        // sum; one a step with the projection
  int pressure_iterations = 0;     // sum
  double mass_defect = 0;          // of the last prediction of a step, as continuity_residual
  double continuity_residual = 0;  // greatest of a cell, relative to the flow through the grid
  double mass_inflow = 0;          // [kg/s]
  double mass_outflow = 0;         // [kg/s]
  double mass = 0;                 // of the gas in the grid, at the end [kg]
  // Inflow + sources - outflow - storage of the whole grid, relative; greatest of the steps.
  double mass_imbalance = 0;
  long backflow_faces = 0;            // outlet faces where gas comes in
  long momentum_not_converged = 0;    // components that missed the tolerance, sum
  long outer_not_converged = 0;       // steps that used all outer iterations, sum
  long pressure_not_converged = 0;    // steps whose continuity missed the tolerance, sum
  long turbulence_clamped = 0;        // values of k, e, mu_t cut or raised, sum
  long turbulence_not_converged = 0;  // equations of k, e that missed the tolerance, sum
  // What the gas lost to the grains by drag [N s]: dt sum of (K u - S) V with the mean velocity.
  Vec3 drag_impulse = Vec3::Zero();
  std::vector<double> probe_pressure;  // above the outlet's [Pa], as [output] pressure_probes
  double bubble_diameter = 0;          // [m]
  double surface_height = 0;           // z [m]
};

class GasSolver {
 public:
  GasSolver(const GasInput& input, const Communicator& comm);

  [[nodiscard]] const BoxGrid& grid() const { return domain_.grid(); }
  [[nodiscard]] const IndexBox& own() const { return domain_.own(); }
  [[nodiscard]] const Domain& domain() const { return domain_; }
  [[nodiscard]] double time() const { return time_; }

  // Void fraction at the end of the next interval, over own(); within it eps changes linearly. The
  // first one holds from the beginning. Collective.
  void set_void_fraction(const Array3<double>& eps);
  // K [kg/(m3 s)] and S [N/m3] of the next interval, over own(): the gas loses K u - S. Collective.
  void set_drag(const Array3<double>& coefficient, const CellVector& source);

  // S_m [kg/(m3 s)] of the next intervals, over own(), in place of [[mass_source]]. Gas that
  // appears brings no momentum: what it brings belongs to the source of set_drag().
  void set_mass_source(const Array3<double>& source);

  // Collective.
  GasReport advance(double interval);

  // Means of the last interval over own(), see interval_means.h.
  [[nodiscard]] const CellVector& mean_velocity() const { return means_.velocity; }
  [[nodiscard]] const CellVector& mean_pressure_gradient() const {
    return means_.pressure_gradient;
  }
  // Further means are made from the next interval on, and are empty unless asked for.
  void ask_for(const FurtherMeans& further) { means_.ask_for(further); }
  [[nodiscard]] const CellVector& mean_vorticity() const { return means_.vorticity; }
  [[nodiscard]] const CellVector& mean_acceleration() const { return means_.acceleration; }
  [[nodiscard]] const CellVector& mean_viscous_force() const { return means_.viscous_force; }

  // Fields at the present time over own().
  [[nodiscard]] Array3<double> void_fraction() const;
  [[nodiscard]] Array3<double> pressure() const;  // with the hydrostatic part [Pa]
  [[nodiscard]] CellVector cell_velocity() const;
  // Fields of cells that the choices of the run add to these, over Domain::box(): "density",
  // "turbulence_k", ...
  using NamedField = std::pair<std::string, const Array3<double>*>;
  [[nodiscard]] std::vector<NamedField> further_fields() const;
  [[nodiscard]] const GasState& state() const { return state_; }
  GasState& state() { return state_; }
  // Null where [turbulence] names no model.
  [[nodiscard]] Turbulence* turbulence() { return turbulence_ ? &*turbulence_ : nullptr; }

  // HDF5. A run that goes on from a checkpoint is bitwise that which wrote it, on as many ranks.
  // Collective; throws Error when the file is of another grid or version.
  void write_checkpoint(const std::string& file);
  void read_checkpoint(const std::string& file);

  // What the solvers learnt is forgotten: the next step is that of a run which begins here.
  void forget() { projection_.forget(); }

  // Seconds by task: "setup", "boundaries", "turbulence", "momentum", "pressure", "means",
  // "measures".
  [[nodiscard]] CostLedger& costs() { return costs_; }

 private:
  // `share`: of what is left of the interval.
  void step(double step, double share, GasReport& report);
  const std::vector<InflowFace>& begin_step(double step, double share);
  void predict_and_project(double step, const std::vector<InflowFace>& inflow, GasReport& report);
  [[nodiscard]] double next_step(double left, double interval);
  void fill_velocity_layers();
  void measure(GasReport& report);
  [[nodiscard]] double gas_mass() const;
  template <class File>
  void exchange_with(File& file);

  CostLedger costs_;  // the first: its age is the solver's
  GasInput input_;
  Domain domain_;
  Halo halo_;
  Hydrostatic hydrostatic_;
  Inflow inflow_;
  GasState state_;
  TimeLevels levels_;
  std::optional<Turbulence> turbulence_;
  Predictor predictor_;
  Projection projection_;
  FrontView front_view_;
  PressureProbes probes_;
  IntervalMeans means_;

  double time_ = 0;
  bool has_void_fraction_ = false;
  Array3<double> void_fraction_to_;  // at the interval's end

  std::size_t task_setup_;
  std::size_t task_boundaries_;
  std::size_t task_turbulence_ = 0;
  std::size_t task_momentum_;
  std::size_t task_pressure_;
  std::size_t task_means_;
  std::size_t task_measures_;
};

}  // namespace gasgrain
