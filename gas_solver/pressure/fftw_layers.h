// Direct solution of the pressure equation where its coefficients change along one axis only:
// Fourier (periodic axis) or cosine transforms (axis between two sides of given velocity) along the
// other two turn it into a tridiagonal system along that axis for each pair of wave numbers. With
// coefficients c of one layer the eigenvalues along a transformed axis of n cells are
//   c (2 - 2 cos(pi m / n)) cosine, m = 0 .. n-1;   c (2 - 2 cos(2 pi m / n)) Fourier.
// On one rank.
#pragma once

#include <fftw3.h>

#include <string>
#include <vector>

#include "gas_solver/pressure/pressure_system.h"

namespace gasgrain {

struct FftwFit {
  int axis = -1;  // along which coefficients may change; -1: the method does not fit, because of
  std::string obstacle;
};

FftwFit fftw_fit(const Domain& domain, const PressureSystem& system);

class FftwLayers {
 public:
  FftwLayers(const Domain& domain, int axis);
  ~FftwLayers();
  FftwLayers(const FftwLayers&) = delete;
  FftwLayers& operator=(const FftwLayers&) = delete;

  [[nodiscard]] int axis() const { return axis_; }
  void solve(PressureSystem& system);

 private:
  void read_layers(const PressureSystem& system);
  void solve_line(const PressureSystem& system, int m1, int m2, double* line,
                  std::ptrdiff_t stride);

  const Domain& domain_;
  int axis_;
  Array3<double> work_;
  fftw_plan forward_ = nullptr;
  fftw_plan backward_ = nullptr;
  double scale_ = 1;  // of a transform and its inverse
  std::array<std::vector<double>, 2> eigenvalue_;
  std::vector<double> across_;
  std::array<std::vector<double>, 2> along_;
  std::vector<double> upper_, rest_, corner_;
};

}  // namespace gasgrain
