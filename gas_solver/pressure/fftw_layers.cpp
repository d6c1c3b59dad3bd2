#include "gas_solver/pressure/fftw_layers.h"

#include <fftw3-mpi.h>

namespace gasgrain {
namespace {

int share(int count, int ranks) {
  return (count + ranks - 1) / ranks;
}

fftw_r2r_kind kind(const Domain& domain, int axis, bool forward) {
  if (domain.grid().periodic[axis]) return forward ? FFTW_R2HC : FFTW_HC2R;
  return forward ? FFTW_REDFT10 : FFTW_REDFT01;
}

}  // namespace

FftwLayers::FftwLayers(const Domain& domain, int axis)
    : domain_(domain),
      axis_(axis),
      layer_size_(static_cast<int>(domain.grid().all().size()) / domain.grid().cells[axis]),
      lines_(domain.grid(), axis),
      slabs_(domain, axis, share(domain.grid().cells[axis], domain.comm().size())),
      end_line_(layer_size_) {
  const auto plane = plane_axes(axis);
  for (const int d : plane)
    scale_ /= (domain.grid().periodic[d] ? 1.0 : 2.0) * domain.grid().cells[d];
  if (domain.comm().size() > 1)
    plan_transposes();
  else
    work_.resize(domain.own().size());
  plan_layers();
}

// Estimated plans, not measured ones: a run must not depend on the clock.
void FftwLayers::plan_layers() {
  const Int3& cells = domain_.grid().cells;
  const auto plane = plane_axes(axis_);
  if (slabs_.layers() == 0) return;
  const std::array<int, 2> size{cells[plane[1]], cells[plane[0]]};  // the fastest last
  const auto make = [&](bool forth) {
    const std::array<fftw_r2r_kind, 2> kinds{kind(domain_, plane[1], forth),
                                             kind(domain_, plane[0], forth)};
    return fftw_plan_many_r2r(2, size.data(), slabs_.layers(), work_.data(), nullptr, 1,
                              layer_size_, work_.data(), nullptr, 1, layer_size_, kinds.data(),
                              FFTW_ESTIMATE);
  };
  forward_ = make(true);
  backward_ = make(false);
}

void FftwLayers::plan_transposes() {
  fftw_mpi_init();
  const MPI_Comm comm = domain_.comm().handle();
  const std::array<std::ptrdiff_t, 2> size{domain_.grid().cells[axis_], layer_size_};
  const std::ptrdiff_t thickness = share(domain_.grid().cells[axis_], domain_.comm().size());
  const std::ptrdiff_t lines = share(layer_size_, domain_.comm().size());
  std::ptrdiff_t layers_here = 0;
  std::ptrdiff_t first_layer = 0;
  std::ptrdiff_t lines_here = 0;
  std::ptrdiff_t first_line = 0;
  work_.resize(fftw_mpi_local_size_many_transposed(2, size.data(), 1, thickness, lines, comm,
                                                   &layers_here, &first_layer, &lines_here,
                                                   &first_line));
  first_line_ = static_cast<int>(first_line);
  end_line_ = static_cast<int>(first_line + lines_here);
  double* data = work_.data();
  to_lines_ = fftw_mpi_plan_many_transpose(size[0], size[1], 1, thickness, lines, data, data, comm,
                                           FFTW_ESTIMATE);
  to_layers_ = fftw_mpi_plan_many_transpose(size[1], size[0], 1, lines, thickness, data, data, comm,
                                            FFTW_ESTIMATE);
}

FftwLayers::~FftwLayers() {
  for (fftw_plan plan : {forward_, backward_, to_lines_, to_layers_})
    if (plan != nullptr) fftw_destroy_plan(plan);
}

void FftwLayers::solve(const Array3<double>& source, Array3<double>& solution) {
  slabs_.gather(source, work_.data());
  if (forward_ != nullptr) fftw_execute(forward_);
  if (to_lines_ != nullptr) {
    fftw_execute(to_lines_);
    lines_.solve(first_line_, end_line_, work_.data(), domain_.grid().cells[axis_], 1, scale_);
    fftw_execute(to_layers_);
  } else {
    lines_.solve(0, layer_size_, work_.data(), 1, layer_size_, scale_);
  }
  if (backward_ != nullptr) fftw_execute(backward_);
  slabs_.scatter(work_.data(), solution);
}

}  // namespace gasgrain
