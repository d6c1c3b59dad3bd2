// What the gas lends to grains: means over the steps of a coupling interval, in cells.
//
// A velocity is the mean of a cell's two faces, those on sides included (a wall's is 0, an inflow's
// f U). A pressure gradient, gravity's included, is the mean of its two faces too; a face of given
// velocity takes that of the cell's opposite face, an outlet's face its own, (p_out - p) / (h / 2).
//
// In model B the pressure acts on the gas alone, and grains feel no more of it than their buoyancy:
// what is lent is rho g (0 along periodic axes).
//
// Fields that only some forces on grains need are computed where they are asked for, and empty
// elsewhere (cell_means.h). The acceleration Du/Dt is the velocity's change over the interval,
// exact as a mean, and the mean of u . grad u of the same velocities.
//
// Half of the drag K u - S of a cell acts on each of its two faces along an axis, those on sides
// included. Summed over the faces this is, face by face and exactly, the sum over the cells of K
// times the mean velocity, less S.
#pragma once

#include "gas_solver/gas_input.h"
#include "gas_solver/grid/gas_state.h"

namespace gasgrain {

struct FurtherMeans {
  bool vorticity = false;
  bool acceleration = false;
  bool viscous_force = false;
  [[nodiscard]] bool any() const { return vorticity || acceleration || viscous_force; }
};

class IntervalMeans {
 public:
  IntervalMeans(const Domain& domain, const GasInput& input);

  // From the next interval on.
  void ask_for(const FurtherMeans& further);

  // An interval [s] begins at this velocity, and ends at that. The layers of all velocities must be
  // filled.
  void begin(const CellVector& velocity, double interval);
  void end(const CellVector& velocity, double interval);
  // A velocity that holds for the share `weight` of the interval.
  void add_velocity(const CellVector& velocity, double weight);
  // A pressure that does.
  void add_pressure(const GasState& state, double weight);
  // Force of the gas on the grains [N], of the whole grid. Collective.
  [[nodiscard]] Vec3 drag_force(const GasState& state) const;

  CellVector velocity;           // [m/s]
  CellVector pressure_gradient;  // [Pa/m]
  // Empty unless asked for.
  CellVector vorticity;      // [1/s]
  CellVector acceleration;   // Du/Dt [m/s2]
  CellVector viscous_force;  // div tau, with the molecular viscosity [N/m3]

 private:
  const Domain& domain_;
  FurtherMeans further_;
  CellVector with_walls_;  // a velocity with parabolic layers; empty unless further means are made
  Walls walls_;
  bool whole_gradient_;  // model B
  double density_;
  double viscosity_;
  double compressibility_;
  Vec3 gravity_;
};

}  // namespace gasgrain
