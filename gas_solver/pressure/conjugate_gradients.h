// Preconditioned conjugate gradients on a pressure system, from the solution 0. The preconditioner
// may be changed on the way: the iteration then starts anew from what is reached.
//
// A singular system is solved for its source less the mean: what no solution can meet stays out of
// the residual that is iterated on.
#pragma once

#include <functional>

#include "gas_solver/grid/halo.h"
#include "gas_solver/pressure/pressure_system.h"

namespace gasgrain {

// A preconditioner that keeps its correction z for a residual r to itself; symmetric and positive
// definite.
class SplitPreconditioner {
 public:
  virtual ~SplitPreconditioner() = default;
  // Finds z; returns r z over all ranks. Collective.
  virtual double correction(const Array3<double>& residual) = 0;
  // direction = z + share direction, own cells.
  virtual void turn(Array3<double>& direction, double share) = 0;
};

class ConjugateGradients {
 public:
  // Sets the second to an approximate solution for the first, own cells both; symmetric and
  // positive definite. Collective.
  using Preconditioner = std::function<void(const Array3<double>&, Array3<double>&)>;

  explicit ConjugateGradients(const Domain& domain);

  // Of a new system: the 2-norm of its residual is to fall below `tolerance`. Collective.
  void begin(PressureSystem& system, double tolerance);
  // Until then, or for `limit` iterations; returns the number. Collective.
  int iterate(PressureSystem& system, int limit, const Preconditioner& precondition);
  int iterate(PressureSystem& system, int limit, SplitPreconditioner& preconditioner);
  // Adds the constant to the solution that makes the residual sum to 0: where gas flows in and out
  // the whole then balances to round-off, however coarse the tolerance. It is the Galerkin
  // correction by the constant vector, which brings the solution nearer in the energy norm; the
  // 2-norm of the residual may rise beyond the tolerance. Not for a singular system. Collective.
  void balance(PressureSystem& system);

  [[nodiscard]] bool converged() const { return square_ <= square_end_; }
  // Powers of ten by which the residual is yet to fall.
  [[nodiscard]] double decades() const;

 private:
  double apply(const PressureSystem& system);
  void advance(PressureSystem& system, double length);

  const Domain& domain_;
  Halo halo_;
  double square_ = 0;  // of the residual's 2-norm
  double square_end_ = 0;
  Array3<double> residual_;   // own cells
  Array3<double> auxiliary_;  // own cells: matrix times direction, or the preconditioned residual
  Array3<double> direction_;
};

}  // namespace gasgrain
