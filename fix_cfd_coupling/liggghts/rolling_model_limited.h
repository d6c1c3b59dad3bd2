// `rolling_friction limited`: the viscous torque up to Coulomb's limit
// (dem_physics/rolling/rolling_limited.h has the law, its units, signs, range and stability).
//
// Properties, peratomtypepair: coefficientRollingFriction [-], as of the host's models, and
// rollingTimeConstant [s]. F_n is the host's normal force of the contact, its damping included.
#ifdef ROLLING_MODEL
ROLLING_MODEL(ROLLING_LIMITED, limited, 21)
#else
#ifndef GASGRAIN_ROLLING_MODEL_LIMITED_H
#define GASGRAIN_ROLLING_MODEL_LIMITED_H

#include "fix_cfd_coupling/dem_physics/rolling/rolling_limited.h"
#include "fix_cfd_coupling/liggghts/contact_styles_rolling_base.h"

namespace LIGGGHTS {
namespace ContactModels {

template <>
class RollingModel<ROLLING_LIMITED>
    : public gasgrain::OwnRollingModel<gasgrain::rolling::RollingLimited> {
 public:
  using OwnRollingModel::OwnRollingModel;

  void connectToProperties(PropertyRegistry&) override {
    const gasgrain::ContactProperties properties(*lmp, "rolling_friction limited");
    properties.refuse_unfit_run();
    const auto friction = properties.need_pairs("coefficientRollingFriction", "no unit, 0 to 0.5");
    const auto time_constant = properties.need_pairs("rollingTimeConstant", "s");
    laws_ = checked_laws(
        properties, "coefficientRollingFriction, rollingTimeConstant", [&](int i, int j) {
          return gasgrain::rolling::RollingLimited{friction(i, j), time_constant(i, j)};
        });
  }
};

}  // namespace ContactModels
}  // namespace LIGGGHTS
#endif
#endif
