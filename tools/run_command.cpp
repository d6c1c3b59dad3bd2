#include "tools/run_command.h"

#include <fmt/ranges.h>

#include <csignal>
#include <fstream>
#include <thread>

#include "coupling/base/error.h"
#include "tools/audit_summary.h"
#include "tools/failure.h"
#include "tools/launch.h"
#include "tools/ledger.h"
#include "tools/measure/measure_file.h"
#include "tools/progress.h"
#include "tools/progress_text.h"
#include "tools/results_folder.h"
#include "tools/scene_check.h"
#include "tools/script_scan.h"
#include "tools/script_steps.h"
#include "tools/stop_request.h"
#include "tools/summary.h"

namespace gasgrain {

namespace fs = std::filesystem;
using std::chrono::seconds;
using std::chrono::steady_clock;

namespace {

constexpr int stopped_status = 130;  // what shells report after Ctrl-C

// Escalates from a request to force: a signal a stage, the next when time is up or on Ctrl-C.
class Stopping {
 public:
  // Without checkpoints the first request already ends the run.
  explicit Stopping(bool checkpoints) : checkpoints_(checkpoints) {}
  void look(ChildProcess& launch, Progress& progress) {
    const bool asked = stop_requests() > seen_;
    if (!asked && (stage_ == 0 || steady_clock::now() < deadline_)) return;
    seen_ = stop_requests();
    progress.end_line();
    stage_ += stage_ == 0 && !checkpoints_ ? 2 : 1;
    constexpr seconds for_checkpoint{60};
    constexpr seconds for_end{10};
    if (stage_ == 1) {
      fmt::print("stopping: writing a checkpoint (Ctrl-C again ends the run at once)\n");
      launch.signal(SIGUSR1);  // mpirun hands it on to every rank
      deadline_ = steady_clock::now() + for_checkpoint;
    } else if (stage_ == 2) {
      fmt::print("stopping: ending the run{}\n",
                 checkpoints_ ? " without a further checkpoint" : "");
      launch.signal(SIGTERM);
      deadline_ = steady_clock::now() + for_end;
    } else {
      launch.kill_all();
    }
    std::fflush(stdout);
  }
  [[nodiscard]] bool begun() const { return stage_ > 0; }

 private:
  bool checkpoints_;
  int seen_ = stop_requests();
  int stage_ = 0;
  steady_clock::time_point deadline_;
};

std::string indented(const std::string& text) {
  std::string result = "  ";
  for (const char c : text) result += c == '\n' ? std::string("\n  ") : std::string(1, c);
  return result;
}

std::string restart_hint(const RunOptions& options, const fs::path& results) {
  const auto step = newest_checkpoint(results);
  if (!step) return "There is no complete checkpoint to go on from.";
  return fmt::format("Go on from the checkpoint at step {}:\n  {}", *step, restart_line(options));
}

void report_failure(const RunOptions& options, const ResultsFolder& results, int status) {
  std::ifstream log(results.file("run.log"));
  const std::string reason = failure_reason(log, dem_ranks(options), options.host);
  fmt::print(stderr,
             "gasgrain: error: the run failed with status {}:\n{}\n"
             "The whole output: {}\nThe results so far are readable: {}\n",
             status, indented(reason), results.file("run.log").string(), results.path().string());
  if (newest_checkpoint(results.path()))
    fmt::print(stderr, "{}\n", restart_hint(options, results.path()));
}

void draw_plots(const ResultsFolder& results, const char* script) {
  constexpr seconds limit{300};
  const Command command{{"/usr/bin/python3", script, results.path()}, results.path(), {}};
  const Captured plots = run_captured(command, limit);
  if (!plots.in_time)
    fmt::print(stderr, "gasgrain: warning: the plots were not done within {} s\n", limit.count());
  else if (plots.status != 0)
    fmt::print(stderr, "gasgrain: warning: not all plots could be made:\n{}\n",
               indented(plots.output));
}

// What the scene's measure.toml asks for, of a run that went well.
void measure(const RunOptions& options, const ResultsFolder& results) {
  const auto file = read_measure_file(options.scene);
  if (!file) return;
  try {
    const Measurement measured = file->measure(results.path());
    write_measurement(results.path(), file->kind, measured);
    fmt::print("Measured:\n{}", text_of(measured));
  } catch (const Error& e) {
    fail("the run went to its end, but nothing was measured ({}, kind \"{}\"):\n  {}",
         (options.scene / "measure.toml").string(), file->kind, e.what());
  }
  if (!options.no_plots) draw_plots(results, GASGRAIN_MEASURE_PLOT);
}

void finish_coupled(const RunOptions& options, const ResultsFolder& results, double wall_s,
                    const std::string& costs) {
  fmt::print("{}", summary(results.path(), wall_s, costs));
  if (const std::string wrong = complete_audit(options.scene, results.path()); !wrong.empty())
    fmt::print("Effects, of audit.txt:\n{}", wrong);
  if (!options.no_plots) draw_plots(results, GASGRAIN_REPORT_SCRIPT);
}

}  // namespace

int run(const RunOptions& options) {
  catch_stop_requests();
  const Programs programs = find_programs(options.host);
  const auto faults = scene_faults(options, programs);
  if (stop_requests() > 0) return stopped_status;
  if (!faults.empty())
    fail("{} cannot be run:\n{}", options.scene.string(),
         indented(fmt::format("{}", fmt::join(faults, "\n"))));

  const bool gas = !is_without_gas(options.scene, options.host);
  const ResultsFolder results(results_path(options), options.restart);
  const auto from = options.restart ? newest_checkpoint(results.path()) : std::nullopt;
  const Command command = launch_command(options, programs, results.path(), from);
  fmt::print("{}\n", shell_line(command));
  std::fflush(stdout);

  Progress progress(gas ? coupled_progress(results.path())
                        : grains_progress(results.file("run.log"), last_step(options)));
  Stopping stopping(gas);
  ChildProcess launch(command, results.log());
  constexpr std::chrono::milliseconds look_again{50};
  while (!launch.poll()) {
    stopping.look(launch, progress);
    progress.update();
    std::this_thread::sleep_for(look_again);
  }
  progress.end_line();
  launch.kill_all();
  const int status = launch.poll().value_or(1);
  const std::string costs = finish_ledger(results.path(), progress.wall_s());

  if (stopping.begun()) {
    fmt::print("stopped after {}\n{}{}\n", clock_text(progress.wall_s()), costs,
               gas ? restart_hint(options, results.path()) : "Nothing was measured.");
    return stopped_status;
  }
  if (status != 0) {
    report_failure(options, results, status);
    return status;
  }
  fmt::print("{} has run to its end\n", options.scene.string());
  if (gas)
    finish_coupled(options, results, progress.wall_s(), costs);
  else
    fmt::print("  {:<18}{}\n", "wall time", clock_text(progress.wall_s()));
  measure(options, results);
  fmt::print("Results:\n{}", made_files(results.path()));
  return 0;
}

}  // namespace gasgrain
