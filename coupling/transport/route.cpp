#include "coupling/transport/route.h"

#include "coupling/base/communicator.h"

namespace gasgrain {
namespace {

// How many periods an interval of indices reaches below and above [0, n).
struct Periods {
  int first;
  int last;
};

Periods periods_of(const BoxGrid& grid, const IndexBox& tile, int axis) {
  if (!grid.periodic[axis]) return {0, 0};
  const int n = grid.cells[axis];
  const auto floor_div = [n](int a) { return a >= 0 ? a / n : -((-a + n - 1) / n); };
  return {floor_div(tile.lo[axis]), floor_div(tile.hi[axis] - 1)};
}

// The pieces' cells in the rank's own numbering, in the order in which both sides walk them.
template <class F>
void walk(const Route& route, bool i_am_gas, F&& f) {
  for (const auto& piece : route.pieces) {
    const Int3 s = i_am_gas ? Int3{0, 0, 0} : piece.shift;
    for_each_cell(piece.gas_cells, [&](int i, int j, int k) { f(i + s[0], j + s[1], k + s[2]); });
  }
}

}  // namespace

std::size_t Route::cells() const {
  std::size_t n = 0;
  for (const auto& piece : pieces) n += piece.gas_cells.size();
  return n;
}

std::vector<RoutePiece> common_pieces(const BoxGrid& grid, const IndexBox& tile,
                                      const IndexBox& gas_box) {
  std::vector<RoutePiece> pieces;
  if (tile.empty()) return pieces;
  const Periods px = periods_of(grid, tile, 0);
  const Periods py = periods_of(grid, tile, 1);
  const Periods pz = periods_of(grid, tile, 2);
  for (int c = pz.first; c <= pz.last; ++c)
    for (int b = py.first; b <= py.last; ++b)
      for (int a = px.first; a <= px.last; ++a) {
        const Int3 shift{a * grid.cells[0], b * grid.cells[1], c * grid.cells[2]};
        IndexBox wanted = tile;
        for (int d = 0; d < 3; ++d) {
          wanted.lo[d] -= shift[d];
          wanted.hi[d] -= shift[d];
        }
        const IndexBox common = intersection(wanted, gas_box);
        if (!common.empty()) pieces.push_back({common, shift});
      }
  return pieces;
}

std::vector<Route> make_routes(const BoxGrid& grid, const IndexBox& mine,
                               const std::vector<IndexBox>& partner_boxes, bool i_am_gas) {
  std::vector<Route> routes;
  for (std::size_t r = 0; r < partner_boxes.size(); ++r) {
    auto pieces = i_am_gas ? common_pieces(grid, partner_boxes[r], mine)
                           : common_pieces(grid, mine, partner_boxes[r]);
    if (!pieces.empty()) routes.push_back({static_cast<int>(r), std::move(pieces)});
  }
  return routes;
}

RouteTransport::RouteTransport(MPI_Comm partner, std::vector<Route> routes, bool i_am_gas,
                               Sends sends)
    : partner_(partner),
      routes_(std::move(routes)),
      i_am_gas_(i_am_gas),
      sends_(sends),
      outgoing_(routes_.size()),
      incoming_(routes_.size()),
      under_way_(routes_.size(), MPI_REQUEST_NULL) {}

void RouteTransport::send(const FieldList& fields, int tag) {
  finish_sends();
  for (std::size_t r = 0; r < routes_.size(); ++r) {
    auto& buffer = outgoing_[r];
    buffer.clear();
    buffer.reserve(routes_[r].cells() * fields.size());
    for (const auto* field : fields)
      walk(routes_[r], i_am_gas_,
           [&](int i, int j, int k) { buffer.push_back((*field)(i, j, k)); });
    MPI_Isend(buffer.data(), static_cast<int>(buffer.size()), MPI_DOUBLE, routes_[r].partner, tag,
              partner_, &under_way_[r]);
    bytes_ += static_cast<long>(buffer.size() * sizeof(double));
  }
  if (sends_ == Sends::finished) finish_sends();
}

void RouteTransport::finish_sends() {
  wait_sleeping(under_way_);
}

void RouteTransport::receive(const FieldList& fields, int tag) {
  std::vector<MPI_Request> requests(routes_.size(), MPI_REQUEST_NULL);
  for (std::size_t r = 0; r < routes_.size(); ++r) {
    incoming_[r].resize(routes_[r].cells() * fields.size());
    MPI_Irecv(incoming_[r].data(), static_cast<int>(incoming_[r].size()), MPI_DOUBLE,
              routes_[r].partner, tag, partner_, &requests[r]);
  }
  wait_sleeping(requests);
  for (std::size_t r = 0; r < routes_.size(); ++r) {
    bytes_ += static_cast<long>(incoming_[r].size() * sizeof(double));
    const double* value = incoming_[r].data();
    for (auto* field : fields)
      walk(routes_[r], i_am_gas_, [&](int i, int j, int k) {
        if (i_am_gas_)
          (*field)(i, j, k) += *value++;
        else
          (*field)(i, j, k) = *value++;
      });
  }
}

}  // namespace gasgrain
