// What becomes of bridges when a grain leaves, a wall is taken away, or the script changes the
// grains.
#include <algorithm>
#include <vector>

#include "coupling/base/error.h"
#include "fix_cfd_coupling/fixes/fix_liquid.h"
#include "fix_cfd_coupling/fixes/fix_liquid_bridges.h"
// --
#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "modify.h"

namespace LAMMPS_NS {

using gasgrain::liquid::StoredBridge;

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
      film_[k] += gasgrain::liquid::given_by_i(b);
      counts_.broken += 0.5;
      dissolved += 0.5;
      b.clear();
    });
  MPI_Allreduce(MPI_IN_PLACE, &dissolved, 1, MPI_DOUBLE, MPI_SUM, world);
  if (dissolved > 0.0)
    host_warning(
        fmt::format("fix liquid: the grains were given new numbers, and {} bridges were "
                    "broken as the host lost track of them. Write 'delete_atoms ... "
                    "compress no'.",
                    dissolved));
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
    if (film_[k] != unmet_) gone_liquid_ += film_[k];
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
      film_[k] += gasgrain::liquid::given_by_i(b);
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
        film_[k] += back.to_i;
        gone_liquid_ += back.to_j;
      }
    }
    if (comm->me == 0) gone_liquid_ += (*wall)->film().volume;
    wall = walls_.erase(wall);
  }
}

}  // namespace LAMMPS_NS
