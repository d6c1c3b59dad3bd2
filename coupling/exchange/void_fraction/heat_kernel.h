// The heat kernel of a line of cells without ends: what has spread to a cell n cells away after the
// exchange with neighbours
//
//   d u_n / d tau = (u_(n-1) - 2 u_n + u_(n+1)) / 2,      u_n(0) = 1 for n = 0, else 0,
//
// has gone on until the variance of u is tau, in cells squared:
//
//   u_n = exp(-tau) I_n(tau),      I_n the modified Bessel function of the first kind.
//
// Source: the generating function of I_n, exp(tau (z + 1/z) / 2) = sum of I_n z^n.
// Properties: positive, even in n, falling with |n|; sum 1; the variance is tau exactly. For
//   tau >> 1 it is the Gaussian sampled at the cells; at tau = 0 it is the unit. The kernel of
//   tau_1 + tau_2 is that of tau_1 applied to that of tau_2.
#pragma once

#include <vector>

namespace gasgrain {

// u_0 to u_R: beyond R less than 1e-14 is left in all, and what is kept is made to sum to 1.
std::vector<double> heat_kernel(double tau);

}  // namespace gasgrain
