// A number or vector that a force takes from the scene: a word, then its values. A force with
// parameters has a static list `parameters` of them, and values(n), where those of parameter n go;
// parameters that a scene leaves out keep the member's default.
#pragma once

#include <string_view>

namespace gasgrain {

struct ForceParameter {
  std::string_view name;
  int values;  // how many follow the name
  std::string_view unit;
};

}  // namespace gasgrain
