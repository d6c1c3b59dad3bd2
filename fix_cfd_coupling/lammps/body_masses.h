// The masses of rigid bodies that stand in the place of those of their grains, as in LAMMPS's own
// granular styles.
#pragma once

#include <vector>

namespace LAMMPS_NS {
class Fix;
class LAMMPS;
}  // namespace LAMMPS_NS

namespace gasgrain {

// Mass of the rigid body that a grain is part of [kg], 0 of a free one.
class BodyMasses {
 public:
  void find_fix(LAMMPS_NS::LAMMPS& host);  // the first rigid fix of the script
  [[nodiscard]] bool exist() const { return fix_ != nullptr; }
  // Of the grains of this rank; those of the ghosts have to be sent.
  void take(LAMMPS_NS::LAMMPS& host);
  [[nodiscard]] const double* data() const { return exist() ? masses_.data() : nullptr; }
  double& operator[](int grain) { return masses_[grain]; }

 private:
  LAMMPS_NS::Fix* fix_ = nullptr;
  std::vector<double> masses_;
};

}  // namespace gasgrain
