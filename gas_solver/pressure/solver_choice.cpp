#include "gas_solver/pressure/solver_choice.h"

#include <algorithm>
#include <cmath>

namespace gasgrain {
namespace {

// Cost of an iteration with FFTW in iterations with hypre, by build/bench/pressure_bench, column
// "ns an iteration and cell": 0.7 to 1.0 on one rank for 5e4 to 2e6 cells; 1.0 to 1.3 on two, where
// FFTW sends the grid round four times.
constexpr double cost_on_one_rank = 0.8;
constexpr double cost_on_several_ranks = 1.1;

constexpr int shortest_wait = 8;
constexpr int longest_wait = 64;

}  // namespace

SolverChoice::SolverChoice(int ranks)
    : cost_fftw_(ranks == 1 ? cost_on_one_rank : cost_on_several_ranks) {}

int SolverChoice::fftw_iterations(double decades) {
  if (hypre_pace_ == 0) return 0;
  const bool trial = until_trial_ == 0;
  if (!trial) --until_trial_;
  if (fftw_serves_ == trial) return 0;
  return static_cast<int>(std::ceil(hypre_pace_ * decades / cost_fftw_));
}

void SolverChoice::fftw_served(bool converged) {
  if (converged) {
    if (!fftw_serves_) until_trial_ = longest_wait;
    wait_ = 0;
  } else {
    wait_ = std::clamp(2 * wait_, shortest_wait, longest_wait);
    until_trial_ = wait_;
  }
  fftw_serves_ = converged;
}

void SolverChoice::hypre_solved(double decades, int iterations) {
  if (decades < 1) return;  // tells little
  hypre_pace_ = iterations / decades;
  if (fftw_serves_) until_trial_ = longest_wait;
}

}  // namespace gasgrain
