// New pairs for single grains, while the lists of all others stay as they are.
//
// A list has all pairs that were nearer than their reach R, contact and skin, when they were looked
// for: each grain at its own moment. As long as no grain has moved half a skin since its own,
// nobody can touch a grain that is not in its list. One that has looks around again, from where it
// is now, at where the others were at theirs; pairs that it finds are added behind its own, those
// that have come apart stay, until all lists are made anew.
//
// Ranks see ghosts that were within G of them when all lists were made. A grain that is then
// D away from the next rank (or periodic side) may move max(s / 2, D - C - s / 2) from there, with
// C the longest reach without skin and s = G - C: of two grains without a ghost of each other, at
// least max(G, D_i) + D_j apart, the moves then add up to less than what is missing to C.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <string_view>
#include <utility>

#include "fix_cfd_coupling/fixes/fix_couple_gas.h"
#include "fix_cfd_coupling/fixes/host_error.h"
#include "fix_cfd_coupling/liggghts/fix_contact_history_packed.h"
#include "fix_cfd_coupling/liggghts/fix_wall_gran_fused.h"
#include "fix_cfd_coupling/liggghts/neighbor_sorted.h"
#include "fix_cfd_coupling/liggghts/pair_gran_bridge.h"
// --
#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "fix_property_atom.h"
#include "force.h"
#include "modify.h"
#include "neigh_list.h"
#include "neigh_request.h"
#include "update.h"

namespace gasgrain {

namespace {

// New pairs for one grain take as long as those of about five in lists that are all made anew, and
// longer the more grains have left their places: beyond these shares of a rank's grains all lists
// are as cheap (the second measured in a jet: 0.1 and 0.2 are best, 0.5 and 1.5 take 1.2 and 1.6
// times).
constexpr double share_at_once = 1.0 / 16.0;
constexpr double share_since_build = 0.2;

constexpr double gone = 1e300;  // [m], of a place that no grain is near to

bool whole_lists_wanted() {
  const char* wish = std::getenv("GASGRAIN_LISTS");
  const std::string_view word = wish == nullptr ? "" : wish;
  if (!word.empty() && word != "whole" && word != "single")
    stop_everything(fmt::format(
        "GASGRAIN_LISTS={}: it is whole, all neighbour lists are made anew at once, or single, "
        "which is as without it: beside pair_style gran/bridge fast grains get new pairs by "
        "themselves.",
        word));
  return word == "whole";
}

// Fixes act upon the making of all lists; of these it is known that they do not wait for it.
bool goes_on(LAMMPS_NS::Fix& fix, int mask) {
  if ((mask & (FixConst::PRE_EXCHANGE | FixConst::PRE_NEIGHBOR)) == 0) return true;
  if (const auto* wall = dynamic_cast<LAMMPS_NS::FixWallGranFused*>(&fix); wall != nullptr)
    return wall->follows_renewed_lists();
  if (dynamic_cast<LAMMPS_NS::FixContactHistoryPacked*>(&fix) != nullptr ||
      dynamic_cast<LAMMPS_NS::FixPropertyAtom*>(&fix) != nullptr ||
      dynamic_cast<LAMMPS_NS::FixCoupleGas*>(&fix) != nullptr)
    return true;
  return (mask & FixConst::PRE_NEIGHBOR) == 0 && fix.force_reneighbor != 0;
}

}  // namespace

// Of pair_style gran/bridge: why all lists are made anew as soon as one grain has moved half the
// skin; empty: they are not.
std::string NeighborSorted::needs_whole_lists() const {
  const auto& pair = dynamic_cast<LAMMPS_NS::PairGranBridge&>(*force->pair);
  if (whole_lists_wanted()) return "GASGRAIN_LISTS asks for it";
  if (!pair.follows_renewed_lists())
    return "contacts have cohesion or no history, or come one after the other";
  if (exclude != 0 || includegroup != 0) return "neigh_modify leaves out pairs";
  if (build_once != 0) return "neigh_modify makes them once";
  if (domain->triclinic != 0 || domain->box_change != 0) return "the box is oblique or changes";
  if (others_read_bins_) return "somebody reads the bins of grains";
  // The requests of this run: the host has put them aside.
  for (int n = 0; n < old_nrequest; ++n)
    if (old_requests[n]->requestor != force->pair) return "somebody else has a list of neighbours";
  if (atom->radvary_flag != 0) return "radii change";
  for (int n = 0; n < modify->nfix; ++n) {
    LAMMPS_NS::Fix& fix = *modify->fix[n];
    if (std::string_view(fix.style) == "adapt") return "fix adapt may change radii";
    if (!goes_on(fix, modify->fmask[n]))
      return fmt::format("fix {} {} acts when they are made", fix.id, fix.style);
  }
  return "";
}

// A rank whose grains are not sorted cannot renew lists, and all others wait for it.
void NeighborSorted::begin_renewals(bool sorted) {
  int all_sorted = sorted ? 1 : 0;
  MPI_Allreduce(MPI_IN_PLACE, &all_sorted, 1, MPI_INT, MPI_MIN, world);
  all_sorted_ = all_sorted != 0;
  if (!all_sorted_) return;
  const auto grains = static_cast<std::size_t>(atom->nlocal + atom->nghost);
  looked_at_.resize(grains);
  for (std::size_t k = 0; k < grains; ++k)
    looked_at_[k] = {atom->x[k][0], atom->x[k][1], atom->x[k][2]};
  const auto cells = [](int first, int last) { return (last - first) / 2 + 1; };
  cells_x_ = cells(first_bin_.x, last_bin_.x);
  cells_y_ = cells(first_bin_.y, last_bin_.y);
  first_in_cell_.assign(
      static_cast<std::size_t>(cells_x_) * cells_y_ * cells(first_bin_.z, last_bin_.z), -1);
  next_in_cell_.resize(grains);
  renewed_now_.clear();
  renewed_since_build_ = 0;
}

void NeighborSorted::find_moved(int begin, int end) {
  const double trigger = 0.25 * skin * skin;
  for (int i = begin; i < end; ++i) {
    const double dx = atom->x[i][0] - looked_at_[i].x;
    const double dy = atom->x[i][1] - looked_at_[i].y;
    const double dz = atom->x[i][2] - looked_at_[i].z;
    // What is no number counts as moved.
    if (!(dx * dx + dy * dy + dz * dz <= trigger)) moved_.push_back(i);
  }
}

// Whether all lists must be made anew.
int NeighborSorted::check_distance() {
  if (!renews_ || !all_sorted_) return Neighbor::check_distance();
  moved_.clear();
  find_moved(0, atom->nlocal);
  moved_at_ = update->ntimestep;
  const double own = atom->nlocal, room = slack();
  const auto moved = static_cast<double>(moved_.size());
  const bool go_on =
      looked_at_.size() == static_cast<std::size_t>(atom->nlocal + atom->nghost) &&
      moved <= share_at_once * own && renewed_since_build_ + moved <= share_since_build * own &&
      std::all_of(moved_.begin(), moved_.end(), [&](int i) { return may_go_on(i, room); });
  int all_anew = go_on ? 0 : 1;
  MPI_Allreduce(MPI_IN_PLACE, &all_anew, 1, MPI_INT, MPI_MAX, world);
  if (all_anew != 0 && ago == std::max(every, delay)) ++ndanger;
  return all_anew;
}

// s: the reach of ghosts beyond the longest contact [m]; infinite where there are none.
double NeighborSorted::slack() const {
  double cut = std::numeric_limits<double>::infinity();
  for (int d = 0; d < 3; ++d)
    if (domain->periodicity[d] != 0 || comm->procgrid[d] > 1)
      cut = std::min(cut, comm->cutghost[d]);
  return cut - (cutneighmax - skin);
}

double NeighborSorted::drift() const {
  const double half_slack = 0.5 * slack();
  return renews_ && std::isfinite(half_slack) ? std::max(skin, half_slack) : skin;
}

// Whether no rank misses a contact of this own grain until it has moved half a skin more.
bool NeighborSorted::may_go_on(int i, double slack) const {
  double depth = std::numeric_limits<double>::infinity(), square = 0.0;
  for (int d = 0; d < 3; ++d) {
    const double now = atom->x[i][d], begin = xhold[i][d];
    square += (now - begin) * (now - begin);
    const bool periodic = domain->periodicity[d] != 0;
    if (!periodic && !(now >= domain->boxlo[d] && now <= domain->boxhi[d])) return false;
    if (periodic || comm->myloc[d] > 0) depth = std::min(depth, begin - domain->sublo[d]);
    if (periodic || comm->myloc[d] + 1 < comm->procgrid[d])
      depth = std::min(depth, domain->subhi[d] - begin);
  }
  const double moved = std::sqrt(square) + 0.5 * skin;
  if (!std::isfinite(slack)) return std::isfinite(moved);
  const double reach = cutneighmax - skin;
  return moved <= std::max(0.5 * slack, depth - reach - 0.5 * slack);
}

void NeighborSorted::renew_lists(LAMMPS_NS::NeighList& list) {
  if (renewed_at_ == update->ntimestep) return;
  renewed_at_ = update->ntimestep;
  renewed_now_.clear();
  if (!renews_ || !all_sorted_ || ago == 0) return;
  const double begin = MPI_Wtime();
  if (moved_at_ != update->ntimestep) {
    moved_.clear();
    find_moved(0, atom->nlocal);
  }
  find_moved(atom->nlocal, atom->nlocal + atom->nghost);
  for (const int i : moved_) {
    renew(list, i);
    if (i < atom->nlocal) renewed_now_.push_back(i);
  }
  renewed_since_build_ += static_cast<int>(moved_.size());
  renewals_ += static_cast<std::int64_t>(moved_.size());
  renewal_seconds_ += MPI_Wtime() - begin;
}

void NeighborSorted::renew(LAMMPS_NS::NeighList& list, int i) {
  const Place before = looked_at_[i], now{atom->x[i][0], atom->x[i][1], atom->x[i][2]};
  const double radius = atom->radius[i];
  const int own = atom->nlocal;
  leave_place(i);
  const auto is_near = [](const Place& a, const Place& b, double reach) {
    const double dx = a.x - b.x, dy = a.y - b.y, dz = a.z - b.z;
    return dx * dx + dy * dy + dz * dz <= reach * reach;
  };
  const Bin bin = nearest_bin(now);
  look_around(bin, [&](int j, const Place& there, double other) {
    const double reach = (radius + other) * contactDistanceFactor + skin;
    // Pairs that were in reach are listed.
    if (!is_near(now, there, reach) || is_near(before, there, reach)) return;
    if (std::min(i, j) >= own || is_listed(list, i, j)) return;
    if (i < own)
      add_pair(list, i, j);
    else
      add_pair(list, j, i);
  });
  looked_at_[i] = now;
  int& first = cell_of(bin);
  next_in_cell_[i] = first;
  first = i;
}

// Beyond the outermost bins the nearest of them sees all that is in reach.
NeighborSorted::Bin NeighborSorted::nearest_bin(const Place& at) const {
  const Bin bin = bin_of(&at.x);
  return {std::clamp(bin.x, first_bin_.x, last_bin_.x),
          std::clamp(bin.y, first_bin_.y, last_bin_.y),
          std::clamp(bin.z, first_bin_.z, last_bin_.z)};
}

// Calls look(j, where it was looked for, radius) for all grains that may be in reach of one in a
// bin.
//
// What is read lies all over the caches' last level: everything is asked for before any of it is
// used.
template <class Look>
void NeighborSorted::look_around(const Bin& bin, const Look& look) {
  const int* const first = first_.data() + number_of(bin);
  stretches_.clear();
  const auto take_row = [&](std::ptrdiff_t from, std::ptrdiff_t to) {
    stretches_.emplace_back(first[from], first[to]);
    __builtin_prefetch(grains_.data() + first[from]);
  };
  take_row(-sx, sx + 1);
  for (const Row& row : rows_)
    for (const std::ptrdiff_t offset : {row.offset, -row.offset})
      take_row(offset - row.half_width, offset + row.half_width + 1);

  const auto cells = [](int at, int reach, int lo, int hi) {
    return std::pair{(std::max(at - reach, lo) - lo) / 2, (std::min(at + reach, hi) - lo) / 2};
  };
  const auto [x_lo, x_hi] = cells(bin.x, sx, first_bin_.x, last_bin_.x);
  const auto [y_lo, y_hi] = cells(bin.y, sy, first_bin_.y, last_bin_.y);
  const auto [z_lo, z_hi] = cells(bin.z, sz, first_bin_.z, last_bin_.z);
  chains_.clear();
  for (int z = z_lo; z <= z_hi; ++z)
    for (int y = y_lo; y <= y_hi; ++y)
      for (int x = x_lo; x <= x_hi; ++x) {
        const int head = first_in_cell_[(z * cells_y_ + y) * cells_x_ + x];
        if (head < 0) continue;
        chains_.push_back(head);
        __builtin_prefetch(looked_at_.data() + head);
      }

  for (const auto& [begin, end] : stretches_)
    for (int q = begin; q < end; ++q) {
      const Grain& grain = grains_[q];
      look(number_[q], {grain.x, grain.y, grain.z}, grain.radius);
    }
  for (const int head : chains_)
    for (int j = head; j >= 0; j = next_in_cell_[j]) look(j, looked_at_[j], atom->radius[j]);
}

// The first grain in the cell of a bin.
int& NeighborSorted::cell_of(const Bin& bin) {
  const int x = (bin.x - first_bin_.x) / 2, y = (bin.y - first_bin_.y) / 2,
            z = (bin.z - first_bin_.z) / 2;
  return first_in_cell_[(z * cells_y_ + y) * cells_x_ + x];
}

void NeighborSorted::leave_place(int i) {
  if (place_[i] >= 0) {
    grains_[place_[i]].x = gone;
    place_[i] = -1;
    return;
  }
  int* link = &cell_of(nearest_bin(looked_at_[i]));
  while (*link != i) link = &next_in_cell_[*link];
  *link = next_in_cell_[i];
}

bool NeighborSorted::is_listed(const LAMMPS_NS::NeighList& list, int i, int j) const {
  const auto has = [&](int of, int partner) {
    const int* const first = list.firstneigh[of];
    const int* const last = first + (of < atom->nlocal ? list.numneigh[of] : 0);
    return std::find(first, last, partner) != last;
  };
  return has(i, j) || has(j, i);
}

// Of an own grain; a row that is full moves to where there is room for some more.
void NeighborSorted::add_pair(LAMMPS_NS::NeighList& list, int i, int j) {
  constexpr int more = 4;
  LAMMPS_NS::NeighList& rows = *list.listgranhistory;
  const int count = list.numneigh[i];
  if (count == room_[i]) {
    if (count == oneatom) error->one(FLERR, "Neighbor list overflow, boost neigh_modify one");
    room_[i] = std::min(count + more, oneatom);
    const auto move = [&](auto*& row, auto& pages, int width) {
      auto* const wider = pages.get(room_[i] * width);
      if (wider == nullptr)
        error->one(FLERR, "Neighbor list overflow, boost neigh_modify one or page");
      row = std::copy_n(row, count * width, wider) - count * width;
    };
    move(list.firstneigh[i], *list.ipage, 1);
    move(rows.firstneigh[i], *rows.ipage, 1);
    move(rows.firstdouble[i], *rows.dpage, rows.dnum);
  }
  list.firstneigh[i][count] = j;
  rows.firstneigh[i][count] = 0;
  std::fill_n(rows.firstdouble[i] + std::ptrdiff_t{count} * rows.dnum, rows.dnum, 0.0);
  ++list.numneigh[i];
}

}  // namespace gasgrain
