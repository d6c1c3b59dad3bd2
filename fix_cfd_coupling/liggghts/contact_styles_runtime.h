// A contact model put together at run time from the sub-models that a hash names: for the
// combinations with a model of ours that are not compiled. What it computes is what the compiled
// one computes, call by call, through virtual functions.
//
// The host has such a class of its own, which knows its own models only.
#pragma once

#include <fmt/format.h>

#include <memory>
#include <string>

#include "fix_cfd_coupling/fixes/host_error.h"
#include "fix_cfd_coupling/liggghts/contact_styles_ids.h"
#include "fix_cfd_coupling/liggghts/contact_styles_outer.h"

namespace gasgrain {

namespace contact_models = LIGGGHTS::ContactModels;

// The five ids of a hash, as the host packs them.
struct ContactIds {
  explicit ContactIds(int64_t hash)
      : normal(hash & 63),
        tangential(hash >> 6 & 63),
        cohesion(hash >> 12 & 63),
        rolling(hash >> 18 & 63),
        surface(hash >> 24 & 63) {}

  // Whether the cohesion or the rolling model is one of ours.
  [[nodiscard]] bool hold_ours() const {
    bool ours = outer_cohesion_laws().count(cohesion) + outer_rolling_laws().count(rolling) > 0;
#define COHESION_LAW(Law, name, id) ours = ours || cohesion == id;
#include "fix_cfd_coupling/dem_physics/contact/cohesion_laws.h"
#undef COHESION_LAW
#define ROLLING_LAW(Law, name, id) ours = ours || rolling == id;
#include "fix_cfd_coupling/dem_physics/contact/rolling_laws.h"
#undef ROLLING_LAW
    return ours;
  }

  int normal, tangential, cohesion, rolling, surface;
};

class RuntimeContactModel : public contact_models::ContactModelBase {
  using Intersect = contact_models::SurfacesIntersectData;
  using Close = contact_models::SurfacesCloseData;
  using Force = contact_models::ForceData;

 public:
  RuntimeContactModel(LAMMPS_NS::LAMMPS* host, LIGGGHTS::IContactHistorySetup* history,
                      bool is_wall, int64_t hash)
      : ContactModelBase(host, is_wall), hash_(hash), ids_(hash) {
    // The history values are claimed in this order, as in a compiled model.
    surface_ = surface_model(host, history);
    normal_ = normal_model(host, history);
    cohesion_ = cohesion_model(host, history);
    tangential_ = tangential_model(host, history);
    rolling_ = rolling_model(host, history);
  }

  int64_t hashcode() { return hash_; }
  double stressStrainExponent() { return normal_->stressStrainExponent(); }
  void tally_pp(double value, int i, int j, int index) override {
    surface_->tally_pp(value, i, j, index);
  }
  void tally_pw(double value, int i, int j, int index) override {
    surface_->tally_pw(value, i, j, index);
  }

  void registerSettings(Settings& settings) {
    surface_->registerSettings(settings);
    normal_->registerSettings(settings);
    cohesion_->registerSettings(settings);
    tangential_->registerSettings(settings);
    rolling_->registerSettings(settings);
  }
  void postSettings(LIGGGHTS::IContactHistorySetup* history) {
    surface_->postSettings(history, this);
    normal_->postSettings(history, this);
    cohesion_->postSettings(history, this);
    tangential_->postSettings(history, this);
    rolling_->postSettings(history, this);
  }
  void connectToProperties(PropertyRegistry& registry) {
    surface_->connectToProperties(registry);
    normal_->connectToProperties(registry);
    cohesion_->connectToProperties(registry);
    tangential_->connectToProperties(registry);
    rolling_->connectToProperties(registry);
  }

  void beginPass(Intersect& data, Force& i, Force& j) {
    surface_->beginPass(data, i, j);
    normal_->beginPass(data, i, j);
    cohesion_->beginPass(data, i, j);
    tangential_->beginPass(data, i, j);
    rolling_->beginPass(data, i, j);
  }
  void endPass(Intersect& data, Force& i, Force& j) {
    rolling_->endPass(data, i, j);
    tangential_->endPass(data, i, j);
    cohesion_->endPass(data, i, j);
    normal_->endPass(data, i, j);
    surface_->endPass(data, i, j);
  }

  bool checkSurfaceIntersect(Intersect& data) { return surface_->checkSurfaceIntersect(data); }
  void surfacesIntersect(Intersect& data, Force& i, Force& j) {
    surface_->surfacesIntersect(data, i, j);
    normal_->surfacesIntersect(data, i, j);
    cohesion_->surfacesIntersect(data, i, j);
    tangential_->surfacesIntersect(data, i, j);
    rolling_->surfacesIntersect(data, i, j);
  }
  void endSurfacesIntersect(Intersect& data, LAMMPS_NS::TriMesh* mesh, Force& i, Force& j) {
    surface_->endSurfacesIntersect(data, mesh, i.delta_F);
    cohesion_->endSurfacesIntersect(data, i, j);
  }
  void surfacesClose(Close& data, Force& i, Force& j) {
    surface_->surfacesClose(data, i, j);
    normal_->surfacesClose(data, i, j);
    cohesion_->surfacesClose(data, i, j);
    tangential_->surfacesClose(data, i, j);
    rolling_->surfacesClose(data, i, j);
  }

  bool contact_match(const std::string& kind, const std::string& model) {
    auto& names = contact_models::Factory::instance();
    if (kind == "surface") return ids_.surface == names.getSurfaceModelId(model);
    if (kind == "normal") return ids_.normal == names.getNormalModelId(model);
    if (kind == "cohesion") return ids_.cohesion == names.getCohesionModelId(model);
    if (kind == "tangential") return ids_.tangential == names.getTangentialModelId(model);
    if (kind == "rolling_friction") return ids_.rolling == names.getRollingModelId(model);
    return false;
  }

 private:
  // The host's bases have no virtual destructor: a shared pointer remembers what it was given.
  template <class Base>
  using Model = std::shared_ptr<Base>;
  using Host = LAMMPS_NS::LAMMPS;
  using History = LIGGGHTS::IContactHistorySetup;

  [[noreturn]] static void refuse(const char* kind, int id) {
    stop_everything(fmt::format(
        "no {} model has the id {}: the restart file or the library is of another version.", kind,
        id));
  }

  Model<contact_models::SurfaceModelBase> surface_model(Host* host, History* history) {
#define SURFACE_MODEL(constant, name, id) \
  if (ids_.surface == id)                 \
    return std::make_shared<contact_models::SurfaceModel<id>>(host, history, this);
#include "style_surface_model.h"
#undef SURFACE_MODEL
    refuse("surface", ids_.surface);
  }
  Model<contact_models::NormalModelBase> normal_model(Host* host, History* history) {
#define NORMAL_MODEL(constant, name, id) \
  if (ids_.normal == id)                 \
    return std::make_shared<contact_models::NormalModel<id>>(host, history, this);
#include "style_normal_model.h"
#undef NORMAL_MODEL
    if (ids_.normal == contact_models::NORMAL_OFF)
      return std::make_shared<contact_models::NormalModel<contact_models::NORMAL_OFF>>(
          host, history, this);
    refuse("normal", ids_.normal);
  }
  Model<contact_models::CohesionModelBase> cohesion_model(Host* host, History* history) {
    const auto outer = outer_cohesion_laws().find(ids_.cohesion);
    if (outer != outer_cohesion_laws().end())
      return outer->second.make(host, history, this, outer->second.name.c_str());
#define COHESION_LAW(Law, name, id) \
  if (ids_.cohesion == id)          \
    return std::make_shared<contact_models::CohesionModel<id>>(host, history, this);
#include "fix_cfd_coupling/dem_physics/contact/cohesion_laws.h"
#undef COHESION_LAW
#define COHESION_MODEL(constant, name, id) \
  if (ids_.cohesion == id)                 \
    return std::make_shared<contact_models::CohesionModel<id>>(host, history, this);
#include "style_cohesion_model.h"
#undef COHESION_MODEL
    if (ids_.cohesion == contact_models::COHESION_OFF)
      return std::make_shared<contact_models::CohesionModel<contact_models::COHESION_OFF>>(
          host, history, this);
    refuse("cohesion", ids_.cohesion);
  }
  Model<contact_models::TangentialModelBase> tangential_model(Host* host, History* history) {
#define TANGENTIAL_MODEL(constant, name, id) \
  if (ids_.tangential == id)                 \
    return std::make_shared<contact_models::TangentialModel<id>>(host, history, this);
#include "style_tangential_model.h"
#undef TANGENTIAL_MODEL
    if (ids_.tangential == contact_models::TANGENTIAL_OFF)
      return std::make_shared<contact_models::TangentialModel<contact_models::TANGENTIAL_OFF>>(
          host, history, this);
    refuse("tangential", ids_.tangential);
  }
  Model<contact_models::RollingModelBase> rolling_model(Host* host, History* history) {
    const auto outer = outer_rolling_laws().find(ids_.rolling);
    if (outer != outer_rolling_laws().end())
      return outer->second.make(host, history, this, outer->second.name.c_str());
#define ROLLING_LAW(Law, name, id) \
  if (ids_.rolling == id)          \
    return std::make_shared<contact_models::RollingModel<id>>(host, history, this);
#include "fix_cfd_coupling/dem_physics/contact/rolling_laws.h"
#undef ROLLING_LAW
#define ROLLING_MODEL(constant, name, id) \
  if (ids_.rolling == id)                 \
    return std::make_shared<contact_models::RollingModel<id>>(host, history, this);
#include "style_rolling_model.h"
#undef ROLLING_MODEL
    if (ids_.rolling == contact_models::ROLLING_OFF)
      return std::make_shared<contact_models::RollingModel<contact_models::ROLLING_OFF>>(
          host, history, this);
    refuse("rolling", ids_.rolling);
  }

  int64_t hash_;
  ContactIds ids_;
  Model<contact_models::SurfaceModelBase> surface_;
  Model<contact_models::NormalModelBase> normal_;
  Model<contact_models::CohesionModelBase> cohesion_;
  Model<contact_models::TangentialModelBase> tangential_;
  Model<contact_models::RollingModelBase> rolling_;
};

}  // namespace gasgrain
