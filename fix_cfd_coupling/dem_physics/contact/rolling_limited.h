// `rolling_friction limited`: the viscous torque up to Coulomb's limit
// (dem_physics/rolling/rolling_limited.h has the law, its units, signs, range and stability).
//
// Properties, peratomtypepair: coefficientRollingFriction [-], as of the host's models, and
// rollingTimeConstant [s]. F_n is the normal force of the contact, its damping included.
#ifdef ROLLING_LAW
ROLLING_LAW(RollingLimited, limited, 21)
#else
#ifndef GASGRAIN_CONTACT_ROLLING_LIMITED_H
#define GASGRAIN_CONTACT_ROLLING_LIMITED_H

#include "fix_cfd_coupling/dem_physics/contact/rolling_law.h"
#include "fix_cfd_coupling/dem_physics/rolling/rolling_limited.h"

namespace gasgrain::contact {

class RollingLimited : public RollingByTypes<rolling::RollingLimited> {
 public:
  void connect(ContactHost& host) {
    host.refuse_unfit_run();
    const auto friction = host.need_pairs("coefficientRollingFriction", "no unit, 0 to 0.5");
    const auto time_constant = host.need_pairs("rollingTimeConstant", "s");
    laws_ =
        checked_laws(host, "coefficientRollingFriction, rollingTimeConstant", [&](int i, int j) {
          return rolling::RollingLimited{friction(i, j), time_constant(i, j)};
        });
  }
};

}  // namespace gasgrain::contact
#endif
#endif
