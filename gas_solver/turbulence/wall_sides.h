// The sides that gas sticks to, as a turbulence model sees them: the layer of cells inside each and
// the coefficient of its wall stress, tau_w = coefficient * (velocity along the wall, relative to
// it, at half a cell's distance).
//
// A face with an inflow patch on it, of whatever size, is no wall to the model: its cell's
// turbulence is that of the flow, and its coefficient stays mu / (h / 2).
#pragma once

#include <vector>

#include "gas_solver/gas_input.h"
#include "gas_solver/grid/domain.h"

namespace gasgrain {

struct WallSide {
  int side;
  double distance;  // h / 2 [m]
  Vec3 velocity;    // of the wall [m/s]
  // Over the layer of cells inside, and along it over the layers of Domain::box().
  Array3<char> is_wall;
  Array3<double> coefficient;  // [Pa s/m]
};

class WallSides {
 public:
  WallSides(const Domain& domain, const GasInput& input);

  [[nodiscard]] const std::vector<WallSide>& sides() const { return sides_; }
  std::vector<WallSide>& sides() { return sides_; }
  // Of a side the rank touches and the gas sticks to.
  [[nodiscard]] const Array3<double>& coefficient(int side) const;

 private:
  std::vector<WallSide> sides_;
};

}  // namespace gasgrain
