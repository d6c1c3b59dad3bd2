// What a contact law may ask of LIGGGHTS when a run begins (contact_host.h says what).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fix_cfd_coupling/dem_physics/contact/contact_host.h"

namespace LAMMPS_NS {
class FixWallGran;
class LAMMPS;
}  // namespace LAMMPS_NS
namespace LIGGGHTS {
class IContactHistorySetup;
}

namespace gasgrain {

class ContactHostLiggghts final : public contact::ContactHost {
 public:
  // `place`: the pair style or the wall, as the host's models know it.
  ContactHostLiggghts(LAMMPS_NS::LAMMPS& host, LIGGGHTS::IContactHistorySetup& place,
                      std::string law);

  void set_history_offset(int offset) { history_offset_ = offset; }
  // The coefficient of friction is 0, whatever the script has.
  void set_frictionless(bool yes) { frictionless_ = yes; }
  [[nodiscard]] LAMMPS_NS::FixWallGran* wall() const { return wall_; }
  // The loop over contacts is one of our own (pair_gran_bridge.h): it has a law of its own, and
  // that of the host's models stands idle.
  [[nodiscard]] bool has_own_loop() const;

  [[nodiscard]] int types() const override;
  [[nodiscard]] std::optional<contact::PairTable<double>> pairs(const char* name) const override;
  [[nodiscard]] std::optional<std::vector<double>> per_type(const char* name) const override;
  [[nodiscard]] std::optional<double> scalar(const char* name) const override;
  [[nodiscard]] std::vector<std::string> property_names() const override;

  [[nodiscard]] bool is_wall() const override { return wall_ != nullptr; }
  [[nodiscard]] std::string wall_id() const override;
  [[nodiscard]] bool normal_model_is(const char* name) const override;
  [[nodiscard]] int history_offset() const override { return history_offset_; }

  [[nodiscard]] double smallest_radius() const override;
  [[nodiscard]] double largest_radius() const override;
  [[nodiscard]] int grains() const override;
  [[nodiscard]] const double* radii() const override;
  [[nodiscard]] const int* const* numbers() const override;
  [[nodiscard]] contact::GrainScalar grain_scalar(const char* name) const override;
  [[nodiscard]] contact::GrainScalarLines grain_scalar_lines(const char* name) const override;
  void send_to_ghosts(const contact::GrainScalar& scalar) override;

  [[nodiscard]] std::int64_t step() const override;
  [[nodiscard]] double timestep() const override;
  [[nodiscard]] MPI_Comm communicator() const override;
  [[nodiscard]] liquid::SceneLiquid& liquid() override;

  using ContactHost::reach;
  void reach(double gap_of_smallest, double greatest) override;

  void refuse_coarse_grains() const override;
  void refuse_unfit_run() const override;
  void warn(const std::string& text) const override;
  void warn_from_here(const std::string& text) const override;

 private:
  void end_launch(const std::string& message) const override;

  LAMMPS_NS::LAMMPS& host_;
  LIGGGHTS::IContactHistorySetup& place_;
  LAMMPS_NS::FixWallGran* wall_;  // null of a pair style
  int history_offset_ = -1;
  bool frictionless_ = false;
};

}  // namespace gasgrain
