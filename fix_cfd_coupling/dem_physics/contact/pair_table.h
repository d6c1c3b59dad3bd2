// One value for each pair of types; types count from 1, as in a script.
#pragma once

#include <cstddef>
#include <vector>

namespace gasgrain::contact {

template <class Value>
class PairTable {
 public:
  PairTable() = default;
  explicit PairTable(int types)
      : types_(types), values_(static_cast<std::size_t>((types + 1) * (types + 1))) {}
  Value& operator()(int i, int j) { return values_[at(i, j)]; }
  const Value& operator()(int i, int j) const { return values_[at(i, j)]; }
  [[nodiscard]] int types() const { return types_; }

  // The place of a pair, the same in all tables of a scene.
  const Value& operator[](std::size_t place) const { return values_[place]; }
  [[nodiscard]] std::size_t at(int i, int j) const {
    return static_cast<std::size_t>(i * (types_ + 1) + j);
  }

 private:
  int types_ = 0;
  std::vector<Value> values_;
};

}  // namespace gasgrain::contact
