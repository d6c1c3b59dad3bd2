#include "tools/calibrate/scene_runs.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>
#include <sstream>
#include <thread>

#include "coupling/base/error.h"
#include "tools/calibrate/measured.h"
#include "tools/calibrate/scene_dials.h"
#include "tools/calibrate/search.h"
#include "tools/child_process.h"
#include "tools/stop_request.h"

namespace gasgrain {

namespace fs = std::filesystem;
using std::chrono::steady_clock;

namespace {

std::string text_of_file(const fs::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

// What `gasgrain run` says went wrong: the lines after 'error:', up to where it tells of files.
std::string reason_of_failure(const std::string& output, int status) {
  const std::string mark = "gasgrain: error: ";
  const auto begin = output.find(mark);
  if (begin == std::string::npos) return fmt::format("it ended with status {}", status);
  std::string text = output.substr(begin + mark.size());
  text = text.substr(0, text.find("The whole output:"));
  return text.substr(0, text.find_last_not_of(" \n") + 1);
}

int open_log(const fs::path& file) {
  const int log = open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (log < 0) fail("{} cannot be written. Choose another folder: --out DIR", file.string());
  return log;
}

std::vector<std::string> names_of(const CalibrationProblem& problem) {
  std::vector<std::string> names;
  for (const auto& target : problem.targets) names.push_back(target.name);
  return names;
}

}  // namespace

struct SceneRuns::Running {
  std::size_t index;  // of the requests
  RunRequest request;
  fs::path results;
  fs::path log;
  std::unique_ptr<ChildProcess> child;
  steady_clock::time_point start = steady_clock::now();
};

SceneRuns::SceneRuns(CalibrateOptions options, CalibrationProblem problem, fs::path folder)
    : options_(std::move(options)), problem_(std::move(problem)), folder_(std::move(folder)) {
  state_ = fmt::format("{}\nquick {}, {} ranks\n", scene_state(options_.scene), options_.quick,
                       options_.dem_ranks);
  state_ = fmt::format("{:016x}", std::hash<std::string>()(state_));
  fs::create_directories(folder_);
}

std::string SceneRuns::name(const RunRequest& request) const {
  std::string text = values_text(problem_, request.values);
  if (problem_.has_seed) text += fmt::format(" seed={}", request.seed);
  return text;
}

fs::path SceneRuns::results(const RunRequest& request) const {
  std::string text = name(request);
  std::replace(text.begin(), text.end(), ' ', '_');  // a script's words end at a blank
  return folder_ / text;
}

bool SceneRuns::read_done(const RunRequest& request, RunOutcome& outcome) const {
  std::ifstream stream(results(request) / "calibration_run.json");
  const auto record = nlohmann::json::parse(stream, nullptr, false);
  if (!record.is_object() || record.value("scene", "") != state_) return false;
  outcome.wall_s = record.value("wall_s", 0.0);
  outcome.measured = measured_values(results(request) / "measured.csv", names_of(problem_));
  return true;
}

void SceneRuns::finish(const Running& run, RunOutcome& outcome) const {
  const int status = run.child->poll().value_or(1);
  if (status != 0)
    fail("the run with {} failed: {}\nWhat it said: {}", name(run.request),
         reason_of_failure(text_of_file(run.log), status), run.log.string());
  outcome.wall_s = std::chrono::duration<double>(steady_clock::now() - run.start).count();
  outcome.measured = measured_values(run.results / "measured.csv", names_of(problem_));
  std::ofstream(run.results / "calibration_run.json")
      << nlohmann::json{{"scene", state_}, {"wall_s", outcome.wall_s}}.dump() << "\n";
}

std::vector<RunOutcome> SceneRuns::perform(const std::vector<RunRequest>& requests) {
  std::vector<RunOutcome> outcomes(requests.size());
  std::vector<Running> running;
  std::size_t next = 0;
  const auto start = [&](std::size_t n) {
    const RunRequest& request = requests[n];
    if (read_done(request, outcomes[n])) return;
    const fs::path out = results(request);
    const fs::path said = out.string() + ".log";
    fs::remove_all(out);
    Command command{{fs::read_symlink("/proc/self/exe"), "run", options_.scene, "--out", out,
                     "--no-plots", "--dem-ranks", std::to_string(options_.dem_ranks)},
                    fs::current_path(),
                    {}};
    const auto set = [&](const std::string& variable, const std::string& value) {
      command.arguments.insert(command.arguments.end(),
                               {"--set", fmt::format("{}={}", variable, value)});
    };
    for (std::size_t i = 0; i < request.values.size(); ++i)
      set(problem_.parameters[i].name, value_text(request.values[i]));
    if (problem_.has_seed) set("seed", std::to_string(request.seed));
    if (options_.quick) set("quick", "1");
    const int log = open_log(said);
    running.push_back({n, request, out, said, std::make_unique<ChildProcess>(command, log)});
    close(log);
  };
  while (next < requests.size() || !running.empty()) {
    while (next < requests.size() && static_cast<int>(running.size()) < options_.jobs)
      start(next++);
    if (stop_requests() > 0) throw CalibrationStopped();
    for (auto run = running.begin(); run != running.end();) {
      if (run->child->poll()) {
        finish(*run, outcomes[run->index]);
        run = running.erase(run);
      } else {
        ++run;
      }
    }
    std::vector<std::string> names;
    for (const auto& run : running) names.push_back(name(run.request));
    progress_.look(names);
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
  progress_.clear();
  return outcomes;
}

}  // namespace gasgrain
