// Growth of a sintered neck between two touching grains by diffusion.
//
//   surface diffusion, below T_v   x^7 = 56 gamma a^4 D_s R^3 t / (k_B T)
//   volume diffusion, T_v and up   x^5 = 10 gamma a^3 D_v R^2 t / (k_B T)
//   D = D_0 exp(-Q / (R_gas T))
//
// x is the neck's radius. The laws are used as rates, d(x^n)/dt = B(T), so that x is all the state:
// x = (x0^n + B dt)^(1/n) is exact for a T that stays, goes on from any x0, and a change of
// temperature or of mechanism needs nothing more. A rough grain touches with 3 or 9 sub-grains of a
// tenth of its radius, each with a neck of its own of the same x.
//
// Source: G.C. Kuczynski, Trans. AIME 185 (1949) 169; K. Kuwagi, T. Mikami, M. Horio, Powder
//   Technol. 109 (2000) 27; Alobaid (2013), eqs 5.90 to 5.92, 5.94 to 5.96.
// Inputs: gamma surface tension [N/m], a lattice constant [m], D_0 [m^2/s], Q [J/mol], T [K], R
//   radius of a grain or sub-grain [m], t [s]. Output: x [m].
// Assumptions: like materials; no pressure sintering (atmospheric pressure); T above some 0.6 of
//   melting, else the neck is negligible; no shrinkage.
// Range: x up to 0.3 R, the first stage of sintering (beyond_first_stage() is for the caller to
//   count). n = 7 and 5 hold in it. The factors 56 and 10 differ among authors with the shape that
//   they give the neck.
// Deviations: the sources have equal spheres; unequal ones take R = 2 R1 R2 / (R1 + R2), a wall 2
//   R, which is R for equal spheres and keeps the curvature of the gap. Eq 5.92's R is the gas
//   constant, the others' a radius.
#pragma once

#include <cmath>

#include "fix_cfd_coupling/dem_physics/adhesion/hamaker_constant.h"
#include "fix_cfd_coupling/dem_physics/adhesion/input_faults.h"

namespace gasgrain::adhesion {

struct Diffusion {
  double prefactor = 0.0;          // D_0 [m^2/s]
  double activation_energy = 0.0;  // Q [J/mol]

  double coefficient(double temperature) const {
    return prefactor * std::exp(-activation_energy / (gas_constant * temperature));
  }
};

struct Sintering {
  double surface_tension = 0.0;   // gamma [N/m]
  double lattice_constant = 0.0;  // a [m]
  Diffusion surface;
  Diffusion volume;
  double volume_diffusion_from = 1323.15;  // T_v [K], that of iron
  int micro_contacts = 1;                  // 1 smooth; 3 or 9 rough

  bool by_volume(double temperature) const { return temperature >= volume_diffusion_from; }
  double exponent(double temperature) const { return by_volume(temperature) ? 5.0 : 7.0; }

  // B [m^n/s] with the radius R that touches (grain_radius of the pair).
  double rate(double grain_radius, double temperature) const {
    const double r = contact_radius(grain_radius);
    const double a3 = lattice_constant * lattice_constant * lattice_constant;
    const double common = surface_tension * a3 / (boltzmann * temperature);
    if (by_volume(temperature)) return 10.0 * common * volume.coefficient(temperature) * r * r;
    return 56.0 * common * lattice_constant * surface.coefficient(temperature) * r * r * r;
  }
  // The neck of one micro-contact after a further time [s] at this temperature.
  double grown(double neck, double grain_radius, double temperature, double time) const {
    const double growth = rate(grain_radius, temperature) * time;
    if (growth == 0.0) return neck;
    const double n = exponent(temperature);
    return std::pow(std::pow(neck, n) + growth, 1.0 / n);
  }
  // Cross-section of all necks of a contact [m^2].
  double area(double neck) const { return micro_contacts * contact::pi * neck * neck; }
  bool beyond_first_stage(double neck, double grain_radius) const {
    return neck > 0.3 * contact_radius(grain_radius);
  }
  // R of the (sub-)grains that touch.
  double contact_radius(double grain_radius) const {
    return micro_contacts == 1 ? grain_radius : 0.1 * grain_radius;
  }
};

inline double grain_radius_of_pair(double r1, double r2) {
  return 2.0 * contact::effective(r1, r2);
}
inline double grain_radius_at_wall(double r) {
  return 2.0 * r;
}

inline void check(const Sintering& law) {
  constexpr auto kelvin = "temperatures are in K, iron's is 1323.15 K";
  constexpr auto molar = "give it in J/mol; metals have 1e5 to 4e5";
  InputFaults("Sintering")
      .not_negative("surface tension", law.surface_tension, "N/m",
                    "metals have 1 to 2.5 N/m; give 0 to switch it off")
      .positive("lattice constant", law.lattice_constant, "m", "iron has 2.87e-10 m")
      .require(law.lattice_constant < 1e-8, "lattice constant", law.lattice_constant, "m",
               "below 1e-8", "give it in m, not in nm")
      .not_negative("prefactor of surface diffusion", law.surface.prefactor, "m2/s",
                    "give it in m2/s; give 0 for none")
      .not_negative("prefactor of volume diffusion", law.volume.prefactor, "m2/s",
                    "give it in m2/s; give 0 for none")
      .not_negative("activation energy of surface diffusion", law.surface.activation_energy,
                    "J/mol", molar)
      .not_negative("activation energy of volume diffusion", law.volume.activation_energy, "J/mol",
                    molar)
      .positive("volume_diffusion_from", law.volume_diffusion_from, "K", kelvin)
      .require(law.micro_contacts == 1 || law.micro_contacts == 3 || law.micro_contacts == 9,
               "micro_contacts", law.micro_contacts, "", "1, 3 or 9",
               "1 for smooth grains, 3 or 9 for rough ones")
      .refuse();
}

}  // namespace gasgrain::adhesion
