// Reads a TOML file key by key and collects EVERY fault of it: wrong types, values out of range,
// misspelt names, unknown keys. finish() throws them all as one Error, a line each:
//   gas.toml:12: drag = "gidaspw" is unknown. Did you mean "gidaspow"?
// A faulty key yields its default, so that reading goes on and finds the other faults too.
#pragma once

#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "coupling/base/vec3.h"

namespace toml {
inline namespace v3 {
class table;
class node;
}  // namespace v3
}  // namespace toml

namespace gasgrain {

// Allowed values of a number, the ends included unless `open_min`.
struct Range {
  double min = -std::numeric_limits<double>::infinity();
  double max = std::numeric_limits<double>::infinity();
  bool open_min = false;

  static Range any() { return {}; }
  static Range positive() { return {0.0, std::numeric_limits<double>::infinity(), true}; }
  static Range not_negative() { return {0.0, std::numeric_limits<double>::infinity(), false}; }
  static Range within(double min, double max) { return {min, max, false}; }
  [[nodiscard]] bool holds(double x) const { return (open_min ? x > min : x >= min) && x <= max; }
  [[nodiscard]] std::string text() const;
};

class TomlInput;

// One table of the file. Keys that are never asked for are faults of finish().
class InputTable {
 public:
  // A value with a default; without one (std::nullopt) the key is required. Units go to the
  // message.
  double number(const std::string& key, std::optional<double> fallback, Range range,
                const std::string& unit);
  std::string text(const std::string& key, std::optional<std::string> fallback);
  std::string choice(const std::string& key, std::optional<std::string> fallback,
                     const std::vector<std::string>& allowed);
  std::vector<double> numbers(const std::string& key, std::optional<std::vector<double>> fallback,
                              Range range, const std::string& unit);
  Vec3 vec3(const std::string& key, std::optional<Vec3> fallback, Range range,
            const std::string& unit);
  Int3 int3(const std::string& key, std::optional<Int3> fallback, Range range);

  [[nodiscard]] bool has(const std::string& key) const;
  // A sub-table [name]; an absent one reads as empty (its required keys then are faults).
  InputTable table(const std::string& key);
  // The elements of [[name]]; none when absent.
  std::vector<InputTable> tables(const std::string& key);
  // The line of a key (of the table itself when the key is empty or absent).
  [[nodiscard]] int line(const std::string& key) const;
  // Adds a fault found by the caller, at the line of `key`. `message` goes on after 'file:line: '.
  void fault(const std::string& key, const std::string& message);

 private:
  friend class TomlInput;
  InputTable(TomlInput* input, const toml::table* table, std::string path, int line);
  const toml::node* find(const std::string& key, bool required);

  TomlInput* input_;
  const toml::table* table_;  // null: absent
  std::string path_;          // dotted name, for messages
  int line_;
};

class TomlInput {
 public:
  // Throws Error when the file cannot be read or is not TOML.
  explicit TomlInput(const std::string& file);
  ~TomlInput();
  TomlInput(const TomlInput&) = delete;
  TomlInput& operator=(const TomlInput&) = delete;

  InputTable root();
  [[nodiscard]] const std::string& file() const { return file_; }
  // Throws one Error that lists all faults, unknown keys included; returns when there are none.
  void finish();

 private:
  friend class InputTable;
  struct Document;
  void find_unknown(const toml::table& table, const std::string& path);

  std::string file_;
  std::unique_ptr<Document> document_;
  std::vector<std::pair<int, std::string>> faults_;  // line, message
  std::vector<std::string> known_;                   // dotted names asked for
};

}  // namespace gasgrain
