// A host of two grains for contact laws, without any DEM code: answers what laws of the LISTs ask,
// and takes a pair through its life.
#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include "fix_cfd_coupling/dem_physics/contact/cohesion_law.h"
#include "fix_cfd_coupling/dem_physics/liquid/scene_liquid.h"
#include "tests/properties/silent_host.h"

namespace gasgrain::contact {

class TwoGrainsLiquid : public liquid::SceneLiquid {
 public:
  explicit TwoGrainsLiquid(const std::array<double, 2>& radii) : radii_(radii) {
    settings_ = liquid::parse_liquid({"content", "0.01", "surface_tension", "0.07", "contact_angle",
                                      "0.3", "viscosity", "0.001", "minimum_separation", "1e-6"},
                                     1);
    wet_ = true;
    films_.resize(2);
    for (int k = 0; k < 2; ++k) film_[k] = settings_.film_at_first(radii_[k]);
    publish();
  }
  void end_step() {
    for (int k = 0; k < 2; ++k) film_[k] = films_.settle(k, film_[k], 0);
    publish();
  }
  double join_pairs(int) override { return 0.2; }
  liquid::WallBridges& join_wall(const std::string&) override { return wall_; }
  [[nodiscard]] Vec3 between(int, int) const override { return Vec3::Zero(); }

 private:
  void publish() {
    for (int k = 0; k < 2; ++k) films_.publish(k, film_[k], radii_[k], 1e-5);
  }
  std::array<double, 2> radii_;
  std::array<double, 2> film_{};
  liquid::WallBridges wall_{"none"};
};

class TwoGrains final : public SilentHost {
 public:
  std::array<double, 2> radius{1e-3, 6e-4};
  TwoGrainsLiquid film{radius};

  [[nodiscard]] int types() const override { return 1; }
  [[nodiscard]] std::optional<PairTable<double>> pairs(const char* name) const override {
    const auto value = of_pairs_.find(name);
    if (value == of_pairs_.end()) return std::nullopt;
    PairTable<double> table(1);
    table(1, 1) = value->second;
    return table;
  }
  [[nodiscard]] std::optional<std::vector<double>> per_type(const char* name) const override {
    const auto value = others_.find(name);
    if (value == others_.end()) return std::nullopt;
    return std::vector<double>{0.0, value->second};
  }
  [[nodiscard]] std::optional<double> scalar(const char* name) const override {
    const auto value = others_.find(name);
    return value == others_.end() ? std::nullopt : std::optional<double>(value->second);
  }
  [[nodiscard]] double smallest_radius() const override { return radius[1]; }
  [[nodiscard]] double largest_radius() const override { return radius[0]; }
  [[nodiscard]] int grains() const override { return 2; }
  [[nodiscard]] const double* radii() const override { return radius.data(); }
  [[nodiscard]] const int* const* numbers() const override { return &number_; }
  [[nodiscard]] GrainScalar grain_scalar(const char*) const override { return {&charge_, true}; }
  [[nodiscard]] liquid::SceneLiquid& liquid() override { return film; }

 private:
  std::map<std::string, double> of_pairs_{
      {"hamakerConstant", 1e-19},         {"workOfAdhesion", 0.05},
      {"neckSurfaceTension", 2.0},        {"neckTensileStrength", 1e12},
      {"neckShearStrength", 1e12},        {"neckStiffness", 1e3},
      {"coefficientFriction", 0.3},       {"rollingTimeConstant", 1e-3},
      {"coefficientRollingFriction", 0.1}};
  std::map<std::string, double> others_{
      {"youngsModulus", 5e6},          {"poissonsRatio", 0.3},
      {"neckLatticeConstant", 3e-10},  {"surfaceDiffusionPrefactor", 5e-4},
      {"surfaceDiffusionEnergy", 2e5}, {"volumeDiffusionPrefactor", 2e-4},
      {"volumeDiffusionEnergy", 2e5}};
  std::array<double, 2> charges_{1e-12, -2e-12};
  const double* charge_ = charges_.data();
  std::array<int, 2> numbers_{11, 7};
  const int* number_ = numbers_.data();
};

// The words' values where they have no default that acts.
class WordsOfTest final : public LawWords {
 public:
  void number(const char* word, double& value, double otherwise) override {
    const std::map<std::string, double> given{{"greatest_gap", 1e-5}, {"neck_temperature", 1400.0}};
    const auto at = given.find(word);
    value = at == given.end() ? otherwise : at->second;
  }
  void on_off(const char*, bool& value, bool otherwise) override { value = otherwise; }
};

// How two grains lie and move; `swapped`: the host has the other one as i.
struct PairMotion {
  Vec3 normal = Vec3(2.0, -1.0, 2.0) / 3.0;  // from the second to the first
  std::array<Vec3, 2> velocity{Vec3(0.1, -0.02, 0.03), Vec3(-0.05, 0.01, 0.06)};
  std::array<Vec3, 2> spin{Vec3(10.0, 4.0, -7.0), Vec3(-3.0, 8.0, 5.0)};
  bool swapped = false;
};

// Of one step, of the first and of the second grain.
struct PairForces {
  std::array<Vec3, 2> force{Vec3::Zero(), Vec3::Zero()};
  std::array<Vec3, 2> torque{Vec3::Zero(), Vec3::Zero()};
  Vec3 between = Vec3::Zero();  // the centres
  bool acts = false;
};

// Two grains that touch for three steps, then are apart for one.
template <class Law>
class PairLife {
 public:
  explicit PairLife(const PairMotion& motion) : motion_(motion) {
    WordsOfTest words;
    law_.words(words);
    law_.connect(host_);
    history.assign(Law::history(false).size(), 0.0);
  }

  std::vector<double> history;
  static constexpr double overlap = 1e-6;
  static constexpr double gap = 2e-7;

  std::vector<PairForces> all() {
    std::vector<PairForces> steps;
    for (int n = 0; n < 3; ++n) steps.push_back(step(-overlap, true));
    steps.push_back(step(gap, true));
    return steps;
  }

  PairForces step(double gap_of_step, bool updates) {
    if (updates) ++step_;
    const int i = motion_.swapped ? 1 : 0;
    const int j = 1 - i;
    PairForces result;
    const double distance = host_.radius[0] + host_.radius[1] + gap_of_step;
    result.between = distance * motion_.normal;
    const Vec3 delta = motion_.swapped ? Vec3(-result.between) : result.between;
    const Vec3 en = delta / distance;
    const ContactForces forces{result.force[i].data(), result.torque[i].data(),
                               result.force[j].data(), result.torque[j].data()};
    ContactView c{};
    c.i = i;
    c.j = j;
    c.itype = c.jtype = 1;
    c.owns_j = true;
    c.radi = host_.radius[i];
    c.radj = host_.radius[j];
    c.radsum = c.radi + c.radj;
    c.rsq = delta.squaredNorm();
    c.delta = delta.data();
    c.v_i = motion_.velocity[i].data();
    c.v_j = motion_.velocity[j].data();
    c.omega_i = motion_.spin[i].data();
    c.omega_j = motion_.spin[j].data();
    c.updates = updates;
    c.history = history.empty() ? nullptr : history.data();
    c.dt = host_.timestep();
    c.step = step_;
    c.area_ratio = 1.0;
    law_.begin_pass();
    if (gap_of_step < 0.0) {
      c.en = en.data();
      c.overlap = -gap_of_step;
      c.vn = (motion_.velocity[i] - motion_.velocity[j]).dot(en);
      c.meff = 5e-6;
      c.kn = 1e3;
      c.kt = 800.0;
      c.Fn = c.kn * c.overlap;
      law_.touching(c, forces);
      law_.after_all(c, forces);
      result.acts = true;
    } else {
      law_.apart(c, forces);
      result.acts = c.acts;
    }
    if (updates) host_.film.end_step();
    return result;
  }

 private:
  PairMotion motion_;
  TwoGrains host_;
  Law law_;
  std::int64_t step_ = 0;
};

}  // namespace gasgrain::contact
