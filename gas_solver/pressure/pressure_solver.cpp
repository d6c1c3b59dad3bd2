#include "gas_solver/pressure/pressure_solver.h"

#include "coupling/base/error.h"
#include "gas_solver/pressure/fftw_layers.h"
#include "gas_solver/pressure/hypre_pfmg.h"

namespace gasgrain {

PressureSolver::PressureSolver(const Domain& domain, PressureMethod method)
    : domain_(domain), method_(method) {}

PressureSolver::~PressureSolver() = default;

int PressureSolver::solve(PressureSystem& system, double tolerance) {
  if (method_ != PressureMethod::hypre) {
    const FftwFit fit = fftw_fit(domain_, system);
    if (fit.axis >= 0) {
      if (!fftw_ || fftw_->axis() != fit.axis)
        fftw_ = std::make_unique<FftwLayers>(domain_, fit.axis);
      fftw_->solve(system);
      return 0;
    }
    if (method_ == PressureMethod::fftw)
      fail("[solver] pressure = \"fftw\" cannot solve this step: {}. Use \"auto\" or \"hypre\".",
           fit.obstacle);
  }
  if (!hypre_) hypre_ = std::make_unique<HyprePfmg>(domain_);
  return hypre_->solve(system, tolerance);
}

void PressureSolver::forget() {
  if (hypre_) hypre_->forget();
}

}  // namespace gasgrain
