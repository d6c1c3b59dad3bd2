#include "tools/study/point_run.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <thread>

#include "coupling/base/error.h"
#include "tools/child_process.h"
#include "tools/history.h"
#include "tools/scene_copy.h"
#include "tools/stop_request.h"
#include "tools/study/pair_style.h"

namespace gasgrain {

namespace fs = std::filesystem;
using nlohmann::json;

namespace {

constexpr const char* packed_file = "packed.restart";

std::string text_of_file(const fs::path& file) {
  std::ifstream stream(file);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

// The settings that the record of a finished point names; empty where there is no record.
std::string finished(const fs::path& record) {
  std::ifstream stream(record);
  const json done = json::parse(stream, nullptr, false);
  return done.is_object() ? done.value("settings", "") : "";
}

void write_finished(const fs::path& record, const std::string& settings) {
  std::ofstream(record) << json{{"settings", settings}}.dump() << "\n";
}

// What `gasgrain run` says went wrong: the lines after 'error:', up to where it tells of files.
std::string reason_of_failure(const std::string& output, int status) {
  const std::string mark = "gasgrain: error: ";
  const auto begin = output.find(mark);
  if (begin == std::string::npos) return fmt::format("ended with status {}", status);
  std::string text = output.substr(begin + mark.size());
  text = text.substr(0, text.find("The whole output:"));
  while (!text.empty() && std::isspace(static_cast<unsigned char>(text.back())) != 0)
    text.pop_back();
  return text;
}

// Share of the run that its files tell of.
class RunShare {
 public:
  explicit RunShare(const fs::path& results)
      : plan_file_(results / "run.json"), history_(results / "history.csv") {}
  double now() {
    history_.read_on();
    const auto first = history_.value(0, "time_s");
    const auto last = history_.last("time_s");
    const auto plan = read_run_plan(plan_file_);
    if (!first || !last || !plan) return 0.0;
    // A scene that packs writes its plan anew when the gas starts: the packing is one part of it.
    const double end = std::max(plan->time_end_s, 0.0);
    return end > *first ? std::clamp((*last - *first) / (end - *first), 0.0, 1.0) : 0.0;
  }

 private:
  fs::path plan_file_;
  History history_;
};

}  // namespace

PointRunner::PointRunner(StudyOptions options, double time_s, fs::path folder)
    : options_(std::move(options)), time_s_(time_s), folder_(std::move(folder)) {}

fs::path PointRunner::results(const StudyPoint& point, int repeat) const {
  return folder_ / point.name / fmt::format("run{}", repeat);
}

std::string PointRunner::prepare(const StudyPoint& point, bool packed) const {
  SceneCopy copy(options_.scene, folder_ / point.name / "scene");
  for (const auto& [name, value] : point.variables) copy.set_variable(name, value);
  if (!point.pair_style.empty()) set_pair_style(copy, options_.scene, point.pair_style);
  for (const auto& [key, value] : point.gas_keys)
    if (value == absent_table)
      copy.remove_gas_table(key);
    else
      copy.set_gas_key(key, value);
  if (packed) {
    copy.set_variable("packed", "1");
    copy.set_variable("packing", fmt::format("{:g}", point.settle_s));
    fs::copy_file(folder_ / packed_file, copy.folder() / packed_file,
                  fs::copy_options::overwrite_existing);
  }
  copy.write();
  return fmt::format("{} s, {} + {} ranks, {} runs\n{}", time_s_, point.dem_ranks, point.gas_ranks,
                     options_.repeats, copy.text());
}

std::string PointRunner::launch(const StudyPoint& point, const fs::path& results, double time_s,
                                const Look& look) const {
  const auto ranks = [](int own, int all) { return std::to_string(own > 0 ? own : all); };
  const Command command{{fs::read_symlink("/proc/self/exe"), "run", folder_ / point.name / "scene",
                         "--out", results, "--no-plots", "--time", fmt::format("{:g}", time_s),
                         "--dem-ranks", ranks(point.dem_ranks, options_.dem_ranks), "--gas-ranks",
                         ranks(point.gas_ranks, options_.gas_ranks)},
                        fs::current_path(),
                        {}};
  fs::remove_all(results);
  fs::create_directories(results.parent_path());
  const fs::path said = results.string() + ".log";
  const int output = open(said.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666);
  if (output < 0) fail("{} cannot be written. Choose another folder: --out DIR", said.string());
  RunShare share(results);
  ChildProcess child(command, output);
  close(output);
  constexpr std::chrono::milliseconds look_again{200};
  while (!child.poll() && stop_requests() == 0) {
    look(share.now());
    std::this_thread::sleep_for(look_again);
  }
  if (stop_requests() > 0) return "";
  child.kill_all();
  const int status = child.poll().value_or(1);
  return status == 0 ? "ok" : reason_of_failure(text_of_file(said), status);
}

bool PointRunner::pack(const Settings& variables, const Look& look) {
  const SceneCopy scene(options_.scene, folder_ / "packing" / "scene");
  begins_packed_ = scene.has_variable("packed") && scene.has_variable("packing");
  if (!begins_packed_) return true;
  StudyPoint packing;
  packing.name = "packing";
  packing.variables = variables;
  const std::string settings = prepare(packing, false);
  const fs::path record = folder_ / "packing" / "done.json";
  if (finished(record) == settings && fs::exists(folder_ / packed_file)) return true;
  // The shortest run with gas there is: the bed is what is wanted.
  const double interval = 1e-9;
  const std::string status = launch(packing, results(packing), interval, look);
  if (status.empty()) return false;
  const fs::path bed = results(packing) / packed_file;
  if (status != "ok") fail("the scene's bed could not be packed: {}", status);
  if (!fs::exists(bed))
    fail(
        "{}: the script has a variable 'packed', but its packing leaves no {}: add the line "
        "'write_restart ${{out}}/{}' after the packing.",
        scene.script_path(), bed.string(), packed_file);
  fs::copy_file(bed, folder_ / packed_file, fs::copy_options::overwrite_existing);
  write_finished(record, settings);
  return true;
}

bool PointRunner::is_done(const StudyPoint& point) const {
  return finished(folder_ / point.name / "done.json") == prepare(point, begins_packed_);
}

std::string PointRunner::run(const StudyPoint& point, const Look& look) {
  if (is_done(point)) return "ok";
  const std::string settings = prepare(point, begins_packed_);
  for (int repeat = 1; repeat <= options_.repeats; ++repeat) {
    const auto part = [&](double share) { look((repeat - 1 + share) / options_.repeats); };
    const std::string status = launch(point, results(point, repeat), time_s_, part);
    if (status != "ok") return status;
  }
  write_finished(folder_ / point.name / "done.json", settings);
  return "ok";
}

}  // namespace gasgrain
