#include "gas_solver/measures/front_view.h"

#include <algorithm>
#include <cmath>

namespace gasgrain {

FrontView::FrontView(const Domain& domain, double surface_solids, double bubble_void_fraction)
    : domain_(domain),
      surface_solids_(surface_solids),
      bubble_void_fraction_(bubble_void_fraction) {
  const Int3& place = domain.place();
  const Int3& layout = domain.layout();
  const MPI_Comm comm = domain.comm().handle();
  MPI_Comm_split(comm, place[0] + layout[0] * place[2], place[1], &depth_);
  MPI_Comm_split(comm, place[0] + layout[0] * place[1], place[2], &height_);
}

FrontView::~FrontView() {
  int finalized = 0;
  MPI_Finalized(&finalized);
  if (finalized != 0) return;  // MPI has freed them
  MPI_Comm_free(&depth_);
  MPI_Comm_free(&height_);
}

BedShape FrontView::measure(const Array3<double>& void_fraction) const {
  const IndexBox own = domain_.own();
  const BoxGrid& grid = domain_.grid();
  IndexBox flat = own;
  flat.lo[1] = 0;
  flat.hi[1] = 1;
  Array3<double> mean(flat);
  for_each_cell(
      own, [&](int i, int j, int k) { mean(i, 0, k) += void_fraction(i, j, k) / grid.cells[1]; });
  MPI_Allreduce(MPI_IN_PLACE, mean.data(), static_cast<int>(mean.size()), MPI_DOUBLE, MPI_SUM,
                depth_);

  std::vector<int> surface(own.extent(0), 0);  // of each column: cells below it
  for_each_cell(flat, [&](int i, int j, int k) {
    int& height = surface[i - own.lo[0]];
    if (1.0 - mean(i, j, k) > surface_solids_) height = std::max(height, k + 1);
  });
  MPI_Allreduce(MPI_IN_PLACE, surface.data(), static_cast<int>(surface.size()), MPI_INT, MPI_MAX,
                height_);

  long bubble_cells = 0;
  if (domain_.place()[1] == 0)
    for_each_cell(flat, [&](int i, int j, int k) {
      if (k < surface[i - own.lo[0]] && mean(i, j, k) > bubble_void_fraction_) ++bubble_cells;
    });
  bubble_cells = domain_.comm().sum(bubble_cells);
  const double top = domain_.comm().max(*std::max_element(surface.begin(), surface.end()));
  const Vec3 h = grid.spacing();
  return {grid.lo[2] + top * h[2],
          std::sqrt(4.0 * static_cast<double>(bubble_cells) * h[0] * h[2] / M_PI)};
}

}  // namespace gasgrain
