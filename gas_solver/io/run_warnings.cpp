#include "gas_solver/io/run_warnings.h"

#include <fmt/format.h>

#include <algorithm>

namespace gasgrain {

void RunWarnings::add(const GasReport& report) {
  momentum_ += report.momentum_not_converged;
  pressure_ += report.pressure_not_converged;
  outer_ += report.outer_not_converged;
  turbulence_clamped_ += report.turbulence_clamped;
  turbulence_ += report.turbulence_not_converged;
  backflow_ = std::max(backflow_, report.backflow_faces);
}

std::string RunWarnings::text() const {
  std::string lines;
  const auto add = [&](long count, const char* what) {
    if (count > 0) lines += fmt::format("{}{} {}", lines.empty() ? "" : "\n", count, what);
  };
  add(momentum_, "components of the momentum missed the tolerance");
  add(pressure_, "steps missed the tolerance of continuity");
  add(outer_, "steps used all their outer iterations");
  add(turbulence_clamped_, "values of k, e or mu_t were cut or raised");
  add(turbulence_, "equations of k or e missed the tolerance");
  add(backflow_, "outlet faces at most let gas in at a time");
  return lines;
}

}  // namespace gasgrain
