// Sums of fields over ranks that share cells, for collective effects of particles.
//
// Each rank deposits into its own tile; tiles overlap by what particles may reach. Every cell has
// one owner: tiles are sent there, added in the order of the ranks, and the sums are sent back, so
// that all who hold a cell hold the same number. No rank sees more than the cells it shares.
#pragma once

#include "coupling/base/communicator.h"
#include "coupling/transport/route.h"

namespace gasgrain {

class TileSums {
 public:
  // Collective over `ranks`. Throws Error when there are more ranks than cells can be cut into.
  TileSums(const Communicator& ranks, const BoxGrid& grid);

  // Of this rank from now on; unwrapped cells along periodic axes (tile_frame.h). Collective; does
  // nothing when no rank's tile has changed.
  void set_tile(const IndexBox& tile);

  // Replaces the fields over the tile by their sums. Collective.
  void add_up(const FieldList& fields);

 private:
  OwnCommunicator channel_;
  BoxGrid grid_;
  std::vector<IndexBox> owned_;  // by rank
  IndexBox tile_;
  bool met_before_ = false;
  bool alone_ = false;  // one rank, whose tile has no cell twice
  RouteTransport to_owners_, to_tiles_;
  std::vector<Array3<double>> sums_;  // over the cells that this rank owns
};

}  // namespace gasgrain
