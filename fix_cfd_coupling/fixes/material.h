// A property of the script's materials: that of a `fix property/global`, or one number for all.
#pragma once

#include "fix.h"

namespace gasgrain {

class Material {
 public:
  Material() = default;
  explicit Material(LAMMPS_NS::Fix* fix) : fix_(fix) {}
  explicit Material(double for_all) : is_number_(true), number_(for_all) {}

  // Whether the script has it.
  explicit operator bool() const { return fix_ != nullptr || is_number_; }
  [[nodiscard]] double value() const { return is_number_ ? number_ : fix_->compute_scalar(); }
  // Types count from 1.
  [[nodiscard]] double of(int type) const {
    return is_number_ ? number_ : fix_->compute_vector(type - 1);
  }
  [[nodiscard]] double of(int a, int b) const {
    return is_number_ ? number_ : fix_->compute_array(a - 1, b - 1);
  }

 private:
  LAMMPS_NS::Fix* fix_ = nullptr;
  bool is_number_ = false;
  double number_ = 0.0;
};

}  // namespace gasgrain
