// Collects what is wrong with a law's constants, so that one message names them all: name, value,
// unit, allowed range and remedy. A value that is no number (NaN) is never in a range.
#pragma once

#include <cmath>
#include <string>
#include <string_view>

#include "coupling/base/error.h"

namespace gasgrain {

class InputFaults {
 public:
  explicit InputFaults(std::string_view law) : law_(law) {}

  InputFaults& positive(std::string_view name, double value, std::string_view unit,
                        std::string_view remedy) {
    return require(value > 0.0 && std::isfinite(value), name, value, unit, "above 0 and finite",
                   remedy);
  }
  InputFaults& not_negative(std::string_view name, double value, std::string_view unit,
                            std::string_view remedy) {
    return require(value >= 0.0 && std::isfinite(value), name, value, unit,
                   "0 or above, and finite", remedy);
  }
  InputFaults& finite(std::string_view name, double value, std::string_view unit,
                      std::string_view remedy) {
    return require(std::isfinite(value), name, value, unit, "finite", remedy);
  }
  InputFaults& at_least(std::string_view name, double value, double least, std::string_view unit,
                        std::string_view remedy) {
    return require(value >= least && std::isfinite(value), name, value, unit,
                   fmt::format("{:g} or above, and finite", least), remedy);
  }
  InputFaults& require(bool allowed, std::string_view name, double value, std::string_view unit,
                       std::string_view range, std::string_view remedy) {
    if (!allowed)
      text_ += fmt::format("\n  {} = {:g}{}{} must be {}: {}.", name, value,
                           unit.empty() ? "" : " ", unit, range, remedy);
    return *this;
  }

  // Throws Error when anything was wrong.
  void refuse() const {
    if (!text_.empty()) fail("{} cannot be used:{}", law_, text_);
  }

 private:
  std::string law_;
  std::string text_;
};

}  // namespace gasgrain
