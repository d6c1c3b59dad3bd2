#include "fix_cfd_coupling/fixes/fix_couple_gas.h"

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <limits>

#include "coupling/base/error.h"
#include "coupling/transport/inner_gas.h"
#include "fix_cfd_coupling/fixes/fix_parcels.h"
#include "fix_cfd_coupling/fixes/host_session.h"
// --
#include "atom.h"
#include "comm.h"
#include "dialect_drift.h"
#include "dialect_restart.h"
#include "dialect_stop.h"
#include "dialect_version.h"
#include "dialect_words.h"
#include "domain.h"
#include "modify.h"
#include "neighbor.h"
#include "update.h"

namespace LAMMPS_NS {

using gasgrain::Vec3;

namespace {

constexpr const char* usage =
    "fix ID all couple/gas every N [start STEP] [output DIR] [mode in_turn|overlapped] "
    "[gas FILE [gas_restart FILE]] EFFECTS..., for instance\n"
    "  fix gas all couple/gas every 100 drag koch_hill pressure_gradient";

int whole_number(const char* text, const char* keyword, long least) {
  char* end = nullptr;
  const long value = std::strtol(text, &end, 10);
  if (end == text || *end != '\0' || value < least || value > std::numeric_limits<int>::max())
    gasgrain::fail("{} {}: must be a whole number, at least {}.\n{}", keyword, text, least, usage);
  return static_cast<int>(value);
}

// Every DEM step: whether some rank was asked to stop. The ranks wait for each other here.
constexpr const char* in_step_task = "coupling: DEM ranks in step";

bool mode_is_overlapped(const std::string& mode) {
  const std::vector<std::string> modes{"in_turn", "overlapped"};
  if (mode != modes[0] && mode != modes[1])
    gasgrain::fail("mode \"{}\" is unknown.{}\n{}", mode, gasgrain::suggestion(mode, modes), usage);
  return mode == modes[1];
}

}  // namespace

FixCoupleGas::FixCoupleGas(LAMMPS* host, int narg, char** arg) : HostFix(host, narg, arg) {
  try {
    read_arguments(narg, arg);
  } catch (const gasgrain::Error& e) {
    gasgrain::stop_everything(e.what());
  }
  nevery = every_;
  vector_flag = 1;
  size_vector = 4;
  global_freq = 1;
  extvector = 0;
  restart_global = 1;
  restart_peratom = 1;
  create_attribute = 1;  // the host then calls set_arrays() for every grain it inserts
  grow_arrays(atom->nmax);
  atom->add_callback(0);
  atom->add_callback(1);
}

void FixCoupleGas::read_arguments(int narg, char** arg) {
  if (std::strcmp(arg[1], "all") != 0)
    gasgrain::fail("the group of couple/gas must be 'all', it is '{}': every grain displaces gas.",
                   arg[1]);
  int a = 3;
  for (; a + 1 < narg; a += 2) {
    if (std::strcmp(arg[a], "every") == 0)
      every_ = whole_number(arg[a + 1], "every", 1);
    else if (std::strcmp(arg[a], "start") == 0)
      start_ = whole_number(arg[a + 1], "start", 0);
    else if (std::strcmp(arg[a], "output") == 0)
      output_ = arg[a + 1];
    else if (std::strcmp(arg[a], "mode") == 0)
      overlapped_ = mode_is_overlapped(arg[a + 1]);
    else if (std::strcmp(arg[a], "gas") == 0)
      gas_input_ = arg[a + 1];
    else if (std::strcmp(arg[a], "gas_restart") == 0)
      gas_restart_ = arg[a + 1];
    else
      break;
  }
  if (every_ == 0) gasgrain::fail("couple/gas needs 'every N' before the effects.\n{}", usage);
  if (!gas_restart_.empty() && gas_input_.empty())
    gasgrain::fail(
        "'gas_restart {}' is for a gas inside this program and needs 'gas FILE' beside it; a "
        "gasgrain-gas of the launch takes the option --restart.",
        gas_restart_);
  if (overlapped_ && !gas_input_.empty())
    gasgrain::fail(
        "'gas {}' and 'mode overlapped' exclude each other: a gas inside this program works while "
        "the grains wait. Leave out one of the two.",
        gas_input_);
  effects_ = gasgrain::parse_effects({arg + a, arg + narg}, "couple/gas");
  records_ = gasgrain::ExchangeRecords(effects_.layout(overlapped_));
  audit_ = gasgrain::Audit(effects_);
  if (!gasgrain::session().local.is_root()) return;
  std::filesystem::create_directories(output_ + "/checkpoint");
  std::filesystem::create_directories(output_ + "/particles");
}

// The partner is met once the box is known and, in a restart, the stored state has been read.
void FixCoupleGas::begin() {
  try {
    meet_partner();
  } catch (const gasgrain::Error& e) {
    gasgrain::stop_everything(e.what());
  }
}

std::unique_ptr<gasgrain::GasPartner> FixCoupleGas::gas_partner() const {
  const auto& session = gasgrain::session();
  if (!gas_input_.empty())
    return gasgrain::make_inner_gas({gas_input_, output_, gas_restart_}, session.local);
  return gasgrain::make_remote_gas(session.local, session.partner);
}

void FixCoupleGas::meet_partner() {
  auto& session = gasgrain::session();
  const bool launched_with_gas = session.partner != MPI_COMM_NULL;
  if (launched_with_gas && !gas_input_.empty())
    gasgrain::fail(
        "there are two gas solvers: 'gas {}' puts one inside this program, and the launch has a "
        "gasgrain-gas. Leave out one of the two.",
        gas_input_);
  if (!launched_with_gas && gas_input_.empty())
    gasgrain::fail(
        "couple/gas has no partner in this launch. Use 'gasgrain run SCENE', or\n"
        "  mpirun -np 2 {} : -np 1 gasgrain-gas gas.toml\n"
        "or, for the gas inside this program, name its input on the line:\n"
        "  couple/gas every {} gas gas.toml ...",
        gasgrain::words::dem_program, every_);
  if (session.greeted)
    gasgrain::fail("a script couples once: there is a second couple/gas line, or a 'clear'.");
  if (domain->box_exist == 0)
    gasgrain::fail("couple/gas must stand after create_box or read_restart.");
  if (std::strcmp(update->unit_style, "si") != 0)
    gasgrain::fail(
        "the script has 'units {}', the gas knows metres, kilograms and seconds only: write "
        "'units si', and the script's numbers in them.",
        update->unit_style);
  if (domain->nonperiodic == 2)
    gasgrain::fail(
        "the box may not follow the particles: use 'boundary f f f' (or p), not s or m.");
  session.greeted = true;
  gasgrain::DemScene scene;
  scene.box_lo = Vec3(domain->boxlo[0], domain->boxlo[1], domain->boxlo[2]);
  scene.box_hi = Vec3(domain->boxhi[0], domain->boxhi[1], domain->boxhi[2]);
  for (int d = 0; d < 3; ++d) scene.periodic[d] = domain->periodicity[d];
  scene.interval = every_ * update->dt;
  scene.overlapped = overlapped_;
  scene.time =
      last_coupled_ < 0 ? 0.0 : static_cast<double>(last_coupled_ + every_ - start_) * update->dt;
  coupled_ = std::make_unique<gasgrain::CoupledStep>(session.local, gas_partner(), effects_, scene);

  open_history();
}

FixCoupleGas::~FixCoupleGas() {
  atom->delete_callback(id, 0);
  atom->delete_callback(id, 1);
  if (!coupled_) return;
  guarded([&] { tell_costs(); });
}

int FixCoupleGas::mask() {
  return FixConst::PRE_EXCHANGE | FixConst::POST_FORCE | FixConst::END_OF_STEP | FixConst::POST_RUN;
}

void FixCoupleGas::init() {
  begin_setup_costs();
  if (atom->radius_flag == 0 || atom->rmass_flag == 0)
    gasgrain::stop_everything(
        fmt::format("couple/gas needs spheres: {}.", gasgrain::words::sphere_style));
  contacts_checked_ = false;
  parcels_ = FixParcels::of_scene(lmp);
}

gasgrain::ParticleView FixCoupleGas::particles() const {
  gasgrain::ParticleView view;
  view.count = static_cast<std::size_t>(atom->nlocal);
  if (atom->nlocal == 0) return view;
  view.position = atom->x[0];
  view.velocity = atom->v[0];
  view.angular_velocity = atom->omega != nullptr ? atom->omega[0] : nullptr;
  view.radius = atom->radius;
  view.mass = atom->rmass;
  if (parcels_ != nullptr) view.parcel_size = parcels_->sizes();
  return view;
}

bigint FixCoupleGas::step_now() const {
  return update->ntimestep;
}

bool FixCoupleGas::due(bigint step) const {
  return (step - start_) % every_ == 0;
}

// Drag is implicit in the sum of all other forces, and so wants to see all of them.
void FixCoupleGas::warn_of_later_forces() const {
  if (comm->me != 0) return;
  for (int n = modify->nfix - 1; n >= 0 && modify->fix[n] != this; --n)
    if ((modify->fmask[n] & FixConst::POST_FORCE) != 0)
      for (FILE* sink : {screen, logfile})
        if (sink != nullptr)
          fmt::print(sink,
                     "couple/gas: warning: fix {} {} stands after it in the script: drag does not "
                     "see the forces that it adds. Put couple/gas after it.\n",
                     modify->fix[n]->id, modify->fix[n]->style);
}

void FixCoupleGas::setup(int) {
  if (update->laststep > start_) warn_of_later_forces();
  guarded([&] {
    if (resumed_ && !restored_ledger_.empty()) {
      coupled_->resume(particles(), records_, restored_ledger_, restored_report_);
      restored_ledger_.clear();
    }
    if (gasgrain::session().local.is_root())
      gasgrain::write_run_frame(output_, {update->firststep, update->laststep, start_, update->dt,
                                          gasgrain::host_version(*lmp), effects_.text()});
    check_contacts();
    const bigint step = update->ntimestep;
    if (due(step)) record();
    if (step >= start_ && due(step) && last_coupled_ != step) couple();
    // The host uses the forces of this moment for the first half of the next step only. That half
    // is in the ledger already when the step before was booked whole; a run of no steps uses none.
    const bool booked = booked_whole_ || update->laststep == step;
    apply_forces(booked ? 0.0 : 0.5);
  });
  end_setup_costs();
}

void FixCoupleGas::post_force(int) {
  const bigint step = update->ntimestep;
  const bool last = step == update->laststep;
  if (due(step)) {
    guarded([&] {
      record();
      // What starts at the last step is coupled by the next run, if there is one.
      if (step >= start_ && !last) couple();
    });
  }
  apply_forces(last ? 0.5 : 1.0);
  booked_whole_ = !last;
}

void FixCoupleGas::couple() {
  const auto& local = gasgrain::session().local;
  gasgrain::DemRegion region;
  region.lo = Vec3(domain->sublo[0], domain->sublo[1], domain->sublo[2]);
  region.hi = Vec3(domain->subhi[0], domain->subhi[1], domain->subhi[2]);
  region.drift = gasgrain::drift_of_grains(*lmp);
  for (int i = 0; i < atom->nlocal; ++i)
    region.largest_radius = std::max(region.largest_radius, atom->radius[i]);
  region.largest_radius = local.max(region.largest_radius);
  const double dt = update->dt;
  const bigint step = update->ntimestep;
  coupled_->begin(particles(), region, records_, every_ * dt, step,
                  static_cast<double>(step - start_) * dt);
  last_coupled_ = step;
  watch_interval();
  look_for_audit();
}

void FixCoupleGas::apply_forces(double share_of_step) {
  if (last_coupled_ < 0 || atom->nlocal == 0) return;
  coupled_->apply(particles(), records_, {atom->f[0], atom->torque[0]}, update->dt, share_of_step);
}

void FixCoupleGas::end_of_step() {
  auto& session = gasgrain::session();
  const gasgrain::Stopwatch watch(coupled_->costs(), coupled_->costs().task(in_step_task));
  if (session.local.max(session.stop_wanted != 0 ? 1.0 : 0.0) == 0.0) return;
  gasgrain::write_restart_file(
      *lmp, fmt::format("{}/checkpoint/dem.{}.restart", output_, update->ntimestep));
  gasgrain::end_runs(*lmp);
}

void FixCoupleGas::post_run() {
  take_host_costs();
  if (last_coupled_ < 0) return;
  guarded([&] { coupled_->complete(particles(), records_); });
  tell_of_interval();
  const auto ledger = coupled_->whole_ledger(particles(), records_);
  report_audit(ledger);
  if (comm->me != 0) return;
  for (FILE* sink : {screen, logfile})
    if (sink != nullptr) fmt::print(sink, "{}\n", ledger.text());
}

double FixCoupleGas::compute_vector(int n) {
  return shown_[n];
}

double FixCoupleGas::memory_usage() {
  return static_cast<double>(records_.size() * records_.layout().size * sizeof(double));
}

}  // namespace LAMMPS_NS
