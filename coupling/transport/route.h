// Which cells a rank shares with which ranks of the partner program, and the moving of fields along
// these routes. Fields move as boxes of cells; particles never do, and nothing is gathered.
#pragma once

#include <mpi.h>

#include <utility>
#include <vector>

#include "coupling/base/array3.h"

namespace gasgrain {

// Cells exchanged with one partner rank. A DEM rank's tile has UNWRAPPED indices on a periodic axis
// (it may reach below 0 or beyond the last cell), a gas rank's box never does: `shift` is added to
// a gas index to give the tile's.
struct RoutePiece {
  IndexBox gas_cells;
  Int3 shift{0, 0, 0};
};

struct Route {
  int partner = 0;  // rank in the partner program
  std::vector<RoutePiece> pieces;
  [[nodiscard]] std::size_t cells() const;
};

// Pieces in which a DEM tile meets a gas box; both sides compute the same list in the same order.
std::vector<RoutePiece> common_pieces(const BoxGrid& grid, const IndexBox& tile,
                                      const IndexBox& gas_box);

// Routes of a DEM rank to all gas ranks, or (`i_am_gas`) of a gas rank to all DEM ranks; only
// partners with common cells have one. `partner_boxes`: tile or box of every partner rank.
std::vector<Route> make_routes(const BoxGrid& grid, const IndexBox& mine,
                               const std::vector<IndexBox>& partner_boxes, bool i_am_gas);

// The fields that move together; all over the rank's own box (tile or gas box).
using FieldList = std::vector<Array3<double>*>;

// How send() returns. A partner program takes a message while the sender waits. A partner inside
// the same process cannot: there the message is on its way until a later call.
enum class Sends { finished, started };

// Moves lists of fields along the routes of a rank, one message a partner.
class RouteTransport {
 public:
  RouteTransport() = default;
  // `partner`: an intercommunicator to the partner program, or a communicator of ranks that hold a
  // tile and a gas box each; tags then tell the two directions apart.
  RouteTransport(MPI_Comm partner, std::vector<Route> routes, bool i_am_gas,
                 Sends sends = Sends::finished);

  // Sends the common cells of `fields` to every partner.
  void send(const FieldList& fields, int tag);
  // Waits, asleep, until the partners have what was sent. Before the object is replaced.
  void finish_sends();
  // Receives from every partner, asleep while waiting. A gas rank ADDS what comes, in the order of
  // the partners' ranks (so that the same launch gives the same sums); a DEM rank overwrites.
  void receive(const FieldList& fields, int tag);

  // Bytes of fields sent and received since the last call.
  long take_bytes() { return std::exchange(bytes_, 0); }
  [[nodiscard]] const std::vector<Route>& routes() const { return routes_; }

 private:
  MPI_Comm partner_ = MPI_COMM_NULL;
  std::vector<Route> routes_;
  bool i_am_gas_ = false;
  Sends sends_ = Sends::finished;
  std::vector<std::vector<double>> outgoing_;
  std::vector<std::vector<double>> incoming_;
  std::vector<MPI_Request> under_way_;
  long bytes_ = 0;
};

}  // namespace gasgrain
