// Numbers of a TOML file, for the readers of it.
#pragma once

#define TOML_HEADER_ONLY 1
#include <toml++/toml.h>

#include <cmath>
#include <optional>
#include <string>

#include "coupling/base/toml_input.h"

namespace gasgrain {

// ' in kg/m3'
inline std::string in_unit(const std::string& unit) {
  return unit.empty() || unit == "1" ? "" : " in " + unit;
}

// A finite number within the range.
inline std::optional<double> number_of(const toml::node& node, const Range& range) {
  const auto value = node.is_number() ? node.value<double>() : std::nullopt;
  return value && std::isfinite(*value) && range.holds(*value) ? value : std::nullopt;
}

}  // namespace gasgrain
