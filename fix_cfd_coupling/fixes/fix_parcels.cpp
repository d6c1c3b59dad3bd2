#include "fix_cfd_coupling/fixes/fix_parcels.h"

#include <cmath>
#include <cstring>
#include <string>

#include "coupling/base/error.h"
#include "fix_cfd_coupling/dem_physics/parcels/return_to_isotropy.h"
#include "fix_cfd_coupling/dem_physics/parcels/velocity_damping.h"
#include "fix_cfd_coupling/fixes/host_error.h"
#include "fix_cfd_coupling/fixes/host_session.h"
// --
#include "atom.h"
#include "atom_vec.h"
#include "comm.h"
#include "dialect_density.h"
#include "dialect_words.h"
#include "domain.h"
#include "force.h"
#include "modify.h"
#include "neighbor.h"
#include "update.h"

namespace LAMMPS_NS {

using gasgrain::Vec3;

namespace {

constexpr const char* property = "particlesPerParcel";
constexpr double unmet = -1.0;  // of the property

// A way of a whole cell, the stencil at its end, and one more for a parcel on its rank's rim.
constexpr int reach = 3;

gasgrain::ParcelSettings settings_of(LAMMPS* host, int narg, char** arg) {
  try {
    if (std::strcmp(arg[1], "all") != 0)
      gasgrain::fail("the group of fix parcels must be 'all', it is '{}'.", arg[1]);
    if (std::strcmp(host->update->unit_style, "si") != 0)
      gasgrain::fail("fix parcels needs 'units si', the script has 'units {}'.",
                     host->update->unit_style);
    if (FixParcels::of_scene(host) != nullptr)
      gasgrain::fail("there is a fix parcels already: a scene has one.");
    return gasgrain::parse_parcels({arg + 3, arg + narg});
  } catch (const gasgrain::Error& e) {
    gasgrain::stop_everything(e.what());
  }
}

}  // namespace

FixParcels* FixParcels::of_scene(LAMMPS* host) {
  for (int n = 0; n < host->modify->nfix; ++n)
    if (auto* found = dynamic_cast<FixParcels*>(host->modify->fix[n])) return found;
  return nullptr;
}

FixParcels::FixParcels(LAMMPS* host, int narg, char** arg)
    : HostFix(host, narg, arg),
      settings_(settings_of(host, narg, arg)),
      stress_(settings_),
      motion_(settings_.close_packing) {
  time_integrate = 1;
  nevery = 1;
  vector_flag = 1;
  size_vector = 15;
  global_freq = 1;
  extvector = 0;
  restart_global = 1;
  restart_peratom = 1;
  create_attribute = 1;  // the host then calls set_arrays() for every atom it inserts
  // Every step: parcels are then always with the rank in whose part they are.
  force_reneighbor = 1;
  next_reneighbor = update->ntimestep + 1;
  grow_arrays(atom->nmax);
  atom->add_callback(0);
  atom->add_callback(1);
}

FixParcels::~FixParcels() {
  atom->delete_callback(id, 0);
  atom->delete_callback(id, 1);
}

int FixParcels::mask() {
  return FixConst::INITIAL_INTEGRATE | FixConst::PRE_EXCHANGE | FixConst::PRE_FORCE |
         FixConst::POST_FORCE | FixConst::FINAL_INTEGRATE | FixConst::END_OF_STEP |
         FixConst::POST_RUN;
}

void FixParcels::make_properties() {
  size_.make(*this, *lmp, property, unmet, GrainScalar::Stays::with_the_fix);
}

void FixParcels::check_scene() const {
  if (force->pair != nullptr)
    gasgrain::stop_everything(
        "fix parcels: parcels have no contacts, but the script has a pair_style. Take it away, or "
        "write 'pair_style none'.");
  if (atom->radius_flag == 0 || atom->rmass_flag == 0)
    gasgrain::stop_everything(
        fmt::format("fix parcels needs spheres: {}.", gasgrain::words::sphere_style));
  for (int n = 0; n < modify->nfix; ++n)
    if (modify->fix[n] != this && modify->fix[n]->time_integrate != 0)
      gasgrain::stop_everything(
          fmt::format("fix parcels moves the parcels itself, and fix {} {} would move them again. "
                      "Take it away.",
                      modify->fix[n]->id, modify->fix[n]->style));
}

void FixParcels::init() {
  check_scene();
  size_.find(*this, *lmp);
  try {
    if (cells_ == nullptr)
      cells_ = std::make_unique<gasgrain::RankCells>(
          *lmp, gasgrain::grid_of_scene(*lmp, settings_.cells, "fix parcels"));
  } catch (const gasgrain::Error& e) {
    gasgrain::stop_everything(e.what());
  }
}

const double* FixParcels::sizes() const {
  return size_.values();
}

gasgrain::ParcelView FixParcels::view() const {
  gasgrain::ParcelView parcels;
  parcels.count = static_cast<std::size_t>(atom->nlocal);
  if (atom->nlocal == 0) return parcels;
  parcels.position = atom->x[0];
  parcels.velocity = atom->v[0];
  parcels.radius = atom->radius;
  parcels.mass = atom->rmass;
  parcels.solid_volume = solid_volume_.data();
  parcels.particles = size_.values();
  parcels.number = atom->tag;
  return parcels;
}

// Atoms that the script or the host made: all solid so far.
void FixParcels::meet_new_parcels() {
  for (int k = 0; k < atom->nlocal; ++k) {
    double& core = solid_mass_[static_cast<std::size_t>(k)];
    if (core != 0.0) continue;
    double& size = size_[k];
    if (size == unmet) size = settings_.particles;
    const double r = atom->radius[k];
    core = known_mass_[static_cast<std::size_t>(k)] = atom->rmass[k];
    solid_volume_[static_cast<std::size_t>(k)] = 4.0 / 3.0 * M_PI * r * r * r;
    came_ += {size * core, 0.0};
  }
}

// What the script may have done to them before this run.
void FixParcels::check_parcels() const {
  for (int k = 0; k < atom->nlocal; ++k) {
    const double size = size_[k];
    if (!(size > 0.0) || !std::isfinite(size))
      gasgrain::stop_everything_from_here(
          fmt::format("the {} of atom {} is {}: give the number of particles, above 0.", property,
                      atom->tag[k], size));
    const double known = known_mass_[static_cast<std::size_t>(k)];
    if (atom->rmass[k] != known)
      gasgrain::stop_everything_from_here(
          fmt::format("the mass of atom {} has become {} kg, where fix parcels knows {} kg of it: "
                      "set diameters "
                      "and densities before the first run, films by the property liquidFilm.",
                      atom->tag[k], atom->rmass[k], known));
  }
}

void FixParcels::check_numbers() const {
  for (int k = 0; k < atom->nlocal; ++k) {
    const double *x = atom->x[k], *v = atom->v[k];
    if (std::isfinite(x[0] + x[1] + x[2] + v[0] + v[1] + v[2])) continue;
    gasgrain::stop_everything_from_here(
        fmt::format("atom {} has a position or velocity that is not a number at step {}: x = {} {} "
                    "{} m, v = {} "
                    "{} {} m/s. Look at what the script sets, or take a shorter timestep.",
                    atom->tag[k], update->ntimestep, x[0], x[1], x[2], v[0], v[1], v[2]));
  }
}

// Parcels that the script has put on a wall, or behind it: the host would lose them.
void FixParcels::put_inside_walls() {
  const gasgrain::BoxGrid& grid = cells_->frame().grid;
  for (int k = 0; k < atom->nlocal; ++k)
    for (int d = 0; d < 3; ++d) {
      if (grid.periodic[d]) continue;
      const double gap = std::min(atom->radius[k], 0.25 * grid.spacing()[d]);
      double& x = atom->x[k][d];
      const double before = x;
      if (settings_.walls.side[d][0] && x < grid.lo[d]) x = grid.lo[d] + gap;
      if (settings_.walls.side[d][1] && x >= grid.hi[d]) x = grid.hi[d] - gap;
      if (x != before) put_inside_ += 1.0;
    }
}

void FixParcels::setup_pre_exchange() {
  next_reneighbor = update->ntimestep + 1;
  check_numbers();
  put_inside_walls();
  take_out_leavers();
}

void FixParcels::setup_pre_force(int) {
  grains_have_values();
  size_.grains_have_values();
  meet_new_parcels();
  check_parcels();
}

// Before and between runs the script may do what it likes: the balance is one of a run.
void FixParcels::begin_balance() {
  const Stock stock = take_stock();
  if (comm->me != 0) return;
  // What is more came in, what is less has gone.
  const double solids = stock.held.solids - (stock.came.solids - stock.gone.solids);
  const double liquid = stock.held.liquid - (stock.came.liquid - stock.gone.liquid);
  came_ += {std::max(0.0, solids), std::max(0.0, liquid)};
  gone_ += {std::max(0.0, -solids), std::max(0.0, -liquid)};
}

void FixParcels::setup(int) {
  begin_balance();
  shown_at_ = -1;  // of the run before
  limits_ = {};
  cells_->follow_domain(0.0, reach);
  post_force(0);
}

void FixParcels::kick() {
  const double half = 0.5 * update->dt * force->ftm2v;
  for (int k = 0; k < atom->nlocal; ++k) {
    const double per_mass = half / atom->rmass[k];
    for (int d = 0; d < 3; ++d) atom->v[k][d] += per_mass * atom->f[k][d];
  }
}

void FixParcels::initial_integrate(int) {
  kick();
  check_numbers();
  cells_->follow_domain(0.0, reach);
  const auto total = [](double value) { return gasgrain::session().local.sum(value); };
  try {
    const gasgrain::MotionReport report =
        motion_.move(view(), cells_->frame(), update->dt, settings_.walls, cells_->sum(), total);
    limited_now_ = static_cast<double>(report.limited);
    fraction_now_ = report.greatest_fraction;
    limits_.limited += limited_now_;
    limits_.stopped += static_cast<double>(report.stopped);
    limits_.cut += static_cast<double>(report.cut_at_tile);
    if (report.all_held) limits_.held_steps += 1.0;
    limits_.most_passes = std::max(limits_.most_passes, report.passes);
    limits_.greatest_fraction = std::max(limits_.greatest_fraction, fraction_now_);
    limits_.lost_momentum += report.lost_momentum;
  } catch (const gasgrain::Error& e) {
    gasgrain::stop_everything_from_here(e.what());
  }
}

void FixParcels::pre_exchange() {
  next_reneighbor = update->ntimestep + 1;
  take_out_leavers();
}

void FixParcels::pre_force(int) {
  meet_new_parcels();
}

// Parcels beyond an open side of the box leave the run.
void FixParcels::take_out_leavers() {
  const auto left = [&](int k) {
    for (int d = 0; d < 3; ++d)
      if (domain->periodicity[d] == 0 &&
          !(atom->x[k][d] >= domain->boxlo[d] && atom->x[k][d] < domain->boxhi[d]))
        return true;
    return false;
  };
  long leavers = 0;
  for (int k = 0; k < atom->nlocal;) {
    if (!left(k)) {
      ++k;
      continue;
    }
    gone_ += masses_of(k);
    atom->avec->copy(atom->nlocal - 1, k, 1);
    --atom->nlocal;
    ++leavers;
  }
  atom->natoms -= gasgrain::session().local.sum(leavers);
}

void FixParcels::post_force(int) {
  try {
    const gasgrain::StressReport report =
        stress_.add_forces(view(), cells_->frame(), update->dt,
                           atom->nlocal > 0 ? atom->f[0] : nullptr, cells_->sum());
    limits_.stress_limited += static_cast<double>(report.limited);
  } catch (const gasgrain::Error& e) {
    gasgrain::stop_everything_from_here(e.what());
  }
}

void FixParcels::final_integrate() {
  kick();
}

void FixParcels::end_of_step() {
  if (!settings_.damping && !settings_.isotropy) return;
  const gasgrain::ParcelView parcels = view();
  const std::vector<std::size_t> where = gasgrain::parcel_cells(parcels, cells_->frame());
  if (settings_.damping)
    limits_.damped_energy +=
        gasgrain::VelocityDamping{settings_.damping_restitution, settings_.close_packing}.damp(
            parcels, where, cells_->frame(), update->dt, cells_->sum());
  if (!settings_.isotropy) return;
  const gasgrain::ReturnToIsotropy isotropy{settings_.isotropy_restitution,
                                            settings_.isotropy_share, settings_.close_packing,
                                            settings_.seed};
  limits_.redirect_limited += static_cast<double>(
      isotropy
          .redirect(parcels, where, cells_->frame(), update->dt,
                    static_cast<std::uint64_t>(update->ntimestep), cells_->sum())
          .limited);
}

void FixParcels::admit(int k, const gasgrain::NewParcel& parcel) {
  const auto n = static_cast<std::size_t>(k);
  size_[k] = parcel.particles;
  solid_mass_[n] = parcel.solid_mass;
  solid_volume_[n] = parcel.solid_volume;
  double film = 0.0;
  for (const double mass : parcel.film_mass) film += mass;
  atom->radius[k] = parcel.radius;
  atom->rmass[k] = known_mass_[n] = parcel.solid_mass + film;
  gasgrain::density_follows(*atom, k, 4.0 / 3.0 * M_PI * std::pow(parcel.radius, 3));
  came_ += masses_of(k);
}

void FixParcels::set_film(int k, double mass, double volume) {
  const auto n = static_cast<std::size_t>(k);
  const double whole = solid_volume_[n] + volume;
  const double before = atom->rmass[k];
  atom->rmass[k] = known_mass_[n] = solid_mass_[n] + mass;
  // The force of this step moves it for the first half of the next one, too: a droplet that has
  // given its liquid away keeps its acceleration, or its core would be shot out of the box.
  for (int d = 0; d < 3; ++d) atom->f[k][d] *= atom->rmass[k] / before;
  atom->radius[k] = std::cbrt(0.75 / M_PI * whole);
  gasgrain::density_follows(*atom, k, whole);
}

void FixParcels::tell(const std::string& text) const {
  if (comm->me != 0) return;
  for (FILE* sink : {screen, logfile})
    if (sink != nullptr) fmt::print(sink, "parcels: {}\n", text);
}

// What acted at the limits of the model, once a run.
void FixParcels::post_run() {
  double sums[6] = {limits_.limited,        limits_.stopped,          limits_.cut,
                    limits_.stress_limited, limits_.redirect_limited, put_inside_};
  put_inside_ = 0.0;
  MPI_Allreduce(MPI_IN_PLACE, sums, 6, MPI_DOUBLE, MPI_SUM, world);
  const double fraction = gasgrain::session().local.max(limits_.greatest_fraction);
  show();
  tell(
      fmt::format("{:.0f} parcels of {:.6g} particles; greatest solid fraction {:.4f} "
                  "({:.4f} of close packing); balance of masses {:.1e}",
                  shown_[0], shown_[1], fraction, fraction / settings_.close_packing, shown_[8]));
  const auto say = [&](double count, const char* what) {
    if (count > 0.0) tell(fmt::format("{:.0f} {}", count, what));
  };
  say(sums[0], "ways of parcels were shortened at close packing");
  say(sums[1], "of them were brought to rest");
  say(limits_.most_passes, "passes at most a step were needed for that");
  say(limits_.held_steps, "steps in which no parcel moved, as no ways were found that fit");
  say(sums[2], "ways were longer than a cell and were cut: take a shorter timestep");
  say(sums[3], "components of the stress were limited by the mean velocity");
  say(sums[4], "parcels were in cells whose return to isotropy was limited to its share");
  say(sums[5], "coordinates beyond a wall were put inside before the run");
}

}  // namespace LAMMPS_NS
