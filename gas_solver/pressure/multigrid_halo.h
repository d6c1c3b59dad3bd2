// Fills the layer round a rank's box of a multigrid's grid, from neighbouring ranks or across a
// periodic side.
#pragma once

#include <vector>

#include "gas_solver/pressure/multigrid_grid.h"

namespace gasgrain {

class MultigridHalo {
 public:
  explicit MultigridHalo(const Domain& domain) : domain_(domain) {}

  // Whether there is a layer to fill along this axis.
  [[nodiscard]] bool joins(const MultigridGrid& grid, int axis) const {
    return grid.periodic[axis] || splits(grid, axis);
  }
  [[nodiscard]] bool joins(const MultigridGrid& grid) const {
    return joins(grid, 0) || joins(grid, 1) || joins(grid, 2);
  }

  // Along one axis, over the layers of the other two as well. Layers beyond the domain are left as
  // they are. Collective where ranks share the grid.
  void exchange(const MultigridGrid& grid, Array3<float>& field, int axis);
  // Along all axes.
  void exchange(const MultigridGrid& grid, Array3<float>& field);
  // Sets the layers that exchange() fills to 0.
  void clear(const MultigridGrid& grid, Array3<float>& field) const;
  // Fills a grid that every rank holds from one of the same cells that ranks share; of fields on
  // the faces of an axis also the faces on the domain's high side. Collective.
  void gather(const MultigridGrid& shared, const Array3<float>& from, Array3<float>& whole,
              int faces_of_axis = -1);

 private:
  [[nodiscard]] bool splits(const MultigridGrid& grid, int axis) const {
    return !grid.whole && domain_.layout()[axis] > 1;
  }

  const Domain& domain_;
  std::vector<float> sent_;
  std::vector<float> received_;
};

}  // namespace gasgrain
