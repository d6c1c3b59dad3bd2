#include "tools/analyse/grain_dumps.h"

#include <algorithm>
#include <map>
#include <optional>
#include <regex>

#include "coupling/base/error.h"
#include "tools/analyse/vtk_grains.h"

namespace gasgrain {

namespace fs = std::filesystem;

namespace {

using Series = std::map<std::string, std::vector<std::pair<long, fs::path>>>;

// Files of dumps by their pattern. p_boundingBox_*.vtk goes with p_*.vtk and has no grains.
Series series_in(const fs::path& folder) {
  static const std::regex of_step(R"((.*?)(\d+)(\.(?:dump|txt|vtk)))");
  static const std::regex of_all(R"(.*\.(?:dump|txt))");
  Series found;
  if (!fs::is_directory(folder)) return found;
  for (const auto& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename();
    std::smatch parts;
    if (name.find("boundingBox") != std::string::npos) continue;
    if (std::regex_match(name, parts, of_step))
      found[parts[1].str() + "*" + parts[3].str()].emplace_back(std::stol(parts[2]), entry.path());
    else if (std::regex_match(name, of_all))
      found[name].emplace_back(0, entry.path());
  }
  for (auto& [pattern, files] : found) std::sort(files.begin(), files.end());
  return found;
}

std::vector<std::string> names_of(const Series& series) {
  std::vector<std::string> names;
  for (const auto& one : series) names.push_back(one.first);
  return names;
}

}  // namespace

GrainDumps::GrainDumps(const fs::path& place, const std::string& pattern) {
  if (fs::is_regular_file(place)) {
    name_ = place.filename();
    files_ = {{0, place}};
    return;
  }
  const fs::path folder = place / "particles";
  const Series series = series_in(folder);
  if (series.empty())
    fail(
        "{} has no dumps (*.dump, *.txt, *.vtk). The script must write them, for example\n"
        "  dump grains all custom 1000 ${{out}}/particles/grains.*.dump id type x y z vx vy vz "
        "radius f_mean[1] f_mean[2] f_mean[3]",
        folder.string());
  if (pattern.empty() && series.size() > 1) {
    std::string all;
    for (const auto& name : names_of(series)) all += "\n  --dump \"" + name + '"';
    fail("{} has several dumps. Choose:{}", folder.string(), all);
  }
  const auto chosen = pattern.empty() ? series.begin() : series.find(pattern);
  if (chosen == series.end())
    fail("--dump: {} has no \"{}\".{}", folder.string(), pattern,
         suggestion(pattern, names_of(series)));
  name_ = chosen->first;
  files_ = chosen->second;
}

void GrainDumps::each(const std::function<void(const DumpFrame& frame)>& look) const {
  std::optional<long> last;
  const auto take = [&](const DumpFrame& frame) {
    if (last && frame.step() <= *last)
      fail("{}: step {} comes after step {}: the dumps are of more than one run.", name_,
           frame.step(), *last);
    last = frame.step();
    look(frame);
  };
  for (const auto& [step, file] : files_)
    if (file.extension() == ".vtk")
      take(read_vtk_grains(file, step));
    else
      for (const auto& frame : read_dump(file)) take(frame);
}

}  // namespace gasgrain
