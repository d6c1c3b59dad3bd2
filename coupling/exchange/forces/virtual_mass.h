// Virtual mass: the gas that a particle must push aside when it accelerates otherwise than the gas.
//
//   F = m_a (Du/Dt - dv/dt),   m_a = C rho V_p,   C = 1/2
//
// Source: T.R. Auton, J.C.R. Hunt, M. Prud'homme, J. Fluid Mech. 197 (1988) 241: C = 1/2 for a
//   sphere in an inviscid gas, with Du/Dt along the gas's own path.
// Inputs: density [kg/m3], radius [m]. Output: m_a [kg]. The force is left to the host's code,
// which
//   takes dv/dt implicitly: (m + m_a) dv/dt = other forces + m_a Du/Dt. Explicitly it would be
//   unstable for particles lighter than m_a.
// Assumptions: a sphere alone. In dense beds C grows (Zuber, 1964: by (1 + 2 phi) / (1 - phi)).
// Range: any Reynolds number. For glass in air m_a is 1/4000 of the particle's mass.
// Deviations: Alobaid (2013), eqs 5.11 and 5.12, takes the factor of Odar and Hamilton (1964),
//   C = 1.05 - 0.066 / (A^2 + 0.12), A = |u - v|^2 / (d |d(u - v)/dt|), which is 1/2 for A = 0 (not
//   1, as the text has it) and 1.05 for large A. Resolved simulations of accelerated spheres have
//   since found 1/2 at all A and Reynolds numbers (Mei, Lawrence and Adrian 1991; Rivero, Magnaudet
//   and Fabre 1991): what the old experiments booked as virtual mass was history force. A factor
//   with dv/dt in it could not be taken implicitly either.
#pragma once

#include <string_view>

#include "coupling/exchange/drag/basis.h"
#include "coupling/exchange/forces/force_kind.h"
#include "coupling/exchange/gas_fields.h"
#include "coupling/exchange/sphere.h"

namespace gasgrain {

struct ForceVirtualMass {
  static constexpr std::string_view name = "virtual_mass";
  static constexpr ForceKind kind = ForceKind::added_mass;
  static constexpr bool reacts = true;

  static constexpr FieldSet lent() { return FieldSet().add(GasField::acceleration); }

  static double added_mass(const GasProperties& gas, double radius) {
    constexpr double displaced_share = 0.5;
    return displaced_share * gas.density * sphere_volume(radius);
  }
};

}  // namespace gasgrain
