#include "tools/scene_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <sstream>

#include "coupling/base/error.h"
#include "tools/child_process.h"
#include "tools/failure.h"
#include "tools/measure/measure_file.h"
#include "tools/results_folder.h"
#include "tools/script_scan.h"

namespace gasgrain {

namespace fs = std::filesystem;

namespace {

constexpr std::chrono::seconds check_limit{10};

bool is_scene(const fs::path& folder) {
  return fs::is_regular_file(script_of(folder, DemHost::liggghts)) ||
         fs::is_regular_file(script_of(folder, DemHost::lammps));
}

std::string absent_scene(const fs::path& scene) {
  const fs::path plain = (scene / ".").lexically_normal().parent_path();
  std::map<std::string, std::string> found;  // name: how to write it
  for (const fs::path& folder :
       {plain.parent_path(), fs::path("inputs"), fs::path("inputs/calibration"),
        fs::path(GASGRAIN_INPUTS), fs::path(GASGRAIN_INPUTS) / "calibration"}) {
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

void check_script(const RunOptions& options, std::vector<std::string>& faults) {
  const fs::path script = script_of(options.scene, options.host);
  if (!fs::is_regular_file(script)) {
    const DemHost other = options.host == DemHost::lammps ? DemHost::liggghts : DemHost::lammps;
    faults.push_back(fmt::format(
        "{} is absent: it is the DEM side of the scene.{}", script.string(),
        !fs::is_regular_file(script_of(options.scene, other)) ? ""
        : other == DemHost::lammps ? " The scene is written for LAMMPS: --host lammps"
                                   : " The scene is written for LIGGGHTS: leave out --host"));
    return;
  }
  if (is_without_gas(options.scene, options.host)) return;
  const ScriptScan scan(script);
  if (scan.couples) return;
  faults.insert(faults.end(), scan.misspelt.begin(), scan.misspelt.end());
  if (scan.misspelt.empty())
    faults.push_back(fmt::format(
        "{}: no line couples the particles to the gas. Add one before the first run, for example:\n"
        "  fix gas all {} every 100 drag koch_hill pressure_gradient\n"
        "or, for a scene of grains alone, take gas.toml away.",
        script.string(), ScriptScan::coupling_style));
}

void check_gas(const RunOptions& options, const Programs& programs,
               std::vector<std::string>& faults) {
  const fs::path input = options.scene / options.gas_input;
  if (!fs::is_regular_file(input)) {
    faults.push_back(fmt::format("{} is absent: it is the gas side of the scene.", input.string()));
    return;
  }
  if (!is_executable(programs.gas)) return;
  const Command check{
      {programs.gas, "--check", options.gas_input, "--ranks", std::to_string(options.gas_ranks)},
      options.scene,
      {{"OMPI_MCA_btl_vader_single_copy_mechanism", "none"}}};
  const Captured answer = run_captured(check, check_limit);
  if (!answer.in_time) {
    faults.push_back(fmt::format("{}: its check did not end within {} s: {}", input.string(),
                                 check_limit.count(), shell_line(check)));
  } else if (answer.status != 0) {
    std::istringstream output(answer.output);
    faults.push_back(failure_reason(output, 0, options.host));
  }
}

void check_variables(const RunOptions& options, std::vector<std::string>& faults) {
  const fs::path script = script_of(options.scene, options.host);
  const ScriptScan scan(script);
  const auto& known = scan.index_names;
  const auto is_known = [&](const std::string& name) {
    return std::find(known.begin(), known.end(), name) != known.end();
  };
  for (const auto& [name, value] : options.variables) {
    const std::vector<std::string> own{"out", "time", "restart"};
    if (std::find(own.begin(), own.end(), name) != own.end())
      faults.push_back(
          fmt::format("--var {0}: this variable is set by gasgrain. Use --{0} instead.", name));
    else if (fs::is_regular_file(script) && !is_known(name))
      faults.push_back(fmt::format("{}: no line 'variable {} index ...'.{}", script.string(), name,
                                   suggestion(name, known)));
  }
  if (options.time_s && is_without_gas(options.scene, options.host) && !is_known("time"))
    faults.push_back(
        fmt::format("--time: {} has no line 'variable time index ...': the scene's end is its own.",
                    script.string()));
}

void check_restart(const RunOptions& options, std::vector<std::string>& faults) {
  const fs::path results = results_path(options);
  if (options.restart && !newest_checkpoint(results))
    faults.push_back(fmt::format(
        "{} holds no complete checkpoint (dem.STEP.restart and gas.STEP.h5 of one step). Leave out "
        "--restart to begin anew, or name the folder of the run to go on with: --out DIR",
        (results / "checkpoint").string()));
}

// What is asked of a scene of grains alone that only a coupled one can give.
void check_without_gas(const RunOptions& options, std::vector<std::string>& faults) {
  const std::string scene = options.scene.string();
  if (options.gas_ranks_given)
    faults.push_back(fmt::format(
        "--gas-ranks: {} is a scene of grains alone, it has no gas.toml: there is no gas to be "
        "computed. Leave it out.",
        scene));
  if (options.restart)
    faults.push_back(fmt::format(
        "--restart: {} is a scene of grains alone, which is short and writes no checkpoints. Leave "
        "it out to begin anew.",
        scene));
}

void check_measure(const RunOptions& options, std::vector<std::string>& faults) {
  try {
    read_measure_file(options.scene);
  } catch (const Error& e) {
    faults.emplace_back(e.what());
  }
}

}  // namespace

std::vector<std::string> scene_faults(const RunOptions& options, const Programs& programs) {
  std::vector<std::string> faults =
      program_faults(programs, !is_without_gas(options.scene, options.host));
  if (!fs::is_directory(options.scene)) {
    faults.push_back(absent_scene(options.scene));
    return faults;
  }
  check_script(options, faults);
  if (is_without_gas(options.scene, options.host)) {
    check_without_gas(options, faults);
  } else {
    check_gas(options, programs, faults);
    check_restart(options, faults);
  }
  check_measure(options, faults);
  check_variables(options, faults);
  return faults;
}

void require_scene(const fs::path& scene) {
  if (!fs::is_directory(scene)) throw Error(absent_scene(scene));
}

}  // namespace gasgrain
