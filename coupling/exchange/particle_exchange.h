// The loops over a rank's particles in a coupled step, in the order of their use:
//   deposit_solid_volume -> [void fraction from the gas ranks] -> refresh_drag -> deposit_drag
//   -> [the gas advances over the interval] -> set_records -> apply_forces, every DEM step.
// All of them work on the host's arrays and on fields over the rank's tile; none communicates.
//
// The particles must not move, nor change order, between refresh_drag and set_records, so that what
// the gas gave and what is expected are the same to round-off.
#pragma once

#include <vector>

#include "coupling/exchange/effects.h"
#include "coupling/exchange/exchange_record.h"
#include "coupling/exchange/particle_view.h"
#include "coupling/exchange/particle_weights.h"

namespace gasgrain {

// Adds the particles' volume [m3] to the field.
void deposit_solid_volume(const ParticleView& particles, const ParticleWeights& weights,
                          Array3<double>& solid_volume);

struct DragRefresh {
  std::size_t too_dense = 0;         // particles at a void fraction below least_drag_void_fraction
  double least_void_fraction = 1.0;  // met at any particle, before it was raised to that bound
};

// K of every record from the void fraction and the last gas velocity [m/s] at the particle.
DragRefresh refresh_drag(const ParticleView& particles, const ParticleWeights& weights,
                         const DragModel& model, const GasProperties& gas,
                         const Array3<double>& void_fraction, const VectorField& gas_velocity,
                         ExchangeRecord* records);

// Adds K [kg/(m3 s)] and S = K v - carry / interval [N/m3] per volume of cell.
void deposit_drag(const ParticleView& particles, const ParticleWeights& weights,
                  const ExchangeRecord* records, double cell_volume, double interval,
                  Array3<double>& drag_coefficient, VectorField& drag_source);

// Fields returned by the gas; null where no effect needs the field.
struct LentFields {
  const VectorField* velocity = nullptr;           // [m/s]
  const VectorField* pressure_gradient = nullptr;  // [Pa/m]
};

// Begins a coupling interval [s]: u and steady forces from the returned fields, expected = K (u -
// v) interval, taken = 0. Returns for each of effects.forces the sum over particles and components
// of |F| interval [N s], its share in the work shown by the ledger.
std::vector<double> set_records(const ParticleView& particles, const ParticleWeights& weights,
                                const Effects& effects, const LentFields& lent, double interval,
                                ExchangeRecord* records);

struct AppliedDrag {
  Vec3 impulse = Vec3::Zero();  // given to the particles in this call [N s]
  double magnitude = 0.0;       // sum over particles and components of |impulse| [N s]
};

// Adds K (u - v) + steady_force to `force` [N] (count x 3, row by row) and K (u - v) dt to `taken`.
// dt [s] is the time over which the host will let this force act.
AppliedDrag apply_forces(const ParticleView& particles, const Effects& effects,
                         ExchangeRecord* records, double* force, double dt);

// Sum of the particles' carry [N s].
Vec3 outstanding_carry(std::size_t count, const ExchangeRecord* records);

}  // namespace gasgrain
