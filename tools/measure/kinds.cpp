#include "tools/measure/kinds.h"

namespace gasgrain {

const std::vector<MeasureKind>& all_measure_kinds() {
  static const std::vector<MeasureKind> kinds{
      {"angle_of_repose", "slope of a heap's flank", read_heap},
      {"normal_restitution", "speed after over speed before impacts on a plate", read_bounce}};
  return kinds;
}

}  // namespace gasgrain
