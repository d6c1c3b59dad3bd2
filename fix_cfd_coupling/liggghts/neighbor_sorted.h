// Neighbour lists of grains, made from grains that are sorted by bin.
//
// The host walks 125 bins for every grain, each a chain of grains that lie anywhere in its arrays;
// most bins are empty, and every pair is met twice. Here the grains are put in the order of their
// bins first, so that the bins of a row, side by side in x, are one stretch of memory; of each
// grain only what comes after it is looked at: 13 stretches, and every pair once. A second pass
// puts the pairs into the lists. The lists are the host's to the last bit, with the pairs in its
// order, and so is all that follows.
//
// The host makes all lists anew as soon as one grain has moved half the skin: in a jet every few
// steps, for some grains in a hundred. Beside `pair_style gran/bridge` such grains get new pairs by
// themselves (neighbor_sorted_renewal.cpp), and all lists are made anew when that has cost as much.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "lammps.h"
// --
#include "neighbor.h"

namespace gasgrain {

class NeighborSorted : public LAMMPS_NS::Neighbor {
 public:
  using Neighbor::Neighbor;

  // The one of a host: host_styles.cpp has put it there.
  static NeighborSorted& of(LAMMPS_NS::LAMMPS& host);

  void init() override;
  int check_distance() override;

  // Adds the pairs of grains that have moved half the skin since their pairs were looked for; to be
  // called when ghosts have their places of this step, before forces. The pairs of a list stay
  // complete: at any time all that are nearer than their reach.
  void renew_lists(LAMMPS_NS::NeighList& list);
  // Own grains that got new pairs in this step.
  [[nodiscard]] const std::vector<int>& renewed_now() const { return renewed_now_; }
  // Whether lists go on beyond the move of a grain by half the skin, in this run.
  [[nodiscard]] bool renews() const { return renews_; }
  // How often a grain of this rank got new pairs in this run, and what that took [s].
  [[nodiscard]] std::int64_t renewals() const { return renewals_; }
  [[nodiscard]] double renewal_seconds() const { return renewal_seconds_; }
  // How far a grain may leave the sub-domain of its rank [m].
  [[nodiscard]] double drift() const;

 protected:
  // The host asks for the way in which each list is made; half lists of grains in bins, without
  // newton, are made here.
  void choose_build(int list, LAMMPS_NS::NeighRequest* request) override;

 private:
  struct Grain {
    double x, y, z, radius;
  };
  struct Place {
    double x, y, z;
  };
  struct Bin {
    int x, y, z;
  };
  struct Row {  // of bins, as seen from a grain's own bin
    std::ptrdiff_t offset;
    int half_width;
  };
  struct Found {
    int i;        // of the two grains the one with the lower number, whose list has the pair
    int partner;  // the other
    bool near;    // the two may touch or have a bridge: without the skin
  };

  void build_sorted(LAMMPS_NS::NeighList* list);
  bool sort_grains();
  [[nodiscard]] Bin bin_of(const double* at) const;
  [[nodiscard]] int number_of(const Bin& bin) const;
  void find_rows();
  void find_pairs();
  void write_history(LAMMPS_NS::NeighList& list, int i) const;

  // neighbor_sorted_renewal.cpp
  [[nodiscard]] std::string needs_whole_lists() const;
  void begin_renewals(bool sorted);
  void find_moved(int begin, int end);
  [[nodiscard]] double slack() const;
  [[nodiscard]] bool may_go_on(int i, double slack) const;
  void renew(LAMMPS_NS::NeighList& list, int i);
  [[nodiscard]] Bin nearest_bin(const Place& at) const;
  template <class Look>
  void look_around(const Bin& bin, const Look& look);
  [[nodiscard]] int& cell_of(const Bin& bin);
  void leave_place(int i);
  [[nodiscard]] bool is_listed(const LAMMPS_NS::NeighList& list, int i, int j) const;
  void add_pair(LAMMPS_NS::NeighList& list, int i, int j);

  bool others_read_bins_ = false;
  std::ptrdiff_t row_length_ = 0, layer_size_ = 0;  // [bins], of those that hold grains
  std::vector<Row> rows_;                           // behind the own one
  Bin first_bin_{}, last_bin_{};                    // of those that hold grains
  std::vector<Bin> bins_;                           // by grain
  std::vector<int> bin_;                            // its number, by grain
  std::vector<int> bin_at_;                         // by place
  std::vector<int> first_;                          // place of a bin's first grain, by bin
  std::vector<Grain> grains_;                       // by place
  std::vector<int> number_;                         // of the grain, by place
  std::vector<Found> found_;
  std::vector<int> seen_;      // places of those in reach of one grain
  std::vector<int> partners_;  // how many, by grain

  // Renewal. A grain that got new pairs leaves its place among the sorted for its cell, of 2 x 2 x
  // 2 bins; all lengths are by grain of this rank, ghosts included, if not said otherwise.
  bool renews_ = false;
  std::optional<std::string> said_;  // of needs_whole_lists()
  bool all_sorted_ = false;          // what follows is of the lists in use, on all ranks
  int cells_x_ = 0, cells_y_ = 0;
  std::vector<int> place_;                         // among the sorted; below 0: in a cell
  std::vector<Place> looked_at_;                   // where it was when its pairs were looked for
  std::vector<int> room_;                          // for pairs in its list; of own grains
  std::vector<int> first_in_cell_, next_in_cell_;  // grains; below 0: no more
  std::vector<std::pair<int, int>> stretches_;     // of places, around one grain
  std::vector<int> chains_;                        // their first grains, around one grain
  std::vector<int> moved_;                         // half the skin since then
  std::vector<int> renewed_now_;
  LAMMPS_NS::bigint moved_at_ = -1, renewed_at_ = -1;  // steps
  int renewed_since_build_ = 0;
  std::int64_t renewals_ = 0;
  double renewal_seconds_ = 0.0;
};

}  // namespace gasgrain
