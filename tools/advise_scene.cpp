#include "tools/advise_scene.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "coupling/base/error.h"
#include "tools/command_words.h"

namespace gasgrain {

namespace fs = std::filesystem;

namespace {

class SceneReader {
 public:
  SceneReader(AdviseScene& scene, std::vector<std::string>& faults)
      : scene_(scene), faults_(faults) {}

  void read() {
    GrainReader grains;
    for (const ScriptCommand& command : scene_.script.commands()) {
      grains.read(command, faults_);
      CommandWords words(command, faults_);
      const std::string verb = words.word(0);
      if (verb == "fix")
        read_fix(command, words);
      else if (verb == "timestep")
        scene_.dt = words.number(1);
      else if (verb == "pair_style" && words.word(1).rfind("gran", 0) == 0)
        read_pair(words);
    }
    scene_.grains = grains.grains();
    find_missing();
  }

 private:
  void read_fix(const ScriptCommand& command, CommandWords words) {
    const std::string style = words.word(3);
    if (style == "property/global") {
      read_property(words);
    } else if (style == "gravity") {
      scene_.gravity = std::abs(words.number(4));
    } else if (style == "couple/gas") {
      read_couple(command, words);
    } else if (style == "parcels") {
      scene_.moves = scene_.parcels = true;
    } else if (style.rfind("nve", 0) == 0) {
      scene_.moves = true;
      scene_.rotates = style.find("sphere") != std::string::npos;
    }
  }

  // Of all types and pairs the one that asks for most.
  void read_property(CommandWords words) {
    const std::string name = words.word(4);
    std::size_t first = 6;                              // after scalar, vector, peratomtype
    if (words.word(5) == "peratomtypepair") first = 7;  // after the number of types
    std::vector<double> values;
    Contacts& contacts = scene_.contacts;
    if (name == "youngsModulus" || name == "poissonsRatio" || name == "coefficientRestitution" ||
        name == "coefficientFriction" || name == "characteristicVelocity")
      for (std::size_t n = first; n < words.size(); ++n) values.push_back(words.number(n));
    if (values.empty()) return;
    const double least = *std::min_element(values.begin(), values.end());
    const double most = *std::max_element(values.begin(), values.end());
    if (name == "youngsModulus") contacts.youngs = most;
    if (name == "poissonsRatio") contacts.poisson = most;
    if (name == "coefficientRestitution") contacts.restitution = least;
    if (name == "coefficientFriction") contacts.friction = most;
    if (name == "characteristicVelocity") contacts.characteristic_velocity = most;
  }

  void read_pair(const CommandWords& words) {
    Contacts& contacts = scene_.contacts;
    contacts.normal = words.after("model");
    contacts.tangential = words.after("tangential");
    if (contacts.tangential == "off") contacts.tangential.clear();
    if (words.has("cohesion")) contacts.cohesion = words.after("cohesion");
    if (contacts.cohesion == "off") contacts.cohesion.clear();
  }

  void read_couple(const ScriptCommand& command, CommandWords words) {
    CoupleLine& couple = scene_.couple;
    couple.command = command;
    std::size_t n = 4;
    for (; n + 1 < words.size(); n += 2) {
      const std::string key = words.word(n);
      if (key == "every")
        couple.every = static_cast<int>(words.number(n + 1));
      else if (key == "mode")
        couple.mode = words.word(n + 1);
      else if (key != "start" && key != "output" && key != "gas" && key != "gas_restart")
        break;
    }
    const auto first = static_cast<std::ptrdiff_t>(std::min(n, words.size()));
    couple.words.assign(command.words.begin() + first, command.words.end());
    if (couple.every < 1) words.fault("couple/gas needs 'every N' before the effects.");
    try {
      couple.effects = parse_effects(couple.words, command.place());
    } catch (const Error& e) {
      faults_.emplace_back(e.what());
    }
  }

  void find_missing() {
    const std::string script = (scene_.folder / "in.liggghts").string();
    if (scene_.grains.density == 0.0)
      faults_.push_back(script +
                        ": no line says how large and dense grains are. Write 'fix ID all "
                        "particletemplate/sphere SEED atom_type 1 density constant RHO radius "
                        "constant R', or 'set group all diameter D density RHO'.");
    if (scene_.dt <= 0.0) faults_.push_back(script + ": no 'timestep' line sets the DEM step.");
    if (scene_.couple.command.words.empty())
      faults_.push_back(script +
                        ": no line couples the particles to the gas. Add one before the first run, "
                        "for example:\n  fix gas all couple/gas every 100 drag koch_hill "
                        "pressure_gradient");
  }

  AdviseScene& scene_;
  std::vector<std::string>& faults_;
};

}  // namespace

AdviseScene read_scene(const fs::path& folder,
                       const std::vector<std::pair<std::string, std::string>>& variables) {
  std::vector<std::string> faults;
  const auto gather = [&](auto&& action) {
    try {
      action();
    } catch (const Error& e) {
      faults.emplace_back(e.what());
    }
  };
  std::optional<DemScript> script;
  gather([&] { script.emplace(folder / "in.liggghts", variables); });
  GasInput gas;
  gather([&] { gas = read_gas_input((folder / "gas.toml").string(), false); });
  std::optional<AdviseScene> scene;
  if (script) {
    scene.emplace(AdviseScene{folder, std::move(*script), {}, {}, {}, 0.0, 0.0, false, false, gas});
    SceneReader(*scene, faults).read();
    // A bed that is held has its weight all the same: what effects are compared with.
    if (scene->gravity == 0.0) scene->gravity = gas.gravity.norm();
  }
  if (!faults.empty()) throw Error(fmt::format("{}", fmt::join(faults, "\n")));
  return std::move(*scene);
}

}  // namespace gasgrain
