// The LIST of the stacks whose loops are compiled for several contacts at once (contact_batch.h):
// those of compiled_stacks.h without cohesion whose rolling friction needs no view.
#pragma once

#include "fix_cfd_coupling/dem_physics/contact/normal_hertz.h"
#include "fix_cfd_coupling/dem_physics/contact/normal_hertz_stiffness.h"
#include "fix_cfd_coupling/dem_physics/contact/normal_hooke.h"
#include "fix_cfd_coupling/dem_physics/contact/normal_hooke_stiffness.h"
#include "fix_cfd_coupling/dem_physics/contact/rolling_cdt.h"
#include "fix_cfd_coupling/dem_physics/contact/rolling_epsd.h"
#include "fix_cfd_coupling/dem_physics/contact/rolling_epsd2.h"
#include "fix_cfd_coupling/dem_physics/contact/tangential_damped_history.h"
#include "fix_cfd_coupling/dem_physics/contact/tangential_history.h"
#include "fix_cfd_coupling/dem_physics/contact/tangential_no_history.h"

#define GASGRAIN_ROLLING_IN_LANES(STACK, Normal, Tangential) \
  STACK(Normal, Tangential, RollingOff)                      \
  STACK(Normal, Tangential, RollingCdt)                      \
  STACK(Normal, Tangential, RollingEpsd)                     \
  STACK(Normal, Tangential, RollingEpsd2)
#define GASGRAIN_NORMAL_IN_LANES(STACK, Normal)               \
  GASGRAIN_ROLLING_IN_LANES(STACK, Normal, TangentialHistory) \
  GASGRAIN_ROLLING_IN_LANES(STACK, Normal, TangentialNoHistory)
#define GASGRAIN_STACKS_IN_LANES(STACK)                            \
  GASGRAIN_NORMAL_IN_LANES(STACK, NormalHertz)                     \
  GASGRAIN_NORMAL_IN_LANES(STACK, NormalHooke)                     \
  GASGRAIN_NORMAL_IN_LANES(STACK, NormalHertzStiffness)            \
  GASGRAIN_NORMAL_IN_LANES(STACK, NormalHookeStiffness)            \
  STACK(NormalHertzStiffness, TangentialDampedHistory, RollingOff) \
  STACK(NormalHookeStiffness, TangentialDampedHistory, RollingOff)
