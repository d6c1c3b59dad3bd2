// The temperature of a film from its enthalpy: T in
//
//   sum_i M_f,i h_i(T) = H
//
// Used in (9) for a cell and in (57) for a particle; O'Rourke, Zhao and Snider, Chem. Eng. Sci. 64
// (2009) 1784. Masses [kg], of one species each, 0 or more and not all 0; H [J].
// c_p > 0 makes the left side rise with T: one solution, between the temperatures that were mixed.
// Newton's method held in that bracket; (58) promises the bracket, and keeps T in it to the bit. A
// bracket without an upper end is one, too.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "fix_cfd_coupling/dem_physics/collisional_exchange/exchange_settings.h"

namespace gasgrain {

// sum_i M_f,i h_i(T) [J]; mass(i) gives M_f,i.
template <class Mass>
double film_enthalpy(const std::vector<LiquidSpecies>& species, const Mass& mass, double T) {
  double sum = 0.0;
  for (std::size_t i = 0; i < species.size(); ++i) sum += mass(i) * species[i].enthalpy.enthalpy(T);
  return sum;
}

struct TemperatureBracket {
  double low;
  double high;
};

// T [K] with film_enthalpy(T) = H, within the bracket; start: a guess in it.
template <class Mass>
double temperature_of(const std::vector<LiquidSpecies>& species, const Mass& mass, double H,
                      TemperatureBracket bracket, double start) {
  // Newton needs two or three passes; a bracket that halves needs 60 to the last bit.
  constexpr int most_passes = 100;
  auto& [low, high] = bracket;
  double T = std::clamp(start, low, high);
  for (int pass = 0; pass < most_passes; ++pass) {
    const double excess = film_enthalpy(species, mass, T) - H;
    if (excess == 0.0) return T;
    (excess > 0.0 ? high : low) = T;
    double slope = 0.0;
    for (std::size_t i = 0; i < species.size(); ++i)
      slope += mass(i) * species[i].enthalpy.specific_heat(T);
    const double next = T - excess / slope;
    const double last_digits = 4.0 * std::numeric_limits<double>::epsilon() * T;
    if (std::abs(next - T) <= last_digits || high - low <= last_digits)
      return std::clamp(next, low, high);
    if (next > low && next < high)
      T = next;
    else
      T = 0.5 * (low + high);
  }
  return T;
}

}  // namespace gasgrain
