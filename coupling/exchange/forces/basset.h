// Basset's history force: the boundary layer of a particle lags behind when its slip changes.
//
//   F = B Int_0^t (Du/Dt - dv/dt)(s) (t - s)^(-1/2) ds,   B = 3/2 d^2 (pi rho mu)^(1/2)
//
// Source: A.B. Basset, A Treatise on Hydrodynamics vol. 2 (1888); Alobaid (2013), eq 5.14.
// Inputs: density, viscosity, radius, Du/Dt and dv/dt of every step. Output: B [kg/s^(1/2)], and
//   through BassetKernel the present step's added mass [kg] and the past steps' force [N].
// Assumptions: creeping flow about a sphere alone, which has the gas's velocity at t = 0 (a jump of
// the
//   slip to U adds B U t^(-1/2), which is left out).
// Range: Re below 1. At greater Re the memory fades faster, as t^(-2) once the wake has formed
//   (R. Mei, R.J. Adrian, J. Fluid Mech. 237 (1992) 323), and this force is an upper bound.
// Deviations: eq 5.14 has the factor of Odar and Hamilton (1964), eq 5.15, 2.88 + 3.12 / (1 + A)^3:
//   theirs is to be divided by 6 beside Basset's own B, else the force is six times too great at A
//   = 0. Here it is 1: it was fitted together with a virtual mass that later work has not confirmed
//   (virtual_mass.h). The thesis calls the variable of integration a relaxation time; it is time.
#pragma once

#include <array>
#include <cmath>
#include <string_view>

#include "coupling/exchange/drag/basis.h"
#include "coupling/exchange/forces/basset_kernel.h"
#include "coupling/exchange/forces/force_kind.h"
#include "coupling/exchange/forces/force_parameter.h"
#include "coupling/exchange/gas_fields.h"
#include "coupling/exchange/sphere.h"

namespace gasgrain {

struct ForceBasset {
  static constexpr std::string_view name = "basset";
  static constexpr ForceKind kind = ForceKind::history;
  static constexpr bool reacts = true;
  using Memory = BassetKernel;

  static constexpr FieldSet lent() { return FieldSet().add(GasField::acceleration); }

  // `basset tolerance E horizon N`: the greatest error of the memory within the last N steps.
  // A hundredth is less than the law's own error; 1e5 DEM steps outlast most runs' transients.
  static constexpr std::array<ForceParameter, 2> parameters{{
      {"tolerance", 1, "1", 1e-4, 0.2},
      {"horizon", 1, "DEM steps", 10.0, 1e9},
  }};
  double* values(std::size_t n) { return n == 0 ? &tolerance : &horizon; }

  double tolerance = 0.01;
  double horizon = 1e5;

  // For a DEM step [s].
  [[nodiscard]] Memory memory(double dt) const { return {dt, horizon * dt, tolerance}; }

  static double coefficient(const GasProperties& gas, double radius) {
    return 6.0 * radius * radius * std::sqrt(pi * gas.density * gas.viscosity);
  }
};

}  // namespace gasgrain
