// What the collisional exchange finds along a line of cells, as means over time, in a CSV file.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "coupling/base/communicator.h"
#include "coupling/base/tile_frame.h"
#include "fix_cfd_coupling/dem_physics/collisional_exchange/collisional_exchange.h"

namespace gasgrain {

// The cells along `axis` that hold the point given by the other two coordinates, in their order.
struct ProfileSettings {
  int axis = 0;
  double first = 0.0;  // [m]
  double second = 0.0;
  double from = 0.0;  // s: means over what comes later
  std::string file;
};

// Takes `profile AXIS A B from T file F` out of the words; empty: there is none. Throws Error with
// its faults.
std::optional<ProfileSettings> take_profile(std::vector<std::string>& words);

class ExchangeProfile {
 public:
  // Throws Error when the line is outside of the grid.
  ExchangeProfile(const ProfileSettings& settings, const BoxGrid& grid);

  // Adds the state after an exchange. Every rank adds the parcels that it owns; collective over
  // `sum`.
  void add(const ExchangeView& view, const ExchangeCells& cells, const TileFrame& frame,
           double time, const SumOverRanks& sum);
  // Means so far; collective over `ranks`, whose rank 0 writes. Throws Error when it cannot.
  void write(const Communicator& ranks) const;

 private:
  // Sums over exchanges of a cell's values. Liquid is of the rank's own parcels; the others are
  // added by every rank that holds the cell, which all hold the same, and divided by `holders`.
  enum Column {
    liquid_mass,
    liquid_momentum,
    holders,
    equilibrium,
    rms,
    rate,
    spread,
    fraction,
    columns
  };

  ProfileSettings settings_;
  BoxGrid grid_;
  Int3 cell_;                 // of the line, its own axis 0
  std::vector<double> sums_;  // cell x columns
  Array3<double> eta_;
};

}  // namespace gasgrain
