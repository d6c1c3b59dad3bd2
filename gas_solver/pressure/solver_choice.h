// Which preconditioner serves a bed better: FFTW's, which is cheap and needs few iterations where
// layers are nearly uniform, or hypre's multigrid, which bears bubbles. Decided from the iterations
// that this run has seen, times a measured cost of an iteration, and never from the clock: the same
// input gives the same output, bit for bit.
//
// hypre solves first. Then FFTW is given as many iterations as cost what hypre's last solve did; as
// long as they suffice, FFTW it is, else hypre goes on from there. Who does not serve is tried
// again from time to time, as the bed changes.
#pragma once

namespace gasgrain {

class SolverChoice {
 public:
  explicit SolverChoice(int ranks = 1);

  // Iterations that FFTW is to try first in a solve of so many decades; 0: hypre alone.
  int fftw_iterations(double decades);
  // It does so for the first time in a while: most often in vain, and to be given up early.
  [[nodiscard]] bool is_trial() const { return !fftw_serves_; }
  // What came of it.
  void fftw_served(bool converged);
  void hypre_solved(double decades, int iterations);

 private:
  double cost_fftw_;       // of an iteration with FFTW in iterations with hypre
  double hypre_pace_ = 0;  // iterations a decade; 0: not known
  bool fftw_serves_ = false;
  int wait_ = 0;         // solves from one trial to the next
  int until_trial_ = 0;  // solves
};

}  // namespace gasgrain
