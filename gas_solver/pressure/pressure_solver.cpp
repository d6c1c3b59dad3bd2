#include "gas_solver/pressure/pressure_solver.h"

#include <cmath>

#include "coupling/base/error.h"
#include "gas_solver/pressure/conjugate_gradients.h"
#include "gas_solver/pressure/fftw_layers.h"
#include "gas_solver/pressure/hypre_pfmg.h"

namespace gasgrain {
namespace {

constexpr int max_iterations = 1000;

}  // namespace

PressureSolver::PressureSolver(const Domain& domain, PressureMethod method)
    : domain_(domain), method_(method), choice_(domain.comm().size()) {}

PressureSolver::~PressureSolver() = default;

int PressureSolver::solve(PressureSystem& system, double tolerance) {
  if (method_ != PressureMethod::hypre) {
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
    const int more = go_on(system, max_iterations - iterations);
    if (more == 0) break;  // the residual is no number: the step's check of its fields will say so
    iterations += more;
    gradients_->balance(system);
  }
  return iterations;
}

int PressureSolver::iterate(PressureSystem& system) {
  const std::vector<int> axes = layer_axes(system);
  if (method_ == PressureMethod::fftw && axes.empty())
    fail(
        "[solver] pressure = \"fftw\" cannot solve this case: outlets lie on the sides of more "
        "than one axis. Use \"auto\" or \"hypre\".");
  if (method_ == PressureMethod::fftw) return with_fftw(system, axes.front(), max_iterations);
  if (method_ == PressureMethod::hypre || axes.empty()) return with_hypre(system);

  const double decades = gradients_->decades();
  const int fftw_first = choice_.fftw_iterations(decades);
  int iterations = 0;
  if (fftw_first > 0) {
    iterations = choice_.is_trial() ? try_fftw(system, axes.front(), fftw_first)
                                    : with_fftw(system, axes.front(), fftw_first);
    choice_.fftw_served(gradients_->converged());
    if (gradients_->converged()) return iterations;
  }
  const int by_hypre = with_hypre(system);
  if (fftw_first == 0) choice_.hypre_solved(decades, by_hypre);
  return iterations + by_hypre;
}

int PressureSolver::with_fftw(PressureSystem& system, int axis, int limit) {
  set_layers(system, axis);
  ended_with_fftw_ = true;
  return go_on(system, limit);
}

// Gives up on the way when too much of it is still to go.
int PressureSolver::try_fftw(PressureSystem& system, int axis, int limit) {
  struct Milestone {
    double of_iterations;
    double most_to_go;  // of the decades
  };
  constexpr Milestone milestones[] = {{0.25, 0.9}, {0.5, 2.0 / 3.0}};
  const double decades = gradients_->decades();
  int iterations = 0;
  for (const Milestone& at : milestones) {
    const int next = static_cast<int>(std::ceil(at.of_iterations * limit)) - iterations;
    iterations += iterations == 0 ? with_fftw(system, axis, next) : go_on(system, next);
    if (gradients_->decades() > at.most_to_go * decades) return iterations;
  }
  return iterations + go_on(system, limit - iterations);
}

int PressureSolver::with_hypre(PressureSystem& system) {
  if (!hypre_) hypre_ = std::make_unique<HyprePfmg>(domain_);
  ended_with_fftw_ = false;
  return hypre_->solve(system, *gradients_, max_iterations);
}

// With who was last at work on this system.
int PressureSolver::go_on(PressureSystem& system, int limit) {
  if (!ended_with_fftw_) return hypre_->go_on(system, *gradients_, limit);
  return gradients_->iterate(
      system, limit, [this](const Array3<double>& r, Array3<double>& z) { fftw_->solve(r, z); });
}

// The system that FFTW solves, or preconditions with.
void PressureSolver::set_layers(const PressureSystem& system, int axis) {
  if (!fftw_ || fftw_->axis() != axis) fftw_ = std::make_unique<FftwLayers>(domain_, axis);
  fftw_->set(layer_means(domain_, system, axis), system.singular);
}

void PressureSolver::forget() {
  choice_ = SolverChoice(domain_.comm().size());
  if (hypre_) hypre_->forget();
}

}  // namespace gasgrain
