#include "gas_solver/pressure/multigrid_smoother.h"

#include <algorithm>

namespace gasgrain {
namespace {

// Of a row of cells along x: coefficients, solution, and strides to rows next to it.
struct Row {
  Row(const MultigridGrid& grid, int j, int k)
      : sy(grid.solution.stride(1)),
        sz(grid.solution.stride(2)),
        offset(grid.solution.offset(grid.own.lo[0], j, k)),
        count(grid.own.extent(0)),
        damping(grid.damping),
        cx(grid.face_coefficient[0].data() + offset),
        cy(grid.face_coefficient[1].data() + offset),
        cz(grid.face_coefficient[2].data() + offset),
        inverse(grid.inverse_diagonal.data() + offset),
        x(grid.solution.data() + offset) {}
  std::ptrdiff_t sy, sz, offset;
  int count;
  float damping;
  const float *cx, *cy, *cz, *inverse, *x;
};

template <class T>
void sweep_down(MultigridGrid& grid, const Array3<T>& source, int k) {
  for (int j = grid.own.hi[1] - 1; j >= grid.own.lo[1]; --j) {
    const Row row(grid, j, k);
    const T* b = &source(grid.own.lo[0], j, k);
    float* x = grid.solution.data() + row.offset;
    const auto [sy, sz, offset, count, damping, cx, cy, cz, inverse, old] = row;
#pragma GCC ivdep
    for (int n = 0; n < count; ++n)
      x[n] =
          inverse[n] * (static_cast<float>(b[n]) + cy[n + sy] * x[n + sy] + cz[n + sz] * x[n + sz]);
  }
}

// What that sweep leaves: the couplings that it has not seen.
void set_rest(MultigridGrid& grid, int k) {
  for (int j = grid.own.lo[1]; j < grid.own.hi[1]; ++j) {
    const auto [sy, sz, offset, count, damping, cx, cy, cz, inverse, x] = Row(grid, j, k);
    float* rest = grid.rest.data() + offset;
#pragma GCC ivdep
    for (int n = 0; n < count; ++n)
      rest[n] = cx[n] * x[n - 1] + cx[n + 1] * x[n + 1] + damping * (cx[n] + cx[n + 1]) * x[n] +
                cy[n] * x[n - sy] + cz[n] * x[n - sz];
    if (j == grid.own.hi[1] - 1)
      for (int n = 0; n < count; ++n) rest[n] += cy[n + sy] * x[n + sy];
    if (k == grid.own.hi[2] - 1)
      for (int n = 0; n < count; ++n) rest[n] += cz[n + sz] * x[n + sz];
  }
}

template <class T>
double product_of(const T* a, const float* b, int count) {
  constexpr int lanes = 8;
  T partial[lanes] = {};
  int n = 0;
  for (; n + lanes <= count; n += lanes)
    for (int lane = 0; lane < lanes; ++lane) partial[lane] += a[n + lane] * b[n + lane];
  double sum = 0;
  for (; n < count; ++n) sum += a[n] * b[n];
  for (const T value : partial) sum += value;
  return sum;
}

}  // namespace

void set_diagonal(MultigridGrid& grid) {
  const bool stores = grid.storage.size() > 0;
  for (int k = grid.own.lo[2]; k < grid.own.hi[2]; ++k)
    for (int j = grid.own.lo[1]; j < grid.own.hi[1]; ++j) {
      const auto [sy, sz, offset, count, damping, cx, cy, cz, before, x] = Row(grid, j, k);
      float* inverse = grid.inverse_diagonal.data() + offset;
      const float* storage = stores ? grid.storage.data() + offset : nullptr;
      for (int n = 0; n < count; ++n) {
        const float along = cx[n] + cx[n + 1];
        float sum = along + damping * along + cy[n] + cy[n + sy] + cz[n] + cz[n + sz];
        if (storage != nullptr) sum += storage[n];
        inverse[n] = sum > 0 ? 1 / sum : 0;  // 0: a cell that nothing flows to or from
      }
    }
}

// What a plane of cells leaves is known once the plane below is swept; then the planes are still in
// the cache.
template <class T>
void relax_from_zero(MultigridGrid& grid, const Array3<T>& source, MultigridHalo& halo) {
  const bool joined = halo.joins(grid);
  if (joined) halo.clear(grid, grid.solution);
  for (int k = grid.own.hi[2] - 1; k >= grid.own.lo[2]; --k) {
    sweep_down(grid, source, k);
    if (!joined && k + 1 < grid.own.hi[2]) set_rest(grid, k + 1);
  }
  halo.exchange(grid, grid.solution);
  for (int k = joined ? grid.own.hi[2] - 1 : grid.own.lo[2]; k >= grid.own.lo[2]; --k)
    set_rest(grid, k);
}

template <class T>
double relax(MultigridGrid& grid, const Array3<T>& source, MultigridHalo& halo) {
  halo.exchange(grid, grid.solution);
  std::vector<float> fresh(grid.own.extent(0));
  double product = 0;
  for (int k = grid.own.lo[2]; k < grid.own.hi[2]; ++k)
    for (int j = grid.own.lo[1]; j < grid.own.hi[1]; ++j) {
      const auto [sy, sz, offset, count, damping, cx, cy, cz, inverse, x] = Row(grid, j, k);
      const T* b = &source(grid.own.lo[0], j, k);
      float* y = fresh.data();
#pragma GCC ivdep
      for (int n = 0; n < count; ++n)
        y[n] = inverse[n] * (static_cast<float>(b[n]) + cx[n] * x[n - 1] + cx[n + 1] * x[n + 1] +
                             damping * (cx[n] + cx[n + 1]) * x[n] + cy[n] * x[n - sy] +
                             cy[n + sy] * x[n + sy] + cz[n] * x[n - sz] + cz[n + sz] * x[n + sz]);
      std::copy(fresh.begin(), fresh.end(), grid.solution.data() + offset);
      product += product_of(b, y, count);
    }
  return product;
}

template void relax_from_zero(MultigridGrid&, const Array3<float>&, MultigridHalo&);
template void relax_from_zero(MultigridGrid&, const Array3<double>&, MultigridHalo&);
template double relax(MultigridGrid&, const Array3<float>&, MultigridHalo&);
template double relax(MultigridGrid&, const Array3<double>&, MultigridHalo&);

}  // namespace gasgrain
