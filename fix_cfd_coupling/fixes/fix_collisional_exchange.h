// fix ID all collisional_exchange KEYWORD VALUE...
//
// Collisions exchange liquid, momentum and heat between the particles of a cell (O'Rourke, Zhao and
// Snider 2009): of parcels, where the scene has fix parcels, or of grains. The
// physics is in dem_physics/collisional_exchange, the keywords in exchange_settings.h.
//
// Films are the property `liquidFilm` [m3] of one particle, the same that liquid bridges take from;
// of several species the fix keeps the mixture, which whoever changes a film does not touch.
// Parcels take the mass and volume of their film on; grains stay what they are (the bridges' films
// have no inertia).
// f_ID[1..NS]: mass of each species in films [kg]; then greatest u'_rms [m/s] and shortest
// collision time [s] of a cell in the last exchange; parcels at close packing in it; since the run
// began liquid moved [kg] and energy of motion lost [J]. Of a particle, f_ID[1..NS]: film mass of
// each species [kg]; with temperatures f_ID[NS+1]: that of the film [K].
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "fix_cfd_coupling/dem_physics/collisional_exchange/collisional_exchange.h"
#include "fix_cfd_coupling/dem_physics/collisional_exchange/exchange_profile.h"
#include "fix_cfd_coupling/fixes/rank_cells.h"
// --
#include "dialect_fix.h"
#include "dialect_grain_scalar.h"

namespace LAMMPS_NS {

class FixParcels;

class FixCollisionalExchange : public HostFix {
 public:
  FixCollisionalExchange(LAMMPS* host, int narg, char** arg);
  ~FixCollisionalExchange() override;

  int mask() override;
  void init() override;
  void setup_pre_force(int) override;
  void setup(int) override;
  void end_of_step() override;
  void post_run() override;

  void grow_arrays(int size) override;
  void copy_arrays(int from, int to, int) override;
  void set_arrays(int particle) override;
  int pack_exchange(int particle, double* buffer) override;
  int unpack_exchange(int particle, double* buffer) override;
  int pack_restart(int particle, double* buffer) override;
  void unpack_restart(int particle, int nth) override;
  int size_restart(int) override;
  int maxsize_restart() override;

  double compute_vector(int n) override;
  double memory_usage() override;

  static FixCollisionalExchange* of_scene(LAMMPS* host);
  [[nodiscard]] std::vector<std::string> species() const;
  // An atom that was just made has this film [kg, of one particle, each species].
  void admit(int atom_index, const std::vector<double>& film_mass);

 protected:
  void make_properties() override;

 private:
  struct Words {
    gasgrain::ExchangeSettings exchange;
    std::optional<gasgrain::ProfileSettings> profile;
  };
  static Words read_words(LAMMPS* host, int narg, char** arg);
  FixCollisionalExchange(LAMMPS* host, int narg, char** arg, const Words& words);

  void check_scene() const;
  [[nodiscard]] std::size_t count_of_species() const { return settings_.species.size(); }
  [[nodiscard]] double film_volume(int k) const;
  void take_film(int k);
  void take_films();
  void give_films();
  void show(int k);
  [[nodiscard]] gasgrain::ExchangeView view();

  gasgrain::ExchangeSettings settings_;
  std::optional<gasgrain::ProfileSettings> profile_settings_;
  gasgrain::CollisionalExchange exchange_;
  std::unique_ptr<gasgrain::RankCells> cells_;
  std::unique_ptr<gasgrain::ExchangeProfile> profile_;
  FixParcels* parcels_ = nullptr;  // null: grains
  GrainScalar film_;
  std::vector<double> mass_;          // of films [kg], atom x species
  std::vector<double> temperature_;   // [K]
  std::vector<double> known_;         // volume [m3] of the film that the masses are of
  std::vector<double> solid_volume_;  // of grains
  std::vector<std::uint32_t> cell_;
  bool checked_ = false;  // what the script gave, in this run
  gasgrain::ExchangeReport total_, last_;
  int grown_to_ = 0;
};

}  // namespace LAMMPS_NS
