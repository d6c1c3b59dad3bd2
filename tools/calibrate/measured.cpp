#include "tools/calibrate/measured.h"

#include <fmt/ranges.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>

#include "coupling/base/error.h"

namespace gasgrain {

std::vector<double> measured_values(const std::filesystem::path& file,
                                    const std::vector<std::string>& names) {
  std::ifstream stream(file);
  if (!stream) fail("{} is absent: the run has measured nothing.", file.string());
  std::map<std::string, std::string> quantities;
  std::vector<std::string> known;
  std::string line;
  std::getline(stream, line);  // quantity,value,unit,uncertainty
  while (std::getline(stream, line)) {
    std::istringstream fields(line);
    std::string name;
    std::string value;
    if (!std::getline(fields, name, ',') || !std::getline(fields, value, ',')) continue;
    quantities[name] = value;
    known.push_back(name);
  }
  std::vector<double> values;
  std::vector<std::string> faults;
  for (const auto& name : names) {
    const auto found = quantities.find(name);
    char* end = nullptr;
    values.push_back(found == quantities.end() ? 0.0 : std::strtod(found->second.c_str(), &end));
    if (found == quantities.end())
      faults.push_back(
          fmt::format("\"{}\" is not measured by this scene.{}", name, suggestion(name, known)));
    else if (end == found->second.c_str() || !std::isfinite(values.back()))
      faults.push_back(fmt::format("{} is \"{}\", no finite number.", name, found->second));
  }
  if (!faults.empty()) fail("{}:\n  {}", file.string(), fmt::join(faults, "\n  "));
  return values;
}

}  // namespace gasgrain
