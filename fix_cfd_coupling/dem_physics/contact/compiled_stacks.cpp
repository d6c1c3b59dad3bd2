#include "fix_cfd_coupling/dem_physics/contact/contact_stacks.h"

namespace gasgrain::contact {

void add_stacks_off(ContactStacks& stacks);
#define COHESION_LAW(Class, name, id) void add_stacks_##name(ContactStacks& stacks);
#include "fix_cfd_coupling/dem_physics/contact/cohesion_laws.h"
#undef COHESION_LAW

ContactStacks& ContactStacks::known() {
  static ContactStacks stacks = [] {
    ContactStacks compiled;
    add_stacks_off(compiled);
#define COHESION_LAW(Class, name, id) add_stacks_##name(compiled);
#include "fix_cfd_coupling/dem_physics/contact/cohesion_laws.h"
#undef COHESION_LAW
    return compiled;
  }();
  return stacks;
}

}  // namespace gasgrain::contact
