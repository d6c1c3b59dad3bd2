#include "tools/study/pareto_front.h"

#include "tools/study/study_kind.h"

namespace gasgrain {
namespace {

bool counts(const StudyRow& row, const std::string& cost, const std::string& error) {
  return row.ok() && row.point.name != study_twin && std::isfinite(row.figures.get(cost)) &&
         std::isfinite(row.figures.get(error));
}

}  // namespace

void mark_pareto_front(std::vector<StudyRow>& rows, const std::string& cost,
                       const std::string& error) {
  for (std::size_t n = 0; n < rows.size(); ++n) {
    StudyRow& row = rows[n];
    row.on_front = counts(row, cost, error);
    for (std::size_t m = 0; m < rows.size() && row.on_front; ++m) {
      if (!counts(rows[m], cost, error)) continue;
      const double cheaper = row.figures.get(cost) - rows[m].figures.get(cost);
      const double better = row.figures.get(error) - rows[m].figures.get(error);
      const bool beaten = cheaper >= 0.0 && better >= 0.0 && cheaper + better > 0.0;
      row.on_front = !beaten;
    }
  }
}

}  // namespace gasgrain
