// What the two programs say to each other besides fields. Everything here travels as plain bytes
// between the two leaders (rank 0 of each program) on machines of one kind.
#pragma once

#include <mpi.h>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "coupling/base/box_grid.h"
#include "coupling/base/communicator.h"
#include "coupling/exchange/gas_fields.h"

namespace gasgrain {

// Raised with every change of a message's meaning or layout.
constexpr int protocol_version = 5;

// Message tags between the programs.
enum Tag : int {
  hello_tag = 100,
  command_tag,
  report_tag,
  solids_tag,
  drag_tag,
  lent_tag,
  text_tag
};

// First words of the DEM program.
struct DemHello {
  int protocol = protocol_version;
  std::array<char, 32> version{};
  std::array<double, 3> box_lo{};  // [m]
  std::array<double, 3> box_hi{};
  std::array<int, 3> periodic{};
  double interval = 0.0;   // coupling interval [s]
  double time = 0.0;       // gas time at which the first coupling starts [s]
  std::uint32_t lent = 0;  // FieldSet that the scene's effects need
  std::uint32_t taken = 0;
};

// First words of the gas program.
struct GasHello {
  int protocol = protocol_version;
  std::array<char, 32> version{};
  std::array<double, 3> grid_lo{};  // [m]
  std::array<double, 3> grid_hi{};
  std::array<int, 3> cells{};
  std::array<int, 3> periodic{};
  double density = 0.0;             // [kg/m3]
  double viscosity = 0.0;           // [Pa s]
  int whole_pressure_gradient = 0;  // model B
  int plane_of_spheres = 0;         // along y the grid is a slice, not the DEM box
  double time = 0.0;                // of the gas state, 0 or that of a checkpoint [s]
  std::array<char, 256> input_file{};
  std::uint32_t lends = 0;
  std::uint32_t takes = 0;
  int probes = 0;
  std::array<double, 16> probe_heights{};  // [m]
};

enum class CommandKind : int {
  couple = 1,
  checkpoint,
  autopsy,  // a checkpoint of a run that has gone wrong, under a name of its own
  finish
};

// From the DEM leader, once per coupled step (and for a checkpoint, and at the end).
struct Command {
  CommandKind kind = CommandKind::finish;
  int fresh = 0;          // the DEM ranks' tiles are new: their boxes follow, velocities are lent
  long step = 0;          // DEM step
  double time = 0.0;      // gas time at the start of the interval [s]
  double interval = 0.0;  // [s]
};

// From the gas leader when the interval is done.
struct Report {
  double time = 0.0;  // at the end of the interval [s]
  int substeps = 0;
  double courant_max = 0.0;
  int pressure_iterations = 0;
  double continuity_residual = 0.0;
  double mass_inflow = 0.0;   // [kg/s]
  double mass_outflow = 0.0;  // [kg/s]
  long backflow_faces = 0;
  int outer_iterations = 0;
  double mass_imbalance = 0.0;
  long momentum_not_converged = 0;
  long pressure_not_converged = 0;
  long outer_not_converged = 0;
  long turbulence_clamped = 0;
  long turbulence_not_converged = 0;
  long moved_cells = 0;                  // cells whose solids beyond the packing limit were moved
  std::array<double, 3> drag_impulse{};  // lost by the gas in the interval [N s]
  double bubble_diameter = 0.0;          // [m]
  double surface_height = 0.0;           // [m]
  std::array<double, 16> probe_pressure{};  // [Pa]
  // The gas cannot go on, or could not write what it was asked to: why. It stays for an autopsy.
  int fault = 0;
  std::array<char, 640> fault_text{};
};

// Exchanges first words between the leaders and spreads the partner's over the local ranks.
// Collective over both programs. Sleeps while waiting.
GasHello greet_gas(const Communicator& local, MPI_Comm partner, const DemHello& mine);
DemHello greet_dem(const Communicator& local, MPI_Comm partner, const GasHello& mine);

// Faults of a pairing, all together, in words for the user; empty when the two fit.
std::string pairing_faults(const DemHello& dem, const GasHello& gas);

void send_command(const Communicator& local, MPI_Comm partner, const Command& command);
// Waits asleep; the command reaches every gas rank.
Command receive_command(const Communicator& local, MPI_Comm partner);
void send_report(const Communicator& local, MPI_Comm partner, const Report& report);
// On the DEM leader; other ranks get an empty one.
Report receive_report(const Communicator& local, MPI_Comm partner);
// From leader to leader, of any length; other ranks get an empty one.
void send_text(const Communicator& local, MPI_Comm partner, const std::string& text);
std::string receive_text(const Communicator& local, MPI_Comm partner);

// Every rank tells its box to all ranks of the partner. Collective over both programs.
std::vector<IndexBox> swap_boxes(MPI_Comm partner, const IndexBox& mine);

template <std::size_t size>
void put_text(std::array<char, size>& place, const std::string& text) {
  place.fill('\0');
  text.copy(place.data(), size - 1);
}

}  // namespace gasgrain
