// The LIST of estimates: one for every effect that the program knows, and for those that it knows
// of. An effect is a header beside the others and a line here; of a force of forces/forces.h the
// header alone (size_of.h), without which nothing that includes this compiles.
#pragma once

#include <type_traits>
#include <utility>
#include <variant>

#include "coupling/base/choice_list.h"
#include "coupling/exchange/effect_sizes/basset.h"
#include "coupling/exchange/effect_sizes/convection.h"
#include "coupling/exchange/effect_sizes/depth_correction.h"
#include "coupling/exchange/effect_sizes/drag.h"
#include "coupling/exchange/effect_sizes/electrostatics.h"
#include "coupling/exchange/effect_sizes/ideal_gas.h"
#include "coupling/exchange/effect_sizes/k_epsilon.h"
#include "coupling/exchange/effect_sizes/liquid_bridge.h"
#include "coupling/exchange/effect_sizes/lorentz.h"
#include "coupling/exchange/effect_sizes/lubrication.h"
#include "coupling/exchange/effect_sizes/magnus.h"
#include "coupling/exchange/effect_sizes/model_b.h"
#include "coupling/exchange/effect_sizes/momentum_sharing.h"
#include "coupling/exchange/effect_sizes/overlapped.h"
#include "coupling/exchange/effect_sizes/polydisperse.h"
#include "coupling/exchange/effect_sizes/pressure_gradient.h"
#include "coupling/exchange/effect_sizes/rotation.h"
#include "coupling/exchange/effect_sizes/rotation_torque.h"
#include "coupling/exchange/effect_sizes/saffman_mei.h"
#include "coupling/exchange/effect_sizes/self_disturbance.h"
#include "coupling/exchange/effect_sizes/smagorinsky.h"
#include "coupling/exchange/effect_sizes/tangential_history.h"
#include "coupling/exchange/effect_sizes/van_der_waals.h"
#include "coupling/exchange/effect_sizes/virtual_mass.h"
#include "coupling/exchange/effect_sizes/viscous_stress.h"
#include "coupling/exchange/forces/forces.h"

namespace gasgrain {

// Of drag and what changes it, of the grains' contacts, of the gas solver.
using SizesBesideForces =
    std::variant<SizePolydisperse, SizeSelfDisturbance, SizeMomentumSharing, SizeOverlapped,
                 SizeRotation, SizeTangentialHistory, SizeSmagorinsky, SizeKEpsilon, SizeIdealGas,
                 SizeModelB, SizeConvection, SizeDepthCorrection>;

// Of what this version does not have.
using SizesOfAbsent =
    std::variant<SizeLubrication, SizeLiquidBridge, SizeVanDerWaals, SizeElectrostatics>;

namespace detail {

template <class List>
struct SizesOf;
template <class... Forces>
struct SizesOf<std::variant<Forces...>> {
  using type = std::variant<SizeOf<Forces>...>;
};

}  // namespace detail

using SizesOfForces = detail::SizesOf<Force>::type;

// Calls f with an object of every estimate: drag, the forces, the others, those of what is absent.
template <class F>
void for_each_size(F&& f) {
  f(SizeDrag{});
  for_each_choice<SizesOfForces>(f);
  for_each_choice<SizesBesideForces>(f);
  for_each_choice<SizesOfAbsent>(f);
}

// The same of those that gas and grains at a coupling tell of: neither of contacts nor of what is
// absent.
template <class F>
void for_each_audited_size(F&& f) {
  f(SizeDrag{});
  for_each_choice<SizesOfForces>(f);
  for_each_choice<SizesBesideForces>([&](auto size) {
    using Size = decltype(size);
    if constexpr (!std::is_same_v<Size, SizeRotation> &&
                  !std::is_same_v<Size, SizeTangentialHistory>)
      f(size);
  });
}

}  // namespace gasgrain
