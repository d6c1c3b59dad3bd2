#include "fix_cfd_coupling/fixes/fix_liquid.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "coupling/base/error.h"
#include "fix_cfd_coupling/dem_physics/liquid/saturation.h"
#include "fix_cfd_coupling/fixes/host_error.h"
// --
#include "atom.h"
#include "comm.h"
#include "dialect_words.h"
#include "domain.h"
#include "force.h"
#include "memory.h"
#include "modify.h"
#include "neighbor.h"
#include "update.h"

namespace LAMMPS_NS {

using gasgrain::liquid::GrainFilms;

namespace {

constexpr const char* property = "liquidFilm";

}  // namespace

FixLiquid::FixLiquid(LAMMPS* host, int narg, char** arg) : HostFix(host, narg, arg) {
  try {
    if (std::strcmp(arg[1], "all") != 0)
      gasgrain::fail("the group of fix liquid must be 'all', it is '{}': dry grains have film 0.",
                     arg[1]);
    if (std::strcmp(update->unit_style, "si") != 0)
      gasgrain::fail("fix liquid needs 'units si', the script has 'units {}'.", update->unit_style);
    for (int n = 0; n < modify->nfix; ++n)
      if (dynamic_cast<FixLiquid*>(modify->fix[n]) != nullptr)
        gasgrain::fail("there is a fix liquid already ('{}'): a scene has one.",
                       modify->fix[n]->id);
    settings_ = gasgrain::liquid::parse_liquid({arg + 3, arg + narg}, atom->ntypes);
  } catch (const gasgrain::Error& e) {
    gasgrain::stop_everything(e.what());
  }
  nevery = 1;
  vector_flag = 1;
  size_vector = 9;
  global_freq = 1;
  extvector = 0;
  peratom_flag = 1;
  size_peratom_cols = 2;
  peratom_freq = 1;
  restart_global = 1;
  restart_peratom = 1;
  create_attribute = 1;  // the host then calls set_arrays() for every grain it inserts
  periodic_ = domain->xperiodic != 0 || domain->yperiodic != 0 || domain->zperiodic != 0;
  comm_forward = GrainFilms::Published::size + (periodic_ ? 3 : 0);
  grow_arrays(atom->nmax);
  atom->add_callback(0);
  atom->add_callback(1);
}

FixLiquid::~FixLiquid() {
  atom->delete_callback(id, 0);
  atom->delete_callback(id, 1);
  memory->destroy(array_atom);
}

int FixLiquid::mask() {
  return FixConst::PRE_EXCHANGE | FixConst::PRE_FORCE | FixConst::END_OF_STEP | FixConst::POST_RUN;
}

void FixLiquid::make_properties() {
  film_.make(*this, *lmp, property, unmet_, GrainScalar::Stays::with_the_fix);
}

FixLiquid& FixLiquid::of_scene(LAMMPS* host) {
  for (int n = 0; n < host->modify->nfix; ++n)
    if (auto* found = dynamic_cast<FixLiquid*>(host->modify->fix[n])) return *found;
  gasgrain::stop_everything(
      "'cohesion bridge' has no liquid: add a line before the first run, for instance\n"
      "  fix liquid all liquid content 0.01 surface_tension 0.0728 contact_angle 0.35");
}

void FixLiquid::init() {
  contacts_.find(*lmp);
  if (!contacts_)
    gasgrain::stop_everything(
        fmt::format("fix liquid needs '{}'.", gasgrain::words::grain_pair_style));
  if (force->newton_pair != 0)
    gasgrain::stop_everything("fix liquid needs 'newton off' before the box is made.");
  film_.find(*this, *lmp);
}

void FixLiquid::check_walls() const {
  if (history_offset_ < 0 && walls_.empty())
    gasgrain::stop_everything(
        fmt::format("fix liquid has no effect: neither '{}' nor a '{}' has 'cohesion bridge' among "
                    "its models. Add it, or take the fix away.",
                    gasgrain::words::grain_pair_style, gasgrain::words::grain_wall));
  std::vector<std::string> ids;
  for (const auto& wall : walls_) ids.push_back(wall->id());
  for (const auto& setting : settings_.walls)
    if (std::find(ids.begin(), ids.end(), setting.id) == ids.end())
      gasgrain::stop_everything(
          fmt::format("fix liquid: wall \"{}\" is no {} with 'cohesion bridge'.{}", setting.id,
                      gasgrain::words::grain_wall,
                      ids.empty() ? " There is none." : gasgrain::suggestion(setting.id, ids)));
}

void FixLiquid::check_films() const {
  for (int k = 0; k < atom->nlocal; ++k) {
    const double film = film_[k];
    if (film == unmet_ || (std::isfinite(film) && film >= -1e-12 * std::abs(solid_volume(k))))
      continue;
    gasgrain::stop_everything_from_here(fmt::format(
        "the liquidFilm of grain {} is {}: give m3, 0 or more (0: dry).", atom->tag[k], film));
  }
}

void FixLiquid::setup_pre_force(int) {
  check_walls();
  check_films();
  grains_have_values();
  film_.grains_have_values();
  part_with_removed_walls();
  meet_new_grains();
  if (wet_) {
    take_back_from_lost_partners();
    renew_contacts();
  }
  begin_ledger();
  publish_films();
}

void FixLiquid::setup(int) {
  if (update->ntimestep % settings_.every == 0) record();
}

void FixLiquid::pre_force(int) {
  if (neighbor->ago == 0) {
    meet_new_grains();
    if (wet_) take_back_from_lost_partners();
  }
  publish_films();
}

void FixLiquid::settle_walls() {
  std::vector<double> sums;
  bool hold = false;
  for (auto& wall : walls_) {
    hold = hold || wall->film().holds();
    sums.push_back(wall->change());
    sums.push_back(wall->asked_share());
  }
  if (!hold) return;
  MPI_Allreduce(MPI_IN_PLACE, sums.data(), static_cast<int>(sums.size()), MPI_DOUBLE, MPI_SUM,
                world);
  for (std::size_t w = 0; w < walls_.size(); ++w) walls_[w]->settle(sums[2 * w], sums[2 * w + 1]);
}

void FixLiquid::end_of_step() {
  if (wet_) {
    for (auto& wall : walls_)
      for (int k = 0; k < atom->nlocal; ++k)
        wall->advance(settings_, films_, counts_, k, atom->radius[k], atom->type[k] - 1);
    for (int k = 0; k < atom->nlocal; ++k) {
      film_[k] = films_.settle(k, film_[k], settings_.bridges_max);
      array_atom[k][0] = films_.tally(k).bridges;
      array_atom[k][1] = films_.tally(k).bridged;
    }
    settle_walls();
  }
  if (update->ntimestep % settings_.every == 0) record();
}

double FixLiquid::solid_volume(int k) const {
  const double r = atom->radius[k];
  return 4.0 / 3.0 * gasgrain::bridge::pi * r * r * r;
}

double FixLiquid::saturation(int k) const {
  return gasgrain::liquid::saturation(films_.tally(k).bridged, solid_volume(k),
                                      settings_.packing_void_fraction);
}

}  // namespace LAMMPS_NS
