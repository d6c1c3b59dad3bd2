// Is the coupling interval T short enough for the grains as they move now? Two limits.
//
// Crossing. Void fraction and gas velocity are held where a grain was at the coupling. With v the
// greatest component and h the cell along it, C = T v / h cells are crossed in an interval: half a
// cell is advised, one is too many.
//
// Drag. The gas of an interval is charged with drag by the grains' velocity at its beginning, and
// moved by their displacement of the interval before, which the void fraction tells of; the grains
// feel the gas's velocity and pressure gradient held. In a layer of a bed continuity lets the gas
// rise only as the grains sink, and the pressure gradient that enforces it acts on the grains. With
// a = K T / m, E = exp(-a), s = (1 - E) / a, kappa = phi / eps, the densities' ratio q = rho /
// rho_s, w the grains' mean velocity of an interval, and c the carry over m (exchange_record.h):
//   u' = -kappa w,          G = kappa (a (u' - v) + c) + q (u' - u)   impulse of grad p over m
//   v_oo = u' + G / a,      v' = E v + (1 - E) v_oo,   w' = v_oo + (v - v_oo) s
//   c' = v' - v - G - a (u' - v)
// The mode that changes sign from interval to interval neither grows nor decays where
//   F = a h (kappa - 1) + a kappa (1 + kappa) g + 2 kappa (a - 1) + 2 q kappa g = 0,
//   h = coth(a / 2),  g = h (1 - s) - s;
// it grows where F > 0: in air a > 0.59 at 60 % of solids, 1.07 at 45 %, 2.3 at 30 %, nowhere below
// 19 %. Half of that is advised. Assumes: coupled in turn, model A, the pressure gradient on, one
// step of the gas an interval, grains free to move (contacts and weight hold a packed bed down:
// there the limit is on the safe side; parcels of less than a thousandth of the mean parcel's
// mass are left out), above 55 % of solids q < 0.4. Overlapped, what a grain
// feels is an interval older; T is taken twice.
#pragma once

#include <string>

#include "coupling/base/array3.h"
#include "coupling/exchange/exchange_record.h"
#include "coupling/exchange/particle_view.h"

namespace gasgrain {

inline constexpr double most_cells_crossed = 1.0;
inline constexpr double advised_cells_crossed = 0.5;
inline constexpr double advised_share_of_drag_limit = 0.5;

// F above: > 0 where a bed and its gas throw each other to and fro.
double drag_swing(double a, double solids, double density_ratio);
// The a at which F is 0; infinite where there is none.
double drag_limit(double solids, double density_ratio);

struct IntervalNeed {
  double crossing_rate = 0.0;  // greatest |v_d| / h_d [1/s]
  double
      longest_of_drag;  // least a_limit m / K of the grains that are beyond it [s]; infinite: none
  IntervalNeed();

  // What grains of another rank need as well.
  void join(const IntervalNeed& other);

  [[nodiscard]] double cells_crossed(double interval) const { return crossing_rate * interval; }
  [[nodiscard]] bool too_long(double interval) const;
  // The longest interval that keeps both advised shares [s]; infinite when nothing moves.
  [[nodiscard]] double advised() const;
};

// Why an interval is too long; empty when it is not.
std::string in_words(const IntervalNeed& need, double interval);
// The remedy: 'Write 'every 40'.', from the advised interval and the DEM step [s].
std::string every_to_write(double advised, double dt);

// The gas beside the grains; without a void fraction there is no drag to look at.
struct IntervalGas {
  double density = 0.0;  // [kg/m3]
  const BoxGrid& grid;
  const Array3<double>* void_fraction = nullptr;  // over the rank's tile
  double interval = 0.0;                          // [s]; twice it when overlapped
};

// Of a rank's grains, K from their records. One pass; grains with a < 0.05 (all of a bed of
// millimetres in air) cost a division.
IntervalNeed interval_need(const ParticleView& particles, const ExchangeRecords& records,
                           const IntervalGas& gas);

}  // namespace gasgrain
