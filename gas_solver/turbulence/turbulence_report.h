// What a turbulence model did in a step, of all ranks.
#pragma once

namespace gasgrain {

struct TurbulenceReport {
  long floored = 0;        // values of k or e raised to the least one
  long capped = 0;         // cells whose mu_t was cut to the greatest
  long not_converged = 0;  // equations that used all sweeps
};

}  // namespace gasgrain
