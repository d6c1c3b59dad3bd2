// What a run of the gas tells while it goes.
#include "gas_solver/io/progress.h"

#include <gtest/gtest.h>

namespace gasgrain {
namespace {

TEST(gas_progress, bar_shows_the_share_and_the_time_left) {
  EXPECT_EQ(bar_text(0.5, 1.5, 3, 90),
            "[###############...............]  50 %  1.5 of 3 s  left 0:01:30");
  EXPECT_EQ(bar_text(1.2, 3, 3, -1),
            "[##############################] 100 %  3 of 3 s  left 0:00:00");
}

GasReport report(double time, int substeps, double step) {
  GasReport done;
  done.time = time;
  done.substeps = substeps;
  done.step = step;
  done.courant_max = 9;
  return done;
}

TEST(gas_progress, substeps_that_the_courant_number_asks_for_are_told_once) {
  GasInput input;
  input.step = 1e-3;
  SubstepNote note(input, 0.0);
  EXPECT_EQ(note.after(report(0.01, 10, 1e-3)), "");  // as many as [time] step asks for
  EXPECT_EQ(
      note.after(report(0.02, 40, 0.25e-3)),
      "note: at t = 0.02 s the gas takes 40 steps of 0.00025 s in an interval of 0.01 s: with "
      "0.001 s the Courant number would be 36.");
  EXPECT_EQ(note.after(report(0.03, 40, 0.25e-3)), "");
}

TEST(gas_progress, one_step_an_interval_is_nothing_to_tell) {
  SubstepNote note(GasInput{}, 0.0);
  EXPECT_EQ(note.after(report(0.5e-3, 1, 0.5e-3)), "");
}

}  // namespace
}  // namespace gasgrain
