// Which stacks of contact laws are compiled.
//
// With each cohesion law: hertz, hooke x history, no_history x every rolling friction. Without
// cohesion hertz/stiffness and hooke/stiffness too. And, with each cohesion and without, LAMMPS's
// own laws gran/hertz/history and gran/hooke/history: hertz/stiffness and hooke/stiffness with
// damped_history.
#pragma once

#include "fix_cfd_coupling/dem_physics/contact/contact_stacks.h"
#include "fix_cfd_coupling/dem_physics/contact/normal_hertz.h"
#include "fix_cfd_coupling/dem_physics/contact/normal_hertz_stiffness.h"
#include "fix_cfd_coupling/dem_physics/contact/normal_hooke.h"
#include "fix_cfd_coupling/dem_physics/contact/normal_hooke_stiffness.h"
#include "fix_cfd_coupling/dem_physics/contact/rolling_cdt.h"
#include "fix_cfd_coupling/dem_physics/contact/rolling_epsd.h"
#include "fix_cfd_coupling/dem_physics/contact/rolling_epsd2.h"
#include "fix_cfd_coupling/dem_physics/contact/rolling_laws.h"
#include "fix_cfd_coupling/dem_physics/contact/tangential_damped_history.h"
#include "fix_cfd_coupling/dem_physics/contact/tangential_history.h"
#include "fix_cfd_coupling/dem_physics/contact/tangential_no_history.h"

namespace gasgrain::contact {

template <class Normal, class Tangential, class Rolling, class Cohesion>
void add_stack(ContactStacks& stacks, const char* rolling, const char* cohesion) {
  stacks.add(
      {Normal::name, Tangential::name, rolling, cohesion},
      [](bool of_wall) -> std::unique_ptr<ContactStack> {
        return std::make_unique<CompiledStack<Normal, Tangential, Rolling, Cohesion>>(of_wall);
      });
}

template <class Normal, class Tangential, class Cohesion>
void add_rolling(ContactStacks& stacks, const char* cohesion) {
  add_stack<Normal, Tangential, RollingOff, Cohesion>(stacks, "off", cohesion);
  add_stack<Normal, Tangential, RollingCdt, Cohesion>(stacks, RollingCdt::name, cohesion);
  add_stack<Normal, Tangential, RollingEpsd, Cohesion>(stacks, RollingEpsd::name, cohesion);
  add_stack<Normal, Tangential, RollingEpsd2, Cohesion>(stacks, RollingEpsd2::name, cohesion);
#define ROLLING_LAW(Class, name, id) \
  add_stack<Normal, Tangential, Class, Cohesion>(stacks, #name, cohesion);
#include "fix_cfd_coupling/dem_physics/contact/rolling_laws.h"
#undef ROLLING_LAW
}

// `cohesion` as scripts name it.
template <class Cohesion>
void add_stacks_with(ContactStacks& stacks, const char* cohesion) {
  add_rolling<NormalHertz, TangentialHistory, Cohesion>(stacks, cohesion);
  add_rolling<NormalHertz, TangentialNoHistory, Cohesion>(stacks, cohesion);
  add_rolling<NormalHooke, TangentialHistory, Cohesion>(stacks, cohesion);
  add_rolling<NormalHooke, TangentialNoHistory, Cohesion>(stacks, cohesion);
  add_stack<NormalHertzStiffness, TangentialDampedHistory, RollingOff, Cohesion>(stacks, "off",
                                                                                 cohesion);
  add_stack<NormalHookeStiffness, TangentialDampedHistory, RollingOff, Cohesion>(stacks, "off",
                                                                                 cohesion);
}

}  // namespace gasgrain::contact
