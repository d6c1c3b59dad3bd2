// The laws of the LISTs as the host's templates know its models: by their ids.
#pragma once

#include "fix_cfd_coupling/dem_physics/contact/cohesion_laws.h"
#include "fix_cfd_coupling/dem_physics/contact/rolling_laws.h"
#include "fix_cfd_coupling/liggghts/contact_styles_adaptors.h"

namespace LIGGGHTS {
namespace ContactModels {

// The host has the cohesion models 1, 2, 7 and 8, and the rolling models 1 to 4 and 6.
#define COHESION_LAW(Law, name, id)                                                            \
  static_assert(id < 64 && id > 8, #name ": id taken");                                        \
  template <>                                                                                  \
  class CohesionModel<id> : public gasgrain::CohesionAdaptor<gasgrain::contact::Law> {         \
   public:                                                                                     \
    CohesionModel(LAMMPS_NS::LAMMPS* host, IContactHistorySetup* place, ContactModelBase* all) \
        : CohesionAdaptor(host, place, all, #name) {}                                          \
  };
#include "fix_cfd_coupling/dem_physics/contact/cohesion_laws.h"
#undef COHESION_LAW

#define ROLLING_LAW(Law, name, id)                                                            \
  static_assert(id < 64 && id > 6, #name ": id taken");                                       \
  template <>                                                                                 \
  class RollingModel<id> : public gasgrain::RollingAdaptor<gasgrain::contact::Law> {          \
   public:                                                                                    \
    RollingModel(LAMMPS_NS::LAMMPS* host, IContactHistorySetup* place, ContactModelBase* all) \
        : RollingAdaptor(host, place, all, #name) {}                                          \
  };
#include "fix_cfd_coupling/dem_physics/contact/rolling_laws.h"
#undef ROLLING_LAW

}  // namespace ContactModels
}  // namespace LIGGGHTS
