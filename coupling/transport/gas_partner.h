// The gas as the DEM ranks see it, wherever it runs: in a second program of the launch, or inside
// the DEM ranks themselves. Every call is collective over the DEM ranks.
#pragma once

#include <mpi.h>

#include <memory>
#include <string>

#include "coupling/base/communicator.h"
#include "coupling/transport/protocol.h"
#include "coupling/transport/route.h"

namespace gasgrain {

class GasPartner {
 public:
  GasPartner() = default;
  virtual ~GasPartner() = default;
  GasPartner(const GasPartner&) = delete;
  GasPartner& operator=(const GasPartner&) = delete;

  // Exchanges first words.
  virtual GasHello greet(const DemHello& mine) = 0;
  virtual void send_command(const Command& command) = 0;
  // The way of the fields of this rank's new tile; follows a command that is `fresh`.
  virtual RouteTransport connect(const BoxGrid& grid, const IndexBox& tile) = 0;
  // Every rank has sent its solids, or its drag: a gas that has no processes of its own does its
  // next piece of work before these return.
  virtual void solids_are_sent() {}
  virtual void drag_is_sent() {}
  // When the answer's fields are here. The report is rank 0's; other ranks get an empty one.
  virtual Report receive_report() = 0;
  // The orderly end. What the gas spent its time on, a JSON object (rank 0's; empty elsewhere).
  virtual std::string finish() = 0;
};

// The gas program of the launch, over the intercommunicator to it. Waits asleep.
std::unique_ptr<GasPartner> make_remote_gas(const Communicator& local, MPI_Comm partner);

}  // namespace gasgrain
