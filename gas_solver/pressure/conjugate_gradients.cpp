#include "gas_solver/pressure/conjugate_gradients.h"

#include <algorithm>
#include <cmath>

namespace gasgrain {
namespace {

// Visits the rows of cells along x: f(i_begin, count, j, k).
template <class F>
void for_each_row(const IndexBox& box, F&& f) {
  for (int k = box.lo[2]; k < box.hi[2]; ++k)
    for (int j = box.lo[1]; j < box.hi[1]; ++j) f(box.lo[0], box.extent(0), j, k);
}

// In several partial sums, which the vector unit takes side by side.
double dot(const double* a, const double* b, std::size_t count) {
  constexpr std::size_t lanes = 8;
  double partial[lanes] = {};
  std::size_t n = 0;
  for (; n + lanes <= count; n += lanes)
    for (std::size_t lane = 0; lane < lanes; ++lane) partial[lane] += a[n + lane] * b[n + lane];
  double sum = 0;
  for (; n < count; ++n) sum += a[n] * b[n];
  for (const double value : partial) sum += value;
  return sum;
}

// f(coefficient, cell) for each face of given pressure.
template <class F>
void for_each_given_pressure(const Domain& domain, const PressureSystem& system, F&& f) {
  for (int side = 0; side < side_count; ++side) {
    if (system.sides[side]->normal_velocity_given) continue;
    const int axis = axis_of(side);
    for_each_cell(domain.side_faces(side), [&](int i, int j, int k) {
      Int3 cell{i, j, k};
      if (is_high(side)) --cell[axis];
      f(system.face_coefficient[axis](i, j, k), cell);
    });
  }
}

}  // namespace

ConjugateGradients::ConjugateGradients(const Domain& domain)
    : domain_(domain),
      halo_(domain),
      residual_(domain.own()),
      auxiliary_(domain.own()),
      direction_(domain.box()) {}

void ConjugateGradients::begin(PressureSystem& system, double tolerance) {
  system.solution.fill(0.0);
  double mean = 0;
  if (system.singular) {
    for (const double value : system.source) mean += value;
    mean = domain_.comm().sum(mean) / static_cast<double>(domain_.grid().all().size());
  }
  for (std::size_t n = 0; n < residual_.size(); ++n) residual_[n] = system.source[n] - mean;
  square_ = domain_.comm().sum(dot(residual_.data(), residual_.data(), residual_.size()));
  square_end_ = tolerance * tolerance;
}

double ConjugateGradients::decades() const {
  constexpr double most = 16;  // of double precision
  return converged() ? 0.0 : std::min(most, 0.5 * std::log10(square_ / square_end_));
}

namespace {

// Of a correction in full: the field that is also lent to the product of matrix and direction.
class FullPreconditioner : public SplitPreconditioner {
 public:
  FullPreconditioner(const Domain& domain, const ConjugateGradients::Preconditioner& precondition,
                     Array3<double>& z)
      : domain_(domain), precondition_(precondition), z_(z) {}

  double correction(const Array3<double>& residual) override {
    precondition_(residual, z_);
    return domain_.comm().sum(dot(residual.data(), z_.data(), residual.size()));
  }
  void turn(Array3<double>& direction, double share) override {
    for_each_row(domain_.own(), [&](int i, int count, int j, int k) {
      double* p = &direction(i, j, k);
      const double* z = &z_(i, j, k);
      for (int n = 0; n < count; ++n) p[n] = z[n] + share * p[n];
    });
  }

 private:
  const Domain& domain_;
  const ConjugateGradients::Preconditioner& precondition_;
  Array3<double>& z_;
};

}  // namespace

int ConjugateGradients::iterate(PressureSystem& system, int limit,
                                const Preconditioner& precondition) {
  FullPreconditioner full(domain_, precondition, auxiliary_);
  return iterate(system, limit, full);
}

int ConjugateGradients::iterate(PressureSystem& system, int limit,
                                SplitPreconditioner& preconditioner) {
  double product_before = 0;
  int iterations = 0;
  while (square_ > square_end_ && iterations < limit) {  // not when it is no number either
    const double product = preconditioner.correction(residual_);
    const double share = iterations == 0 ? 0.0 : product / product_before;
    product_before = product;
    preconditioner.turn(direction_, share);
    halo_.exchange({&direction_});
    advance(system, product / apply(system));
    ++iterations;
  }
  return iterations;
}

void ConjugateGradients::balance(PressureSystem& system) {
  // What leaves through faces of given pressure or is stored: of the solution, and of a unit more.
  std::vector<double> sums(3, 0.0);
  for (const double value : system.source) sums[0] += value;
  const auto take = [&](double coefficient, double x) {
    sums[1] += coefficient * x;
    sums[2] += coefficient;
  };
  for_each_given_pressure(domain_, system, [&](double c, const Int3& at) {
    take(c, system.solution(at[0], at[1], at[2]));
  });
  if (has_storage(system))
    for_each_cell(domain_.own(), [&](int i, int j, int k) {
      take(system.storage(i, j, k), system.solution(i, j, k));
    });
  domain_.comm().sum_in_place(sums);
  const double more = (sums[0] - sums[1]) / sums[2];

  for_each_cell(domain_.own(), [&](int i, int j, int k) { system.solution(i, j, k) += more; });
  for_each_given_pressure(domain_, system, [&](double c, const Int3& at) {
    residual_(at[0], at[1], at[2]) -= more * c;
  });
  if (has_storage(system))
    for (std::size_t n = 0; n < residual_.size(); ++n) residual_[n] -= more * system.storage[n];
  square_ = domain_.comm().sum(dot(residual_.data(), residual_.data(), residual_.size()));
}

// The matrix times direction; returns its product with direction. Layers of direction beyond the
// domain are 0: a given pressure.
double ConjugateGradients::apply(const PressureSystem& system) {
  const auto& c = system.face_coefficient;
  const std::ptrdiff_t sy = direction_.stride(1);
  const std::ptrdiff_t sz = direction_.stride(2);
  double product = 0;
  for_each_row(domain_.own(), [&](int i, int count, int j, int k) {
    const double* p = &direction_(i, j, k);
    const double* cx = &c[0](i, j, k);
    const double* cy = &c[1](i, j, k);
    const double* cz = &c[2](i, j, k);
    double* q = &auxiliary_(i, j, k);
    for (int n = 0; n < count; ++n)
      q[n] = cx[n] * (p[n] - p[n - 1]) + cx[n + 1] * (p[n] - p[n + 1]) +
             cy[n] * (p[n] - p[n - sy]) + cy[n + sy] * (p[n] - p[n + sy]) +
             cz[n] * (p[n] - p[n - sz]) + cz[n + sz] * (p[n] - p[n + sz]);
    if (has_storage(system)) {
      const double* storage = &system.storage(i, j, k);
      for (int n = 0; n < count; ++n) q[n] += storage[n] * p[n];
    }
    product += dot(p, q, count);
  });
  return domain_.comm().sum(product);
}

void ConjugateGradients::advance(PressureSystem& system, double length) {
  double square = 0;
  for_each_row(domain_.own(), [&](int i, int count, int j, int k) {
    const double* p = &direction_(i, j, k);
    const double* q = &auxiliary_(i, j, k);
    double* x = &system.solution(i, j, k);
    double* r = &residual_(i, j, k);
    for (int n = 0; n < count; ++n) {
      x[n] += length * p[n];
      r[n] -= length * q[n];
    }
    square += dot(r, r, count);
  });
  square_ = domain_.comm().sum(square);
}

}  // namespace gasgrain
