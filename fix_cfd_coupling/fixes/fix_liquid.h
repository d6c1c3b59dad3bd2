// fix ID all liquid KEYWORD VALUE...
//
// The liquid of the scene: films on the grains and walls, and the rules by which `cohesion bridge`
// of `pair_style gran` and of `fix wall/gran` makes bridges of them. The
// physics is in dem_physics/liquid, the keywords in liquid_settings.h.
//
// Films are the property `liquidFilm` [m3] of the grains: `set ... property/atom liquidFilm V`
// sets, `f_liquidFilm` shows them.
// f_ID[1..9]: liquid in films, bridges of grains, bridges to walls, films of walls, come in, gone
// [m3]; what of them does not add up, over the whole; bridges; greatest saturation at a grain.
// Of a grain, f_ID[1..2]: bridges, liquid in them (half of those with grains) [m3].
#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "coupling/base/vec3.h"
#include "fix_cfd_coupling/dem_physics/liquid/liquid_ledger.h"
#include "fix_cfd_coupling/dem_physics/liquid/scene_liquid.h"
// --
#include "dialect_contacts.h"
#include "dialect_fix.h"
#include "dialect_grain_scalar.h"

namespace LAMMPS_NS {

class FixLiquid : public HostFix, public gasgrain::liquid::SceneLiquid {
 public:
  FixLiquid(LAMMPS* host, int narg, char** arg);
  ~FixLiquid() override;

  int mask() override;
  void init() override;
  void setup_pre_exchange() override;
  void setup_pre_force(int) override;
  void setup(int) override;
  void pre_exchange() override;
  void pre_force(int) override;
  void end_of_step() override;
  void post_run() override;

  void grow_arrays(int size) override;
  void copy_arrays(int from, int to, int) override;
  void set_arrays(int grain) override;
  int pack_exchange(int grain, double* buffer) override;
  int unpack_exchange(int grain, double* buffer) override;
  int pack_restart(int grain, double* buffer) override;
  void unpack_restart(int grain, int nth) override;
  int size_restart(int) override;
  int maxsize_restart() override;
  void write_restart(FILE* file) override;
  void restart(char* data) override;

  double compute_vector(int n) override;
  double memory_usage() override;

  // For the contact models. The fix of the scene; ends the launch when there is none.
  static FixLiquid& of_scene(LAMMPS* host);
  double join_pairs(int history_offset) override;
  gasgrain::liquid::WallBridges& join_wall(const std::string& wall_id) override;
  [[nodiscard]] gasgrain::Vec3 between(int i, int k) const override;

 protected:
  void make_properties() override;
  void pack_ghosts(int count, const int* list, double* buffer) override;
  void unpack_ghosts(int count, int first, const double* buffer) override;

 private:
  // Film of a grain that was inserted and has not met the fix yet; no film is negative.
  static constexpr double unmet_ = -1.0;

  void check_films() const;
  void check_walls() const;
  void settle_walls();
  // fix_liquid_films.cpp
  void meet_new_grains();
  void publish_films();
  // fix_liquid_reach.cpp
  void show_far_enough(double shown_within, const gasgrain::liquid::WallBridges& bridges);
  // fix_liquid_changes.cpp
  void leave_box(bool from_list);
  void dissolve_bridges_of_renumbered_grains();
  void take_back_from_lost_partners();
  void renew_contacts();
  void part_with_removed_walls();
  // fix_liquid_ledger.cpp
  void begin_ledger();
  void record();
  [[nodiscard]] gasgrain::liquid::LiquidTotals totals_of_rank() const;
  gasgrain::liquid::LiquidTotals take_stock();
  void warn(const gasgrain::liquid::LiquidTotals& totals, double residual);
  template <class F>
  void for_each_bridge(const F& f) const;
  template <class F>
  void for_each_stored(int k, const F& f) const;
  [[nodiscard]] double solid_volume(int k) const;
  [[nodiscard]] double saturation(int k) const;

  std::vector<std::unique_ptr<gasgrain::liquid::WallBridges>> walls_;
  gasgrain::liquid::LiquidLedger ledger_;
  std::vector<double> number_;            // of an owned grain, as it was in the last step; 0: new
  std::vector<gasgrain::Vec3> position_;  // of the owner, before any periodic image
  GrainScalar film_;
  gasgrain::HostContacts contacts_;
  int history_offset_ = -1;
  bool resumed_ = false;
  bool began_ = false;  // the ledger
  bool warned_of_saturation_ = false;
  bool warned_of_residual_ = false;
  double reach_ = 0.0;       // greatest gap of a bridge, over r_i + r_j
  double wall_reach_ = 0.0;  // and to a wall, over r
  // Of this rank, since stock was taken
  double new_liquid_ = 0.0, new_grains_ = 0.0;
  double gone_liquid_ = 0.0, gone_grains_ = 0.0;
  gasgrain::liquid::LiquidLedger told_;  // what warnings told of already
  std::array<double, 9> shown_{};        // f_ID[1..9]
  bigint shown_at_ = -1;                 // step
  bigint written_at_ = -1;
  bool file_begun_ = false;
  int grown_to_ = 0;
};

}  // namespace LAMMPS_NS
