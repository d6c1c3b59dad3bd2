// What a contact law asks of LAMMPS: the answers to dem_physics/contact/contact_host.h. Properties
// come from `fix property/global` (fix_property_global.h), or from the words of the style itself.
#pragma once

#include <map>
#include <memory>
#include <string>

#include "fix_cfd_coupling/dem_physics/contact/contact_host.h"
#include "fix_cfd_coupling/dem_physics/contact/contact_stack.h"

namespace LAMMPS_NS {
class LAMMPS;
class PairGranBridge;
}  // namespace LAMMPS_NS

namespace gasgrain {

// Of a pair style or a wall: what all its laws share.
struct ContactOwner {
  LAMMPS_NS::LAMMPS* host = nullptr;
  std::string style;    // as of errors: 'pair_style gran/bridge'
  std::string wall_id;  // '' of the pair style
  std::string normal;   // the normal model's name
  const std::map<std::string, double>* properties = nullptr;  // of the words
  contact::Reach* reach = nullptr;
  LAMMPS_NS::PairGranBridge* pair = nullptr;  // sends to the ghosts; null of a wall
};

class LammpsContactHost : public contact::ContactHost {
 public:
  LammpsContactHost(const ContactOwner& owner, const std::string& law, int history_offset)
      : ContactHost(owner.style + ": " + law), owner_(owner), offset_(history_offset) {}

  [[nodiscard]] int types() const override;
  [[nodiscard]] std::optional<contact::PairTable<double>> pairs(const char* name) const override;
  [[nodiscard]] std::optional<std::vector<double>> per_type(const char* name) const override;
  [[nodiscard]] std::optional<double> scalar(const char* name) const override;
  [[nodiscard]] std::vector<std::string> property_names() const override;

  [[nodiscard]] bool is_wall() const override { return !owner_.wall_id.empty(); }
  [[nodiscard]] std::string wall_id() const override { return owner_.wall_id; }
  [[nodiscard]] bool normal_model_is(const char* name) const override {
    return owner_.normal == name;
  }
  [[nodiscard]] int history_offset() const override { return offset_; }

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

  void reach(double gap_of_smallest, double greatest) override;
  void refuse_coarse_grains() const override {}  // there are none in LAMMPS
  void refuse_unfit_run() const override;
  void warn(const std::string& text) const override;
  void warn_from_here(const std::string& text) const override;

 protected:
  void end_launch(const std::string& message) const override;

 private:
  ContactOwner owner_;
  int offset_;
};

// The laws of a stack keep the host that they were connected to: one for each law, for as long.
class LammpsContactHosts {
 public:
  void connect(const ContactOwner& owner, contact::ContactStack& stack,
               const contact::StackName& name) {
    hosts_.clear();
    stack.connect(name, [&](const std::string& law, int offset) -> contact::ContactHost& {
      return *hosts_.emplace_back(std::make_unique<LammpsContactHost>(owner, law, offset));
    });
  }

 private:
  std::vector<std::unique_ptr<LammpsContactHost>> hosts_;
};

}  // namespace gasgrain
