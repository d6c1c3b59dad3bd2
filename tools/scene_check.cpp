#include "tools/scene_check.h"

#include <fmt/format.h>

#include <fstream>
#include <map>
#include <sstream>

#include "coupling/base/error.h"
#include "tools/child_process.h"
#include "tools/failure.h"
#include "tools/results_folder.h"

namespace gasgrain {

namespace fs = std::filesystem;

namespace {

constexpr const char* coupling_style = "couple/gas";
constexpr std::chrono::seconds check_limit{10};

bool is_scene(const fs::path& folder) {
  return fs::is_regular_file(folder / "in.liggghts");
}

std::string absent_scene(const fs::path& scene) {
  const fs::path plain = (scene / ".").lexically_normal().parent_path();
  std::map<std::string, std::string> found;  // name: how to write it
  for (const fs::path& folder :
       {plain.parent_path(), fs::path("inputs"), fs::path(GASGRAIN_INPUTS)}) {
    const fs::path here = folder.empty() ? fs::path(".") : folder;
    if (!fs::is_directory(here)) continue;
    for (const auto& entry : fs::directory_iterator(here))
      if (is_scene(entry.path()))
        found.emplace(entry.path().filename(), (folder / entry.path().filename()).string());
  }
  std::vector<std::string> names;
  std::vector<std::string> paths;
  for (const auto& [name, path] : found) {
    names.push_back(name);
    paths.push_back(path);
  }
  const std::string nearest = nearest_name(plain.filename(), names);
  const std::string advice = !nearest.empty() ? fmt::format(" Did you mean \"{}\"?", found[nearest])
                             : paths.empty() ? " A scene is a folder with in.liggghts and gas.toml."
                                             : suggestion(plain.string(), paths);
  return fmt::format("{}: there is no such scene folder.{}", scene.string(), advice);
}

// Looks for the fix in one DEM script and in the files it includes.
struct CouplingSearch {
  bool found = false;
  std::vector<std::string> misspelt;

  void read(const fs::path& script, int depth = 0) {
    constexpr int deepest = 8;  // a script may include itself
    std::ifstream file(script);
    int number = 0;
    std::string command;
    for (std::string line; depth < deepest && std::getline(file, line);) {
      ++number;
      command += line.substr(0, line.find('#'));
      const auto last = command.find_last_not_of(" \t\r");
      if (last != std::string::npos && command[last] == '&') {
        command.replace(last, std::string::npos, " ");
        continue;
      }
      std::istringstream words(command);
      std::string verb;
      std::string id;
      std::string group;
      std::string style;
      words >> verb >> id >> group >> style;
      if (verb == "include") read(script.parent_path() / id, depth + 1);
      if (verb == "fix" && style == coupling_style) found = true;
      if (verb == "fix" && style.rfind("couple/", 0) == 0 && style != coupling_style &&
          !nearest_name(style, {coupling_style}).empty())
        misspelt.push_back(fmt::format("{}:{}: fix style \"{}\" is unknown.{}", script.string(),
                                       number, style, suggestion(style, {coupling_style})));
      command.clear();
    }
  }
};

void check_script(const fs::path& scene, std::vector<std::string>& faults) {
  const fs::path script = scene / "in.liggghts";
  if (!fs::is_regular_file(script)) {
    faults.push_back(
        fmt::format("{} is absent: it is the DEM side of the scene.", script.string()));
    return;
  }
  CouplingSearch search;
  search.read(script);
  if (search.found) return;
  faults.insert(faults.end(), search.misspelt.begin(), search.misspelt.end());
  if (search.misspelt.empty())
    faults.push_back(fmt::format(
        "{}: no line couples the particles to the gas. Add one before the first run, for example:\n"
        "  fix gas all {} every 100 drag koch_hill pressure_gradient",
        script.string(), coupling_style));
}

void check_gas(const RunOptions& options, const Programs& programs,
               std::vector<std::string>& faults) {
  const fs::path input = options.scene / "gas.toml";
  if (!fs::is_regular_file(input)) {
    faults.push_back(fmt::format("{} is absent: it is the gas side of the scene.", input.string()));
    return;
  }
  if (!is_executable(programs.gas)) return;
  const Command check{
      {programs.gas, "--check", "gas.toml", "--ranks", std::to_string(options.gas_ranks)},
      options.scene,
      {{"OMPI_MCA_btl_vader_single_copy_mechanism", "none"}}};
  const Captured answer = run_captured(check, check_limit);
  if (!answer.in_time) {
    faults.push_back(fmt::format("{}: its check did not end within {} s: {}", input.string(),
                                 check_limit.count(), shell_line(check)));
  } else if (answer.status != 0) {
    std::istringstream output(answer.output);
    faults.push_back(failure_reason(output, 0));
  }
}

void check_request(const RunOptions& options, std::vector<std::string>& faults) {
  const fs::path results = results_path(options);
  if (options.restart && !newest_checkpoint(results))
    faults.push_back(fmt::format(
        "{} holds no complete checkpoint (dem.STEP.restart and gas.STEP.h5 of one step). Leave out "
        "--restart to begin anew, or name the folder of the run to go on with: --out DIR",
        (results / "checkpoint").string()));
  for (const auto& variable : options.variables)
    for (const char* taken : {"out", "time", "restart"})
      if (variable.first == taken)
        faults.push_back(
            fmt::format("--var {0}: this variable is set by gasgrain. Use --{0} instead.", taken));
}

}  // namespace

std::vector<std::string> scene_faults(const RunOptions& options, const Programs& programs) {
  std::vector<std::string> faults = program_faults(programs);
  if (!fs::is_directory(options.scene)) {
    faults.push_back(absent_scene(options.scene));
    return faults;
  }
  check_script(options.scene, faults);
  check_gas(options, programs, faults);
  check_request(options, faults);
  return faults;
}

void require_scene(const fs::path& scene) {
  if (!fs::is_directory(scene)) throw Error(absent_scene(scene));
}

}  // namespace gasgrain
