// The gas as a library inside the DEM ranks: no second program, for runs on one machine. Each rank
// holds a tile of its particles and a box of the gas grid, and does both works in turn. The fields
// go the same way as between two programs, over a communicator of the DEM ranks.
//
// Declared here for the hosts, defined by the gas solver (gas_solver/inner_gas_port.cpp).
#pragma once

#include <memory>
#include <string>

#include "coupling/base/communicator.h"
#include "coupling/transport/gas_partner.h"

namespace gasgrain {

struct GasFiles {
  std::string input;            // gas.toml
  std::string out = "results";  // folder
  std::string restart;          // checkpoint to go on from; empty: a new run
};

// Collective over `local`. Throws Error with all faults of the input, on every rank.
std::unique_ptr<GasPartner> make_inner_gas(const GasFiles& files, const Communicator& local);

}  // namespace gasgrain
