// What our models of rolling friction have in common: a law without a state, whose torque acts on a
// contact's both bodies, or on the grain at a wall. A wall does not turn, as in the host's models.
#pragma once

#include "fix_cfd_coupling/dem_physics/contact_time.h"
#include "fix_cfd_coupling/dem_physics/rolling/relative_rolling.h"
#include "fix_cfd_coupling/liggghts/contact_styles_ids.h"
#include "fix_cfd_coupling/liggghts/contact_styles_properties.h"

namespace gasgrain {

template <class Law>
class OwnRollingModel : public LIGGGHTS::ContactModels::RollingModelBase {
 protected:
  using Close = LIGGGHTS::ContactModels::SurfacesCloseData;
  using Intersect = LIGGGHTS::ContactModels::SurfacesIntersectData;
  using Force = LIGGGHTS::ContactModels::ForceData;

 public:
  using RollingModelBase::RollingModelBase;

  void registerSettings(Settings&) override {}
  void postSettings(LIGGGHTS::IContactHistorySetup*,
                    LIGGGHTS::ContactModels::ContactModelBase*) override {}
  void beginPass(Intersect&, Force&, Force&) override {}
  void endPass(Intersect&, Force&, Force&) override {}
  void surfacesClose(Close&, Force&, Force&) override {}

  void surfacesIntersect(Intersect& data, Force& i, Force& j) override {
    const auto spin = [](const double* w) { return Vec3(w[0], w[1], w[2]); };
    const Vec3 spin_j = data.is_wall ? Vec3(0.0, 0.0, 0.0) : spin(data.omega_j);
    const Vec3 rolling = rolling::relative_rolling(spin(data.omega_i), spin_j, spin(data.en));
    const double radius = data.is_wall ? data.radi : contact::effective(data.radi, data.radj);
    const Vec3 torque = laws_(data.itype, data.jtype).torque(rolling, data.Fn, radius);
    for (int d = 0; d < 3; ++d) {
      i.delta_torque[d] += torque[d] * (data.is_wall ? data.area_ratio : 1.0);
      if (!data.is_wall) j.delta_torque[d] -= torque[d];
    }
  }

 protected:
  PairTable<Law> laws_;
};

}  // namespace gasgrain
