// How grains and gas share the momentum of drag: the three ways that Feng and Yu compare.
//
//   scheme_1  grains: each its own, K (u - v);  gas: that of the mean velocity of the grains
//   around,
//             K (u - v_mean). The two sums differ: what is lost shows in the ledger's residual.
//   scheme_2  gas: as scheme 1;  grains: the same force, each its share of it, K (u - v_mean),
//             whatever its own velocity.
//   scheme_3  grains: each its own;  gas: the sum over the grains. The default.
//
// Source: Y.Q. Feng, A.B. Yu, Ind. Eng. Chem. Res. 43 (2004) 8378; F. Alobaid, thesis, TU Darmstadt
//   (2013), eqs 7.4 to 7.7.
// v_mean [m/s] at a grain: the velocities of the cells' solids (by volume) with the grain's
// weights. In schemes 1 and 2 the law for the gas is taken at the mean slip |u - v_mean|.
// Deviations: the share of a grain is by its own K instead of a weight function w(r), 7.6. Scheme 2
//   damps no motion of grains against each other, and its force holds for a whole interval: it is
//   not implicit in the grain's velocity.
#pragma once

#include <string_view>
#include <variant>

namespace gasgrain {

struct SharingScheme1 {
  static constexpr std::string_view name = "scheme_1";
  static constexpr bool by_mean_velocity = true;  // of the gas's force
  static constexpr bool own_drag = true;          // grains feel drag by their own velocity
};
struct SharingScheme2 {
  static constexpr std::string_view name = "scheme_2";
  static constexpr bool by_mean_velocity = true;
  static constexpr bool own_drag = false;
};
struct SharingScheme3 {
  static constexpr std::string_view name = "scheme_3";
  static constexpr bool by_mean_velocity = false;
  static constexpr bool own_drag = true;
};

// A build may list fewer (coupling/base/listed.h).
#ifndef GASGRAIN_MOMENTUM_SHARINGS
#define GASGRAIN_MOMENTUM_SHARINGS SharingScheme3, SharingScheme1, SharingScheme2
#endif
using MomentumSharing = std::variant<GASGRAIN_MOMENTUM_SHARINGS>;

}  // namespace gasgrain
