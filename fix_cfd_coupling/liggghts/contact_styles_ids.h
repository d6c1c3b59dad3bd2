// The constants by which our contact sub-models are known to the host's templates.
#pragma once

// The host's headers lean on each other's order.
#include "fix_insert_stream.h"
// --
#include "contact_models.h"

namespace LIGGGHTS {
namespace ContactModels {

#define COHESION_MODEL(constant, name, id) \
  inline constexpr int constant = id;      \
  static_assert(id < 64 && id != 1 && id != 2 && id != 7 && id != 8, #name ": id taken");
#include "fix_cfd_coupling/liggghts/contact_styles_cohesion.h"
#undef COHESION_MODEL

#define ROLLING_MODEL(constant, name, id) \
  inline constexpr int constant = id;     \
  static_assert(id < 64 && id > 6, #name ": id taken");
#include "fix_cfd_coupling/liggghts/contact_styles_rolling.h"
#undef ROLLING_MODEL

}  // namespace ContactModels
}  // namespace LIGGGHTS
