#include <fmt/ranges.h>

#include <algorithm>

#include "coupling/base/error.h"
#include "coupling/base/toml_input.h"
#include "coupling/base/toml_number.h"

namespace gasgrain {
namespace {

std::string in_brackets(const std::vector<double>& values) {
  return fmt::format("[{}]", fmt::join(values, ", "));
}

}  // namespace

std::vector<double> InputTable::list(const std::string& key,
                                     const std::optional<std::vector<double>>& other, Range range,
                                     const std::string& unit, std::size_t count,
                                     const std::string& kind) {
  const std::vector<double> otherwise = other.value_or(std::vector<double>{});
  const std::string bounds =
      std::isfinite(range.min) || std::isfinite(range.max) ? " " + range.text() : "";
  const toml::node* node = find(key, unit, kind + bounds, other ? in_brackets(*other) : "");
  if (node == nullptr) return otherwise;
  const toml::array* elements = node->as_array();
  if (elements == nullptr) {
    fault(key, fmt::format("{} must be a list of numbers{}.", dotted(key), in_unit(unit)));
    return otherwise;
  }
  std::vector<double> values;
  for (const auto& element : *elements) {
    const auto value = number_of(element, range);
    if (!value) {
      const auto given = element.is_number() ? element.value<double>() : std::nullopt;
      fault(key, fmt::format("every value of {} must be a{} number{}{}{}.", dotted(key),
                             given && !std::isfinite(*given) ? " finite" : "", bounds,
                             in_unit(unit), given ? fmt::format(", {} is not", *given) : ""));
      return otherwise;
    }
    values.push_back(*value);
  }
  if (count == 0 || values.size() == count) return values;
  fault(key, fmt::format("{} must have {} values, it has {}.", dotted(key),
                         count == 3 ? "three" : "two", values.size()));
  return otherwise;
}

std::vector<double> InputTable::numbers(const std::string& key,
                                        std::optional<std::vector<double>> fallback, Range range,
                                        const std::string& unit) {
  return list(key, fallback, range, unit, 0, "list of numbers");
}

std::vector<double> InputTable::two_numbers(const std::string& key, Range range,
                                            const std::string& unit) {
  return list(key, std::nullopt, range, unit, 2, "two numbers");
}

Vec3 InputTable::vec3(const std::string& key, std::optional<Vec3> fallback, Range range,
                      const std::string& unit) {
  std::optional<std::vector<double>> other;
  if (fallback) other = std::vector<double>{fallback->x(), fallback->y(), fallback->z()};
  const std::vector<double> values = list(key, other, range, unit, 3, "three numbers");
  return values.empty() ? Vec3(Vec3::Zero()) : Vec3(values[0], values[1], values[2]);
}

Int3 InputTable::int3(const std::string& key, std::optional<Int3> fallback, Range range) {
  std::optional<std::vector<double>> other;
  if (fallback) other = std::vector<double>(fallback->begin(), fallback->end());
  const std::vector<double> values = list(key, other, range, "1", 3, "three whole numbers");
  Int3 whole{0, 0, 0};
  if (values.empty()) return whole;
  for (int d = 0; d < 3; ++d) whole[d] = static_cast<int>(values[d]);
  if (std::vector<double>(whole.begin(), whole.end()) == values) return whole;
  fault(key, fmt::format("{} must be three whole numbers.", dotted(key)));
  return fallback.value_or(Int3{0, 0, 0});
}

std::vector<std::array<double, 2>> InputTable::pairs(const std::string& key, Range range,
                                                     const std::string& first,
                                                     const std::string& second) {
  const std::string what = fmt::format("list of [{}, {}], each {}", first, second, range.text());
  const toml::node* node = find(key, "", what, "none");
  std::vector<std::array<double, 2>> pairs;
  if (node == nullptr) return pairs;
  const toml::array* lines = node->as_array();
  bool right = lines != nullptr && !lines->empty();
  for (std::size_t n = 0; right && n < lines->size(); ++n) {
    const toml::array* line = lines->get(n)->as_array();
    right = line != nullptr && line->size() == 2;
    if (!right) break;
    const auto a = number_of(*line->get(0), range);
    const auto b = number_of(*line->get(1), range);
    right = a && b;
    if (right) pairs.push_back({*a, *b});
  }
  if (right) return pairs;
  fault(key, fmt::format("{} must be a {}.", dotted(key), what));
  return {};
}

}  // namespace gasgrain
