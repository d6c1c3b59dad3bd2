// Subgrid viscosity of large eddies:
//
//   mu_t = rho (C_s Delta)^2 |S|,  Delta = (hx hy hz)^(1/3)
//
// Source: J. Smagorinsky, Mon. Weather Rev. 91 (1963) 99; Delta after Deardorff (1970). |S| [1/s]
// of the interstitial velocity, see strain_rate.h. C_s = 0.1 is the usual value where there is
// shear (Deardorff's of channels), 0.17 that of isotropic turbulence (Lilly 1967). On a grid one
// cell deep Delta is the mean (geometric) of the other two spacings: the depth of the one cell says
// nothing of what the grid resolves. (Large eddies in two dimensions are not turbulence; the model
// then is a measure of damping.) Walls: no damping (van Driest) and no wall law. Damping acts below
// y+ = 25, within the first cell of such grids; the stress is that of mu alone, too small where the
// viscous layer is thinner than that cell. The grains' own effect on the subgrid scales is not
// modelled.
#pragma once

#include "gas_solver/gas_input.h"
#include "gas_solver/grid/gas_state.h"
#include "gas_solver/grid/halo.h"
#include "gas_solver/turbulence/turbulence_report.h"
#include "gas_solver/turbulence/wall_sides.h"

namespace gasgrain {

// Width of the filter [m].
double filter_width(const BoxGrid& grid);

class Smagorinsky {
 public:
  static constexpr bool has_wall_law = false;

  Smagorinsky(const Domain& domain, const GasInput& input, Halo& halo);

  // Collective; the velocity's layers are filled.
  TurbulenceReport update(const GasState& state, double step,
                          const std::vector<InflowFace>& inflow);
  [[nodiscard]] const Array3<double>& viscosity() const { return viscosity_; }
  [[nodiscard]] const WallSides& walls() const { return walls_; }
  // The viscosity follows from the velocity: nothing to keep.
  template <class File>
  void exchange_with(File&) {}
  void restore(const GasState&) {}

 private:
  const Domain& domain_;
  Halo& halo_;
  double molecular_;  // [Pa s]
  double density_;    // [kg/m3]; where the state has none
  double area_;       // (C_s Delta)^2 [m2]
  WallSides walls_;
  Array3<double> viscosity_;
};

}  // namespace gasgrain
