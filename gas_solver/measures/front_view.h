// Height of a bed and size of its bubbles, as seen through the flat side of a bed (along y).
//
// From the void fraction averaged over the depth y, in cells (x, z): the surface of a column x is
// the top of its highest cell with a solids fraction above `surface_solids`; the bed's is the
// highest of all columns. Cells below the surface of their column with a void fraction above
// `bubble_void_fraction` are bubble; their area A gives the equivalent diameter
//   d = sqrt(4 A / pi),   F. Alobaid (2013), eq. 2.6.
// Only lines of a rank's own extent cross between ranks.
#pragma once

#include "gas_solver/grid/domain.h"

namespace gasgrain {

struct BedShape {
  double surface_height = 0;   // z [m]; the grid's floor when there is no bed
  double bubble_diameter = 0;  // [m]
};

class FrontView {
 public:
  FrontView(const Domain& domain, double surface_solids, double bubble_void_fraction);
  ~FrontView();
  FrontView(const FrontView&) = delete;
  FrontView& operator=(const FrontView&) = delete;

  // Collective.
  [[nodiscard]] BedShape measure(const Array3<double>& void_fraction) const;

 private:
  const Domain& domain_;
  double surface_solids_;
  double bubble_void_fraction_;
  MPI_Comm depth_ = MPI_COMM_NULL;   // ranks that share (x, z)
  MPI_Comm height_ = MPI_COMM_NULL;  // ranks that share (x, y)
};

}  // namespace gasgrain
