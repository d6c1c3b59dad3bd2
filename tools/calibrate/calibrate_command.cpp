#include "tools/calibrate/calibrate_command.h"

#include "coupling/base/error.h"
#include "tools/calibrate/calibrate_report.h"
#include "tools/calibrate/calibrate_text.h"
#include "tools/calibrate/scene_runs.h"
#include "tools/child_process.h"
#include "tools/programs.h"
#include "tools/progress_text.h"
#include "tools/scene_check.h"
#include "tools/stop_request.h"

namespace gasgrain {

namespace fs = std::filesystem;

namespace {

constexpr const char* result_files[] = {"calibrated.txt", "calibration.csv", "calibration.json",
                                        "calibration.png"};
constexpr int not_met_status = 2;
constexpr int stopped_status = 130;  // what shells report after Ctrl-C

fs::path calibration_folder(const CalibrateOptions& options) {
  if (!options.out.empty()) return fs::absolute(options.out).lexically_normal();
  const fs::path scene = (fs::absolute(options.scene) / ".").lexically_normal().parent_path();
  return fs::absolute("results") / "calibrate" / scene.filename();
}

// The line that makes the calibration again.
std::string command_line(const CalibrateOptions& options) {
  const CalibrateOptions usual;
  std::string line = fmt::format("gasgrain calibrate {}", options.scene.string());
  for (const auto& target : options.targets) line += " --target " + target;
  for (const auto& tolerance : options.tolerances) line += " --tolerance " + tolerance;
  for (const auto& varied : options.varied) line += " --vary " + varied;
  if (options.seeds) line += fmt::format(" --seeds {}", *options.seeds);
  if (options.quick) line += " --quick";
  if (options.jobs != usual.jobs) line += fmt::format(" --jobs {}", options.jobs);
  if (options.dem_ranks != usual.dem_ranks)
    line += fmt::format(" --dem-ranks {}", options.dem_ranks);
  return line;
}

std::vector<std::string> faults_of_scene(const CalibrateOptions& options) {
  require_scene(options.scene);
  RunOptions run;
  run.scene = options.scene;
  return scene_faults(run, find_programs());
}

// Makes the folder; results of an earlier calibration there, of another request it may be, are
// removed, but for its runs.
void prepare(const fs::path& folder) {
  std::error_code failed;
  fs::create_directories(folder, failed);
  for (const char* name : result_files)
    if (!failed) fs::remove(folder / name, failed);
  if (failed)
    fail("{} cannot be written: {}. Choose another folder: --out DIR", folder.string(),
         failed.message());
}

void draw(const fs::path& folder) {
  constexpr std::chrono::seconds limit{120};
  const Captured plot =
      run_captured({{"/usr/bin/python3", GASGRAIN_CALIBRATE_PLOT, folder}, folder, {}}, limit);
  if (!plot.in_time || plot.status != 0)
    fmt::print(stderr, "gasgrain: warning: the picture could not be made:\n{}\n", plot.output);
}

}  // namespace

int calibrate(const CalibrateOptions& options) {
  catch_stop_requests();
  const CalibrationProblem problem = calibration_problem(options, faults_of_scene(options));
  const fs::path folder = calibration_folder(options);
  const std::string command = command_line(options);
  prepare(folder);
  SceneRuns runs(options, problem, folder / "runs");
  fmt::print("{}\ninto {}\n", command, folder.string());
  std::fflush(stdout);

  Objective objective(
      problem, [&](const auto& requests) { return runs.perform(requests); },
      [&](int number, const auto& point, const auto& all) {
        fmt::print("{}\n", point_text(problem, number, point));
        std::fflush(stdout);
        write_runs(folder, problem, all);
      });
  Calibration result;
  try {
    result = refine(objective, search(objective));
  } catch (const CalibrationStopped&) {
    fmt::print("\nstopped; the same command goes on from here\n");
    return stopped_status;
  }
  write_result(folder, command, options.scene, objective, result);
  double run_s = 0.0;
  for (const auto& run : objective.runs()) run_s += run.outcome.wall_s;
  fmt::print("\n{} runs, {} of running\n", objective.runs().size(), clock_text(run_s));
  std::fflush(stdout);
  fmt::print(result.met ? stdout : stderr, "{}{}",
             result.met ? "" : "gasgrain: error: ", result_text(objective, result));
  if (!options.no_plots) draw(folder);
  fmt::print("Results:\n");
  for (const char* name : result_files)
    if (fs::exists(folder / name)) fmt::print("  {}\n", (folder / name).string());
  return result.met ? 0 : not_met_status;
}

}  // namespace gasgrain
