// Isotropic stress of particles that are pressed together, which keeps parcels from passing close
// packing.
//
//   tau = P_s theta^beta / max(theta_cp - theta, eps (1 - theta))     [Pa]
//   dv/dt = -grad tau / (rho_p theta_p)                               [m/s2]
//
// Source: D. M. Snider, J. Comput. Phys. 170 (2001) 523, after S. E. Harris and D. G. Crighton,
// J. Fluid Mech. 266 (1994) 243; the denominator's second member keeps it above 0 at and beyond
// close packing. P_s [Pa], beta (2 to 5), eps (of the order 1e-7) are constants of the model.
// theta: SOLID volume fraction by trilinear deposit. A film takes up voids: O'Rourke, Zhao and
// Snider (2009), (17), theta_cp = theta_cp,s theta_p / theta_s, is the same as theta_s <=
// theta_cp,s. theta_p: volume fraction of particles with their films; rho_p: density of such a
// particle, so that the force on all particles of a volume is -grad tau.
//
// The gradient at a parcel is that of the trilinear interpolation of tau between cell centres, with
// no width beyond the cells that hold the parcel's solids; in the half cell along a wall it is
// that between the first two centres.
//
// Limiter (per component): with v the parcel's velocity and u the mean solid velocity around it as
// the step begins, and w = v + dt F / m the velocity that all other forces lead to, the change of
// velocity dv by the stress is
//
//   dv = minmod(-dt grad tau / (rho_p theta_p), (u - w) + e (u - v))
//
// the last member where it has the sign of u - w. So the stress brings a parcel to the mean of its
// surroundings, or beyond it by e times the velocity with which it came; it is stable at any step.
// A bed at rest under gravity stays at rest: u = v = 0, w = g dt, dv = -g dt where the stress
// suffices.
// Deviations: tau is explicit (theta of the step's beginning) where Snider solves for it; what then
// still passes close packing is stopped by parcel_motion.h. Snider's limiter, as MFiX-PIC documents
// it, is (1 + e) (u - w): it rebounds from the step of gravity too, and lifts a bed at rest with
// e g until it falls again (measured: beds of 0.2 m and more breathe by 1 % of their height).
// Momentum is exchanged with the surroundings through the mean, not pair by pair; the limiter's
// share is reported. Assumptions: N_p particles of a parcel move as one. Valid for theta from 0 up;
// steps with |v| dt < h.
#pragma once

#include "coupling/base/array3.h"
#include "coupling/base/tile_frame.h"
#include "fix_cfd_coupling/dem_physics/cell_sums.h"
#include "fix_cfd_coupling/dem_physics/parcels/parcel_settings.h"
#include "fix_cfd_coupling/dem_physics/parcels/parcel_view.h"

namespace gasgrain {

// Sums over the parcels of this rank.
struct StressReport {
  std::size_t limited = 0;         // components of parcels that the limiter made smaller
  std::size_t acting = 0;          // components with a force
  Vec3 impulse = Vec3::Zero();     // given to the parcels, all particles of them [N s]
  double greatest_fraction = 0.0;  // of the tile
  double greatest_stress = 0.0;    // [Pa], of the tile
};

class ParticleStress {
 public:
  explicit ParticleStress(const ParcelSettings& settings);

  // Adds the force on ONE particle [N] to `force` (count x 3), which holds all other forces of the
  // step but drag. The tile holds the trilinear stencils of all parcels, and the first
  // two layers of cells along a wall where it holds the first. Collective.
  StressReport add_forces(const ParcelView& parcels, const TileFrame& frame, double dt,
                          double* force, const SumOverRanks& sum);

  // tau [Pa] of a solid volume fraction.
  [[nodiscard]] double stress(double fraction) const;
  // Of the last call, over its tile.
  [[nodiscard]] const Array3<double>& solid_fraction() const { return fraction_; }

 private:
  // The greatest change of a velocity component.
  [[nodiscard]] double bound(double mean, double was, double coming) const;
  void deposit(const ParcelView& parcels, const TileFrame& frame, const SumOverRanks& sum);

  double close_packing_;
  double constant_;
  double exponent_;
  double epsilon_;
  double restitution_;
  bool on_;
  Array3<double> fraction_;                 // of solids
  Array3<double> filled_;                   // of particles with films
  Array3<double> stress_;                   // [Pa]
  Array3<double> mass_;                     // [kg]
  std::array<Array3<double>, 3> momentum_;  // [kg m/s]
};

}  // namespace gasgrain
