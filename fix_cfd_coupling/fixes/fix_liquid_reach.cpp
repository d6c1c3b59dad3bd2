// How far bridges reach, and the walls that grains have bridges to.
#include <algorithm>

#include "coupling/base/error.h"
#include "fix_cfd_coupling/fixes/fix_liquid.h"
#include "fix_cfd_coupling/fixes/host_error.h"
// --
#include "atom.h"
#include "comm.h"
#include "dialect_walls.h"

namespace LAMMPS_NS {

using gasgrain::liquid::WallBridges;

namespace {

// Films become uneven as bridges break: room for bridges this much longer than the first ones.
constexpr double reach_margin = 1.25;

}  // namespace

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
    double film = film_[k];
    if (film == unmet_) film = settings_.film_at_first(atom->radius[k]);
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
  gasgrain::show_contacts_within(*lmp, 1.0 + reach_, 1.0 + wall_reach_);
  return reach_;
}

WallBridges& FixLiquid::join_wall(const std::string& wall_id) {
  const gasgrain::WallFacts wall = gasgrain::wall_facts(*lmp, wall_id.c_str());
  WallBridges* found = nullptr;
  for (auto& known : walls_)
    if (known->id() == wall_id) found = known.get();
  const bool is_new = found == nullptr;
  if (is_new) {
    found = walls_.emplace_back(std::make_unique<WallBridges>(wall_id)).get();
    found->resize(static_cast<std::size_t>(atom->nmax));
  }
  for (const auto& setting : settings_.walls) {
    if (setting.id != wall_id || found->film().holds()) continue;
    const double area = setting.area ? *setting.area : wall.mesh_area.value_or(0.0);
    if (!(area > 0.0))
      gasgrain::stop_everything(fmt::format(
          "fix liquid: 'wall {} mesh' is no wall of meshes: give its area in m2 in the place of "
          "'mesh'.",
          wall_id));
    found->film().area = area;
    found->film().volume = setting.film;
    if (resumed_ || ledger_.at_first > 0.0) ledger_.came_in += setting.film;
  }
  found->type = wall.type - 1;
  show_far_enough(wall.shown_within, *found);
  return *found;
}

// `shown_within`: the gap [m] at which the host shows the wall for certain; without end where that
// is the distance of contacts, which is counted in radii.
void FixLiquid::show_far_enough(double shown_within, const WallBridges& bridges) {
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
    double film = film_[k];
    if (film == unmet_) film = settings_.film_at_first(radius);
    const double volume = film * share + bridges.film().given(radius);
    if (!(volume > 0.0)) continue;
    const double gap = reach_of(radius, atom->type[k] - 1, volume);
    longest[0] = std::max(longest[0], gap);
    longest[1] = std::max(longest[1], reach_margin * gap / radius);
  }
  MPI_Allreduce(MPI_IN_PLACE, longest, 2, MPI_DOUBLE, MPI_MAX, world);
  wall_reach_ = settings_.reach.value_or(std::max(longest[1], wall_reach_));
  gasgrain::show_wall_within(*lmp, bridges.id(), 1.0 + wall_reach_);
  if (longest[0] > shown_within)
    host_warning(
        fmt::format("fix liquid: bridges to the wall '{}' reach {:.3g} m, but the host "
                    "shows a primitive wall within half of the skin only. Write "
                    "'neighbor {:.2g} bin'.",
                    bridges.id(), longest[0], 2.0 * longest[0]));
}

}  // namespace LAMMPS_NS
