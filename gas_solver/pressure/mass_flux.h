// The mass fluxes eps rho u on the faces, which continuity is about and which convect momentum.
#pragma once

#include "gas_solver/boundary/ghosts.h"
#include "gas_solver/boundary/inflow.h"
#include "gas_solver/gas_input.h"
#include "gas_solver/grid/gas_state.h"
#include "gas_solver/grid/halo.h"

namespace gasgrain {

// What passes the sides of the domain.
struct SideFlows {
  double mass_inflow = 0;   // through faces of given velocity [kg/s]
  double mass_outflow = 0;  // through outlets [kg/s], backflow counted negative
  long backflow_faces = 0;
};

class MassFlux {
 public:
  MassFlux(const Domain& domain, const GasInput& input, Halo& halo)
      : domain_(domain), sides_(input.sides), density_(input.density), halo_(halo) {}

  // From the velocity, void fraction and density of the state, and from the inflow. Collective.
  void update(GasState& state, const std::vector<InflowFace>& inflow);
  // Collective.
  [[nodiscard]] SideFlows measure(const GasState& state) const;

 private:
  const Domain& domain_;
  Sides sides_;
  double density_;
  Halo& halo_;
};

}  // namespace gasgrain
