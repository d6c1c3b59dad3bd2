#include "tools/calibrate/scene_dials.h"

#include <algorithm>
#include <fstream>
#include <sstream>

#include "coupling/base/error.h"

namespace gasgrain {

namespace fs = std::filesystem;

std::map<std::string, std::string> scene_dials(const fs::path& scene) {
  std::ifstream script(scene / "in.liggghts");
  if (!script) fail("{} is absent or cannot be read.", (scene / "in.liggghts").string());
  std::map<std::string, std::string> dials;
  for (std::string line; std::getline(script, line);) {
    std::istringstream words(line.substr(0, line.find('#')));
    std::string verb;
    std::string name;
    std::string style;
    std::string value;
    if (words >> verb >> name >> style >> value && verb == "variable" && style == "index")
      dials.emplace(name, value);  // as the host does: a later line does not set it again
  }
  return dials;
}

std::string scene_state(const fs::path& scene) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(scene))
    if (entry.is_regular_file()) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  std::ostringstream text;
  for (const auto& file : files)
    text << file.filename() << '\n' << std::ifstream(file, std::ios::binary).rdbuf() << '\n';
  return text.str();
}

}  // namespace gasgrain
