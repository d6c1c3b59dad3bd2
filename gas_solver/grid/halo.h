// Fills the layers of fields that lie in neighbouring ranks, or across a periodic side.
#pragma once

#include <initializer_list>
#include <vector>

#include "gas_solver/grid/domain.h"

namespace gasgrain {

class Halo {
 public:
  explicit Halo(const Domain& domain) : domain_(domain) {}

  // Collective. Axis after axis, each with the layers of the axes before, so that edges and corners
  // are right. Layers outside of the domain are left to the boundary conditions.
  void exchange(std::initializer_list<Array3<double>*> fields);

 private:
  void wrap(Array3<double>& field, int axis) const;
  void swap(std::initializer_list<Array3<double>*> fields, int axis);

  const Domain& domain_;
  std::vector<double> sent_;
  std::vector<double> received_;
};

}  // namespace gasgrain
