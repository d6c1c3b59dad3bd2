// Enthalpy of a liquid species, from its specific heat as a polynomial of the temperature.
//
//   c_p(T) = C_0 + C_1 T + C_2 T^2 + ...  [J/(kg K)],  T in K
//   h(T) = integral of c_p from the low end of the range to T  [J/kg]
//
// Beyond its range c_p stays what it is at that end, so that h goes on rising and no enthalpy is
// lost; whoever uses it counts such temperatures. Only differences of h matter to the exchange: its
// reference is of no consequence.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace gasgrain {

struct SpeciesEnthalpy {
  std::vector<double> coefficients;  // C_0, C_1, ...
  double low = 0.0;                  // range of the fit [K]
  double high = 0.0;

  [[nodiscard]] bool within_range(double T) const { return T >= low && T <= high; }

  // Specific heat at constant pressure [J/(kg K)].
  [[nodiscard]] double specific_heat(double T) const {
    const double t = std::clamp(T, low, high);
    double sum = 0.0;
    for (std::size_t n = coefficients.size(); n-- > 0;) sum = sum * t + coefficients[n];
    return sum;
  }
  // [J/kg]
  [[nodiscard]] double enthalpy(double T) const {
    const double t = std::clamp(T, low, high);
    return antiderivative(t) - antiderivative(low) + specific_heat(t) * (T - t);
  }

 private:
  [[nodiscard]] double antiderivative(double t) const {
    double sum = 0.0;
    for (std::size_t n = coefficients.size(); n-- > 0;)
      sum = sum * t + coefficients[n] / static_cast<double>(n + 1);
    return sum * t;
  }
};

}  // namespace gasgrain
