#include "gas_solver/pressure/pressure_solver.h"

#include <cmath>

#include "coupling/base/error.h"
#include "gas_solver/pressure/conjugate_gradients.h"
#include "gas_solver/pressure/fftw_layers.h"
#include "gas_solver/pressure/hypre_pfmg.h"
#include "gas_solver/pressure/layers.h"
#include "gas_solver/pressure/multigrid.h"

namespace gasgrain {
namespace {

constexpr int max_iterations = 1000;

}  // namespace

PressureSolver::PressureSolver(const Domain& domain, PressureMethod method)
    : domain_(domain), method_(method) {}

PressureSolver::~PressureSolver() = default;

int PressureSolver::solve(PressureSystem& system, double tolerance) {
  if (method_ == PressureMethod::automatic || method_ == PressureMethod::fftw) {
    const int axis = layered_axis(domain_, system);
    if (axis >= 0) {
      set_layers(system, axis);
      fftw_->solve(system.source, system.solution);
      return 0;
    }
  }
  if (!gradients_) gradients_ = std::make_unique<ConjugateGradients>(domain_);
  gradients_->begin(system, tolerance);
  int iterations = iterate(system);
  if (system.singular) return iterations;
  // To balance the whole may lift a cell at an outlet above the tolerance again.
  gradients_->balance(system);
  while (!gradients_->converged() && iterations < max_iterations) {
    const double to_go = gradients_->decades();
    const int more = go_on(system, max_iterations - iterations);
    if (more == 0) break;  // the residual is no number: the step's check of its fields will say so
    iterations += more;
    gradients_->balance(system);
    if (gradients_->decades() >= to_go) break;  // the tolerance is below the round-off of sums
  }
  return iterations;
}

int PressureSolver::iterate(PressureSystem& system) {
  if (method_ == PressureMethod::hypre) {
    if (!hypre_) hypre_ = std::make_unique<HyprePfmg>(domain_);
    return hypre_->solve(system, *gradients_, max_iterations);
  }
  if (method_ == PressureMethod::fftw) {
    const std::vector<int> axes = layer_axes(system);
    if (axes.empty())
      fail(
          "[solver] pressure = \"fftw\" cannot solve this case: outlets lie on the sides of more "
          "than one axis. Use \"auto\" or \"multigrid\".");
    set_layers(system, axes.front());
  }
  multigrid_is_set_ = false;
  return gradients_->converged() ? 0 : go_on(system, max_iterations);
}

// On the same system.
int PressureSolver::go_on(PressureSystem& system, int limit) {
  if (method_ == PressureMethod::hypre) return hypre_->go_on(system, *gradients_, limit);
  if (method_ == PressureMethod::fftw)
    return gradients_->iterate(
        system, limit, [this](const Array3<double>& r, Array3<double>& z) { fftw_->solve(r, z); });
  if (!multigrid_) multigrid_ = std::make_unique<Multigrid>(domain_);
  if (!multigrid_is_set_) multigrid_->set(system);
  multigrid_is_set_ = true;
  return gradients_->iterate(system, limit, *multigrid_);
}

// The system that FFTW solves, or preconditions with.
void PressureSolver::set_layers(const PressureSystem& system, int axis) {
  if (!fftw_ || fftw_->axis() != axis) fftw_ = std::make_unique<FftwLayers>(domain_, axis);
  fftw_->set(layer_means(domain_, system, axis), system.singular);
}

void PressureSolver::forget() {
  if (hypre_) hypre_->forget();
}

}  // namespace gasgrain
