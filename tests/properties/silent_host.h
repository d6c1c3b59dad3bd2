// A host for contact laws under test that keeps no grains and no liquid, and stays silent.
#pragma once

#include "coupling/base/error.h"
#include "fix_cfd_coupling/dem_physics/contact/contact_host.h"

namespace gasgrain::contact {

class SilentHost : public ContactHost {
 public:
  SilentHost() : ContactHost("law under test") {}

  [[nodiscard]] std::vector<std::string> property_names() const override { return {}; }
  [[nodiscard]] bool is_wall() const override { return false; }
  [[nodiscard]] std::string wall_id() const override { return ""; }
  [[nodiscard]] bool normal_model_is(const char* name) const override {
    return std::string(name) == "hertz";
  }
  [[nodiscard]] int history_offset() const override { return 0; }
  [[nodiscard]] double smallest_radius() const override { return 0.0; }
  [[nodiscard]] double largest_radius() const override { return 0.0; }
  [[nodiscard]] int grains() const override { return 0; }
  [[nodiscard]] const double* radii() const override { return nullptr; }
  [[nodiscard]] const int* const* numbers() const override { return nullptr; }
  [[nodiscard]] GrainScalar grain_scalar(const char*) const override { return {}; }
  [[nodiscard]] GrainScalarLines grain_scalar_lines(const char*) const override { return {}; }
  void send_to_ghosts(const GrainScalar&) override {}
  [[nodiscard]] std::int64_t step() const override { return 0; }
  [[nodiscard]] double timestep() const override { return 1e-6; }
  [[nodiscard]] MPI_Comm communicator() const override { return MPI_COMM_SELF; }
  [[nodiscard]] liquid::SceneLiquid& liquid() override { refuse("there is none."); }
  void reach(double, double) override {}
  void refuse_coarse_grains() const override {}
  void refuse_unfit_run() const override {}
  void warn(const std::string&) const override {}
  void warn_from_here(const std::string&) const override {}

 private:
  void end_launch(const std::string& message) const override { throw Error(message); }
};

}  // namespace gasgrain::contact
