// Study of MPI ranks on both sides (Alobaid 2013, 8.1.5.3).
#include <sstream>
#include <thread>

#include "coupling/base/error.h"
#include "tools/study/kinds.h"

namespace gasgrain {
namespace {

std::pair<int, int> ranks_of(const std::string& word) {
  std::istringstream text(word);
  int dem = 0;
  int gas = 0;
  char plus = ' ';
  if (!(text >> dem >> plus >> gas) || plus != '+' || dem < 1 || gas < 1 || !text.eof())
    fail("--values {}: ranks are DEM+GAS, for example --values 1+1 2+1 2+2", word);
  return {dem, gas};
}

std::vector<std::string> findings(const std::vector<StudyRow>& rows, double) {
  const StudyRow& first = rows.front();
  const StudyRow* fastest = nullptr;
  for (const auto& row : rows)
    if (row.ok() &&
        (fastest == nullptr || row.figures.get(study_cost) < fastest->figures.get(study_cost)))
      fastest = &row;
  if (fastest == nullptr || !first.ok()) return {};
  return {fmt::format(
      "Fastest: {} ranks, {:.2f} times as fast as {}, on {} cores. Alobaid (2013), 8.1.5.3: more "
      "ranks pay up to a number that grows with the grains (21 for 1e3, 39 for 1e6); {}.",
      fastest->point.name, first.figures.get(study_cost) / fastest->figures.get(study_cost),
      first.point.name, std::thread::hardware_concurrency(),
      "such numbers need as many cores, so that this run neither agrees nor disagrees")};
}

}  // namespace

Study plan_ranks(const SceneCopy&, const StudyOptions& options) {
  Study study;
  study.dial = "ranks";
  study.dial_text = "DEM ranks + gas ranks";
  study.error = "height_error";
  study.error_text = "bed height, rms difference from the first";
  study.reference_text =
      "the run with the first number of ranks; sums in another order differ by "
      "round-off, which a bed's collisions enlarge";
  const auto words =
      options.values.empty()
          ? (options.quick ? std::vector<std::string>{"1+1", "2+1"}
                           : std::vector<std::string>{"1+1", "2+1", "1+2", "2+2", "4+1"})
          : options.values;
  for (const auto& word : words) {
    const auto [dem, gas] = ranks_of(word);
    StudyPoint point;
    point.name = word;
    point.dials = {{"ranks", word}};
    point.dem_ranks = dem;
    point.gas_ranks = gas;
    study.points.push_back(point);
  }
  study.findings = findings;
  return study;
}

}  // namespace gasgrain
