// What fix couple/gas writes to history.csv: a line a coupling.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "coupling/exchange/bed_measures.h"
#include "fix_cfd_coupling/fixes/fix_couple_gas.h"
#include "fix_cfd_coupling/fixes/host_session.h"
// --
#include "atom.h"
#include "domain.h"
#include "force.h"
#include "neigh_list.h"
#include "pair.h"
#include "update.h"

namespace LAMMPS_NS {

namespace {

// Share of the solid volume that lies under the bed height: single grains thrown above the bed are
// no bed; with 36,500 grains this leaves out the highest 180.
constexpr double bed_height_share = 0.995;

// Columns of history.csv (docs/liggghts.md), in the order of record(); the ledger's
// and the probes' pressures follow.
constexpr std::array<const char*, 34> history_columns{"time_s",
                                                      "step",
                                                      "particles",
                                                      "parcels",
                                                      "bed_height_m",
                                                      "surface_height_m",
                                                      "bubble_diameter_m",
                                                      "kinetic_energy_J",
                                                      "momentum_x_Ns",
                                                      "momentum_y_Ns",
                                                      "momentum_z_Ns",
                                                      "max_overlap",
                                                      "courant",
                                                      "gas_substeps",
                                                      "pressure_iterations",
                                                      "outer_iterations",
                                                      "continuity_residual",
                                                      "mass_imbalance",
                                                      "moved_cells",
                                                      "too_dense",
                                                      "beyond_walls",
                                                      "disturbance_cut",
                                                      "left_box",
                                                      "cells_crossed",
                                                      "interval_too_long",
                                                      "momentum_not_converged",
                                                      "pressure_not_converged",
                                                      "outer_not_converged",
                                                      "turbulence_clamped",
                                                      "turbulence_not_converged",
                                                      "backflow_faces",
                                                      "mass_inflow_kg_s",
                                                      "mass_outflow_kg_s",
                                                      "bytes_of_fields"};

}  // namespace

void FixCoupleGas::open_history() {
  const auto& gas = coupled_->gas();
  std::vector<std::string> columns(history_columns.begin(), history_columns.end());
  for (const auto& name : gasgrain::Ledger(effects_).column_names()) columns.push_back(name);
  for (int n = 0; n < gas.probes; ++n)
    columns.push_back(fmt::format("p_{:g}m_Pa", gas.probe_heights[n]));
  if (gasgrain::session().local.is_root())
    history_ = std::make_unique<gasgrain::HistoryFile>(output_, columns, resumed_);
}

// A line of history: the bed and the gas at this moment, before the coupling that starts here.
void FixCoupleGas::record() {
  const gasgrain::Stopwatch watch(coupled_->costs(), coupled_->costs().task("coupling: history"));
  const auto& local = gasgrain::session().local;
  const Overlap deepest = greatest_overlap();
  watch_state(deepest);
  // At the beginning of a further run the line is there, and the grains may be others.
  if (update->ntimestep == last_recorded_) return;
  last_recorded_ = update->ntimestep;
  gasgrain::BedMeasures bed(2, domain->boxlo[2], domain->boxhi[2]);
  bed.add(particles());
  local.sum_in_place(bed.values());
  if (bed.count() > 0.0) check_contacts();
  watch_count(bed.parcels());
  const double overlap = local.max(deepest.ratio);
  const auto clamps = coupled_->take_clamps();
  const long too_dense = local.sum(clamps.too_dense);
  const long beyond_walls = local.sum(clamps.beyond_walls);
  const long disturbance_cut = local.sum(clamps.disturbance_cut);
  const long left_box = local.sum(std::exchange(left_box_, 0));
  const double interval = every_ * update->dt;
  const gasgrain::IntervalNeed& need = interval_watch_.last;
  const long bytes = local.sum(coupled_->take_bytes());
  const auto ledger = coupled_->whole_ledger(particles(), records_);
  const gasgrain::Report& gas = coupled_->report();
  shown_ = {bed.height(bed_height_share), gas.bubble_diameter, ledger.residual(), gas.courant_max};
  if (!history_) return;
  const auto count = [](auto n) { return static_cast<double>(n); };
  std::vector<double> line{count(update->ntimestep - start_) * update->dt,
                           count(update->ntimestep),
                           bed.count(),
                           bed.parcels(),
                           shown_[0],
                           gas.surface_height,
                           gas.bubble_diameter,
                           bed.kinetic_energy(),
                           bed.momentum()[0],
                           bed.momentum()[1],
                           bed.momentum()[2],
                           overlap,
                           gas.courant_max,
                           count(gas.substeps),
                           count(gas.pressure_iterations),
                           count(gas.outer_iterations),
                           gas.continuity_residual,
                           gas.mass_imbalance,
                           count(gas.moved_cells),
                           count(too_dense),
                           count(beyond_walls),
                           count(disturbance_cut),
                           count(left_box),
                           need.cells_crossed(interval),
                           need.too_long(interval) ? 1.0 : 0.0,
                           count(gas.momentum_not_converged),
                           count(gas.pressure_not_converged),
                           count(gas.outer_not_converged),
                           count(gas.turbulence_clamped),
                           count(gas.turbulence_not_converged),
                           count(gas.backflow_faces),
                           gas.mass_inflow,
                           gas.mass_outflow,
                           count(bytes)};
  for (const double value : ledger.column_values()) line.push_back(value);
  for (int n = 0; n < coupled_->gas().probes; ++n) line.push_back(gas.probe_pressure[n]);
  history_->write(line);
}

// Of grains on grains, relative to the smaller diameter; walls are not looked at.
FixCoupleGas::Overlap FixCoupleGas::greatest_overlap() const {
  const Pair* pair = force->pair_match("gran", 0);
  if (pair == nullptr || pair->list == nullptr) return {};
  const NeighList& list = *pair->list;
  Overlap greatest;
  for (int n = 0; n < list.inum; ++n) {
    const int i = list.ilist[n];
    for (int m = 0; m < list.numneigh[i]; ++m) {
      const int j = list.firstneigh[i][m] & NEIGHMASK;
      const double dx = atom->x[i][0] - atom->x[j][0];
      const double dy = atom->x[i][1] - atom->x[j][1];
      const double dz = atom->x[i][2] - atom->x[j][2];
      const double touch = atom->radius[i] + atom->radius[j];
      const double squared = dx * dx + dy * dy + dz * dz;
      if (squared >= touch * touch) continue;
      const double overlap = touch - std::sqrt(squared);
      const double ratio = overlap / (2.0 * std::min(atom->radius[i], atom->radius[j]));
      if (ratio > greatest.ratio) greatest = {ratio, i, j};
    }
  }
  return greatest;
}

}  // namespace LAMMPS_NS
