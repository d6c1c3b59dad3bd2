// The gas inside the DEM ranks: each of its pieces of work is done where the DEM ranks would else
// wait for a gas program. One thread, and a communicator for each of the two: the fields' messages
// are sent and received by one process, and so are started, and finished later.
#include <mpi.h>

#include <array>
#include <chrono>
#include <new>
#include <utility>

#include "coupling/base/decomposition.h"
#include "coupling/base/error.h"
#include "coupling/transport/inner_gas.h"
#include "gas_solver/coupled_gas_port.h"
#include "gas_solver/gas_input.h"

namespace gasgrain {
namespace {

class InnerGas : public GasPartner {
 public:
  InnerGas(const GasInput& input, const GasFiles& files, const Communicator& dem)
      : channel_(dem), own_(dem), gas_(input, files, own_.get()) {}

  GasHello greet(const DemHello& mine) override {
    work([&] { gas_.meet(mine); });
    return gas_.port().hello();
  }

  void send_command(const Command& command) override {
    work([&] {
      switch (command.kind) {
        case CommandKind::couple:
          return gas_.port().begin(command);
        case CommandKind::checkpoint:
          report_ = Report{};
          return gas_.write_checkpoint(command.step);
        case CommandKind::autopsy:
          report_ = gas_.write_autopsy(command.step);
          return;
        case CommandKind::finish:
          costs_ = gas_.finish();
      }
    });
  }

  RouteTransport connect(const BoxGrid& grid, const IndexBox& tile) override {
    using Pair = std::array<IndexBox, 2>;  // a rank's tile and its box of the gas
    static_assert(sizeof(Pair) == 12 * sizeof(int));
    const Pair mine{tile, gas_.solver().own()};
    std::vector<Pair> all(channel_.get().size());
    MPI_Allgather(&mine, 12, MPI_INT, all.data(), 12, MPI_INT, channel_.get().handle());
    std::vector<IndexBox> tiles;
    std::vector<IndexBox> boxes;
    for (const auto& [of_dem, of_gas] : all) {
      tiles.push_back(of_dem);
      boxes.push_back(of_gas);
    }
    const MPI_Comm channel = channel_.get().handle();
    gas_.port().route(tiles, channel, Sends::started);
    return {channel, make_routes(grid, tile, boxes, false), false, Sends::started};
  }

  void solids_are_sent() override {
    work([&] { gas_.port().take_solids(); });
  }

  void drag_is_sent() override {
    work([&] {
      report_ = gas_.advance();
      if (report_.fault == 0) gas_.end_interval();
    });
  }

  std::string finish() override {
    send_command(Command{});
    return costs_;
  }

  // The fields have come, so that what was sent is with all ranks, or will be as soon as they look:
  // nobody goes on to the grains with an unfinished message.
  Report receive_report() override {
    gas_.port().finish_sends();
    return own_.get().is_root() ? report_ : Report{};
  }

 private:
  using Clock = std::chrono::steady_clock;

  // A piece of the gas's work; the time since the one before was the particles'.
  template <class Piece>
  void work(Piece&& piece) {
    const std::chrono::duration<double> waited = Clock::now() - idle_since_;
    gas_.solver().costs().charge(gas_.port().cost_wait(), waited.count());
    try {
      piece();
    } catch (const std::bad_alloc&) {
      throw Error(out_of_memory);
    }
    idle_since_ = Clock::now();
  }

  OwnCommunicator channel_;  // for the fields
  OwnCommunicator own_;      // for the gas
  CoupledGas gas_;
  Report report_;
  std::string costs_;  // at the end
  Clock::time_point idle_since_ = Clock::now();
};

}  // namespace

std::unique_ptr<GasPartner> make_inner_gas(const GasFiles& files, const Communicator& local) {
  const GasInput input = read_gas_input(files.input, false);
  rank_layout(input.grid, local.size());
  try {
    return std::make_unique<InnerGas>(input, files, local);
  } catch (const std::bad_alloc&) {
    throw Error(out_of_memory);
  }
}

}  // namespace gasgrain
