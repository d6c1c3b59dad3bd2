// fix ID all parcels/inject KEYWORD VALUE...
//
// A source of parcels: droplets or solids from a nozzle, or a feed through a face of the box. One
// fix a source; it stands after fix parcels and, where it injects liquid, after
// fix collisional_exchange, whose species it names (without one: the single species `liquid`).
// The physics is in dem_physics/parcels/injection.h, the keywords in
// injection_settings.h. Times are those of the run: steps times the timestep when the source first
// runs, from then on its own clock, which neither another timestep nor reset_timestep sets. Nothing
// comes in for the time before it first runs.
//
// f_ID[1..5]: mass of the flow come in, mass that has not come in whole yet [kg], solid mass, cores
// of droplets included [kg], particles, parcels; [6..]: mass of each species [kg].
#pragma once

#include <memory>
#include <vector>

#include "fix_cfd_coupling/dem_physics/parcels/injection.h"
// --
#include "dialect_fix.h"

namespace LAMMPS_NS {

class FixCollisionalExchange;
class FixParcels;

class FixParcelsInject : public HostFix {
 public:
  FixParcelsInject(LAMMPS* host, int narg, char** arg);

  int mask() override;
  void init() override;
  void pre_exchange() override;

  void write_restart(FILE* file) override;
  void restart(char* data) override;

  double compute_vector(int n) override;

 private:
  bool make(const gasgrain::NewParcel& parcel, int number);
  void begin_at(double time);
  void follow_clock();
  [[nodiscard]] double now() const;

  gasgrain::InjectionSettings settings_;
  std::unique_ptr<gasgrain::Injector> injector_;
  FixParcels* parcels_ = nullptr;
  FixCollisionalExchange* exchange_ = nullptr;
  gasgrain::BoxGrid box_;
  bigint done_to_ = -1;  // step up to which parcels have come in; -1: none yet
  double begun_ = 0.0;   // time at which the source first ran [s]
  // The clock: a time [s], its step, and the timestep since.
  double clock_time_ = 0.0;
  bigint clock_step_ = 0;
  double clock_dt_ = 0.0;
  std::size_t species_ = 0;
};

}  // namespace LAMMPS_NS
