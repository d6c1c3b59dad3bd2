// fix ID all parcels KEYWORD VALUE...
//
// Makes the host's atoms parcels of many equal particles (multiphase particle-in-cell): no
// contacts, a stress on the grid instead, walls that are sides of the box. The
// physics is in dem_physics/parcels, the keywords in parcel_settings.h. Radius and mass of an
// atom are those of ONE particle, its film included. The fix moves the parcels itself and stands
// after gravity and before couple/gas.
//
// Particles a parcel are the property `particlesPerParcel`: `set ... property/atom
// particlesPerParcel N` sets, `f_particlesPerParcel` shows them.
// f_ID[1..4]: parcels; particles; solids, liquid of all particles [kg]. [5..8]: solids and liquid
// come in, gone [kg]. [9]: what of them does not add up, over the whole. [10]: greatest solid
// fraction of a cell over close packing. [11] parcels whose way was shortened there in this step.
// [12..14]: momentum lost there [N s], [15]: energy lost by damping [J], since the run began.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "coupling/base/exact_sum.h"
#include "fix_cfd_coupling/dem_physics/parcels/injection.h"
#include "fix_cfd_coupling/dem_physics/parcels/parcel_motion.h"
#include "fix_cfd_coupling/dem_physics/parcels/particle_stress.h"
#include "fix_cfd_coupling/fixes/rank_cells.h"
// --
#include "dialect_fix.h"
#include "dialect_grain_scalar.h"

namespace LAMMPS_NS {

class FixParcels : public HostFix {
 public:
  FixParcels(LAMMPS* host, int narg, char** arg);
  ~FixParcels() override;

  int mask() override;
  void init() override;
  void setup_pre_exchange() override;
  void setup_pre_force(int) override;
  void setup(int) override;
  void initial_integrate(int) override;
  void pre_exchange() override;
  void pre_force(int) override;
  void post_force(int) override;
  void final_integrate() override;
  void end_of_step() override;
  void post_run() override;

  void grow_arrays(int size) override;
  void copy_arrays(int from, int to, int) override;
  void set_arrays(int parcel) override;
  int pack_exchange(int parcel, double* buffer) override;
  int unpack_exchange(int parcel, double* buffer) override;
  int pack_restart(int parcel, double* buffer) override;
  void unpack_restart(int parcel, int nth) override;
  int size_restart(int) override;
  int maxsize_restart() override;
  void write_restart(FILE* file) override;
  void restart(char* data) override;

  double compute_vector(int n) override;
  double memory_usage() override;

  // The fix of the scene; null: atoms are grains.
  static FixParcels* of_scene(LAMMPS* host);
  [[nodiscard]] const gasgrain::ParcelSettings& settings() const { return settings_; }
  // By atom: N_p, and of one particle's solid core mass [kg] and volume [m3].
  [[nodiscard]] const double* sizes() const;
  [[nodiscard]] const double* solid_mass() const { return solid_mass_.data(); }
  [[nodiscard]] const double* solid_volume() const { return solid_volume_.data(); }
  // An atom that was just made is this one.
  void admit(int atom_index, const gasgrain::NewParcel& parcel);
  // The film of an atom now has this mass [kg] and volume [m3]: its mass and radius follow.
  void set_film(int atom_index, double mass, double volume);

 protected:
  void make_properties() override;

 private:
  // Solids and liquid [kg].
  struct Masses {
    double solids = 0.0;
    double liquid = 0.0;
  };
  struct Account {
    gasgrain::ExactSum solids;
    gasgrain::ExactSum liquid;
    Account& operator+=(const Masses& masses) {
      solids += masses.solids;
      liquid += masses.liquid;
      return *this;
    }
    [[nodiscard]] Masses value() const { return {solids.value(), liquid.value()}; }
  };
  // Of all ranks.
  struct Stock {
    double parcels = 0.0;
    double particles = 0.0;
    Masses held, came, gone;
    [[nodiscard]] double residual() const;
  };
  // Since the run began, of this rank.
  struct Limits {
    gasgrain::Vec3 lost_momentum = gasgrain::Vec3::Zero();  // at close packing [N s]
    double damped_energy = 0.0;                             // [J]
    double limited = 0.0, stopped = 0.0, cut = 0.0, stress_limited = 0.0, redirect_limited = 0.0;
    int most_passes = 0;
    double held_steps = 0.0;
    double greatest_fraction = 0.0;
  };

  void check_scene() const;
  void meet_new_parcels();
  void begin_balance();
  void check_parcels() const;
  void check_numbers() const;
  void take_out_leavers();
  [[nodiscard]] gasgrain::ParcelView view() const;
  void put_inside_walls();
  [[nodiscard]] Masses masses_of(int k) const;
  [[nodiscard]] Stock take_stock() const;
  void show();
  void kick();
  void tell(const std::string& text) const;

  gasgrain::ParcelSettings settings_;
  gasgrain::ParticleStress stress_;
  gasgrain::ParcelMotion motion_;
  std::unique_ptr<gasgrain::RankCells> cells_;
  GrainScalar size_;
  std::vector<double> solid_mass_;    // [kg], of a particle; 0: has not met the fix yet
  std::vector<double> solid_volume_;  // [m3]
  std::vector<double> known_mass_;    // [kg], with the film, as this fix knows it
  Account came_, gone_;               // of this rank, since the balance began
  Limits limits_;
  double put_inside_ = 0.0;  // coordinates beyond walls, before this run
  double limited_now_ = 0.0;
  double fraction_now_ = 0.0;
  std::array<double, 15> shown_{};
  bigint shown_at_ = -1;
};

}  // namespace LAMMPS_NS
