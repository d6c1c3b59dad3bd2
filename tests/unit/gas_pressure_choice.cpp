// Who preconditions, from iterations seen.
#include <gtest/gtest.h>

#include "gas_solver/pressure/solver_choice.h"

namespace gasgrain {
namespace {

constexpr double decades = 8;

// A bed in which each solver needs so many iterations; solves it, returns the iterations spent.
struct Bed {
  int fftw;
  int hypre;

  int solve(SolverChoice& choice) const {
    const int first = choice.fftw_iterations(decades);
    if (first > 0) choice.fftw_served(fftw <= first);
    if (first >= fftw) return fftw;
    if (first == 0) choice.hypre_solved(decades, hypre);
    return first + hypre;
  }
};

TEST(gas_pressure_choice, hypre_solves_first_and_fftw_is_taken_once_it_is_cheaper) {
  SolverChoice choice;
  const Bed calm{9, 15};
  EXPECT_EQ(calm.solve(choice), 15);
  for (int n = 0; n < 50; ++n) EXPECT_EQ(calm.solve(choice), 9);
}

TEST(gas_pressure_choice, trials_in_a_bed_of_bubbles_cost_less_than_a_fifth) {
  SolverChoice choice;
  const Bed bubbles{200, 17};
  int spent = 0;
  for (int n = 0; n < 12; ++n) spent += bubbles.solve(choice);
  EXPECT_LE(spent, 1.25 * 12 * 17);  // an iteration with FFTW costs less than one with hypre
  for (int n = 12; n < 500; ++n) spent += bubbles.solve(choice);
  EXPECT_LE(spent, 1.05 * 500 * 17);
}

TEST(gas_pressure_choice, hypre_takes_over_when_bubbles_come_and_fftw_when_they_are_gone) {
  SolverChoice choice;
  const Bed calm{9, 15};
  const Bed bubbles{200, 17};
  for (int n = 0; n < 20; ++n) calm.solve(choice);
  bubbles.solve(choice);
  EXPECT_EQ(bubbles.solve(choice), 17);
  int spent = 0;
  for (int n = 0; n < 100; ++n) spent += calm.solve(choice);
  EXPECT_LE(spent, 100 * 9 + 8 * 6 + 15);
}

}  // namespace
}  // namespace gasgrain
