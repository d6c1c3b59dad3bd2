// The LIST of convection schemes: what [solver] convection of gas.toml may name. A scheme is the
// addition to the first-order upwind value of a face, from the two values upwind of it and the one
// downwind.
#pragma once

#include <array>
#include <string_view>
#include <variant>

#include "coupling/base/listed.h"
#include "gas_solver/operators/convection/blend.h"
#include "gas_solver/operators/convection/central.h"
#include "gas_solver/operators/convection/quick.h"
#include "gas_solver/operators/convection/tvd.h"
#include "gas_solver/operators/convection/upwind.h"

namespace gasgrain {

// In the order of the variant and of the names.
enum class Convection { upwind, central, blend, quick, tvd };
inline constexpr std::array<std::string_view, 5> convection_names{"upwind", "central", "blend",
                                                                  "quick", "tvd"};
// A build may list fewer (coupling/base/listed.h).
#ifndef GASGRAIN_CONVECTION_SCHEMES
#define GASGRAIN_CONVECTION_SCHEMES \
  ConvectionUpwind, ConvectionCentral, ConvectionBlend, ConvectionQuick, ConvectionTvd
#endif
using ConvectionScheme = std::variant<GASGRAIN_CONVECTION_SCHEMES>;

// `upwind_share`: of "blend".
inline ConvectionScheme convection_scheme(Convection name, double upwind_share) {
  switch (name) {
    case Convection::upwind:
      return listed<ConvectionScheme>([] { return ConvectionUpwind{}; });
    case Convection::central:
      return listed<ConvectionScheme>([] { return ConvectionCentral{}; });
    case Convection::blend:
      return listed<ConvectionScheme>([&] { return ConvectionBlend{upwind_share}; });
    case Convection::quick:
      return listed<ConvectionScheme>([] { return ConvectionQuick{}; });
    case Convection::tvd:
      break;
  }
  return listed<ConvectionScheme>([] { return ConvectionTvd{}; });
}

}  // namespace gasgrain
