#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "coupling/base/error.h"
#include "coupling/base/toml_input.h"
#include "coupling/base/toml_number.h"

namespace gasgrain {
namespace {

int line_of(const toml::node& node) {
  return static_cast<int>(node.source().begin.line);
}

}  // namespace

std::string Range::text() const {
  const bool low = std::isfinite(min);
  const bool high = std::isfinite(max);
  if (low && high && open_min) return fmt::format("greater than {}, at most {}", min, max);
  if (low && high) return fmt::format("from {} to {}", min, max);
  if (low) return fmt::format("{} {}", open_min ? "greater than" : "at least", min);
  if (high) return fmt::format("at most {}", max);
  return "any finite number";
}

InputTable::InputTable(TomlInput* input, const toml::table* table, std::string path,
                       std::string heading, int line)
    : input_(input),
      table_(table),
      path_(std::move(path)),
      heading_(std::move(heading)),
      line_(line) {}

std::string InputTable::dotted(const std::string& key) const {
  return path_.empty() ? key : path_ + "." + key;
}

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
  input_->keys_at_fault_.emplace(table_, key);
}

bool InputTable::at_fault(const std::string& key) const {
  return input_->keys_at_fault_.count({table_, key}) > 0;
}

InputTable InputTable::when(bool goes, const std::string& with, const std::string& remedy) const {
  InputTable same = *this;
  same.goes_ = goes;
  same.with_ = with;
  same.remedy_ = remedy.empty() ? "set that, or leave the key out" : remedy;
  return same;
}

void InputTable::note_default(const std::string& key, const std::string& text) {
  for (InputKey& known : input_->known_)
    if (known.path == dotted(key)) known.fallback = text;
}

const toml::node* InputTable::find(const std::string& key, const std::string& unit,
                                   const std::string& range, const std::string& fallback) {
  input_->remember({heading_, key, dotted(key), unit, range, fallback, with_});
  const toml::node* node = table_ == nullptr ? nullptr : table_->get(key);
  if (!goes_) {
    if (node != nullptr)
      fault(key, fmt::format("{} goes only with {}: {}.", dotted(key), with_, remedy_));
    return nullptr;
  }
  if (node == nullptr && fallback.empty())
    fault("", path_.empty() ? fmt::format("the key {} is missing.", key)
                            : fmt::format("{} lacks the key {}.", heading_, key));
  return node;
}

double InputTable::number(const std::string& key, std::optional<double> fallback, Range range,
                          const std::string& unit) {
  const double otherwise = fallback.value_or(0.0);
  const toml::node* node =
      find(key, unit, range.text(), fallback ? fmt::format("{}", *fallback) : "");
  if (node == nullptr) return otherwise;
  if (const auto value = number_of(*node, range)) return *value;
  const auto given = node->is_number() ? node->value<double>() : std::nullopt;
  fault(key, given ? fmt::format("{} = {} is {}: it must be {}{}.", dotted(key), *given,
                                 std::isfinite(*given) ? "out of range" : "not finite",
                                 range.text(), in_unit(unit))
                   : fmt::format("{} must be a number{}.", dotted(key), in_unit(unit)));
  return otherwise;
}

int InputTable::integer(const std::string& key, std::optional<int> fallback, Range range) {
  const toml::node* node =
      find(key, "1", "whole number " + range.text(), fallback ? fmt::format("{}", *fallback) : "");
  const int otherwise = fallback.value_or(0);
  if (node == nullptr) return otherwise;
  const auto value = number_of(*node, range);
  if (value && *value == std::floor(*value)) return static_cast<int>(*value);
  fault(key, fmt::format("{} must be a whole number {}.", dotted(key), range.text()));
  return otherwise;
}

std::string InputTable::text(const std::string& key, std::optional<std::string> fallback) {
  const toml::node* node = find(key, "", "text", fallback ? fmt::format("\"{}\"", *fallback) : "");
  if (node == nullptr) return fallback.value_or("");
  if (const auto value = node->value_exact<std::string>()) return *value;
  fault(key, fmt::format("{} must be a text in quotes.", dotted(key)));
  return fallback.value_or("");
}

std::string InputTable::choice(const std::string& key, std::optional<std::string> fallback,
                               const std::vector<std::string>& allowed) {
  const toml::node* node = find(key, "", fmt::format("\"{}\"", fmt::join(allowed, "\", \"")),
                                fallback ? fmt::format("\"{}\"", *fallback) : "");
  const std::string otherwise = fallback.value_or(allowed.empty() ? "" : allowed.front());
  if (node == nullptr) return otherwise;
  const auto word = node->value_exact<std::string>();
  if (word && std::find(allowed.begin(), allowed.end(), *word) != allowed.end()) return *word;
  if (!word)
    fault(key, fmt::format("{} must be a text in quotes.", dotted(key)));
  else
    fault(key, fmt::format("{} = \"{}\" is unknown.{} Allowed: {}.", dotted(key), *word,
                           nearest_name(*word, allowed).empty() ? "" : suggestion(*word, allowed),
                           fmt::join(allowed, ", ")));
  return otherwise;
}

const toml::node* InputTable::find_table(const std::string& key) {
  input_->remember({"", key, dotted(key), "", "", "", ""});
  return table_ == nullptr ? nullptr : table_->get(key);
}

InputTable InputTable::table(const std::string& key) {
  const std::string heading = "[" + dotted(key) + "]";
  const toml::node* node = find_table(key);
  const toml::table* table = node == nullptr ? nullptr : node->as_table();
  if (node != nullptr && table == nullptr) {
    fault(key, fmt::format("{} must be a table: {}.", dotted(key), heading));
    // What [[name]] holds is no less to be read.
    if (const toml::array* elements = node->as_array(); elements != nullptr && !elements->empty())
      table = elements->get(0)->as_table();
  }
  return {input_, table, dotted(key), heading, node == nullptr ? line_ : line_of(*node)};
}

std::vector<InputTable> InputTable::tables(const std::string& key) {
  const std::string heading = "[[" + dotted(key) + "]]";
  const toml::node* node = find_table(key);
  std::vector<InputTable> result;
  if (input_->describes_) result.push_back({input_, nullptr, dotted(key), heading, line_});
  if (node == nullptr) return result;
  const auto add = [&](const toml::node& element) {
    const toml::table* table = element.as_table();
    if (table != nullptr) result.push_back({input_, table, dotted(key), heading, line_of(element)});
    return table != nullptr;
  };
  bool right = false;
  if (const toml::array* elements = node->as_array()) {
    right = true;
    for (const auto& element : *elements) right = add(element) && right;
  } else {
    add(*node);  // what [name] holds is no less to be read
  }
  if (!right) fault(key, fmt::format("{} must be a list of tables: {}.", dotted(key), heading));
  return result;
}

}  // namespace gasgrain
