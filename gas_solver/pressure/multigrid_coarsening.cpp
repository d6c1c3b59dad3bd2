#include "gas_solver/pressure/multigrid_coarsening.h"

namespace gasgrain {
namespace {

// Whether the cell at an odd place along the axis lies in the domain, or is a copy of one that does
// and whose place is odd as well.
bool is_between(const MultigridGrid& fine, int axis, int odd) {
  if (odd >= 0 && odd < fine.cells[axis]) return true;
  return fine.periodic[axis] && fine.cells[axis] % 2 == 0;
}

void set_shares(MultigridGrid& fine, MultigridHalo& halo) {
  const int axis = fine.coarsened_along;
  const Array3<float>& c = fine.face_coefficient[axis];
  const std::ptrdiff_t s = c.stride(axis);
  for_each_cell(fine.own, [&](int i, int j, int k) {
    const Int3 at{i, j, k};
    if (at[axis] % 2 == 0) return;
    const auto o = c.offset(i, j, k);
    const float sum = c[o] + c[o + s];
    const float inverse = sum > 0 ? 1 / sum : 0;
    fine.to_low[o] = c[o] * inverse;
    fine.to_high[o] = c[o + s] * inverse;
  });
  for (Array3<float>* shares : {&fine.to_low, &fine.to_high}) {
    halo.exchange(fine, *shares);
    // Faces on a side of the domain have one cell, whose shares the mean is to be.
    for (int side = 0; side < side_count; ++side) {
      if (axis_of(side) == axis || !fine.touches(side)) continue;
      IndexBox layer = shares->box();
      layer.lo[axis_of(side)] = is_high(side) ? fine.own.hi[axis_of(side)] : -1;
      layer.hi[axis_of(side)] = layer.lo[axis_of(side)] + 1;
      const std::ptrdiff_t in = inward(side, shares->stride(axis_of(side)));
      for_each_cell(layer, [&](int i, int j, int k) {
        const auto o = shares->offset(i, j, k);
        (*shares)[o] = (*shares)[o + in];
      });
    }
  }
}

// Faces across the axis: in series, or one face where no cell lies between.
void set_faces_across(const MultigridGrid& fine, MultigridGrid& coarse) {
  const int axis = fine.coarsened_along;
  const Array3<float>& c = fine.face_coefficient[axis];
  const std::ptrdiff_t s = c.stride(axis);
  for_each_cell(coarse.faces(axis), [&](int i, int j, int k) {
    float& value = coarse.face_coefficient[axis](i, j, k);
    Int3 at{i, j, k};
    const int odd = 2 * at[axis] - 1;
    if (coarse.cells[axis] == 1 && coarse.periodic[axis]) {
      value = 0;  // its own neighbour
    } else if (is_between(fine, axis, odd)) {
      at[axis] = odd;
      const auto o = c.offset(at[0], at[1], at[2]);
      value = fine.to_low[o] * c[o + s];
    } else {
      at[axis] = std::min(2 * at[axis], fine.cells[axis]);
      value = c(at[0], at[1], at[2]);
    }
  });
}

void set_faces_along(const MultigridGrid& fine, MultigridGrid& coarse, int normal) {
  const int axis = fine.coarsened_along;
  const Array3<float>& c = fine.face_coefficient[normal];
  const std::ptrdiff_t s = c.stride(axis);
  const std::ptrdiff_t n = c.stride(normal);
  for_each_cell(coarse.faces(normal), [&](int i, int j, int k) {
    Int3 at{i, j, k};
    at[axis] *= 2;
    const auto o = c.offset(at[0], at[1], at[2]);
    coarse.face_coefficient[normal](i, j, k) =
        c[o] + 0.5F * ((fine.to_low[o + s] + fine.to_low[o + s - n]) * c[o + s] +
                       (fine.to_high[o - s] + fine.to_high[o - s - n]) * c[o - s]);
  });
}

void set_storage(const MultigridGrid& fine, MultigridGrid& coarse) {
  const int axis = fine.coarsened_along;
  const std::ptrdiff_t s = fine.storage.stride(axis);
  for_each_cell(coarse.own, [&](int i, int j, int k) {
    Int3 at{i, j, k};
    at[axis] *= 2;
    const auto o = fine.storage.offset(at[0], at[1], at[2]);
    coarse.storage(i, j, k) = fine.storage[o] + fine.to_low[o + s] * fine.storage[o + s] +
                              fine.to_high[o - s] * fine.storage[o - s];
  });
}

// Where a cell of the next grid lies on the fine one.
Int3 on_fine(int axis, int i, int j, int k) {
  Int3 at{i, j, k};
  at[axis] *= 2;
  return at;
}

void restrict_row(const float* x, std::ptrdiff_t s, const float* to_low, const float* to_high,
                  int count, float* sum) {
#pragma GCC ivdep
  for (int n = 0; n < count; ++n) sum[n] = x[n] + to_low[n] * x[n + s] + to_high[n] * x[n - s];
}

void restrict_along_row(const float* x, const float* to_low, const float* to_high, int count,
                        float* sum) {
#pragma GCC ivdep
  for (int n = 0; n < count; ++n)
    sum[n] = x[2 * n] + to_low[2 * n + 1] * x[2 * n + 1] + to_high[2 * n - 1] * x[2 * n - 1];
}

// Sets, or adds.
template <bool add>
void put(float& x, float value) {
  if constexpr (add)
    x += value;
  else
    x = value;
}

template <bool add>
void interpolate(MultigridGrid& fine, const MultigridGrid& coarse) {
  const int axis = fine.coarsened_along;
  const IndexBox& own = fine.own;
  const int first = own.lo[0];
  const int count = own.extent(0);
  const std::ptrdiff_t s = coarse.solution.stride(axis);
  for (int k = own.lo[2]; k < own.hi[2]; ++k)
    for (int j = own.lo[1]; j < own.hi[1]; ++j) {
      float* x = &fine.solution(first, j, k);
      const float* to_low = &fine.to_low(first, j, k);
      const float* to_high = &fine.to_high(first, j, k);
      if (axis == 0) {
        const float* e = &coarse.solution(coarse.own.lo[0], j, k);
        const int even = first % 2;  // the first even place, counted from the row's begin
        for (int n = 0; n < coarse.own.extent(0); ++n) put<add>(x[even + 2 * n], e[n]);
        for (int n = 1 - even; n < count; n += 2) {
          const int low = (n - even - 1) / 2;
          put<add>(x[n], to_low[n] * e[low] + to_high[n] * e[low + 1]);
        }
        continue;
      }
      const int at = axis == 1 ? j : k;
      const float* e =
          axis == 1 ? &coarse.solution(first, j / 2, k) : &coarse.solution(first, j, k / 2);
      if (at % 2 == 0) {
#pragma GCC ivdep
        for (int n = 0; n < count; ++n) put<add>(x[n], e[n]);
      } else {
#pragma GCC ivdep
        for (int n = 0; n < count; ++n) put<add>(x[n], to_low[n] * e[n] + to_high[n] * e[n + s]);
      }
    }
}

}  // namespace

void coarsen(MultigridGrid& fine, MultigridGrid& coarse, MultigridHalo& halo) {
  set_shares(fine, halo);
  set_faces_across(fine, coarse);
  for (const int normal : plane_axes(fine.coarsened_along)) set_faces_along(fine, coarse, normal);
  for (Array3<float>& c : coarse.face_coefficient) halo.exchange(coarse, c);
  if (fine.storage.size() == 0) return;
  set_storage(fine, coarse);
  halo.exchange(coarse, coarse.storage);
}

void restrict_rest(MultigridGrid& fine, MultigridGrid& coarse, MultigridHalo& halo) {
  const int axis = fine.coarsened_along;
  halo.exchange(fine, fine.left(), axis);
  const IndexBox& own = coarse.own;
  const int count = own.extent(0);
  const std::ptrdiff_t s = fine.to_low.stride(axis);
  for (int k = own.lo[2]; k < own.hi[2]; ++k)
    for (int j = own.lo[1]; j < own.hi[1]; ++j) {
      const Int3 at = on_fine(axis, own.lo[0], j, k);
      const auto o = fine.to_low.offset(at[0], at[1], at[2]);
      const float* x = fine.left().data() + o;
      const float* to_low = fine.to_low.data() + o;
      const float* to_high = fine.to_high.data() + o;
      float* sum = &coarse.source(own.lo[0], j, k);
      if (axis == 0)
        restrict_along_row(x, to_low, to_high, count, sum);
      else
        restrict_row(x, s, to_low + s, to_high - s, count, sum);
    }
}

void correct(MultigridGrid& fine, MultigridGrid& coarse, MultigridHalo& halo) {
  halo.exchange(coarse, coarse.solution, fine.coarsened_along);
  if (fine.relaxed)
    interpolate<true>(fine, coarse);
  else
    interpolate<false>(fine, coarse);
}

}  // namespace gasgrain
