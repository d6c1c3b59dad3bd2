#include "tools/measure/kinds.h"

namespace gasgrain {

const std::vector<MeasureKind>& all_measure_kinds() {
  static const std::vector<MeasureKind> kinds{
      {"angle_of_repose", "slope of a heap's flank", read_heap},
      {"drained_angle", "slope of what a drained box keeps", read_drained},
      {"dynamic_angle", "inclination of the surface in a turning drum", read_drum},
      {"normal_restitution", "speed after over speed before impacts on a plate", read_bounce},
      {"oblique_impact", "restitution, rebound angle and spin over the angle", read_impact},
      {"constrained_modulus", "stress over strain of compressed grains", read_uniaxial},
      {"internal_friction", "shear over normal stress of sheared grains", read_shear},
      {"force_distance", "force over gap of two bodies pulled apart", read_pull},
      {"fragments", "what an impact leaves of an agglomerate", read_fragments}};
  return kinds;
}

}  // namespace gasgrain
