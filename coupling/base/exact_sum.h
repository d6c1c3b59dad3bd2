// A sum of many numbers that keeps what its last digits lose (Neumaier's summation): adding the
// same small number a million times is wrong by round-off of the sum, not by a million of them.
#pragma once

#include <cmath>

namespace gasgrain {

class ExactSum {
 public:
  ExactSum() = default;
  ExactSum(double value) : sum_(value) {}  // NOLINT: a number is a sum of one

  ExactSum& operator+=(double value) {
    const double sum = sum_ + value;
    lost_ += std::abs(sum_) >= std::abs(value) ? (sum_ - sum) + value : (value - sum) + sum_;
    sum_ = sum;
    return *this;
  }
  [[nodiscard]] double value() const { return sum_ + lost_; }

 private:
  double sum_ = 0.0;
  double lost_ = 0.0;
};

}  // namespace gasgrain
