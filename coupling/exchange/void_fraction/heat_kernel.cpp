#include "coupling/exchange/void_fraction/heat_kernel.h"

#include <cmath>
#include <cstddef>

namespace gasgrain {
namespace {

constexpr double cut_off = 1e-14;  // of what has spread

double sum_of_both_sides(const std::vector<double>& u) {
  double sum = 0.0;
  for (std::size_t n = u.size() - 1; n > 0; --n) sum += 2.0 * u[n];  // small ones first
  return sum + u[0];
}

}  // namespace

// I_(n-1) = I_(n+1) + (2 n / tau) I_n, downwards from where I_n is nothing: in that direction
// whatever error there is dies out. The sum gives the scale.
std::vector<double> heat_kernel(double tau) {
  if (tau < cut_off) return {1.0};
  const auto top = static_cast<std::size_t>(40.0 + std::ceil(14.0 * std::sqrt(tau)));
  std::vector<double> u(top + 2, 0.0);
  u[top] = 1.0;
  for (std::size_t n = top; n > 0; --n) {
    u[n - 1] = u[n + 1] + 2.0 * static_cast<double>(n) / tau * u[n];
    if (u[n - 1] > 1e200)
      for (std::size_t m = n - 1; m <= top; ++m) u[m] *= 1e-200;
  }
  const double whole = sum_of_both_sides(u);
  double left = 0.0;
  while (u.size() > 1 && left + 2.0 * u.back() < cut_off * whole) {
    left += 2.0 * u.back();
    u.pop_back();
  }
  const double scale = 1.0 / sum_of_both_sides(u);
  for (double& value : u) value *= scale;
  return u;
}

}  // namespace gasgrain
