// What a particle keeps of its own in one implicit step, (48)-(60) of O'Rourke, Zhao and Snider,
// Chem. Eng. Sci. 64 (2009) 1784.
//
//   psi_n = 1 / (1 + dt/tau_u + dt/tau_t)   (53)      1 - psi_t = 1 / (1 + dt/tau_t)   (54)
//   M_f,i' = kept M_f,i + (1 - kept) lambda_i M_s                                      (55)
//   H' = kept H + (1 - kept) sum_i lambda_i M_s h_i(T_f,eq),  H = sum_i M_f,i h_i(T_f)  (57)
//   u' = u_eq + a (u - u_eq),  a = velocity_kept M_p / M_p'                            (59), (60)
//
// Two choices. `mean`, as printed: kept = 1 - psi_t, velocity_kept = psi_n. It keeps the means of
// the provisional distribution (50), and the widths u'_rms and sigma_M then decay at the rates that
// (33) and (35) state of their squares: the squares decay twice as fast. `variance`: the square
// roots of both. Then sigma_M^2 is that of (50) and decays as (35) says when dt -> 0; so does k as
// (33) says where M_p does not change (dry, or films without inertia). Where liquid moves,
// M_p (u - u_eq) of all particles decays at one rate, and k has the further factor
// sum (M_p u')_0^2 / M_p(t) over its value at first, with either choice: at most the spread of M_p.
//
// Both conserve what (50) conserves, since sums of M_f,i - lambda_i M_s, of H - H_eq and of
// M_p (u - u_eq) over a cell are 0. Both are bounded: 0 <= kept <= 1, and M_p' >= kept M_p gives
// a <= velocity_kept / kept <= 1, as psi_n <= 1 - psi_t.
#pragma once

#include <cmath>

namespace gasgrain {

enum class Agglomeration { mean, variance };

struct Relaxation {
  double film_kept = 1.0;
  double film_given = 0.0;  // 1 - film_kept, without its cancellation
  double velocity_kept = 1.0;
};

// x y where 0 stays 0, whatever the other: no time scale, or no collisions at close packing.
inline double product_or_zero(double x, double y) {
  return x > 0.0 && y > 0.0 ? x * y : 0.0;
}

// steps_u: dt/tau_u, steps_t: dt/tau_t, 0 to infinity.
inline Relaxation relaxation(double steps_u, double steps_t, Agglomeration agglomeration) {
  Relaxation r;
  r.velocity_kept = 1.0 / (1.0 + steps_u + steps_t);
  r.film_kept = 1.0 / (1.0 + steps_t);
  // 1 - k = x / (1 + x), and 1 - k^(1/2) = x / (1 + x) / (1 + k^(1/2)).
  r.film_given = std::isinf(steps_t) ? 1.0 : steps_t * r.film_kept;
  if (agglomeration == Agglomeration::variance) {
    r.velocity_kept = std::sqrt(r.velocity_kept);
    r.film_kept = std::sqrt(r.film_kept);
    r.film_given /= 1.0 + r.film_kept;
  }
  return r;
}

}  // namespace gasgrain
