// Reads the words of a fix in a host's script: KEYWORD VALUE..., in any order. All faults are
// collected and told together.
//
//   class Reader : WordReader { ... };   Reader derives, names its keywords with a function each,
//   and calls read_keywords(), then its own checks, then throw_faults().
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "coupling/base/choice_list.h"
#include "coupling/base/error.h"

namespace gasgrain {

class WordReader {
 protected:
  using Keywords = std::map<std::string, std::function<void()>>;

  explicit WordReader(const std::vector<std::string>& words) : words_(words) {}

  // Calls the function of each keyword met; it takes the words that follow.
  void read_keywords(const Keywords& keywords);
  // Throws Error when there are faults, under the heading "`who` cannot be used:".
  void throw_faults(std::string_view who) const;

  template <class... Args>
  void fault(fmt::format_string<Args...> text, Args&&... args) {
    faults_.push_back(fmt::format(text, std::forward<Args>(args)...));
  }
  void add_fault(std::string text) { faults_.push_back(std::move(text)); }

  // The next word; `what` it is to be told when it is missing.
  std::optional<std::string> word(std::string_view key, std::string_view what);
  // The next word as a number from low to high; 0 where it is not one.
  double number(std::string_view key, double low, double high, std::string_view what);
  int whole(std::string_view key, int least, std::string_view what);
  // Numbers as far as there are any.
  std::vector<double> numbers();
  // Whether the next word is a number.
  [[nodiscard]] bool number_follows() const;
  // Takes the next word when it is this one.
  bool take(std::string_view expected);

  // A listed choice (choice_list.h) by its name.
  template <class List>
  List choice(std::string_view key, const List& before) {
    const auto names = choice_names<List>();
    const auto name = word(key, fmt::format("one of {}", fmt::join(names, ", ")));
    if (!name) return before;
    if (const auto found = choice_named<List>(*name)) return *found;
    fault("{} \"{}\" is unknown.{}", key, *name, suggestion(*name, names));
    return before;
  }

  // Whether a keyword was given.
  [[nodiscard]] bool named(std::string_view key) const;
  [[nodiscard]] bool faultless() const { return faults_.empty(); }

  static std::optional<double> as_number(const std::string& word);

 private:
  const std::vector<std::string>& words_;
  std::size_t at_ = 0;
  std::vector<std::string> met_;  // keywords
  std::vector<std::string> faults_;
};

}  // namespace gasgrain
