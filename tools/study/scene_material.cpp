#include "tools/study/scene_material.h"

#include <cstdlib>
#include <optional>

#include "coupling/base/error.h"
#include "tools/dem_script.h"

namespace gasgrain {
namespace {

double number_in(const ScriptCommand& command, const std::string& word) {
  char* end = nullptr;
  const double value = std::strtod(word.c_str(), &end);
  if (word.empty() || *end != '\0')
    fail("{}: a number is expected instead of \"{}\": {}", command.place(), word, command.text);
  return value;
}

// `KEY constant VALUE`
std::string second_after(const ScriptCommand& command, const std::string& key) {
  for (std::size_t n = 0; n + 2 < command.words.size(); ++n)
    if (command.words[n] == key) return command.words[n + 2];
  return "";
}

// `fix ID all property/global NAME KIND ...`: the first value, of type 1 (on type 1).
class Properties {
 public:
  explicit Properties(const DemScript& script) : script_(script) {}

  double operator()(const std::string& name, const char* line) const {
    if (const auto value = if_any(name)) return *value;
    fail("{}: this study needs the line\n  {}", script_.commands().front().file, line);
  }

  [[nodiscard]] std::optional<double> if_any(const std::string& name) const {
    for (const auto& command : script_.commands()) {
      if (command.words.front() != "fix" || command.after("property/global") != name) continue;
      // NAME peratomtypepair TYPES VALUE..., NAME peratomtype VALUE..., NAME scalar VALUE
      const std::size_t place = command.after(name) == "peratomtypepair" ? 7 : 6;
      return number_in(command, place < command.words.size() ? command.words[place] : "");
    }
    return std::nullopt;
  }

 private:
  const DemScript& script_;
};

}  // namespace

GrainMaterial scene_material(const std::filesystem::path& scene) {
  const DemScript script(scene / "in.liggghts");
  const Properties property(script);
  GrainMaterial grain;
  grain.youngs =
      property("youngsModulus", "fix youngs all property/global youngsModulus peratomtype VALUE");
  grain.poisson =
      property("poissonsRatio", "fix poisson all property/global poissonsRatio peratomtype VALUE");
  grain.restitution = property(
      "coefficientRestitution",
      "fix restitution all property/global coefficientRestitution peratomtypepair 1 VALUE");
  grain.friction =
      property("coefficientFriction",
               "fix friction all property/global coefficientFriction peratomtypepair 1 VALUE");
  if (const auto speed = property.if_any("characteristicVelocity"))
    grain.characteristic_velocity = *speed;
  for (const auto& command : script.commands()) {
    const bool is_template = command.words.front() == "fix" && command.words.size() > 3 &&
                             command.words[3].rfind("particletemplate/sphere", 0) == 0;
    const bool is_set = command.words.front() == "set";
    if (is_template && !command.after("radius").empty()) {
      grain.radius = number_in(command, second_after(command, "radius"));
      grain.density = number_in(command, second_after(command, "density"));
      break;
    }
    if (is_set && !command.after("diameter").empty()) {
      grain.radius = 0.5 * number_in(command, command.after("diameter"));
      if (!command.after("density").empty())
        grain.density = number_in(command, command.after("density"));
      break;
    }
  }
  if (grain.radius <= 0.0 || grain.density <= 0.0)
    fail(
        "{}: this study needs the grains' size and density, by 'fix ID all particletemplate/sphere "
        "... density constant VALUE radius constant VALUE' or 'set group all diameter VALUE "
        "density "
        "VALUE'.",
        (scene / "in.liggghts").string());
  return grain;
}

}  // namespace gasgrain
