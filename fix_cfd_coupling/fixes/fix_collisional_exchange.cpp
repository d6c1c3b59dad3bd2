#include "fix_cfd_coupling/fixes/fix_collisional_exchange.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numeric>

#include "coupling/base/error.h"
#include "dialect_drift.h"
#include "fix_cfd_coupling/fixes/fix_parcels.h"
#include "fix_cfd_coupling/fixes/host_error.h"
#include "fix_cfd_coupling/fixes/host_session.h"
// --
#include "atom.h"
#include "comm.h"
#include "memory.h"
#include "modify.h"
#include "update.h"

namespace LAMMPS_NS {

namespace {

constexpr const char* property = "liquidFilm";
constexpr double round_off = 1e-12;  // of a particle's volume, that a film may be below 0
constexpr int reach_of_parcels = 1;  // beyond their sub-domain, a cell of leeway

}  // namespace

FixCollisionalExchange* FixCollisionalExchange::of_scene(LAMMPS* host) {
  for (int n = 0; n < host->modify->nfix; ++n)
    if (auto* found = dynamic_cast<FixCollisionalExchange*>(host->modify->fix[n])) return found;
  return nullptr;
}

FixCollisionalExchange::Words FixCollisionalExchange::read_words(LAMMPS* host, int narg,
                                                                 char** arg) {
  try {
    if (std::strcmp(arg[1], "all") != 0)
      gasgrain::fail("the group of fix collisional_exchange must be 'all', it is '{}'.", arg[1]);
    if (std::strcmp(host->update->unit_style, "si") != 0)
      gasgrain::fail("fix collisional_exchange needs 'units si', the script has 'units {}'.",
                     host->update->unit_style);
    if (of_scene(host) != nullptr)
      gasgrain::fail("there is a fix collisional_exchange already: a scene has one.");
    std::vector<std::string> words(arg + 3, arg + narg);
    const auto profile = gasgrain::take_profile(words);
    return {gasgrain::parse_exchange(words), profile};
  } catch (const gasgrain::Error& e) {
    gasgrain::stop_everything(e.what());
  }
}

FixCollisionalExchange::FixCollisionalExchange(LAMMPS* host, int narg, char** arg)
    : FixCollisionalExchange(host, narg, arg, read_words(host, narg, arg)) {}

FixCollisionalExchange::FixCollisionalExchange(LAMMPS* host, int narg, char** arg,
                                               const Words& words)
    : HostFix(host, narg, arg),
      settings_(words.exchange),
      profile_settings_(words.profile),
      exchange_(words.exchange) {
  nevery = settings_.every;
  vector_flag = 1;
  size_vector = static_cast<int>(count_of_species()) + 5;
  global_freq = 1;
  extvector = 0;
  peratom_flag = 1;
  size_peratom_cols = static_cast<int>(count_of_species()) + (settings_.film_temperature ? 1 : 0);
  peratom_freq = 1;
  restart_peratom = 1;
  create_attribute = 1;  // the host then calls set_arrays() for every atom it inserts
  grow_arrays(atom->nmax);
  atom->add_callback(0);
  atom->add_callback(1);
}

FixCollisionalExchange::~FixCollisionalExchange() {
  atom->delete_callback(id, 0);
  atom->delete_callback(id, 1);
  memory->destroy(array_atom);
}

int FixCollisionalExchange::mask() {
  // PRE_FORCE for setup_pre_force() alone.
  return FixConst::PRE_FORCE | FixConst::END_OF_STEP | FixConst::POST_RUN;
}

// The films stay when the fix is taken away: they are the grains'.
void FixCollisionalExchange::make_properties() {
  if (count_of_species() == 0) return;
  film_.make(*this, *lmp, property, 0.0, GrainScalar::Stays::with_the_grains);
}

void FixCollisionalExchange::check_scene() const {
  // Who makes films and parcels knows them before this fix takes them on.
  for (int n = modify->find_fix(id) + 1; n < modify->nfix; ++n)
    for (const char* maker : {"liquid", "parcels"})
      if (std::strcmp(modify->fix[n]->style, maker) == 0)
        gasgrain::stop_everything(
            fmt::format("fix collisional_exchange must stand after fix {} in the script: change "
                        "their order.",
                        maker));
  if (parcels_ != nullptr && !settings_.momentum)
    gasgrain::stop_everything(
        "fix collisional_exchange: 'momentum off' is for grains with contacts, which carry "
        "momentum "
        "themselves; parcels have none. Leave it out.");
  if (parcels_ == nullptr && settings_.momentum && comm->me == 0)
    for (FILE* sink : {screen, logfile})
      if (sink != nullptr)
        fmt::print(sink,
                   "collisional_exchange: warning: the scene has grains, whose contacts exchange "
                   "momentum already: write 'momentum off', or it counts twice.\n");
}

void FixCollisionalExchange::init() {
  parcels_ = FixParcels::of_scene(lmp);
  check_scene();
  if (film_) film_.find(*this, *lmp);
  try {
    if (cells_ == nullptr) {
      const auto own =
          settings_.cells || parcels_ == nullptr ? settings_.cells : parcels_->settings().cells;
      cells_ = std::make_unique<gasgrain::RankCells>(
          *lmp, gasgrain::grid_of_scene(*lmp, own, "fix collisional_exchange"));
      if (profile_settings_)
        profile_ =
            std::make_unique<gasgrain::ExchangeProfile>(*profile_settings_, cells_->frame().grid);
    }
  } catch (const gasgrain::Error& e) {
    gasgrain::stop_everything(e.what());
  }
}

void FixCollisionalExchange::setup_pre_force(int) {
  grains_have_values();
  if (film_) film_.grains_have_values();
  checked_ = false;
  // Parcels take their films' mass on before the gas and the balance of fix parcels see them.
  if (parcels_ != nullptr) take_films();
}

// Grains have the film that fix liquid gives them from here on.
void FixCollisionalExchange::setup(int) {
  take_films();
  for (int k = 0; k < atom->nlocal; ++k) show(k);
}

std::vector<std::string> FixCollisionalExchange::species() const {
  std::vector<std::string> names;
  for (const gasgrain::LiquidSpecies& one : settings_.species) names.push_back(one.name);
  return names;
}

double FixCollisionalExchange::film_volume(int k) const {
  double volume = 0.0;
  for (std::size_t i = 0; i < count_of_species(); ++i)
    volume +=
        mass_[static_cast<std::size_t>(k) * count_of_species() + i] / settings_.species[i].density;
  return volume;
}

void FixCollisionalExchange::admit(int k, const std::vector<double>& film_mass) {
  const std::size_t species = count_of_species();
  if (species == 0) return;
  std::copy_n(film_mass.begin(), species, mass_.begin() + static_cast<std::ptrdiff_t>(k * species));
  known_[static_cast<std::size_t>(k)] = film_[k] = film_volume(k);
  show(k);
}

// A film that someone else has changed (bridges, the script) keeps its mixture; one that was
// nothing is of the first species.
void FixCollisionalExchange::take_film(int k) {
  const auto n = static_cast<std::size_t>(k);
  const double given = film_[k];
  if (given == known_[n]) return;
  const double sphere = 4.0 / 3.0 * M_PI * std::pow(atom->radius[k], 3);
  if (!std::isfinite(given) || given < -round_off * sphere)
    gasgrain::stop_everything_from_here(
        fmt::format("fix collisional_exchange: the {} of atom {} is {}: give m3 of liquid on one "
                    "particle, 0 or more (0: dry).",
                    property, atom->tag[k], given));
  if (given < 0.0) ++total_.films_below_zero;
  const double volume = std::max(0.0, given);
  if (volume == known_[n]) return;
  const std::size_t species = count_of_species();
  double* mass = mass_.data() + n * species;
  if (known_[n] > 0.0)
    for (std::size_t i = 0; i < species; ++i) mass[i] *= volume / known_[n];
  else
    mass[0] = volume * settings_.species[0].density;
  known_[n] = volume;
  if (parcels_ != nullptr)
    parcels_->set_film(k, std::accumulate(mass, mass + species, 0.0), volume);
}

void FixCollisionalExchange::take_films() {
  if (count_of_species() == 0) return;
  for (int k = 0; k < atom->nlocal; ++k) take_film(k);
}

// What dumps see of an atom.
void FixCollisionalExchange::show(int k) {
  const std::size_t species = count_of_species();
  const auto n = static_cast<std::size_t>(k);
  for (std::size_t i = 0; i < species; ++i) array_atom[k][i] = mass_[n * species + i];
  if (settings_.film_temperature) array_atom[k][species] = temperature_[n];
}

void FixCollisionalExchange::give_films() {
  const std::size_t species = count_of_species();
  for (int k = 0; k < atom->nlocal && species > 0; ++k) {
    const auto n = static_cast<std::size_t>(k);
    const double volume = film_volume(k);
    if (volume != known_[n]) film_[k] = known_[n] = volume;
    const double* mass = mass_.data() + n * species;
    if (parcels_ != nullptr)
      parcels_->set_film(k, std::accumulate(mass, mass + species, 0.0), volume);
    show(k);
  }
}

gasgrain::ExchangeView FixCollisionalExchange::view() {
  gasgrain::ExchangeView view;
  view.count = static_cast<std::size_t>(atom->nlocal);
  cell_.resize(view.count);
  for (int k = 0; k < atom->nlocal; ++k)
    cell_[static_cast<std::size_t>(k)] = cells_->offset(atom->x[k]);
  view.cell = cell_.data();
  view.velocity = atom->nlocal > 0 ? atom->v[0] : nullptr;
  view.film_mass = mass_.data();
  if (settings_.film_temperature) view.film_temperature = temperature_.data();
  view.film_has_inertia = parcels_ != nullptr;
  if (parcels_ != nullptr) {
    view.particles = parcels_->sizes();
    view.solid_mass = parcels_->solid_mass();
    view.solid_volume = parcels_->solid_volume();
    return view;
  }
  view.solid_mass = atom->rmass;
  solid_volume_.resize(view.count);
  for (int k = 0; k < atom->nlocal; ++k)
    solid_volume_[static_cast<std::size_t>(k)] = 4.0 / 3.0 * M_PI * std::pow(atom->radius[k], 3);
  view.solid_volume = solid_volume_.data();
  return view;
}

void FixCollisionalExchange::end_of_step() {
  try {
    // Parcels were handed to their ranks in this step.
    const double drift = parcels_ != nullptr ? 0.0 : gasgrain::drift_of_grains(*lmp);
    cells_->follow_domain(drift, reach_of_parcels);
    take_films();
    const gasgrain::ExchangeView particles = view();
    const gasgrain::TileFrame& frame = cells_->frame();
    if (!checked_) gasgrain::check_view(particles, count_of_species(), frame.tile);
    checked_ = true;
    last_ = exchange_.step(particles, frame.tile, frame.grid.cell_volume(),
                           update->dt * settings_.every, cells_->sum());
    total_ += last_;
    give_films();
    if (profile_)
      profile_->add(particles, exchange_.cells(), frame,
                    static_cast<double>(update->ntimestep) * update->dt, cells_->sum());
  } catch (const gasgrain::Error& e) {
    gasgrain::stop_everything_from_here(e.what());
  }
}

// What acted at the limits of the model, once a run.
void FixCollisionalExchange::post_run() {
  try {
    if (profile_) profile_->write(gasgrain::session().local);
  } catch (const gasgrain::Error& e) {
    gasgrain::stop_everything(e.what());
  }
  double sums[4] = {static_cast<double>(total_.at_close_packing),
                    static_cast<double>(total_.films_without_solid),
                    static_cast<double>(total_.films_below_zero),
                    static_cast<double>(total_.temperatures_beyond_range)};
  MPI_Allreduce(MPI_IN_PLACE, sums, 4, MPI_DOUBLE, MPI_SUM, world);
  if (comm->me != 0) return;
  const auto say = [&](double count, const char* what) {
    if (count == 0.0) return;
    for (FILE* sink : {screen, logfile})
      if (sink != nullptr) fmt::print(sink, "collisional_exchange: {:.0f} {}\n", count, what);
  };
  say(sums[0], "times a parcel was in a cell at close packing, where collisions equalise at once");
  say(sums[1], "times a film was in a cell without any solid, and stayed as it was");
  say(sums[2], "times a film came with a negative mass");
  say(sums[3],
      "times a film's temperature was beyond the range of a species' heat, held at its end");
}

double FixCollisionalExchange::compute_vector(int n) {
  const auto& ranks = gasgrain::session().local;
  const auto species = static_cast<int>(count_of_species());
  if (n < species) {
    double held = 0.0;
    for (int k = 0; k < atom->nlocal; ++k)
      held += (parcels_ != nullptr ? parcels_->sizes()[k] : 1.0) *
              mass_[static_cast<std::size_t>(k) * count_of_species() + static_cast<std::size_t>(n)];
    return ranks.sum(held);
  }
  const gasgrain::ExchangeCells& cells = exchange_.cells();
  double value = 0.0;
  switch (n - species) {
    case 0:
      for (const double u : cells.rms_velocity) value = std::max(value, u);
      return ranks.max(value);
    case 1:
      value = HUGE_VAL;
      for (const double tau : cells.collision_time) value = std::min(value, tau);
      return ranks.min(value);
    case 2:
      return ranks.sum(static_cast<double>(last_.at_close_packing));
    case 3:
      return ranks.sum(total_.liquid_moved);
    default:
      return ranks.sum(total_.energy_lost);
  }
}

}  // namespace LAMMPS_NS
