#include "fix_cfd_coupling/liggghts/neighbor_sorted.h"

#include <fmt/core.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <string_view>

#include "fix_cfd_coupling/liggghts/pair_gran_bridge.h"
// --
#include "atom.h"
#include "error.h"
#include "fix.h"
#include "fix_contact_history.h"
#include "force.h"
#include "modify.h"
#include "neigh_list.h"

namespace gasgrain {

namespace {

// Their fixes read the host's own chains of grains by bin.
bool reads_bins(std::string_view style) {
  for (std::string_view part : {"mesh", "heat/gran/rad", "liquidtracking"})
    if (style.find(part) != std::string_view::npos) return true;
  return false;
}

int bin_along(double x, double lo, double hi, double bins_per_length, int bins) {
  if (x >= hi) return static_cast<int>((x - hi) * bins_per_length) + bins;
  if (x >= lo) return std::min(static_cast<int>((x - lo) * bins_per_length), bins - 1);
  return static_cast<int>((x - lo) * bins_per_length) - 1;
}

struct Span {
  int lo = std::numeric_limits<int>::max(), hi = std::numeric_limits<int>::min();
  void take(int bin) {
    lo = std::min(lo, bin);
    hi = std::max(hi, bin);
  }
  [[nodiscard]] std::ptrdiff_t length() const { return std::ptrdiff_t{hi} - lo + 1; }
};

}  // namespace

NeighborSorted& NeighborSorted::of(LAMMPS_NS::LAMMPS& host) {
  return static_cast<NeighborSorted&>(*host.neighbor);
}

void NeighborSorted::init() {
  Neighbor::init();
  others_read_bins_ = false;
  for (int n = 0; n < modify->nfix; ++n)
    others_read_bins_ = others_read_bins_ || reads_bins(modify->fix[n]->style);
  const bool own_pairs = dynamic_cast<LAMMPS_NS::PairGranBridge*>(force->pair) != nullptr;
  const std::string why = own_pairs ? needs_whole_lists() : "the pair style is the host's";
  renews_ = why.empty();
  all_sorted_ = false;
  moved_at_ = renewed_at_ = -1;
  renewals_ = 0;
  renewal_seconds_ = 0.0;
  if (said_ == why) return;
  said_ = why;
  if (renews_ || me != 0 || !own_pairs) return;
  for (FILE* file : {screen, logfile})
    if (file != nullptr)
      fmt::print(file, "Neighbour lists are made anew all at once, because {}\n", why);
}

void NeighborSorted::choose_build(int list, LAMMPS_NS::NeighRequest* request) {
  Neighbor::choose_build(list, request);
  if (pair_build[list] == &NeighborSorted::granular_bin_no_newton)
    pair_build[list] = static_cast<PairPtr>(&NeighborSorted::build_sorted);
}

void NeighborSorted::build_sorted(LAMMPS_NS::NeighList* list) {
  const bool sorted = exclude == 0 && includegroup == 0 && sort_grains();
  if (renews_) begin_renewals(sorted);
  if (!sorted) {
    granular_bin_no_newton(list);
    return;
  }
  if (others_read_bins_) bin_atoms();
  find_rows();
  find_pairs();

  const bool history = list->fix_history != nullptr;
  LAMMPS_NS::NeighList* rows = list->listgranhistory;
  list->ipage->reset();
  if (history) {
    rows->ipage->reset();
    rows->dpage->reset();
  }
  for (int i = 0; i < atom->nlocal; ++i) {
    const int count = partners_[i];
    if (count > oneatom) error->one(FLERR, "Neighbor list overflow, boost neigh_modify one");
    list->ilist[i] = i;
    list->firstneigh[i] = list->ipage->get(count);
    list->numneigh[i] = 0;
    if (history) {
      rows->firstneigh[i] = rows->ipage->get(count);
      rows->firstdouble[i] = rows->dpage->get(count * rows->dnum);
    }
  }
  list->inum = atom->nlocal;
  for (const Found& pair : found_) {
    const int m = list->numneigh[pair.i]++;
    list->firstneigh[pair.i][m] = pair.partner;
    if (history) rows->firstneigh[pair.i][m] = static_cast<int>(pair.near);
  }
  if (history)
    for (int i = 0; i < atom->nlocal; ++i) write_history(*list, i);
  room_.swap(partners_);
}

// The host numbers the bins of the whole box from 0; those outside of it go on at both ends.
NeighborSorted::Bin NeighborSorted::bin_of(const double* at) const {
  return {bin_along(at[0], bboxlo[0], bboxhi[0], bininvx, nbinx),
          bin_along(at[1], bboxlo[1], bboxhi[1], bininvy, nbiny),
          bin_along(at[2], bboxlo[2], bboxhi[2], bininvz, nbinz)};
}

// False when a grain lies in none of the host's bins.
bool NeighborSorted::sort_grains() {
  const auto grains = static_cast<std::size_t>(atom->nlocal + atom->nghost);
  bins_.resize(grains);
  bin_.resize(grains);
  Span x, y, z;
  for (std::size_t k = 0; k < grains; ++k) {
    bins_[k] = bin_of(atom->x[k]);
    x.take(bins_[k].x);
    y.take(bins_[k].y);
    z.take(bins_[k].z);
  }
  const auto in_bins = [](const Span& span, int first, int count) {
    return span.lo >= first && span.hi < first + count;
  };
  if (grains > 0 &&
      !(in_bins(x, mbinxlo, mbinx) && in_bins(y, mbinylo, mbiny) && in_bins(z, mbinzlo, mbinz)))
    return false;

  // Empty bins all around, as wide as a grain sees, spare the questions at the ends.
  if (grains == 0) x = y = z = Span{0, 0};
  first_bin_ = {x.lo, y.lo, z.lo};
  last_bin_ = {x.hi, y.hi, z.hi};
  row_length_ = x.length() + 2 * sx;
  layer_size_ = row_length_ * (y.length() + 2 * sy);
  const std::ptrdiff_t all_bins = layer_size_ * (z.length() + 2 * sz);
  first_.assign(static_cast<std::size_t>(all_bins) + 2, 0);
  // Counts go one bin too far, and starts two, so that filling the bins leaves them in place.
  for (std::size_t k = 0; k < grains; ++k) {
    bin_[k] = number_of(bins_[k]);
    ++first_[bin_[k] + 2];
  }
  std::partial_sum(first_.begin(), first_.end(), first_.begin());
  grains_.resize(grains);
  number_.resize(grains);
  bin_at_.resize(grains);
  place_.resize(grains);
  for (std::size_t k = 0; k < grains; ++k) {
    const int place = first_[bin_[k] + 1]++;
    grains_[place] = {atom->x[k][0], atom->x[k][1], atom->x[k][2], atom->radius[k]};
    number_[place] = static_cast<int>(k);
    bin_at_[place] = bin_[k];
    place_[k] = place;
  }
  return true;
}

int NeighborSorted::number_of(const Bin& bin) const {
  return static_cast<int>((bin.z - first_bin_.z + sz) * layer_size_ +
                          (bin.y - first_bin_.y + sy) * row_length_ + (bin.x - first_bin_.x + sx));
}

// Those of which a part is nearer to the grain's bin than the longest reach: the host's stencil.
void NeighborSorted::find_rows() {
  rows_.clear();
  for (int k = 0; k <= sz; ++k)
    for (int j = k == 0 ? 1 : -sy; j <= sy; ++j) {
      int half_width = sx;
      while (half_width >= 0 && !(bin_distance(half_width, j, k) < cutneighmaxsq)) --half_width;
      if (half_width >= 0) rows_.push_back({k * layer_size_ + j * row_length_, half_width});
    }
}

// All pairs nearer than the reach of both with the skin, unless both belong to other ranks.
//
// The host orders a grain's partners by their bins, and within a bin by their numbers: by their
// places. Those before the grain find it, one after the other, before its own turn comes.
void NeighborSorted::find_pairs() {
  const double factor = contactDistanceFactor, extra = skin;
  const int own = atom->nlocal;
  const int* const number = number_.data();
  const Grain* const grains = grains_.data();
  const int places = static_cast<int>(grains_.size());
  partners_.assign(static_cast<std::size_t>(own), 0);
  found_.clear();
  seen_.resize(grains_.size() + 1);
  int* const seen = seen_.data();
  for (int p = 0; p < places; ++p) {
    const Grain grain = grains[p];
    int count = 0;
    const auto look = [=, &count](int begin, int end) {
      for (int q = begin; q < end; ++q) {
        const Grain& other = grains[q];
        const double dx = grain.x - other.x, dy = grain.y - other.y, dz = grain.z - other.z;
        const double reach = (grain.radius + other.radius) * factor + extra;
        // Nobody could foretell a branch here.
        seen[count] = q;
        count += static_cast<int>(dx * dx + dy * dy + dz * dz <= reach * reach);
      }
    };
    const int* const bin = first_.data() + bin_at_[p];
    look(p + 1, bin[sx + 1]);
    for (const Row& row : rows_)
      look(bin[row.offset - row.half_width], bin[row.offset + row.half_width + 1]);

    const int a = number[p];
    for (int n = 0; n < count; ++n) {
      const Grain& other = grains[seen[n]];
      const int b = number[seen[n]], i = std::min(a, b);
      if (i >= own) continue;
      const double dx = grain.x - other.x, dy = grain.y - other.y, dz = grain.z - other.z;
      const double reach = (grain.radius + other.radius) * factor;
      found_.push_back({i, std::max(a, b), dx * dx + dy * dy + dz * dz < reach * reach});
      ++partners_[i];
    }
  }
}

// What the pairs of the last list left with the grain; zeros for a new pair.
void NeighborSorted::write_history(LAMMPS_NS::NeighList& list, int i) const {
  LAMMPS_NS::FixContactHistory& kept = *list.fix_history;
  const int count = list.numneigh[i], width = list.listgranhistory->dnum;
  int* const in_contact = list.listgranhistory->firstneigh[i];
  double* const values = list.listgranhistory->firstdouble[i];
  std::fill_n(values, count * width, 0.0);
  const int known = kept.n_partner(i);
  for (int n = 0; n < count; ++n) {
    if (in_contact[n] == 0) continue;
    const int tag = atom->tag[list.firstneigh[i][n]];
    int m = 0;
    while (m < known && kept.partner(i, m) != tag) ++m;
    in_contact[n] = static_cast<int>(m < known);
    if (m < known) std::copy_n(kept.contacthistory(i, m), width, values + n * width);
  }
}

}  // namespace gasgrain
