// The loops over a rank's particles at a coupling, in the order of their use:
//   deposit_solids -> [void fraction from the gas ranks] -> refresh_drag -> deposit_drag
//   -> [the gas advances over the interval] -> book_expected, set_gas_at_particles
// and then applied_forces.h at every DEM step. All of them work on the host's arrays and on fields
// over the rank's tile; none communicates.
//
// book_expected() must be given the weights of deposit_drag(), so that what the gas gave and what
// is expected are the same to round-off.
#pragma once

#include <vector>

#include "coupling/exchange/effects.h"
#include "coupling/exchange/exchange_record.h"
#include "coupling/exchange/field_store.h"
#include "coupling/exchange/particle_view.h"
#include "coupling/exchange/particle_weights.h"

namespace gasgrain {

// Adds the particles' volume [m3].
void deposit_solid_volume(const ParticleView& particles, const ParticleWeights& weights,
                          Array3<double>& solid_volume);
// Adds it and, where the effects ask for it, volume times velocity [m4/s].
void deposit_solids(const ParticleView& particles, const ParticleWeights& weights,
                    const Effects& effects, FieldStore& fields);

struct DragRefresh {
  std::size_t too_dense = 0;         // particles at a void fraction below least_drag_void_fraction
  std::size_t disturbance_cut = 0;   // particles whose own disturbance is beyond what can be undone
  double least_void_fraction = 1.0;  // met at any particle, before it was raised to that bound
};

// K of every record from the void fraction and the last gas velocity [m/s] at the particle, its own
// disturbance undone (self_disturbance.h).
DragRefresh refresh_drag(const ParticleView& particles, const ParticleWeights& weights,
                         const Effects& effects, const GasProperties& gas, const FieldStore& fields,
                         ExchangeRecords& records);

// Adds K [kg/(m3 s)] and S = K v - carry / interval [N/m3] per volume of cell. `taken` begins anew;
// until book_expected() is called, the carry stays as it was.
void deposit_drag(const ParticleView& particles, const ParticleWeights& weights,
                  const Effects& effects, double cell_volume, double interval, FieldStore& fields,
                  ExchangeRecords& records);

// expected = K (u - v) interval, u from the gas velocity that the gas was charged with.
// The particles have the velocities of deposit_drag().
void book_expected(const ParticleView& particles, const ParticleWeights& weights,
                   const Effects& effects, const FieldStore& fields, double interval,
                   ExchangeRecords& records);

// The same after set_gas_at_particles(), whose u in the records is that velocity when the weights
// are still those of deposit_drag().
void book_expected(const ParticleView& particles, const Effects& effects, double interval,
                   ExchangeRecords& records);

// What the forces of the interval [s] need of the gas, sampled at the particles. Returns for each
// of Effects::names() the sum over particles and components of |F| interval [N s] where the force
// is a steady one, 0 elsewhere. `seconds`: receives, for the same names, the time
// that the steady forces took.
std::vector<double> set_gas_at_particles(const ParticleView& particles,
                                         const ParticleWeights& weights, const Effects& effects,
                                         const GasProperties& gas, const FieldStore& fields,
                                         double interval, ExchangeRecords& records,
                                         std::vector<double>* seconds = nullptr);

// Sum of the particles' carry [N s].
Vec3 outstanding_carry(const ParticleView& particles, const ExchangeRecords& records);

}  // namespace gasgrain
