// How fix couple/gas watches over the run: the DEM step before it, the grains and the coupling
// interval while it goes on; and how a run that has gone wrong is stopped with its state kept.
#include <algorithm>
#include <cmath>

#include "fix_cfd_coupling/dem_physics/contact_step.h"
#include "fix_cfd_coupling/fixes/contact_limits.h"
#include "fix_cfd_coupling/fixes/fix_couple_gas.h"
#include "fix_cfd_coupling/fixes/host_session.h"
// --
#include "atom.h"
#include "comm.h"
#include "dialect_lost.h"
#include "dialect_restart.h"
#include "dialect_words.h"
#include "domain.h"
#include "update.h"

namespace LAMMPS_NS {

using gasgrain::Vec3;

namespace {

constexpr const char* shaken_apart =
    "Likely the contacts are too stiff for the step, or two grains were put into one place: lower "
    "'timestep', or look at what was inserted or set there.";

}  // namespace

// To the screen and the log, by rank 0.
void FixCoupleGas::tell(const std::string& text) const {
  if (comm->me != 0) return;
  for (FILE* sink : {screen, logfile})
    if (sink != nullptr) fmt::print(sink, "couple/gas: {}\n", text);
}

// Once a run, when there are grains.
void FixCoupleGas::check_contacts() {
  if (contacts_checked_) return;
  const auto verdict = gasgrain::judge_contacts(*lmp, gasgrain::session().local);
  contacts_checked_ = verdict.had_grains;
  if (!verdict.refusal.empty()) gasgrain::fail("{}", verdict.refusal);
  if (verdict.warning.empty() || contacts_told_) return;
  contacts_told_ = true;
  tell("warning: " + verdict.warning);
}

gasgrain::HostGrains FixCoupleGas::host_grains() const {
  return {atom->tag, atom->nlocal > 0 ? atom->f[0] : nullptr};
}

gasgrain::Moment FixCoupleGas::moment() const {
  const bigint step = update->ntimestep;
  return {static_cast<long>(step), static_cast<double>(step - start_) * update->dt};
}

void FixCoupleGas::setup_pre_exchange() {
  watch_grains_that_move_on();
}

void FixCoupleGas::pre_exchange() {
  watch_grains_that_move_on();
}

// Before the host hands grains to the ranks they have moved to: it drops those that belong to
// nobody, and ends with a rank's own error at one whose position is no number.
void FixCoupleGas::watch_grains_that_move_on() {
  const gasgrain::Stopwatch watch(coupled_->costs(),
                                  coupled_->costs().task("coupling: looking for faults"));
  gasgrain::HostBox box;
  for (int d = 0; d < 3; ++d) {
    box.lo[d] = domain->boxlo[d];
    box.hi[d] = domain->boxhi[d];
    box.periodic[d] = domain->periodicity[d] != 0;
    box.own_lo[d] = domain->sublo[d];
    box.own_hi[d] = domain->subhi[d];
  }
  const auto found = gasgrain::look_for_leavers(particles(), host_grains(), box);
  const bool may_leave = !gasgrain::lost_grains_are_errors(*lmp);
  if (may_leave) left_box_ += found.outside;
  std::string fault;
  if (!found.not_finite.empty())
    fault = fmt::format("{} {}. {}", found.not_finite, at(moment()), shaken_apart);
  else if (found.outside > 0 && !may_leave)
    fault = fmt::format(
        "{} {}: a lost particle. Likely there is no wall ('{}'), or the grain was "
        "pressed or shot through it: then raise youngsModulus, or lower 'timestep'. Where grains "
        "are to leave, write 'thermo_modify lost ignore'.",
        found.first, at(moment()), gasgrain::words::grain_wall);
  else if (!found.jumped.empty())
    fault = fmt::format("{} {}: a lost particle. {}", found.jumped, at(moment()), shaken_apart);
  guarded([&] { gasgrain::share_fault(gasgrain::session().local, fault); });
}

// At a coupling, with the host's own forces of this step.
void FixCoupleGas::watch_state(const Overlap& overlap) {
  const gasgrain::Stopwatch watch(coupled_->costs(),
                                  coupled_->costs().task("coupling: looking for faults"));
  std::string fault = gasgrain::look_at_state(particles(), host_grains());
  constexpr double one_radius = 0.5;  // of the smaller diameter
  if (!fault.empty()) {
    fault = fmt::format("{} {}. {}", fault, at(moment()), shaken_apart);
  } else if (overlap.ratio > one_radius) {
    const double smaller = std::min(atom->radius[overlap.i], atom->radius[overlap.j]);
    const double* other = atom->x[overlap.j];
    fault = fmt::format(
        "{} and grain {} at x = {:.6g}, y = {:.6g}, z = {:.6g} m overlap by {:.3g} m, more than "
        "the "
        "radius of the smaller, {:.3g} m, {}. Likely the contacts are too soft for this load or "
        "speed: raise youngsModulus (kn, characteristicVelocity) and lower 'timestep' with it; or "
        "grains were inserted into each other.",
        grain_at(particles(), host_grains(), overlap.i), atom->tag[overlap.j], other[0], other[1],
        other[2], 2.0 * smaller * overlap.ratio, smaller, at(moment()));
  }
  gasgrain::share_fault(gasgrain::session().local, fault);
}

// The same on all ranks.
void FixCoupleGas::watch_count(double grains) {
  const double lost = static_cast<double>(atom->natoms) - grains;
  if (lost <= 0.0 || !gasgrain::lost_grains_are_errors(*lmp)) return;
  throw gasgrain::RunFault(fmt::format(
      "{:.0f} of {} grains are lost particles {}: the host has dropped them between two looks. {}",
      lost, atom->natoms, at(moment()), shaken_apart));
}

void FixCoupleGas::watch_interval() {
  const gasgrain::IntervalNeed& mine = coupled_->interval_need();
  double both[2] = {mine.crossing_rate, -mine.longest_of_drag};
  MPI_Allreduce(MPI_IN_PLACE, both, 2, MPI_DOUBLE, MPI_MAX, gasgrain::session().local.handle());
  IntervalWatch& watch = interval_watch_;
  watch.last.crossing_rate = both[0];
  watch.last.longest_of_drag = -both[1];
  const double interval = every_ * update->dt;
  ++watch.couplings;
  if (!watch.last.too_long(interval)) return;
  const double advised = watch.last.advised();
  const bool first = watch.too_long++ == 0;
  watch.advised = first ? advised : std::min(watch.advised, advised);
  if (first)
    tell(fmt::format("warning: 'every {}' is too long {}: {} {}", every_, at(moment()),
                     in_words(watch.last, interval),
                     gasgrain::every_to_write(advised, update->dt)));
}

// At the end of a run: what would have done for all of it.
void FixCoupleGas::tell_of_interval() const {
  const IntervalWatch& watch = interval_watch_;
  if (watch.too_long == 0) return;
  tell(fmt::format("warning: 'every {}' was too long at {} of {} couplings. {}", every_,
                   watch.too_long, watch.couplings,
                   gasgrain::every_to_write(watch.advised, update->dt)));
}

// A restart file with a grain outside of the box, or nowhere, cannot be read again.
void FixCoupleGas::put_stray_grains_into_box() {
  for (int i = 0; i < atom->nlocal; ++i)
    for (int d = 0; d < 3; ++d) {
      double& x = atom->x[i][d];
      if (std::isfinite(x) && domain->periodicity[d] != 0) continue;
      // The upper side is no part of the box.
      const double last = std::nextafter(domain->boxhi[d], domain->boxlo[d]);
      x = std::isfinite(x) ? std::clamp(x, domain->boxlo[d], last) : domain->boxlo[d];
    }
}

// Called by all DEM ranks; the gas waits for a command, or says so when it cannot write.
void FixCoupleGas::stop_with_autopsy(const std::string& fault) {
  gasgrain::session().fault = fault;
  autopsy_ = true;
  put_stray_grains_into_box();
  // The host refuses to write fewer grains than it believes in.
  atom->natoms =
      static_cast<bigint>(gasgrain::session().local.sum(static_cast<long>(atom->nlocal)));
  const bigint step = update->ntimestep;
  const auto name = fmt::format("{}/checkpoint/autopsy.dem.{}.restart", output_, step);
  gasgrain::write_restart_file(*lmp, name);
  const std::string gas =
      no_gas_autopsy_.empty()
          ? fmt::format("{}/checkpoint/autopsy.gas.{}.h5", output_, step)
          : fmt::format("(that of the gas could not be written: {})", no_gas_autopsy_);
  gasgrain::stop_everything(
      fmt::format("{}\nFor an autopsy, the state is in {} and {}", fault, name, gas));
}

}  // namespace LAMMPS_NS
