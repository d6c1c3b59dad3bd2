#include "fix_cfd_coupling/dem_physics/contact/compiled_stacks.h"

namespace gasgrain::contact {

void add_stacks_off(ContactStacks& stacks) {
  add_stacks_with<CohesionOff>(stacks, "off");
  add_rolling<NormalHertzStiffness, TangentialHistory, CohesionOff>(stacks, "off");
  add_rolling<NormalHertzStiffness, TangentialNoHistory, CohesionOff>(stacks, "off");
  add_rolling<NormalHookeStiffness, TangentialHistory, CohesionOff>(stacks, "off");
  add_rolling<NormalHookeStiffness, TangentialNoHistory, CohesionOff>(stacks, "off");
}

}  // namespace gasgrain::contact
