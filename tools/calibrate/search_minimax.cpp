#include <exception>
#include <nlopt.hpp>

#include "tools/calibrate/search.h"

namespace gasgrain {
namespace {

constexpr double first_step = 0.25;     // of the range: the edge of the first simplex
constexpr double finest = 0.002;        // of the range: that of the last
constexpr std::size_t most_points = 6;  // for each parameter; what is left is for refine()

// Scatter can send COBYLA round points that are known, which cost nothing, without an end.
constexpr int most_looks = 50;  // for each parameter

// What NLopt calls. The parameters are shares of their ranges, t is a share of what it begins with.
class Minimax {
 public:
  explicit Minimax(Objective& objective) : objective_(objective) {}

  void search() {
    const auto& problem = objective_.problem();
    std::vector<double> x(problem.parameters.size(), 0.5);
    try {
      look(x);
      start_distance_ = best_.distance(problem);
      x.push_back(1.0);  // t
      nlopt::opt cobyla(nlopt::LN_COBYLA, static_cast<unsigned>(x.size()));
      cobyla.set_lower_bounds(0.0);
      cobyla.set_upper_bounds(1.0);
      cobyla.set_min_objective(
          [](const std::vector<double>& at, std::vector<double>&, void*) { return at.back(); },
          nullptr);
      constexpr double slack = 1e-6;
      cobyla.add_inequality_mconstraint(constraints, this,
                                        std::vector<double>(2 * problem.targets.size(), slack));
      cobyla.set_initial_step(first_step);
      cobyla.set_xtol_abs(finest);
      double t = 0.0;
      cobyla.optimize(x, t);
    } catch (const nlopt::forced_stop&) {
    } catch (const nlopt::roundoff_limited&) {  // as near as scatter lets it come
    }
    if (fault_) std::rethrow_exception(fault_);
  }
  [[nodiscard]] const CalibrationPoint& best() const { return best_; }

 private:
  // Throws nlopt::forced_stop when the search is over.
  CalibrationPoint look(const std::vector<double>& shares) {
    const auto& problem = objective_.problem();
    std::vector<double> values;
    for (std::size_t n = 0; n < shares.size(); ++n)
      values.push_back(problem.parameters[n].low + shares[n] * problem.parameters[n].span());
    const auto point = objective_.measure(values, problem.search_repeats);
    if (best_.values.empty() || point.distance(problem) < best_.distance(problem)) best_ = point;
    const auto parameters = static_cast<int>(problem.parameters.size());
    if (++looks_ >= most_looks * parameters || best_.distance(problem) <= 1.0 ||
        objective_.points().size() >= most_points * problem.parameters.size())
      throw nlopt::forced_stop();
    return point;
  }

  // Each target's distance, in what the search began with, less t: from above and from below.
  static void constraints(unsigned /*count*/, double* result, unsigned size, const double* x,
                          double* /*gradient*/, void* data) {
    auto& self = *static_cast<Minimax*>(data);
    const double t = x[size - 1];
    try {
      const auto point = self.look(std::vector<double>(x, x + size - 1));
      for (std::size_t n = 0; n < point.mean.size(); ++n) {
        const auto& target = self.objective_.problem().targets[n];
        const double share =
            (point.mean[n] - target.value) / target.tolerance / self.start_distance_;
        result[2 * n] = share - t;
        result[2 * n + 1] = -share - t;
      }
    } catch (const nlopt::forced_stop&) {
      throw;
    } catch (...) {  // NLopt would forget what was said
      self.fault_ = std::current_exception();
      throw nlopt::forced_stop();
    }
  }

  Objective& objective_;
  CalibrationPoint best_;
  double start_distance_ = 1.0;
  int looks_ = 0;
  std::exception_ptr fault_;
};

}  // namespace

SearchResult search_minimax(Objective& objective) {
  Minimax minimax(objective);
  minimax.search();
  return {minimax.best().values, ""};
}

}  // namespace gasgrain
