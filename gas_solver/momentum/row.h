// One equation of the momentum system, for the velocity of one face:
//   u = inverse_diagonal * (source + sum over the six neighbours of coefficient * u_neighbour).
// A row is a cache line: a sweep reads each once.
#pragma once

#include <array>

namespace gasgrain {

struct alignas(64) MomentumRow {
  // Neighbours x lo, x hi, y lo, ... (the numbering of sides).
  std::array<double, 6> coefficient;
  double source;
  // Until finish_rows(): the diagonal itself, without inertia.
  double inverse_diagonal;
};

}  // namespace gasgrain
