// What the gas lends to grains: means over the steps of a coupling interval, in cells.
//
// A velocity is the mean of a cell's two faces, those on sides included (a wall's is 0, an inflow's
// f U). A pressure gradient, gravity's included, is the mean of its two faces too; a face of given
// velocity takes that of the cell's opposite face, an outlet's face its own, (p_out - p) / (h / 2).
//
// In model B the pressure acts on the gas alone, and grains feel no more of it than their buoyancy:
// what is lent is rho g (0 along periodic axes).
//
// Half of the drag K u - S of a cell acts on each of its two faces along an axis, those on sides
// included. Summed over the faces this is, face by face and exactly, the sum over the cells of K
// times the mean velocity, less S.
#pragma once

#include "gas_solver/gas_input.h"
#include "gas_solver/grid/gas_state.h"

namespace gasgrain {

class IntervalMeans {
 public:
  IntervalMeans(const Domain& domain, const GasInput& input);

  void clear();
  // A velocity that holds for the share `weight` of the interval.
  void add_velocity(const CellVector& velocity, double weight);
  // A pressure that does.
  void add_pressure(const GasState& state, double weight);
  // Force of the gas on the grains [N], of the whole grid. Collective.
  [[nodiscard]] Vec3 drag_force(const GasState& state) const;

  CellVector velocity;           // [m/s]
  CellVector pressure_gradient;  // [Pa/m]

 private:
  const Domain& domain_;
  Sides sides_;
  bool whole_gradient_;  // model B
  double density_;
  double compressibility_;
  Vec3 gravity_;
};

}  // namespace gasgrain
