#include "tools/analyse/analyse_command.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <functional>
#include <optional>

#include "coupling/base/error.h"
#include "tools/analyse/drag_files.h"
#include "tools/analyse/drag_reading.h"
#include "tools/analyse/grain_dumps.h"
#include "tools/child_process.h"

namespace gasgrain {

namespace fs = std::filesystem;

namespace {

void check(const AnalyseOptions& options, std::vector<std::string>& faults) {
  for (const auto& word : options.unexpected)
    faults.push_back(word.rfind("--", 0) == 0
                         ? fmt::format("{} is unknown.{}", word, suggestion(word, options.known))
                         : fmt::format("\"{}\" was not expected.", word));
  if (!(options.window_s > 0.0))
    faults.push_back(fmt::format("--window {:g} must be a time above 0 [s].", options.window_s));
  std::vector<double> seen;
  for (const double size : options.sizes) {
    if (!(size > 0.0))
      faults.push_back(fmt::format("--sizes {:g} must be above 0 (1 is d_s + d_b).", size));
    if (std::find(seen.begin(), seen.end(), size) != seen.end())
      faults.push_back(fmt::format("--sizes {:g} is given twice.", size));
    seen.push_back(size);
  }
  if (!options.steady_s.empty() &&
      (options.steady_s.size() != 2 || !(options.steady_s[0] < options.steady_s[1])))
    faults.push_back("--steady must be two times [s], the first before the second.");
}

std::string nearest_sibling(const fs::path& place) {
  const fs::path folder = fs::absolute(place / ".").lexically_normal().parent_path().parent_path();
  std::vector<std::string> names;
  if (fs::is_directory(folder))
    for (const auto& entry : fs::directory_iterator(folder))
      if (entry.is_directory()) names.push_back(entry.path().filename());
  const std::string name = (place / ".").lexically_normal().parent_path().filename();
  const std::string near = nearest_name(name, names);
  return near.empty() ? "" : fmt::format(" Did you mean \"{}\"?", (folder / near).string());
}

std::string command_line(const AnalyseOptions& options) {
  const AnalyseOptions usual;
  std::string line = fmt::format("gasgrain analyse {}", options.results.string());
  if (!options.dump.empty()) line += fmt::format(" --dump \"{}\"", options.dump);
  if (options.big != usual.big) line += " --big " + options.big;
  if (!options.force.empty()) line += " --force " + options.force;
  if (options.window_s != usual.window_s) line += fmt::format(" --window {:g}", options.window_s);
  if (options.sizes != usual.sizes)
    line += fmt::format(" --sizes {}", fmt::join(options.sizes, " "));
  if (!options.steady_s.empty())
    line += fmt::format(" --steady {}", fmt::join(options.steady_s, " "));
  const auto add = [&line](const char* name, const std::optional<double>& value) {
    if (value) line += fmt::format(" --{} {:g}", name, *value);
  };
  add("timestep", options.timestep_s);
  add("restitution", options.restitution);
  add("friction", options.friction);
  add("density", options.density);
  add("density-big", options.density_big);
  return line;
}

void draw(const fs::path& folder) {
  constexpr std::chrono::seconds limit{120};
  const Captured plot =
      run_captured({{"/usr/bin/python3", GASGRAIN_ANALYSE_PLOT, folder}, folder, {}}, limit);
  if (!plot.in_time || plot.status != 0)
    fmt::print(stderr, "gasgrain: warning: the picture could not be made:\n{}\n", plot.output);
}

}  // namespace

int analyse(const AnalyseOptions& options) {
  std::vector<std::string> faults;
  check(options, faults);
  const BigGrains big(options.big, faults);
  RunFacts facts;
  std::optional<GrainDumps> dumps;
  if (!fs::exists(options.results)) {
    faults.push_back(
        fmt::format("{} is absent.{}", options.results.string(), nearest_sibling(options.results)));
  } else {
    for (const auto& read :
         {std::function<void()>([&] { facts = run_facts(options, faults); }),
          std::function<void()>([&] { dumps.emplace(options.results, options.dump); })}) {
      try {
        read();
      } catch (const Error& e) {
        faults.emplace_back(e.what());
      }
    }
  }
  if (!faults.empty())
    fail("{} cannot be analysed:\n  {}", options.results.string(), fmt::join(faults, "\n  "));

  DragReading reading(options, facts, big);
  dumps->each([&reading](const DumpFrame& frame) { reading.add(frame); });
  const auto rates = reading.rates().rates();
  const std::array<double, 2> steady =
      options.steady_s.empty() ? steady_period(rates, options.window_s)
                               : std::array<double, 2>{options.steady_s[0], options.steady_s[1]};
  const auto means = steady_drag(rates, steady);
  const std::string force = reading.force().text();

  fs::path folder = options.results;
  if (fs::is_regular_file(folder)) folder = fs::absolute(folder).parent_path();
  if (!options.out.empty()) folder = options.out;
  fs::create_directories(folder);
  folder = fs::canonical(folder);
  fs::remove(folder / "solid_drag.png");  // of an earlier analysis
  write_drag(folder, rates, means, {command_line(options), force, options.window_s, steady});
  fmt::print("{}: dumps {}, force {}\n", options.results.string(), dumps->name(), force);
  if (const long left = reading.rates().left_over(); left > 0)
    fmt::print("left out: {:g} s that fill no window\n",
               static_cast<double>(left) * facts.timestep_s);
  fmt::print("Means from {:.4g} to {:.4g} s, rates along the slip:\n{}", steady[0], steady[1],
             text_of(means));
  if (!options.no_plots) draw(folder);
  fmt::print("Results:\n");
  for (const char* name : {"solid_drag.csv", "solid_drag_windows.csv", "solid_drag.png"})
    if (fs::exists(folder / name)) fmt::print("  {}\n", (folder / name).string());
  return 0;
}

}  // namespace gasgrain
