// Solves the pressure system: with FFTW directly where the coefficients change along one axis only,
// else by conjugate gradients preconditioned with the multigrid. hypre's multigrid, and FFTW on the
// means of the layers, are preconditioners by choice: build/bench/pressure_bench measured neither
// faster in any bed.
#pragma once

#include <memory>

#include "gas_solver/gas_input.h"
#include "gas_solver/pressure/pressure_system.h"

namespace gasgrain {

class ConjugateGradients;
class FftwLayers;
class HyprePfmg;
class Multigrid;

class PressureSolver {
 public:
  PressureSolver(const Domain& domain, PressureMethod method);
  ~PressureSolver();

  // Solves until the 2-norm of the residual is below `tolerance` [m3/s], which bounds that of every
  // cell. Unless the system is singular the residual sums to 0 up to round-off, whatever the
  // tolerance: what flows in flows out or is stored. Returns the iterations (0: direct).
  // Collective.
  int solve(PressureSystem& system, double tolerance);
  // What was learnt in earlier solves.
  void forget();

 private:
  void set_layers(const PressureSystem& system, int axis);
  int iterate(PressureSystem& system);
  int go_on(PressureSystem& system, int limit);

  const Domain& domain_;
  PressureMethod method_;
  std::unique_ptr<FftwLayers> fftw_;
  std::unique_ptr<HyprePfmg> hypre_;
  std::unique_ptr<Multigrid> multigrid_;
  bool multigrid_is_set_ = false;  // for the system being solved
  std::unique_ptr<ConjugateGradients> gradients_;
};

}  // namespace gasgrain
