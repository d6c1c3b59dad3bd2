// Neighbour lists of grains, made from grains that are sorted by bin.
//
// The host walks 125 bins for every grain, each a chain of grains that lie anywhere in its arrays;
// most bins are empty, and every pair is met twice. Here the grains are put in the order of their
// bins first, so that the bins of a row, side by side in x, are one stretch of memory; of each
// grain only what comes after it is looked at: 13 stretches, and every pair once. A second pass
// puts the pairs into the lists. The lists are the host's to the last bit, with the pairs in its
// order, and so is all that follows.
#pragma once

#include <cstddef>
#include <vector>

#include "lammps.h"
// --
#include "neighbor.h"

namespace gasgrain {

class NeighborSorted : public LAMMPS_NS::Neighbor {
 public:
  using Neighbor::Neighbor;

  void init() override;

 protected:
  // The host asks for the way in which each list is made; half lists of grains in bins, without
  // newton, are made here.
  void choose_build(int list, LAMMPS_NS::NeighRequest* request) override;

 private:
  struct Grain {
    double x, y, z, radius;
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
  void find_rows();
  void find_pairs();
  void write_history(LAMMPS_NS::NeighList& list, int i) const;

  bool others_read_bins_ = false;
  std::ptrdiff_t row_length_ = 0, layer_size_ = 0;  // [bins], of those that hold grains
  std::vector<Row> rows_;                           // behind the own one
  std::vector<int> bin_x_, bin_y_, bin_z_;          // by grain
  std::vector<int> bin_;                            // by grain
  std::vector<int> bin_at_;                         // by place
  std::vector<int> first_;                          // place of a bin's first grain, by bin
  std::vector<Grain> grains_;                       // by place
  std::vector<int> number_;                         // of the grain, by place
  std::vector<Found> found_;
  std::vector<int> seen_;      // places of those in reach of one grain
  std::vector<int> partners_;  // how many, by grain
};

}  // namespace gasgrain
