// Direct solution of a system of layers, whose coefficients change along one axis only: Fourier
// (periodic axis) or cosine transforms (axis between two sides of given velocity) along the other
// two axes turn it into a tridiagonal system along that axis for each pair of wave numbers.
//
// On several ranks each transforms whole layers; then FFTW's transpose brings whole lines across
// the layers to a rank, and back. No rank holds more than its share of the cells.
#pragma once

#include <fftw3.h>

#include "gas_solver/pressure/layer_lines.h"
#include "gas_solver/pressure/slabs.h"

namespace gasgrain {

class FftwLayers {
 public:
  FftwLayers(const Domain& domain, int axis);
  ~FftwLayers();
  FftwLayers(const FftwLayers&) = delete;
  FftwLayers& operator=(const FftwLayers&) = delete;

  [[nodiscard]] int axis() const { return axis_; }
  // The system to solve; a singular one is known but for a constant.
  void set(const Layers& layers, bool singular) { lines_.set(layers, singular); }
  // Own cells; `solution` may have more around them. Collective.
  void solve(const Array3<double>& source, Array3<double>& solution);

 private:
  void plan_layers();
  void plan_transposes();

  const Domain& domain_;
  int axis_;
  int layer_size_;  // cells
  LayerLines lines_;
  Slabs slabs_;
  double scale_ = 1;  // of a transform and its inverse
  fftw_plan forward_ = nullptr;
  fftw_plan backward_ = nullptr;
  // Several ranks: layers to lines and back, and the lines of this rank.
  fftw_plan to_lines_ = nullptr;
  fftw_plan to_layers_ = nullptr;
  int first_line_ = 0;
  int end_line_;
  std::vector<double> work_;
};

}  // namespace gasgrain
