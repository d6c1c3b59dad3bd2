// `rolling_friction viscous`: a torque in proportion to how fast grains roll on each other
// (dem_physics/rolling/rolling_viscous.h has the law, its units, signs, range and stability).
//
// Property: rollingTimeConstant [s], peratomtypepair. F_n is the host's normal force of the
// contact, its damping included.
#ifdef ROLLING_MODEL
ROLLING_MODEL(ROLLING_VISCOUS, viscous, 20)
#else
#ifndef GASGRAIN_ROLLING_MODEL_VISCOUS_H
#define GASGRAIN_ROLLING_MODEL_VISCOUS_H

#include "fix_cfd_coupling/dem_physics/rolling/rolling_viscous.h"
#include "fix_cfd_coupling/liggghts/contact_styles_rolling_base.h"

namespace LIGGGHTS {
namespace ContactModels {

template <>
class RollingModel<ROLLING_VISCOUS>
    : public gasgrain::OwnRollingModel<gasgrain::rolling::RollingViscous> {
 public:
  using OwnRollingModel::OwnRollingModel;

  void connectToProperties(PropertyRegistry&) override {
    const gasgrain::ContactProperties properties(*lmp, "rolling_friction viscous");
    properties.refuse_unfit_run();
    const auto time_constant = properties.need_pairs("rollingTimeConstant", "s");
    laws_ = checked_laws(properties, "rollingTimeConstant", [&](int i, int j) {
      return gasgrain::rolling::RollingViscous{time_constant(i, j)};
    });
  }
};

}  // namespace ContactModels
}  // namespace LIGGGHTS
#endif
#endif
