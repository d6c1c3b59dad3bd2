// The one exception of the program. Its text is the whole message for the user: it names the place
// (file:line), what is wrong, what is allowed, and the remedy.
#pragma once

#include <fmt/format.h>

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace gasgrain {

class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// Throws Error with a message formatted by fmt.
template <class... Args>
[[noreturn]] void fail(fmt::format_string<Args...> text, Args&&... args) {
  throw Error(fmt::format(text, std::forward<Args>(args)...));
}

// The candidate nearest to a misspelt word by edit distance; empty when none is near enough
// (more than a third of the letters wrong, at least two).
std::string nearest_name(const std::string& word, const std::vector<std::string>& candidates);

// ' Did you mean "x"?' or, when nothing is near, ' Known: a, b, c.'
std::string suggestion(const std::string& word, const std::vector<std::string>& candidates);

}  // namespace gasgrain
