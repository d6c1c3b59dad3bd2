// The ledger of fix liquid: what it counts, writes and says.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>

#include "coupling/base/error.h"
#include "fix_cfd_coupling/dem_physics/liquid/saturation.h"
#include "fix_cfd_coupling/fixes/fix_liquid.h"
#include "fix_cfd_coupling/fixes/fix_liquid_bridges.h"
#include "fix_cfd_coupling/fixes/host_error.h"
// --
#include "atom.h"
#include "comm.h"
#include "update.h"

namespace LAMMPS_NS {

using gasgrain::liquid::LiquidTotals;
using gasgrain::liquid::StoredBridge;

LiquidTotals FixLiquid::totals_of_rank() const {
  LiquidTotals t;
  long double films = 0.0, bridges = 0.0, on_walls = 0.0;
  for (int k = 0; k < atom->nlocal; ++k) {
    films += film_[k];
    for (const auto& wall : walls_) on_walls += std::max(0.0, wall->slot(k).bridge.volume);
    t.solid += solid_volume(k);
    if (!wet_) continue;
    if (saturation(k) > gasgrain::liquid::pendular_up_to) t.beyond_pendular += 1.0;
    t.greatest_saturation = std::max(t.greatest_saturation, saturation(k));
    for (const auto& wall : walls_) t.count += wall->slot(k).bridge.stands() ? 1.0 : 0.0;
  }
  // A pair of two ranks is in the lists of both.
  for_each_bridge([&](int, int j, const StoredBridge& b) {
    const double share = j < atom->nlocal ? 1.0 : 0.5;
    bridges += share * b.volume;
    t.count += share;
  });
  t.films = static_cast<double>(films);
  t.bridges = static_cast<double>(bridges);
  t.wall_bridges = static_cast<double>(on_walls);
  if (comm->me == 0)
    for (const auto& wall : walls_) t.walls += wall->film().volume;
  t.came_in = new_liquid_;
  t.gone = gone_liquid_;
  t.grains = atom->nlocal;
  t.grains_came = new_grains_;
  t.grains_gone = gone_grains_;
  t.formed = counts_.formed;
  t.broken = counts_.broken;
  t.cut_short = counts_.cut_short;
  t.lost_sight = counts_.lost_sight;
  t.held_back = held_back_;
  return t;
}

// Sums over all ranks and books them; ends what was counted since the last time.
LiquidTotals FixLiquid::take_stock() {
  const LiquidTotals mine = totals_of_rank();
  auto values = mine.values();
  MPI_Allreduce(MPI_IN_PLACE, values.data(), static_cast<int>(values.size()), MPI_DOUBLE, MPI_SUM,
                world);
  LiquidTotals all = LiquidTotals::of(values);
  MPI_Allreduce(&mine.greatest_saturation, &all.greatest_saturation, 1, MPI_DOUBLE, MPI_MAX, world);
  new_liquid_ = new_grains_ = gone_liquid_ = gone_grains_ = held_back_ = 0.0;
  counts_ = {};
  return all;
}

// At the start of each run. What changed between two runs, the script did: `set`, `delete_atoms`.
void FixLiquid::begin_ledger() {
  const LiquidTotals now = take_stock();
  if (!began_) {
    began_ = true;
    if (!resumed_) {
      ledger_ = {};
      ledger_.at_first = now.liquid();
      ledger_.grains = now.grains;
      return;
    }
  }
  ledger_.book(now);
  const double excess = now.liquid() - (ledger_.at_first + ledger_.came_in - ledger_.gone);
  // Round-off is not the script's doing.
  if (std::abs(excess) <= 1e-12 * now.liquid()) return;
  (excess > 0.0 ? ledger_.came_in : ledger_.gone) += std::abs(excess);
  host_message(
      fmt::format("fix liquid: between two runs the script has {} {:.6g} m3 of "
                  "liquid.",
                  excess > 0.0 ? "added" : "taken away", std::abs(excess)));
}

void FixLiquid::record() {
  const LiquidTotals t = take_stock();
  ledger_.book(t);
  const double residual = ledger_.residual(t.liquid());
  shown_ = {t.films,  t.bridges, t.wall_bridges,       t.walls, ledger_.came_in, ledger_.gone,
            residual, t.count,   t.greatest_saturation};
  shown_at_ = update->ntimestep;
  warn(t, residual);
  if (settings_.output.empty() || comm->me != 0 || update->ntimestep == written_at_) return;
  written_at_ = update->ntimestep;
  const bool append = resumed_ || file_begun_;
  file_begun_ = true;
  const std::filesystem::path path(settings_.output);
  std::error_code ignored;
  if (path.has_parent_path()) std::filesystem::create_directories(path.parent_path(), ignored);
  const bool is_new = !append || !std::filesystem::exists(path, ignored);
  FILE* file = std::fopen(path.c_str(), append ? "a" : "w");
  if (file == nullptr)
    gasgrain::stop_everything_from_here(
        fmt::format("fix liquid: cannot write '{}': give another 'output FILE'.", path.string()));
  if (is_new) fmt::print(file, "{}\n", gasgrain::liquid::liquid_columns);
  const double saturation = gasgrain::liquid::saturation(t.bridges + t.wall_bridges, t.solid,
                                                         settings_.packing_void_fraction);
  fmt::print(file,
             "{},{:.9g},{:.15g},{:.15g},{:.15g},{:.15g},{:.15g},{:.15g},{:.3g},{},{},{},{},{},"
             "{:.6g},{}\n",
             update->ntimestep, static_cast<double>(update->ntimestep) * update->dt, t.films,
             t.bridges, t.wall_bridges, t.walls, ledger_.came_in, ledger_.gone, residual, t.count,
             ledger_.formed, ledger_.broken, ledger_.cut_short, ledger_.lost_sight, saturation,
             t.beyond_pendular);
  std::fclose(file);
}

void FixLiquid::warn(const LiquidTotals& t, double residual) {
  if (t.beyond_pendular > 0.0 && !warned_of_saturation_) {
    warned_of_saturation_ = true;
    host_warning(fmt::format(
        "fix liquid: the bridges of {} of {} grains fill more than {} of the voids between them "
        "(saturation, at most {:.2g}). There bridges merge, and laws of single bridges do not "
        "hold: "
        "take less liquid, or see in it no more than a trend.",
        t.beyond_pendular, t.grains, gasgrain::liquid::pendular_up_to, t.greatest_saturation));
  }
  constexpr double closed = 1e-10;
  if (std::abs(residual) > closed && !warned_of_residual_) {
    warned_of_residual_ = true;
    host_warning(
        fmt::format("fix liquid: {:.3g} of all liquid is unaccounted for at step {}. This is a "
                    "fault of gasgrain: please tell its authors how it came about.",
                    residual, update->ntimestep));
  }
}

void FixLiquid::post_run() {
  contacts_.store_now();
  if (update->ntimestep != shown_at_) record();
  if (ledger_.cut_short > told_.cut_short)
    host_warning(fmt::format(
        "fix liquid: {} of {} broken bridges broke below their rupture distance, as the host does "
        "not show contacts that far. Add 'reach F', greater than {:.3g}.",
        ledger_.cut_short, ledger_.broken, reach_));
  if (ledger_.lost_sight > told_.lost_sight)
    host_warning(fmt::format(
        "fix liquid: {} of {} broken bridges to walls broke below their rupture distance, as the "
        "host does not show walls that far. Add 'reach F', greater than {:.3g} (of a radius), and "
        "at "
        "primitive walls 'neighbor SKIN bin' with a skin of twice that.",
        ledger_.lost_sight, ledger_.broken, wall_reach_));
  if (ledger_.held_back > told_.held_back)
    host_warning(
        fmt::format("fix liquid: viscous forces of bridges were held back in {:.6g} cases (a "
                    "bridge in a step): "
                    "the step is too long for this viscosity at this minimum_separation.",
                    ledger_.held_back));
  if (ledger_.deleted > told_.deleted)
    host_warning(
        fmt::format("fix liquid: deleted grains took {:.6g} m3 of liquid along.", ledger_.deleted));
  told_ = ledger_;
}

double FixLiquid::compute_vector(int n) {
  if (update->ntimestep != shown_at_) record();
  return shown_[static_cast<std::size_t>(n)];
}

}  // namespace LAMMPS_NS
