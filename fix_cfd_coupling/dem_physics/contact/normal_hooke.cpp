#include "fix_cfd_coupling/dem_physics/contact/normal_hooke.h"

namespace gasgrain::contact {

void NormalHooke::find_stiffness() {
  last_stiffness_ = hooke_stiffness(pairs_[last_types_].modulus, last_radius_, last_mass_, speed_);
}

}  // namespace gasgrain::contact
