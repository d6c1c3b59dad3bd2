// The memory of the Basset force: a fixed number of doubles a particle, however long the run.
//
// A particle whose relative acceleration is held at a_k in step k feels, as the mean over step n,
//
//   B dt^(1/2) (4/3 a_n + sum over m >= 1 of g_m a_(n-m)),
//   g_m = 4/3 [(m+1)^(3/2) - 2 m^(3/2) + (m-1)^(3/2)]
//
// exactly: g_m is the double integral of (t - s)^(-1/2) over two steps, in units of dt. Its first
// term, of the present step, is an added mass. The sum is that of a few geometric series,
//
//   g_m ~ sum over j of c_j q_j^m,   so that   z_j <- q_j (z_j + a),   sum = sum over j of c_j z_j
//
// The -ln q_j are equally spaced in their logarithm, from 1/4 over the steps of the horizon to
// between 1/2 and 4; the c_j are fitted to g_m by least squares of the relative error. Beyond the
// horizon the memory fades exponentially instead of as t^(-1/2).
//
// Number of terms (each is 3 doubles a particle and some 10 operations a step, 3 ns) by greatest
// relative error of g_m up to the horizon:
//
//   horizon / dt   10 %   5 %   2 %   1 %   0.5 %   0.1 %
//            100      3     4     5     5       6       8
//           1000      4     5     6     7       7      10
//          10000      5     6     7     8       9      11
//         100000      6     7     8     9      10      13
//        1000000      7     8    10    11      12      15
//
// The error changes its sign from term to term and mostly cancels: a sphere of 0.3 of the fluid's
// density, let go in creeping flow, has the exact velocity to 0.19 % with a tolerance of 10 %, to
// 0.07 % with 5 %, to 0.004 % with 1 % (1000 steps; 83 % too fast without the force).
//
// Sums of exponentials for this force: M.A.T. van Hinsberg, J.H.M. ten Thije Boonkkamp, H.J.H.
// Clercx, J. Comput. Phys. 230 (2011) 1465 (theirs for the tail behind a window of past values).
#pragma once

#include <cstddef>
#include <vector>

#include "coupling/base/vec3.h"
#include "coupling/exchange/drag/basis.h"

namespace gasgrain {

class BassetKernel {
 public:
  // Step dt and horizon [s]; `tolerance`: greatest relative error of g_m, 1e-4 to 0.2. The terms
  // are the fewest that meet it, and the same on every rank.
  BassetKernel(double dt, double horizon, double tolerance);

  [[nodiscard]] std::size_t terms() const { return ratios_.size(); }
  // Doubles a particle: plain numbers that may migrate and be stored; zeros: no past.
  [[nodiscard]] std::size_t state_size() const { return 3 * terms(); }
  // The greatest relative error of g_m up to the horizon.
  [[nodiscard]] double error() const { return error_; }

  // Of the present step, to be taken implicitly [kg]: force = added_mass a + history.
  [[nodiscard]] double added_mass(const GasProperties& gas, double radius) const;
  // Of the steps before, mean over the present one [N].
  [[nodiscard]] Vec3 history(const GasProperties& gas, double radius, const double* state) const;
  // The step is over; `rate`: Du/Dt - dv/dt in it [m/s2].
  void advance(double* state, const Vec3& rate) const;

 private:
  double root_dt_;  // [s^(1/2)]
  double error_;
  std::vector<double> ratios_;   // q_j
  std::vector<double> weights_;  // c_j
};

}  // namespace gasgrain
