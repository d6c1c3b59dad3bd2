// The forces of the gas on a rank's particles at a DEM step, with each particle's own present
// velocity.
//
// Drag, virtual mass and history are implicit in the particle's motion. With F the sum of all other
// forces (the host's own included), M = m + m_a (m_a: added masses), and over the step dt the gas's
// velocity u and acceleration Du/Dt held,
//
//   M dv/dt = K (u - v) + F + m_a Du/Dt + F_history
//
// is solved exactly, and its mean acceleration A over the step is what the host is made to use: the
// force it holds becomes m A. With a = K dt / M,
//
//   A = (1 - exp(-a)) / a * (K (u - v) + F + m_a Du/Dt + F_history) / M.
//
// A particle much faster to follow than the step (a >> 1) ends at u + F / K and not beyond; one
// that is slow (a -> 0) feels K (u - v). So the fix must be the last that adds forces. A particle
// that the host does not move is treated as if it could: of its drag it feels (1 - exp(-a)) / a.
#pragma once

#include <optional>
#include <vector>

#include "coupling/exchange/effects.h"
#include "coupling/exchange/exchange_record.h"
#include "coupling/exchange/force_costs.h"
#include "coupling/exchange/particle_view.h"

namespace gasgrain {

// The host's sums, count x 3, row by row.
struct HostForces {
  double* force = nullptr;   // [N]
  double* torque = nullptr;  // [N m]; needed by torques only
};

// What was applied since clear(), this rank's share.
struct AppliedForces {
  Vec3 reacting = Vec3::Zero();  // impulse of the forces that the gas answers for [N s]
  Vec3 free = Vec3::Zero();      // impulse of those that it does not: grad p, fields [N s]
  Vec3 host = Vec3::Zero();      // impulse of the host's own: walls, weight, contacts [N s]
  double exchanged = 0.0;        // sum over particles and components of |reacting impulse| [N s]
  // The same of each effect, in the order of Effects::names(); of a torque [N m s].
  std::vector<double> work;
};

class ForceLoop {
 public:
  ForceLoop(const Effects& effects, const GasProperties& gas);

  // Adds the forces to the host's. dt: the host's step [s]; share: of it that this force will act.
  void apply(const ParticleView& particles, ExchangeRecords& records, const HostForces& host,
             double dt, double share);

  [[nodiscard]] const AppliedForces& applied() const { return applied_; }
  void clear();
  // What share of apply()'s time each of Effects::names() has had so far.
  [[nodiscard]] const ForceCosts& costs() const { return costs_; }

 private:
  // Particles begin <= p < end.
  struct Block {
    std::size_t begin;
    std::size_t end;
  };
  void add_steady(Block block, const ParticleView& particles, ExchangeRecords& records,
                  const HostForces& host, double duration);
  void add_motions(Block block, const ParticleView& particles, ExchangeRecords& records,
                   const HostForces& host, double duration);
  template <class Motion>
  double add_motion(const Motion& motion, Block block, const ParticleView& particles,
                    ExchangeRecords& records, const HostForces& host, double duration);
  void solve(Block block, const ParticleView& particles, ExchangeRecords& records, double* force,
             double dt, double share);
  template <bool with_inertia, bool parcels>
  void solve_motion(Block block, const ParticleView& particles, ExchangeRecords& records,
                    double* force, double dt, double share);

  void time_solve(Block block, const ParticleView& particles, const ExchangeRecords& records,
                  const double* force, double dt);

  void make_memory(double dt);

  Effects effects_;
  GasProperties gas_;
  bool own_drag_;
  bool added_mass_;
  std::optional<ForceBasset> basset_;
  std::optional<BassetKernel> memory_;
  double dt_of_memory_ = 0.0;  // [s]
  AppliedForces applied_;
  ForceCosts costs_;
};

}  // namespace gasgrain
