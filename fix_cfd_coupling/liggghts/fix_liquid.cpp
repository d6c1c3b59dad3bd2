#include "fix_cfd_coupling/liggghts/fix_liquid.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "coupling/base/error.h"
#include "fix_cfd_coupling/dem_physics/liquid/saturation.h"
#include "fix_cfd_coupling/liggghts/fix_liquid_bridges.h"
#include "fix_cfd_coupling/liggghts/host_error.h"
// --
#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "fix_mesh_surface.h"
#include "fix_property_atom.h"
#include "fix_wall_gran.h"
#include "force.h"
#include "memory.h"
#include "modify.h"
#include "neighbor.h"
#include "tri_mesh.h"
#include "update.h"

namespace LAMMPS_NS {

using gasgrain::Vec3;
using gasgrain::liquid::GrainFilms;
using gasgrain::liquid::StoredBridge;
using gasgrain::liquid::WallBridges;

namespace {

constexpr const char* property = "liquidFilm";
// Films become uneven as bridges break: room for bridges this much longer than the first ones.
constexpr double reach_margin = 1.25;

// A grain that was inserted and has not met the fix yet; no film is negative.
constexpr double unmet = -1.0;

}  // namespace

FixLiquid::FixLiquid(LAMMPS* host, int narg, char** arg) : Fix(host, narg, arg) {
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

int FixLiquid::setmask() {
  return FixConst::PRE_EXCHANGE | FixConst::PRE_FORCE | FixConst::END_OF_STEP;
}

void FixLiquid::post_create() {
  film_ = static_cast<FixPropertyAtom*>(
      modify->find_fix_property(property, "property/atom", "scalar", 0, 0, style, false));
  if (film_ != nullptr) return;
  const char* words[] = {property, "all", "property/atom", property, "scalar", "yes", "no",
                         "no",     "-1."};
  film_ = modify->add_fix_property_atom(9, const_cast<char**>(words), style);
}

void FixLiquid::pre_delete(bool unfixed) {
  if (unfixed) modify->delete_fix(property);
}

FixLiquid& FixLiquid::of_scene(LAMMPS* host) {
  for (int n = 0; n < host->modify->nfix; ++n)
    if (auto* found = dynamic_cast<FixLiquid*>(host->modify->fix[n])) return *found;
  gasgrain::stop_everything(
      "'cohesion bridge' has no liquid: add a line before the first run, for instance\n"
      "  fix liquid all liquid content 0.01 surface_tension 0.0728 contact_angle 0.35");
}

// Called from the pair style's init, before that of the fixes.
double FixLiquid::join_pairs(int history_offset) {
  history_offset_ = history_offset;
  double reach = settings_.reach.value_or(0.0);
  double most = settings_.film_at_first(1.0);
  double largest = 0.0;
  for (int k = 0; k < atom->nlocal; ++k) largest = std::max(largest, atom->radius[k]);
  MPI_Allreduce(MPI_IN_PLACE, &largest, 1, MPI_DOUBLE, MPI_MAX, world);
  const auto reach_of = [&](double radius, double film) {
    const double share =
        gasgrain::liquid::given_share(settings_, radius, std::max(radius, largest));
    const double widest =
        *std::max_element(settings_.contact_angles.begin(), settings_.contact_angles.end());
    const auto b = gasgrain::bridge::bridge_of_grains(
        radius, radius, widest, widest, settings_.surface_tension, 2.0 * share * film);
    const double bridge =
        film > 0.0 ? reach_margin * gasgrain::liquid::rupture_distance(settings_, b) : 0.0;
    return std::max(bridge, settings_.formation_gap) / (2.0 * radius);
  };
  double found = settings_.content.value_or(0.0) > 0.0 ? reach_of(1.0, most) : 0.0;
  for (int k = 0; k < atom->nlocal; ++k) {
    double film = film_->vector_atom[k];
    if (film == unmet) film = settings_.film_at_first(atom->radius[k]);
    most = std::max(most, film);
    if (film > 0.0) found = std::max(found, reach_of(atom->radius[k], film));
  }
  double both[2] = {found, most};
  MPI_Allreduce(MPI_IN_PLACE, both, 2, MPI_DOUBLE, MPI_MAX, world);
  for (const auto& wall : settings_.walls) both[1] = std::max(both[1], wall.film);
  wet_ = both[1] > 0.0 || ledger_.at_first + ledger_.came_in > ledger_.gone;
  if (!wet_) return reach_ = 0.0;
  // Later all liquid may be in bridges, and films tell nothing: it never falls.
  if (reach == 0.0) reach = std::max(both[0], reach_);
  if (reach == 0.0)
    gasgrain::stop_everything(
        "fix liquid: the grains are still to come, and 'film' does not tell how far their bridges "
        "reach. Add 'reach F', the greatest gap of a bridge over r_i + r_j (0.1 is common).");
  reach_ = reach;
  // That of walls is known after this in a first run, and here in the next or after a restart: the
  // lists, and with them the order of sums, are then the same.
  neighbor->register_contact_dist_factor(1.0 + std::max(reach_, wall_reach_));
  return reach_;
}

WallBridges& FixLiquid::join_wall(FixWallGran& wall) {
  WallBridges* found = nullptr;
  for (auto& known : walls_)
    if (known->id() == wall.id) found = known.get();
  const bool is_new = found == nullptr;
  if (is_new) {
    found = walls_.emplace_back(std::make_unique<WallBridges>(wall.id)).get();
    found->resize(static_cast<std::size_t>(atom->nmax));
  }
  for (const auto& setting : settings_.walls) {
    if (setting.id != wall.id || found->film().holds()) continue;
    double area = setting.area.value_or(0.0);
    if (!setting.area)
      for (int n = 0; n < wall.n_meshes(); ++n)
        area += wall.mesh_list()[n]->triMesh()->areaMeshGlobal();
    if (!(area > 0.0))
      gasgrain::stop_everything(fmt::format(
          "fix liquid: 'wall {} mesh' is no wall of meshes: give its area in m2 in the place of "
          "'mesh'.",
          wall.id));
    found->film().area = area;
    found->film().volume = setting.film;
    if (resumed_ || ledger_.at_first > 0.0) ledger_.came_in += setting.film;
  }
  if (wall.is_mesh_wall() && wall.n_meshes() > 0)
    found->type = wall.mesh_list()[0]->atomTypeWall() - 1;
  else
    found->type = wall.atom_type_wall() - 1;
  show_far_enough(wall, *found);
  return *found;
}

// The host shows a wall to a grain within its contact distance, which is counted in radii, and a
// primitive wall within the skin as it was when the lists were made, half of it for certain.
void FixLiquid::show_far_enough(FixWallGran& wall, const WallBridges& bridges) {
  double longest[2] = {0.0, 0.0};  // [m], over the radius
  const double share = settings_.given_share.value_or(gasgrain::liquid::shadow_share_of_wall);
  const auto reach_of = [&](double radius, int type, double volume) {
    return gasgrain::liquid::rupture_distance(settings_,
                                              bridges.bridge_of(settings_, radius, type, volume));
  };
  // Grains that are still to come: a share of their volume tells, whatever their radius.
  if (settings_.content.value_or(0.0) > 0.0)
    for (int type = 0; type < atom->ntypes; ++type)
      longest[1] = std::max(
          longest[1], reach_margin * reach_of(1.0, type, settings_.film_at_first(1.0) * share));
  for (int k = 0; k < atom->nlocal; ++k) {
    const double radius = atom->radius[k];
    double film = film_->vector_atom[k];
    if (film == unmet) film = settings_.film_at_first(radius);
    const double volume = film * share + bridges.film().given(radius);
    if (!(volume > 0.0)) continue;
    const double gap = reach_of(radius, atom->type[k] - 1, volume);
    longest[0] = std::max(longest[0], gap);
    longest[1] = std::max(longest[1], reach_margin * gap / radius);
  }
  MPI_Allreduce(MPI_IN_PLACE, longest, 2, MPI_DOUBLE, MPI_MAX, world);
  wall_reach_ = settings_.reach.value_or(std::max(longest[1], wall_reach_));
  neighbor->register_contact_dist_factor(1.0 + wall_reach_);
  if (!wall.is_mesh_wall() && longest[0] > 0.5 * neighbor->skin && comm->me == 0)
    error->warning(FLERR,
                   fmt::format("fix liquid: bridges to the wall '{}' reach {:.3g} m, but the host "
                               "shows a primitive wall within half of the skin only. Write "
                               "'neighbor {:.2g} bin'.",
                               wall.id, longest[0], 2.0 * longest[0])
                       .c_str());
}

void FixLiquid::init() {
  pairs_ = static_cast<PairGran*>(force->pair_match("gran", 0));
  if (pairs_ == nullptr) gasgrain::stop_everything("fix liquid needs 'pair_style gran'.");
  if (force->newton_pair != 0)
    gasgrain::stop_everything("fix liquid needs 'newton off' before the box is made.");
  film_ = static_cast<FixPropertyAtom*>(
      modify->find_fix_property(property, "property/atom", "scalar", 0, 0, style));
}

void FixLiquid::check_walls() const {
  if (history_offset_ < 0 && walls_.empty())
    gasgrain::stop_everything(
        "fix liquid has no effect: neither 'pair_style gran' nor a 'fix wall/gran' has 'cohesion "
        "bridge' among its models. Add it, or take the fix away.");
  std::vector<std::string> ids;
  for (const auto& wall : walls_) ids.push_back(wall->id());
  for (const auto& setting : settings_.walls)
    if (std::find(ids.begin(), ids.end(), setting.id) == ids.end())
      gasgrain::stop_everything(fmt::format(
          "fix liquid: wall \"{}\" is no fix wall/gran with 'cohesion bridge'.{}", setting.id,
          ids.empty() ? " There is none." : gasgrain::suggestion(setting.id, ids)));
}

void FixLiquid::check_films() const {
  for (int k = 0; k < atom->nlocal; ++k) {
    const double film = film_->vector_atom[k];
    if (film == unmet || (std::isfinite(film) && film >= -1e-12 * std::abs(solid_volume(k))))
      continue;
    gasgrain::stop_everything_from_here(fmt::format(
        "the liquidFilm of grain {} is {}: give m3, 0 or more (0: dry).", atom->tag[k], film));
  }
}

void FixLiquid::setup_pre_force(int) {
  check_walls();
  check_films();
  // Else the host gives both their values of a new grain once more, after this.
  just_created = film_->just_created = 0;
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

// Grains that the host has inserted get their film here, where their radius is known.
void FixLiquid::meet_new_grains() {
  for (int k = 0; k < atom->nlocal; ++k) {
    double& film = film_->vector_atom[k];
    if (film != unmet) continue;
    film = settings_.film_at_first(atom->radius[k]);
    new_liquid_ += film;
    new_grains_ += 1.0;
  }
}

void FixLiquid::publish_films() {
  if (!wet_) return;
  for (int k = 0; k < atom->nlocal; ++k) {
    films_.publish(k, film_->vector_atom[k], atom->radius[k], atom->rmass[k]);
    number_[static_cast<std::size_t>(k)] = atom->tag[k];
    position_[static_cast<std::size_t>(k)] = Vec3(atom->x[k][0], atom->x[k][1], atom->x[k][2]);
  }
  comm->forward_comm_fix(this);
}

int FixLiquid::pack_comm(int count, int* list, double* buffer, int, int*) {
  for (int n = 0; n < count; ++n) {
    const int k = list[n];
    const GrainFilms::Published& p = films_.published(k);
    *buffer++ = p.film;
    *buffer++ = p.thickness;
    *buffer++ = p.scale;
    *buffer++ = p.open;
    *buffer++ = p.bridges_over_mass;
    if (!periodic_) continue;
    for (int d = 0; d < 3; ++d) *buffer++ = position_[static_cast<std::size_t>(k)][d];
  }
  return comm_forward;
}

void FixLiquid::unpack_comm(int count, int first, double* buffer) {
  for (int k = first; k < first + count; ++k) {
    films_.published(k) = {buffer[0], buffer[1], buffer[2], buffer[3], buffer[4]};
    buffer += GrainFilms::Published::size;
    if (!periodic_) continue;
    position_[static_cast<std::size_t>(k)] = Vec3(buffer[0], buffer[1], buffer[2]);
    buffer += 3;
  }
}

Vec3 FixLiquid::between(int i, int k) const {
  Vec3 d = position_[static_cast<std::size_t>(i)] - position_[static_cast<std::size_t>(k)];
  domain->minimum_image(d[0], d[1], d[2]);
  return d;
}

void FixLiquid::pre_force(int) {
  if (neighbor->ago == 0) {
    meet_new_grains();
    if (wet_) take_back_from_lost_partners();
  }
  publish_films();
}

// Grains that the host is about to drop, beyond a fixed face of the box, take their films and what
// they gave to their bridges along.
void FixLiquid::pre_exchange() {
  leave_box(true);
}

// Between two runs the script may have deleted grains, and the list of contacts is of others.
void FixLiquid::setup_pre_exchange() {
  dissolve_bridges_of_renumbered_grains();
  leave_box(false);
}

// `delete_atoms` gives grains new numbers unless it is told `compress no`, and contacts, which are
// stored by number, go to others. Each grain then takes back what it gave.
void FixLiquid::dissolve_bridges_of_renumbered_grains() {
  int renumbered = 0;
  for (int k = 0; k < atom->nlocal; ++k) {
    const double before = number_[static_cast<std::size_t>(k)];
    if (before != 0.0 && before != atom->tag[k]) renumbered = 1;
  }
  MPI_Allreduce(MPI_IN_PLACE, &renumbered, 1, MPI_INT, MPI_MAX, world);
  if (renumbered == 0) return;
  double dissolved = 0.0;
  for (int k = 0; k < atom->nlocal; ++k)
    for_each_stored(k, [&](int, StoredBridge& b) {
      film_->vector_atom[k] += gasgrain::liquid::given_by_i(b);
      counts_.broken += 0.5;
      dissolved += 0.5;
      b.clear();
    });
  MPI_Allreduce(MPI_IN_PLACE, &dissolved, 1, MPI_DOUBLE, MPI_SUM, world);
  if (comm->me == 0 && dissolved > 0.0)
    error->warning(FLERR,
                   fmt::format("fix liquid: the grains were given new numbers, and {} bridges were "
                               "broken as the host lost track of them. Write 'delete_atoms ... "
                               "compress no'.",
                               dissolved)
                       .c_str());
}

void FixLiquid::leave_box(bool from_list) {
  if (!wet_) return;
  const auto leaves = [&](int k) {
    for (int d = 0; d < 3; ++d)
      if (domain->periodicity[d] == 0 &&
          (atom->x[k][d] < domain->boxlo[d] || atom->x[k][d] >= domain->boxhi[d]))
        return domain->boundary[d][0] == 1 || domain->boundary[d][1] == 1;
    return false;
  };
  std::vector<bool> leaving(static_cast<std::size_t>(atom->nlocal), false);
  bool any = false;
  for (int k = 0; k < atom->nlocal; ++k) {
    if (!leaves(k)) continue;
    any = leaving[static_cast<std::size_t>(k)] = true;
    gone_grains_ += 1.0;
    if (film_->vector_atom[k] != unmet) gone_liquid_ += film_->vector_atom[k];
    for (auto& wall : walls_) gone_liquid_ += std::max(0.0, wall->slot(k).bridge.volume);
    if (!from_list)
      for_each_stored(
          k, [&](int, const StoredBridge& b) { gone_liquid_ += gasgrain::liquid::given_by_i(b); });
  }
  if (!any || !from_list) return;
  const int owned = static_cast<int>(leaving.size());
  for_each_bridge([&](int i, int j, const StoredBridge& b) {
    if (i < owned && leaving[static_cast<std::size_t>(i)])
      gone_liquid_ += gasgrain::liquid::given_by_i(b);
    if (j < owned && leaving[static_cast<std::size_t>(j)])
      gone_liquid_ += gasgrain::liquid::given_by_j(b);
  });
}

// After the neighbour lists were built: a bridge whose other grain is gone leaves what its own
// grain gave. The host's per-grain memory still has it, the list has not.
void FixLiquid::take_back_from_lost_partners() {
  if (history_offset_ < 0) return;
  std::vector<int> listed(static_cast<std::size_t>(atom->nlocal), 0);
  for_each_bridge([&](int i, int j, const StoredBridge&) {
    ++listed[static_cast<std::size_t>(i)];
    if (j < atom->nlocal) ++listed[static_cast<std::size_t>(j)];
  });
  for (int k = 0; k < atom->nlocal; ++k) {
    int stored = 0;
    for_each_stored(k, [&](int, const StoredBridge&) { ++stored; });
    if (stored == listed[static_cast<std::size_t>(k)]) continue;
    std::vector<int> partners;
    for_each_bridge([&](int i, int j, const StoredBridge&) {
      if (i == k) partners.push_back(atom->tag[j]);
      if (j == k) partners.push_back(atom->tag[i]);
    });
    for_each_stored(k, [&](int partner, const StoredBridge& b) {
      if (std::find(partners.begin(), partners.end(), partner) != partners.end()) return;
      film_->vector_atom[k] += gasgrain::liquid::given_by_i(b);
      counts_.broken += 1.0;
    });
  }
}

// The script may have given the liquid other properties than it had when the bridges formed.
void FixLiquid::renew_contacts() {
  for_each_bridge([&](int i, int j, StoredBridge& b) {
    const auto& angle = settings_.angle_between(atom->type[i] - 1, atom->type[j] - 1);
    know_contact(settings_,
                 gasgrain::bridge::bridge_of_grains(atom->radius[i], atom->radius[j], angle,
                                                    settings_.surface_tension, b.volume),
                 b);
  });
  for (auto& wall : walls_)
    for (int k = 0; k < atom->nlocal; ++k)
      if (StoredBridge& b = wall->slot(k).bridge; b.stands())
        know_contact(settings_,
                     wall->bridge_of(settings_, atom->radius[k], atom->type[k] - 1, b.volume), b);
}

void FixLiquid::part_with_removed_walls() {
  for (auto wall = walls_.begin(); wall != walls_.end();) {
    if (modify->find_fix((*wall)->id().c_str()) >= 0) {
      ++wall;
      continue;
    }
    for (int k = 0; k < atom->nlocal; ++k) {
      StoredBridge& b = (*wall)->slot(k).bridge;
      if (b.stands()) {
        const auto back = (*wall)->divided(settings_, b, atom->radius[k], atom->type[k] - 1);
        film_->vector_atom[k] += back.to_i;
        gone_liquid_ += back.to_j;
      }
    }
    if (comm->me == 0) gone_liquid_ += (*wall)->film().volume;
    wall = walls_.erase(wall);
  }
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
      film_->vector_atom[k] = films_.settle(k, film_->vector_atom[k], settings_.bridges_max);
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
