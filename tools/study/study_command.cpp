#include "tools/study/study_command.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <numeric>

#include "coupling/base/error.h"
#include "tools/child_process.h"
#include "tools/programs.h"
#include "tools/scene_check.h"
#include "tools/stop_request.h"
#include "tools/study/kinds.h"
#include "tools/study/pareto_front.h"
#include "tools/study/point_figures.h"
#include "tools/study/point_run.h"
#include "tools/study/study_progress.h"
#include "tools/study/study_table.h"
#include "tools/study/trace_error.h"

namespace gasgrain {

namespace fs = std::filesystem;

namespace {

constexpr int stopped_status = 130;   // what shells report after Ctrl-C
constexpr double packing_cost = 3.0;  // against a usual point, for the time left
constexpr double twin_settles_s = 0.01;

const StudyKind& kind_of(const std::string& name) {
  std::vector<std::string> names;
  for (const StudyKind& kind : all_study_kinds()) {
    if (kind.name == name) return kind;
    names.emplace_back(kind.name);
  }
  fail("study \"{}\" is unknown.{}", name, suggestion(name, names));
}

fs::path study_folder(const StudyOptions& options) {
  if (!options.out.empty()) return fs::absolute(options.out).lexically_normal();
  const fs::path scene = (fs::absolute(options.scene) / ".").lexically_normal().parent_path();
  return fs::absolute("results") / "study" / scene.filename() / options.kind;
}

// The line that makes the study again.
std::string command_line(const StudyOptions& options) {
  std::string line = fmt::format("gasgrain study {} {}", options.kind, options.scene.string());
  if (options.quick) line += " --quick";
  if (!options.values.empty()) {
    line += " --values";
    for (const auto& value : options.values)
      line += value.find(' ') == std::string::npos ? " " + value : " \"" + value + "\"";
  }
  if (options.time_s) line += fmt::format(" --time {:g}", *options.time_s);
  if (options.repeats > 1) line += fmt::format(" --repeats {}", options.repeats);
  const StudyOptions usual;
  if (options.dem_ranks != usual.dem_ranks)
    line += fmt::format(" --dem-ranks {}", options.dem_ranks);
  if (options.gas_ranks != usual.gas_ranks)
    line += fmt::format(" --gas-ranks {}", options.gas_ranks);
  return line;
}

void check_scene(const StudyOptions& options) {
  RunOptions run;
  run.scene = options.scene;
  run.gas_ranks = options.gas_ranks;
  run.dem_ranks = options.dem_ranks;
  const auto faults = scene_faults(run, find_programs());
  if (!faults.empty())
    fail("{} cannot be studied:\n  {}", options.scene.string(), fmt::join(faults, "\n  "));
}

StudyPoint twin_of(const StudyPoint& reference) {
  StudyPoint twin = reference;
  twin.name = study_twin;
  twin.settle_s += twin_settles_s;
  return twin;
}

const StudyPoint& reference_of(const StudyPoint& point, const Study& study) {
  for (const auto& other : study.points)
    if (other.name == point.reference) return other;
  return study.points.front();
}

// Figures of all repeats: their costs' median, the rest of the first. A reference has no errors.
void read_figures(const Study& study, const StudyOptions& options, const PointRunner& runner,
                  StudyRow& row) {
  const StudyPoint& reference = reference_of(row.point, study);
  std::vector<double> costs;
  for (int repeat = options.repeats; repeat >= 1; --repeat) {
    row.figures = {};
    if (row.point.name != reference.name)
      add_trace_errors(runner.results(row.point, repeat) / "history.csv",
                       runner.results(reference) / "history.csv", row.figures);
    add_point_figures(runner.results(row.point, repeat), row.figures);
    costs.push_back(row.figures.get(study_cost));
  }
  const auto middle = costs.begin() + static_cast<long>(costs.size() / 2);
  std::nth_element(costs.begin(), middle, costs.end());
  row.figures.set(study_cost, *middle);
  if (study.add_figures) study.add_figures(row.point, runner.results(row.point), row.figures);
}

// How many times as fast as its reference a point is.
void set_speed_up(const Study& study, const std::vector<StudyRow>& rows, StudyRow& row) {
  const StudyRow* reference = row_of(rows, reference_of(row.point, study).name);
  if (reference != nullptr && reference != &row)
    row.figures.set("speed_up", reference->figures.get(study_cost) / row.figures.get(study_cost));
}

std::string told(const Study& study, const StudyRow& row, std::size_t n, std::size_t all) {
  const std::string head = fmt::format("{} of {}  {}", n + 1, all, row.point.name);
  if (!row.ok()) return fmt::format("{}  FAILED: {}", head, row.status);
  const double error = row.figures.get(study.error);
  return fmt::format("{}  {}, {:.3g} s/s", head,
                     std::isfinite(error) ? fmt::format("{} {:.2g}", study.error, error)
                                          : std::string("reference"),
                     row.figures.get(study_cost));
}

void draw(const fs::path& folder) {
  constexpr std::chrono::seconds limit{120};
  const Captured plot =
      run_captured({{"/usr/bin/python3", GASGRAIN_STUDY_PLOT, folder}, folder, {}}, limit);
  if (!plot.in_time || plot.status != 0)
    fmt::print(stderr, "gasgrain: warning: the picture could not be made:\n{}\n", plot.output);
}

std::vector<std::string> all_findings(const Study& study, std::vector<StudyRow> rows) {
  double chance = 0.0;
  if (const StudyRow* twin = row_of(rows, study_twin)) chance = twin->figures.get(study.error);
  rows.erase(std::remove_if(rows.begin(), rows.end(),
                            [](const StudyRow& row) { return row.point.name == study_twin; }),
             rows.end());
  auto findings = study.findings(rows, chance);
  if (chance > 0.0 && study.error_is_of_the_bed)
    findings.push_back(fmt::format(
        "Two runs that ought to be equal (the reference from a bed packed {:g} ms longer) differ "
        "by {} {:.2g}: smaller differences are chance.",
        1e3 * twin_settles_s, study.error, chance));
  return findings;
}

}  // namespace

std::vector<std::pair<std::string, std::string>> study_kinds() {
  std::vector<std::pair<std::string, std::string>> kinds;
  for (const StudyKind& kind : all_study_kinds()) kinds.emplace_back(kind.name, kind.text);
  return kinds;
}

int study(const StudyOptions& options) {
  catch_stop_requests();
  const StudyKind& kind = kind_of(options.kind);
  check_scene(options);
  const fs::path folder = study_folder(options);
  const fs::path points = folder / "points";
  const SceneCopy scene(options.scene, folder / "scene");
  const Study plan = kind.plan(scene, options);
  PointRunner runner(options, options.time_s.value_or(options.quick ? quick_time_s : full_time_s),
                     points);
  fmt::print("{}: {} points of {:g} s, into {}\n", command_line(options), plan.points.size(),
             runner.time_s(), folder.string());

  std::vector<StudyRow> rows;
  for (const auto& point : plan.points) rows.push_back({point, "", {}, false});
  const bool packs = scene.has_variable("packed") && scene.has_variable("packing");
  if (packs) rows.insert(rows.begin() + 1, {twin_of(plan.points.front()), "", {}, false});
  double expected = packs ? packing_cost : 0.0;
  for (const auto& row : rows) expected += row.point.expected_cost;

  StudyProgress progress(expected);
  const auto look = [&progress](double share) { progress.look(share); };
  if (packs) {
    progress.begin("packing the bed", packing_cost, false);
    const bool packed = runner.pack(plan.packing, look);
    progress.end(packed ? "the bed is packed" : "stopped");
    if (!packed) return stopped_status;
  }
  for (std::size_t n = 0; n < rows.size(); ++n) {
    StudyRow& row = rows[n];
    progress.begin(fmt::format("{} of {}  {}", n + 1, rows.size(), row.point.name),
                   row.point.expected_cost, runner.is_done(row.point));
    row.status = runner.run(row.point, look);
    if (row.status.empty()) break;
    try {
      if (row.ok()) read_figures(plan, options, runner, row);
      if (row.ok()) set_speed_up(plan, rows, row);
    } catch (const Error& e) {
      row.status = e.what();
      row.figures = {};
    }
    if (stop_requests() > 0) break;
    mark_pareto_front(rows, study_cost, plan.error);
    write_study(folder, plan, rows, command_line(options), {});
    progress.end(told(plan, row, n, rows.size()));
  }
  if (stop_requests() > 0) {
    fmt::print("\nstopped; the same command goes on from here\n");
    return stopped_status;
  }
  const auto findings = all_findings(plan, rows);
  write_study(folder, plan, rows, command_line(options), findings);
  fmt::print("\n{}\n{}\nErrors: {}.\n", fmt::join(findings, "\n"), short_table(plan, rows),
             plan.reference_text);
  if (!options.no_plots) draw(folder);
  fmt::print("Results:\n");
  for (const char* name : {"study.csv", "study.md", "study.png"})
    if (fs::exists(folder / name)) fmt::print("  {}\n", (folder / name).string());
  const auto good =
      std::count_if(rows.begin(), rows.end(), [](const auto& row) { return row.ok(); });
  if (!rows.front().ok() || good < 2)
    fail("{} of {} points ran; the reference {}.", good, rows.size(),
         rows.front().ok() ? "did" : "did not, so that there are no errors to compare");
  return 0;
}

}  // namespace gasgrain
