// `rolling_friction viscous`: a torque in proportion to how fast grains roll on each other
// (dem_physics/rolling/rolling_viscous.h has the law, its units, signs, range and stability).
//
// Property: rollingTimeConstant [s], peratomtypepair. F_n is the normal force of the contact, its
// damping included.
#ifdef ROLLING_LAW
ROLLING_LAW(RollingViscous, viscous, 20)
#else
#ifndef GASGRAIN_CONTACT_ROLLING_VISCOUS_H
#define GASGRAIN_CONTACT_ROLLING_VISCOUS_H

#include "fix_cfd_coupling/dem_physics/contact/rolling_law.h"
#include "fix_cfd_coupling/dem_physics/rolling/rolling_viscous.h"

namespace gasgrain::contact {

class RollingViscous : public RollingByTypes<rolling::RollingViscous> {
 public:
  void connect(ContactHost& host) {
    host.refuse_unfit_run();
    const auto time_constant = host.need_pairs("rollingTimeConstant", "s");
    laws_ = checked_laws(host, "rollingTimeConstant", [&](int i, int j) {
      return rolling::RollingViscous{time_constant(i, j)};
    });
  }
};

}  // namespace gasgrain::contact
#endif
#endif
