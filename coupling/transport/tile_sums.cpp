#include "coupling/transport/tile_sums.h"

#include "coupling/base/decomposition.h"

namespace gasgrain {
namespace {

constexpr int shares_tag = 1;
constexpr int sums_tag = 2;

}  // namespace

TileSums::TileSums(const Communicator& ranks, const BoxGrid& grid)
    : channel_(ranks), grid_(grid), owned_(decompose(grid, ranks.size(), 1)) {}

void TileSums::set_tile(const IndexBox& tile) {
  const Communicator& ranks = channel_.get();
  if (ranks.max(tile != tile_ || !met_before_ ? 1.0 : 0.0) == 0.0) return;
  met_before_ = true;
  tile_ = tile;
  const IndexBox& mine = owned_[static_cast<std::size_t>(ranks.rank())];
  alone_ = ranks.size() == 1 && intersection(tile, mine) == tile;
  static_assert(sizeof(IndexBox) == 6 * sizeof(int));
  std::vector<IndexBox> tiles(static_cast<std::size_t>(ranks.size()));
  MPI_Allgather(&tile, 6, MPI_INT, tiles.data(), 6, MPI_INT, ranks.handle());
  to_owners_ = {ranks.handle(), make_routes(grid_, tile, owned_, false), false, Sends::started};
  to_tiles_ = {ranks.handle(), make_routes(grid_, mine, tiles, true), true, Sends::started};
}

void TileSums::add_up(const FieldList& fields) {
  if (alone_) return;
  const IndexBox& mine = owned_[static_cast<std::size_t>(channel_.get().rank())];
  FieldList sums;
  if (sums_.size() < fields.size()) sums_.resize(fields.size());
  for (std::size_t n = 0; n < fields.size(); ++n) {
    if (sums_[n].box() != mine) sums_[n] = Array3<double>(mine);
    sums_[n].fill(0.0);
    sums.push_back(&sums_[n]);
  }
  to_owners_.send(fields, shares_tag);
  to_tiles_.receive(sums, shares_tag);
  to_tiles_.send(sums, sums_tag);
  to_owners_.receive(fields, sums_tag);
  to_owners_.finish_sends();
  to_tiles_.finish_sends();
}

}  // namespace gasgrain
