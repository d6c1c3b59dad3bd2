// Reads a TOML file key by key and collects EVERY fault of it: wrong types, values out of range,
// misspelt names, unknown keys. finish() throws them all as one Error, a line each:
//   gas.toml:12: drag = "gidaspw" is unknown. Did you mean "gidaspow"?
// A faulty key yields its default, so that reading goes on and finds the other faults too.
#pragma once

#include <array>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "coupling/base/input_key.h"
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
  static Range positive_up_to(double max) { return {0.0, max, true}; }
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
  // message; "1" is the unit of what has none.
  double number(const std::string& key, std::optional<double> fallback, Range range,
                const std::string& unit);
  int integer(const std::string& key, std::optional<int> fallback, Range range);
  std::string text(const std::string& key, std::optional<std::string> fallback);
  std::string choice(const std::string& key, std::optional<std::string> fallback,
                     const std::vector<std::string>& allowed);
  std::vector<double> numbers(const std::string& key, std::optional<std::vector<double>> fallback,
                              Range range, const std::string& unit);
  // Required; empty when absent or at fault.
  std::vector<double> two_numbers(const std::string& key, Range range, const std::string& unit);
  Vec3 vec3(const std::string& key, std::optional<Vec3> fallback, Range range,
            const std::string& unit);
  Int3 int3(const std::string& key, std::optional<Int3> fallback, Range range);
  // A list of [first, second], whose names and units go to the message; empty when absent.
  std::vector<std::array<double, 2>> pairs(const std::string& key, Range range,
                                           const std::string& first, const std::string& second);

  // The same table for keys that go with a choice only, e.g. with 'shape = "circle"'. Where that
  // is not the choice (`goes` is false), the key's presence is a fault and its absence is none.
  [[nodiscard]] InputTable when(bool goes, const std::string& with,
                                const std::string& remedy = "") const;
  // Says in key_table() what the default is, where that is not a constant.
  void note_default(const std::string& key, const std::string& text);

  [[nodiscard]] bool has(const std::string& key) const;
  // A sub-table [name]; an absent one reads as empty (its required keys then are faults).
  InputTable table(const std::string& key);
  // The elements of [[name]]; none when absent.
  std::vector<InputTable> tables(const std::string& key);
  // The line of a key (of the table itself when the key is empty or absent).
  [[nodiscard]] int line(const std::string& key) const;
  // Adds a fault found by the caller, at the line of `key`. `message` goes on after 'file:line: '.
  void fault(const std::string& key, const std::string& message);
  // Whether a fault of the key has been told: what it yields is then no ground for another one.
  [[nodiscard]] bool at_fault(const std::string& key) const;

 private:
  friend class TomlInput;
  InputTable(TomlInput* input, const toml::table* table, std::string path, std::string heading,
             int line);
  // Null when absent or not to be read; `fallback` as in InputKey.
  const toml::node* find(const std::string& key, const std::string& unit, const std::string& range,
                         const std::string& fallback);
  const toml::node* find_table(const std::string& key);
  // `count` 0: any. `kind` as in "three whole numbers".
  std::vector<double> list(const std::string& key, const std::optional<std::vector<double>>& other,
                           Range range, const std::string& unit, std::size_t count,
                           const std::string& kind);
  [[nodiscard]] std::string dotted(const std::string& key) const;

  TomlInput* input_;
  const toml::table* table_;  // null: absent
  std::string path_;          // dotted name, for messages
  std::string heading_;       // "[gas]" or "[[inflow]]"
  int line_;
  bool goes_ = true;    // see when()
  std::string with_;    // its choice
  std::string remedy_;  // where it is not the choice
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

  // All keys that a reader asks for, in Markdown (see markdown_of). It reads an empty file that has
  // one of each list of tables.
  static std::string key_table(const std::function<void(InputTable root)>& read);

 private:
  friend class InputTable;
  struct Document;
  TomlInput();
  void remember(InputKey key);
  void find_unknown(const toml::table& table, const std::string& path);
  [[nodiscard]] std::vector<std::string> known_in(const std::string& path) const;

  std::string file_;
  std::unique_ptr<Document> document_;
  bool describes_ = false;                           // for key_table
  std::vector<std::pair<int, std::string>> faults_;  // line, message
  std::set<std::pair<const toml::table*, std::string>> keys_at_fault_;
  std::vector<InputKey> known_;  // asked for
};

}  // namespace gasgrain
