#include "tools/analyse/big_grains.h"

#include <algorithm>
#include <cstdlib>
#include <sstream>

#include "coupling/base/error.h"

namespace gasgrain {

BigGrains::BigGrains(const std::string& text, std::vector<std::string>& faults) {
  const std::vector<std::string> names{"largest", "type", "id", "above"};
  const auto equals = text.find('=');
  const std::string name = text.substr(0, equals);
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) {
    faults.push_back(fmt::format("--big: \"{}\" is unknown.{}", name, suggestion(name, names)));
    return;
  }
  by_ = static_cast<By>(found - names.begin());
  if (by_ == By::largest) {
    if (equals != std::string::npos)
      faults.push_back(fmt::format("--big: \"{}\": largest has no value.", text));
    return;
  }
  std::istringstream words(equals == std::string::npos ? "" : text.substr(equals + 1));
  for (std::string word; std::getline(words, word, ',');) {
    char* end = nullptr;
    values_.push_back(std::strtod(word.c_str(), &end));
    if (word.empty() || *end != '\0' || !(values_.back() > 0.0))
      faults.push_back(
          fmt::format("--big: \"{}\" of \"{}\" must be a number above 0.", word, text));
  }
  if (values_.empty() || (by_ == By::above && values_.size() > 1))
    faults.push_back(fmt::format(
        "--big: \"{}\" must read type=2, id=1,7 or above=0.002 (diameter in m).", text));
}

std::vector<bool> BigGrains::of(const DumpFrame& frame) const {
  const auto value_of = [&](const char* name) {
    return
        [&frame, column = frame.column(name)](std::size_t row) { return frame.value(row, column); };
  };
  std::vector<bool> big(frame.size(), false);
  if (by_ == By::type || by_ == By::id) {
    const auto value = value_of(by_ == By::type ? "type" : "id");
    for (std::size_t row = 0; row < frame.size(); ++row)
      big[row] = std::find(values_.begin(), values_.end(), value(row)) != values_.end();
    return big;
  }
  const auto radius = value_of("radius");
  double least = 0.0;
  if (by_ == By::above) {
    least = 0.5 * values_.front();
  } else {
    constexpr double alike = 1.0 - 1e-4;  // dumps have six digits
    for (std::size_t row = 0; row < frame.size(); ++row)
      least = std::max(least, alike * radius(row));
  }
  for (std::size_t row = 0; row < frame.size(); ++row) big[row] = radius(row) > least;
  return big;
}

}  // namespace gasgrain
