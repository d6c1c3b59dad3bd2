// The LIST of forces of the gas on a particle, drag aside (drag/models.h). A new one is a header
// beside the others and a line here; the property tests then cover it.
//
// A force is a struct with
//   name        the word that switches it on in a scene
//   kind        what it depends on, and so when it is evaluated (ForceKind)
//   reacts      true: the gas loses the impulse that the particle takes
//   lent()      the gas fields it needs
// and the function that its kind asks for.
#pragma once

#include <variant>

#include "coupling/base/choice_list.h"
#include "coupling/exchange/forces/basset.h"
#include "coupling/exchange/forces/lorentz.h"
#include "coupling/exchange/forces/magnus.h"
#include "coupling/exchange/forces/pressure_gradient.h"
#include "coupling/exchange/forces/rotation_torque.h"
#include "coupling/exchange/forces/saffman_mei.h"
#include "coupling/exchange/forces/virtual_mass.h"
#include "coupling/exchange/forces/viscous_stress.h"

namespace gasgrain {

// A build may list fewer (coupling/base/listed.h).
#ifndef GASGRAIN_FORCES
#define GASGRAIN_FORCES                                                                      \
  ForcePressureGradient, ForceViscousStress, ForceVirtualMass, ForceBasset, ForceSaffmanMei, \
      ForceMagnus, ForceRotationTorque, ForceLorentz
#endif
using Force = std::variant<GASGRAIN_FORCES>;

}  // namespace gasgrain
