// A number or vector that a force takes from the scene: a word, then its values. A force with
// parameters has a static list `parameters` of them, and values(n), where those of parameter n go;
// parameters that a scene leaves out keep the member's default.
#pragma once

#include <limits>
#include <string_view>
#include <type_traits>

namespace gasgrain {

struct ForceParameter {
  std::string_view name;
  int values;  // how many follow the name
  std::string_view unit;
  double least = -std::numeric_limits<double>::infinity();
  double most = std::numeric_limits<double>::infinity();
};

template <class Force, class = void>
struct HasParameters : std::false_type {};
template <class Force>
struct HasParameters<Force, std::void_t<decltype(Force::parameters)>> : std::true_type {};

}  // namespace gasgrain
