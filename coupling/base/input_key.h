// What a program asks of one key of its input: the record from which the documentation's table of
// keys is checked.
#pragma once

#include <string>
#include <vector>

namespace gasgrain {

struct InputKey {
  std::string heading;  // of its table, "[gas]" or "[[inflow]]"; empty: the key is a table itself
  std::string key;
  std::string path;  // dotted name, for messages
  std::string unit;
  std::string range;
  std::string fallback;  // empty: required
  std::string with;      // the choice it goes with; empty: with any
};

// Lines of a Markdown table: key, unit, range, default. Neighbours that differ in name only share
// a line.
std::string markdown_of(const std::vector<InputKey>& keys);

}  // namespace gasgrain
