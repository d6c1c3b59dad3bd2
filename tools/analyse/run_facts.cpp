#include "tools/analyse/run_facts.h"

#include <fmt/format.h>

#include "coupling/base/toml_input.h"
#include "tools/history.h"

namespace gasgrain {

namespace fs = std::filesystem;

namespace {

constexpr double absent = -1.0;  // every fact is positive or 0

RunFacts facts_of_file(const fs::path& folder) {
  RunFacts facts;
  facts.timestep_s = facts.restitution = facts.friction = facts.density = facts.density_big =
      absent;
  if (const auto plan = read_run_plan(folder / "run.json")) {
    facts.timestep_s = plan->dt_s;
    facts.first_step = plan->start_step;
  }
  const fs::path file = folder / "analyse.toml";
  if (!fs::exists(file)) return facts;
  TomlInput input(file);
  InputTable root = input.root();
  facts.timestep_s = root.number("timestep", facts.timestep_s, Range::positive(), "s");
  facts.restitution = root.number("restitution", absent, Range::within(0.0, 1.0), "1");
  facts.friction = root.number("friction", absent, Range::not_negative(), "1");
  facts.density = root.number("density", absent, Range::positive(), "kg/m3");
  facts.density_big = root.number("density_big", facts.density, Range::positive(), "kg/m3");
  facts.reach = root.number("reach", facts.reach, Range::positive(), "m");
  input.finish();
  return facts;
}

}  // namespace

RunFacts run_facts(const AnalyseOptions& options, std::vector<std::string>& faults) {
  const bool is_file = fs::is_regular_file(options.results);
  const fs::path folder = is_file ? options.results.parent_path() : options.results;
  RunFacts facts = facts_of_file(folder);
  const auto take = [&](double& fact, const std::optional<double>& given, const char* name,
                        const Range& range, const char* what) {
    if (given && !range.holds(*given))
      faults.push_back(fmt::format("--{} {:g} must be {}.", name, *given, range.text()));
    if (given) fact = *given;
    if (!given && fact == absent)
      faults.push_back(
          fmt::format("--{0} is missing: {1}. Give it, or let the script write '{0} = "
                      "...' into {2}",
                      name, what, (folder / "analyse.toml").string()));
  };
  take(facts.timestep_s, options.timestep_s, "timestep", Range::positive(), "the DEM step [s]");
  take(facts.restitution, options.restitution, "restitution", Range::within(0.0, 1.0),
       "the restitution of small on big");
  take(facts.friction, options.friction, "friction", Range::not_negative(),
       "the friction of small on big");
  take(facts.density, options.density, "density", Range::positive(), "of the small grains [kg/m3]");
  if (facts.density_big == absent || (options.density && !options.density_big))
    facts.density_big = facts.density;
  take(facts.density_big, options.density_big, "density-big", Range::positive(), "");
  return facts;
}

}  // namespace gasgrain
