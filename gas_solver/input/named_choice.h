// A choice among the values of an enum by their names in the file.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "coupling/base/toml_input.h"

namespace gasgrain {

template <class Enum>
using Names = std::vector<std::pair<std::string, Enum>>;

// `fallback` is one of the names' values.
template <class Enum>
Enum named_choice(InputTable& table, const std::string& key, Enum fallback,
                  const Names<Enum>& names) {
  std::vector<std::string> allowed;
  std::string otherwise;
  for (const auto& [name, value] : names) {
    allowed.push_back(name);
    if (value == fallback) otherwise = name;
  }
  const std::string chosen = table.choice(key, otherwise, allowed);
  for (const auto& [name, value] : names)
    if (name == chosen) return value;
  return fallback;
}

}  // namespace gasgrain
