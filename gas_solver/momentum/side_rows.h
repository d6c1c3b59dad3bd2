// The momentum rows at the sides of the domain: faces on outlets, faces along walls, faces next to
// inflow. See assembly.h for the equation.
#pragma once

#include "gas_solver/gas_input.h"
#include "gas_solver/momentum/momentum_step.h"
#include "gas_solver/momentum/row.h"
#include "gas_solver/operators/quantity.h"
#include "gas_solver/turbulence/turbulence.h"

namespace gasgrain {

// Share of mu that multiplies a component's derivative along its own axis: 2 - 2/3.
inline constexpr double normal_stress = 4.0 / 3.0;

class SideRows {
 public:
  SideRows(const Domain& domain, const GasInput& input);

  // After the inner rows. `viscosity`: the one they took; `face_void_fraction`: of the component.
  void add(const GasState& state, int component, const Quantity& viscosity,
           const Array3<double>& face_void_fraction, const std::vector<InflowFace>& inflow,
           const Turbulence* turbulence, Array3<MomentumRow>& rows) const;

 private:
  void open(const GasState& state, int side, const Quantity& viscosity,
            Array3<MomentumRow>& rows) const;
  void close(int component, int side, const Quantity& viscosity,
             const Array3<double>& face_void_fraction, const Turbulence* turbulence,
             Array3<MomentumRow>& rows) const;
  void add_jets(const GasState& state, int component, const std::vector<InflowFace>& inflow,
                Array3<MomentumRow>& rows) const;

  const Domain& domain_;
  Walls walls_;
  double density_;
  double viscosity_;     // molecular
  bool whole_gradient_;  // model B
  double compressibility_;
  Vec3 gravity_at_rest_;
  Vec3 gravity_body_;
  Vec3 spacing_;
};

}  // namespace gasgrain
