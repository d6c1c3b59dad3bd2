#include "tools/study/kinds.h"

namespace gasgrain {

const std::vector<StudyKind>& all_study_kinds() {
  static const std::vector<StudyKind> kinds{
      {"stiffness", "Young's modulus, the DEM step with it (values: Pa)", plan_stiffness},
      {"dem-step", "DEM step over the contact time (values: shares of it)", plan_dem_step},
      {"fluid-step", "greatest step of the gas (values: s)", plan_fluid_step},
      {"coupling-interval", "coupling interval, in turn and overlapped (values: s)",
       plan_coupling_interval},
      {"void-fraction", "void-fraction method and cell size (values: methods)", plan_void_fraction},
      {"grid", "fluid cells and particle grid (values: factors on the scene's cells)", plan_grid},
      {"ranks", "MPI ranks (values: DEM+GAS, for example 2+1)", plan_ranks},
      {"contact-model", "contact model (values: the words after `model`, quoted)",
       plan_contact_model},
      {"effects", "each effect of the scene switched off in turn (values: effects)", plan_effects}};
  return kinds;
}

}  // namespace gasgrain
