// The words of a script's command as texts and numbers; what is no number where one must be is a
// fault that names the line.
#pragma once

#include <algorithm>
#include <cstdlib>
#include <string>
#include <vector>

#include "coupling/base/error.h"
#include "tools/dem_script.h"

namespace gasgrain {

class CommandWords {
 public:
  CommandWords(const ScriptCommand& command, std::vector<std::string>& faults)
      : command_(command), faults_(faults) {}

  [[nodiscard]] std::size_t size() const { return command_.words.size(); }
  // Empty beyond the last.
  [[nodiscard]] std::string word(std::size_t n) const {
    return n < size() ? command_.words[n] : "";
  }
  [[nodiscard]] bool has(const std::string& key) const {
    return std::find(command_.words.begin(), command_.words.end(), key) != command_.words.end();
  }
  [[nodiscard]] std::string after(const std::string& key) const { return command_.after(key); }
  double number(std::size_t n) {
    return number_of(word(n), fmt::format("word {} of {}", n + 1, word(0)));
  }
  double number_after(const std::string& key) { return number_of(after(key), key); }
  // Of a box: INF stands for the end of the box.
  double bound(std::size_t n, double end) { return word(n) == "INF" ? end : number(n); }

  template <class... Args>
  void fault(fmt::format_string<Args...> text, Args&&... args) {
    faults_.push_back(command_.place() + ": " + fmt::format(text, std::forward<Args>(args)...));
  }

 private:
  double number_of(const std::string& text, const std::string& what) {
    char* end = nullptr;
    const double value = std::strtod(text.c_str(), &end);
    if (!text.empty() && *end == '\0') return value;
    fault("{} must be a number, found \"{}\".", what, text);
    return 0.0;
  }

  const ScriptCommand& command_;
  std::vector<std::string>& faults_;
};

}  // namespace gasgrain
