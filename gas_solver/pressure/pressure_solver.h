// Chooses who solves the pressure system: FFTW where its coefficients allow (exact, and fastest),
// else hypre's multigrid.
#pragma once

#include <memory>

#include "gas_solver/gas_input.h"
#include "gas_solver/pressure/pressure_system.h"

namespace gasgrain {

class FftwLayers;
class HyprePfmg;

class PressureSolver {
 public:
  PressureSolver(const Domain& domain, PressureMethod method);
  ~PressureSolver();

  // Solves until the 2-norm of the residual is below `tolerance` [m3/s], which bounds that of every
  // cell. Returns the iterations (0: direct). Collective.
  int solve(PressureSystem& system, double tolerance);
  void forget();

 private:
  const Domain& domain_;
  PressureMethod method_;
  std::unique_ptr<FftwLayers> fftw_;
  std::unique_ptr<HyprePfmg> hypre_;
};

}  // namespace gasgrain
