#include "coupling/base/toml_input.h"

#include <fmt/ranges.h>
#define TOML_HEADER_ONLY 1
#include <toml++/toml.h>

#include <algorithm>
#include <cmath>

#include "coupling/base/error.h"

namespace gasgrain {
namespace {

int line_of(const toml::node& node) {
  return static_cast<int>(node.source().begin.line);
}

std::string dotted(const std::string& path, const std::string& key) {
  return path.empty() ? key : path + "." + key;
}

}  // namespace

struct TomlInput::Document {
  toml::table table;
};

std::string Range::text() const {
  const bool low = std::isfinite(min);
  const bool high = std::isfinite(max);
  if (low && high) return fmt::format("from {} to {}", min, max);
  if (low) return fmt::format("{} {}", open_min ? "greater than" : "at least", min);
  if (high) return fmt::format("at most {}", max);
  return "any finite number";
}

InputTable::InputTable(TomlInput* input, const toml::table* table, std::string path, int line)
    : input_(input), table_(table), path_(std::move(path)), line_(line) {}

bool InputTable::has(const std::string& key) const {
  return table_ != nullptr && table_->contains(key);
}

int InputTable::line(const std::string& key) const {
  if (table_ != nullptr && !key.empty())
    if (const toml::node* node = table_->get(key)) return line_of(*node);
  return line_;
}

void InputTable::fault(const std::string& key, const std::string& message) {
  input_->faults_.emplace_back(line(key), message);
}

const toml::node* InputTable::find(const std::string& key, bool required) {
  input_->known_.push_back(dotted(path_, key));
  const toml::node* node = table_ == nullptr ? nullptr : table_->get(key);
  if (node == nullptr && required)
    fault("", path_.empty() ? fmt::format("the key {} is missing.", key)
                            : fmt::format("[{}] lacks the key {}.", path_, key));
  return node;
}

double InputTable::number(const std::string& key, std::optional<double> fallback, Range range,
                          const std::string& unit) {
  const double otherwise = fallback.value_or(0.0);
  const toml::node* node = find(key, !fallback);
  if (node == nullptr) return otherwise;
  const std::string in_unit = unit.empty() || unit == "-" ? "" : fmt::format(" in {}", unit);
  const auto value = node->is_number() ? node->value<double>() : std::nullopt;
  if (!value) {
    fault(key, fmt::format("{} must be a number{}.", dotted(path_, key), in_unit));
    return otherwise;
  }
  if (!std::isfinite(*value) || !range.holds(*value)) {
    fault(key, fmt::format("{} = {} is out of range: it must be {}{}.", dotted(path_, key), *value,
                           range.text(), in_unit));
    return otherwise;
  }
  return *value;
}

std::string InputTable::text(const std::string& key, std::optional<std::string> fallback) {
  const toml::node* node = find(key, !fallback);
  if (node == nullptr) return fallback.value_or("");
  if (!node->is_string()) {
    fault(key, fmt::format("{} must be a text in quotes.", dotted(path_, key)));
    return fallback.value_or("");
  }
  return *node->value<std::string>();
}

std::string InputTable::choice(const std::string& key, std::optional<std::string> fallback,
                               const std::vector<std::string>& allowed) {
  const std::string otherwise = fallback.value_or(allowed.empty() ? "" : allowed.front());
  const bool present = has(key);
  const std::string word = text(key, fallback);
  if (!present || std::find(allowed.begin(), allowed.end(), word) != allowed.end())
    return present ? word : otherwise;
  if (table_->get(key)->is_string())
    fault(key, fmt::format("{} = \"{}\" is unknown.{} Allowed: {}.", dotted(path_, key), word,
                           nearest_name(word, allowed).empty() ? "" : suggestion(word, allowed),
                           fmt::join(allowed, ", ")));
  return otherwise;
}

std::vector<double> InputTable::numbers(const std::string& key,
                                        std::optional<std::vector<double>> fallback, Range range,
                                        const std::string& unit) {
  const toml::node* node = find(key, !fallback);
  if (node == nullptr) return fallback.value_or(std::vector<double>{});
  const toml::array* list = node->as_array();
  if (list == nullptr) {
    fault(key, fmt::format("{} must be a list of numbers in {}.", dotted(path_, key), unit));
    return fallback.value_or(std::vector<double>{});
  }
  std::vector<double> values;
  for (const auto& element : *list) {
    const auto value = element.is_number() ? element.value<double>() : std::nullopt;
    if (!value || !std::isfinite(*value) || !range.holds(*value)) {
      fault(key, fmt::format("every value of {} must be a number {} in {}.", dotted(path_, key),
                             range.text(), unit));
      return fallback.value_or(std::vector<double>{});
    }
    values.push_back(*value);
  }
  return values;
}

Vec3 InputTable::vec3(const std::string& key, std::optional<Vec3> fallback, Range range,
                      const std::string& unit) {
  std::optional<std::vector<double>> list;
  if (fallback) list = std::vector<double>{fallback->x(), fallback->y(), fallback->z()};
  const auto values = numbers(key, list, range, unit);
  if (values.size() == 3) return {values[0], values[1], values[2]};
  if (has(key) && table_->get(key)->is_array() && !values.empty())
    fault(key,
          fmt::format("{} must have three values, it has {}.", dotted(path_, key), values.size()));
  return fallback.value_or(Vec3::Zero());
}

Int3 InputTable::int3(const std::string& key, std::optional<Int3> fallback, Range range) {
  std::optional<Vec3> list;
  if (fallback) list = Vec3((*fallback)[0], (*fallback)[1], (*fallback)[2]);
  const Vec3 values = vec3(key, list, range, "cells");
  for (int d = 0; d < 3; ++d)
    if (values[d] != std::floor(values[d])) {
      fault(key, fmt::format("{} must be three whole numbers.", dotted(path_, key)));
      break;
    }
  return {static_cast<int>(values[0]), static_cast<int>(values[1]), static_cast<int>(values[2])};
}

InputTable InputTable::table(const std::string& key) {
  const toml::node* node = find(key, false);
  const toml::table* table = node == nullptr ? nullptr : node->as_table();
  if (node != nullptr && table == nullptr)
    fault(key, fmt::format("{} must be a table: [{}].", dotted(path_, key), dotted(path_, key)));
  return {input_, table, dotted(path_, key), node == nullptr ? line_ : line_of(*node)};
}

std::vector<InputTable> InputTable::tables(const std::string& key) {
  const toml::node* node = find(key, false);
  std::vector<InputTable> result;
  if (node == nullptr) return result;
  const toml::array* list = node->as_array();
  if (list == nullptr) {
    fault(key, fmt::format("{} must be a list of tables: [[{}]].", dotted(path_, key),
                           dotted(path_, key)));
    return result;
  }
  for (const auto& element : *list) {
    const toml::table* table = element.as_table();
    if (table == nullptr)
      fault(key, fmt::format("{} must be a list of tables: [[{}]].", dotted(path_, key),
                             dotted(path_, key)));
    else
      result.push_back({input_, table, dotted(path_, key), line_of(element)});
  }
  return result;
}

TomlInput::TomlInput(const std::string& file)
    : file_(file), document_(std::make_unique<Document>()) {
  try {
    document_->table = toml::parse_file(file);
  } catch (const toml::parse_error& e) {
    const auto line = e.source().begin.line;
    if (line == 0) fail("{}: cannot be read: {}.", file, e.description());
    fail("{}:{}: this is not TOML: {}.", file, line, e.description());
  }
}

TomlInput::~TomlInput() = default;

InputTable TomlInput::root() {
  return {this, &document_->table, "", 1};
}

void TomlInput::find_unknown(const toml::table& table, const std::string& path) {
  for (const auto& [key, node] : table) {
    const std::string word(key.str());
    const std::string name = dotted(path, word);
    if (std::find(known_.begin(), known_.end(), name) == known_.end()) {
      std::vector<std::string> siblings;
      for (const auto& known : known_) {
        const bool inside = path.empty() ? known.find('.') == std::string::npos
                                         : known.compare(0, path.size() + 1, path + ".") == 0 &&
                                               known.find('.', path.size() + 1) == known.npos;
        const std::string last = inside && !path.empty() ? known.substr(path.size() + 1) : known;
        if (inside && std::find(siblings.begin(), siblings.end(), last) == siblings.end())
          siblings.push_back(last);
      }
      faults_.emplace_back(
          line_of(node), fmt::format("the key {} is unknown.{}", name, suggestion(word, siblings)));
      continue;
    }
    if (const auto* inner = node.as_table()) find_unknown(*inner, name);
    if (const auto* list = node.as_array())
      for (const auto& element : *list)
        if (const auto* inner = element.as_table()) find_unknown(*inner, name);
  }
}

void TomlInput::finish() {
  find_unknown(document_->table, "");
  if (faults_.empty()) return;
  std::stable_sort(faults_.begin(), faults_.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  std::string message;
  for (const auto& [line, text] : faults_)
    message += fmt::format("{}{}:{}: {}", message.empty() ? "" : "\n", file_, line, text);
  throw Error(message);
}

}  // namespace gasgrain
