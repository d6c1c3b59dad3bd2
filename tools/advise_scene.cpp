#include "tools/advise_scene.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "coupling/base/error.h"
#include "coupling/exchange/sphere.h"

namespace gasgrain {

namespace fs = std::filesystem;

namespace {

struct Block {
  Vec3 lo = Vec3::Zero();
  Vec3 hi = Vec3::Zero();
  [[nodiscard]] double volume() const { return (hi - lo).prod(); }
};

struct Template {
  double largest = 0.0;  // diameters [m]
  double smallest = 0.0;
  double density = 0.0;
};

// Number and mass of what has one size.
struct Lot {
  Template kind;
  double mass_share = 1.0;
};

class SceneReader {
 public:
  SceneReader(AdviseScene& scene, std::vector<std::string>& faults)
      : scene_(scene), faults_(faults) {}

  void read() {
    for (const ScriptCommand& command : scene_.script.commands()) {
      here_ = &command;
      const std::string& verb = command.words[0];
      if (verb == "fix")
        read_fix();
      else if (verb == "region")
        read_region();
      else if (verb == "create_box")
        box_ = region(word(2));
      else if (verb == "lattice")
        read_lattice();
      else if (verb == "create_atoms")
        read_create();
      else if (verb == "set")
        read_set();
      else if (verb == "timestep")
        scene_.dt = number(1);
      else if (verb == "pair_style" && word(1) == "gran")
        read_pair();
    }
    finish();
  }

 private:
  template <class... Args>
  void fault(fmt::format_string<Args...> text, Args&&... args) {
    faults_.push_back(here_->place() + ": " + fmt::format(text, std::forward<Args>(args)...));
  }
  [[nodiscard]] std::string word(std::size_t n) const {
    return n < here_->words.size() ? here_->words[n] : "";
  }
  double number_of(const std::string& text, const std::string& what) {
    char* end = nullptr;
    const double value = std::strtod(text.c_str(), &end);
    if (!text.empty() && *end == '\0') return value;
    fault("{} must be a number, found \"{}\".", what, text);
    return 0.0;
  }
  double number(std::size_t n) {
    return number_of(word(n), fmt::format("word {} of {}", n + 1, word(0)));
  }
  double number_after(const std::string& key) { return number_of(here_->after(key), key); }
  [[nodiscard]] bool has(const std::string& key) const {
    return std::find(here_->words.begin(), here_->words.end(), key) != here_->words.end();
  }

  void read_region() {
    if (word(2) == "block") {
      Block block;
      for (int d = 0; d < 3; ++d) {
        block.lo[d] = word(3 + 2 * d) == "INF" ? box_.lo[d] : number(3 + 2 * d);
        block.hi[d] = word(4 + 2 * d) == "INF" ? box_.hi[d] : number(4 + 2 * d);
      }
      regions_[word(1)] = block;
    } else if (word(2) == "cylinder") {
      // As the box about it, of the cylinder's volume along the other axes.
      const int axis = word(3) == "x" ? 0 : (word(3) == "y" ? 1 : 2);
      const double half = 0.5 * std::sqrt(pi) * number(6);
      Block block;
      for (int d = 0, n = 4; d < 3; ++d) {
        if (d == axis) continue;
        const double centre = number(n++);
        block.lo[d] = centre - half;
        block.hi[d] = centre + half;
      }
      block.lo[axis] = word(7) == "INF" ? box_.lo[axis] : number(7);
      block.hi[axis] = word(8) == "INF" ? box_.hi[axis] : number(8);
      regions_[word(1)] = block;
    }
  }
  Block region(const std::string& name) {
    if (name == "box") return regions_.count(name) > 0 ? regions_[name] : box_;
    if (regions_.count(name) > 0) return regions_[name];
    fault("the region \"{}\" is not a block or cylinder that stands above.", name);
    return {};
  }

  void read_lattice() {
    const std::map<std::string, double> in_cell{{"sc", 1.0}, {"bcc", 2.0}, {"fcc", 4.0}};
    const auto found = in_cell.find(word(1));
    if (found != in_cell.end()) sites_ = found->second / std::pow(number(2), 3);
  }
  void read_create() {
    const std::string& how = word(2);
    if (how == "single") {
      scene_.grains.count += 1.0;
      scene_.grains.top = std::max(scene_.grains.top, number(5));
    } else if (how == "random") {
      scene_.grains.count += number(3);
    } else {
      const Block block = region(how == "region" ? word(3) : "box");
      scene_.grains.count += std::floor(sites_ * block.volume() + 0.5);
      scene_.grains.top = std::max(scene_.grains.top, block.hi[2]);
    }
  }
  void read_set() {
    if (!has("diameter") && !has("density")) return;
    Template kind;
    if (has("diameter")) kind.largest = kind.smallest = number_after("diameter");
    if (has("density")) kind.density = number_after("density");
    sets_.push_back(kind);
  }

  void read_fix() {
    const std::string& style = word(3);
    if (style == "property/global")
      read_property();
    else if (style == "gravity")
      scene_.gravity = std::abs(number(4));
    else if (style == "particletemplate/sphere")
      read_template();
    else if (style == "particledistribution/discrete")
      read_distribution();
    else if (style.rfind("insert/", 0) == 0)
      read_insertion();
    else if (style == "couple/gas")
      read_couple();
    else if (style.rfind("nve", 0) == 0 || style.rfind("nvt", 0) == 0) {
      scene_.moves = true;
      scene_.rotates = style.find("sphere") != std::string::npos;
    }
  }

  // Of all types and pairs the one that asks for most.
  void read_property() {
    const std::string& name = word(4);
    std::size_t first = 6;                        // after scalar, vector, peratomtype
    if (word(5) == "peratomtypepair") first = 7;  // after the number of types
    std::vector<double> values;
    Contacts& contacts = scene_.contacts;
    if (name == "youngsModulus" || name == "poissonsRatio" || name == "coefficientRestitution" ||
        name == "coefficientFriction" || name == "characteristicVelocity")
      for (std::size_t n = first; n < here_->words.size(); ++n) values.push_back(number(n));
    if (values.empty()) return;
    const double least = *std::min_element(values.begin(), values.end());
    const double most = *std::max_element(values.begin(), values.end());
    if (name == "youngsModulus") contacts.youngs = most;
    if (name == "poissonsRatio") contacts.poisson = most;
    if (name == "coefficientRestitution") contacts.restitution = least;
    if (name == "coefficientFriction") contacts.friction = most;
    if (name == "characteristicVelocity") contacts.characteristic_velocity = most;
  }

  void read_pair() {
    Contacts& contacts = scene_.contacts;
    contacts.normal = here_->after("model");
    contacts.tangential = here_->after("tangential");
    if (contacts.tangential == "off") contacts.tangential.clear();
    contacts.cohesion = has("cohesion") && here_->after("cohesion") != "off";
  }

  void read_template() {
    Template kind;
    for (std::size_t n = 5; n + 2 < here_->words.size(); ++n) {
      if (word(n) == "density") kind.density = number(n + 2);
      if (word(n) != "radius") continue;
      kind.smallest = kind.largest = 2.0 * number(n + 2);
      if (word(n + 1) == "uniform") kind.largest = 2.0 * number(n + 3);
      if (word(n + 1) == "gaussian") {
        kind.smallest = 2.0 * std::max(0.0, number(n + 2) - 2.0 * number(n + 3));
        kind.largest = 2.0 * (number(n + 2) + 2.0 * number(n + 3));
      }
    }
    templates_[word(1)] = kind;
  }
  // particledistribution/discrete SEED NUMBER (TEMPLATE SHARE) ..., shares of the mass
  void read_distribution() {
    for (std::size_t n = 6; n + 1 < here_->words.size(); n += 2) {
      if (templates_.count(word(n)) == 0)
        fault("the template \"{}\" does not stand above.", word(n));
      else
        lots_.push_back({templates_[word(n)], number(n + 1)});
    }
  }
  void read_insertion() {
    Grains& grains = scene_.grains;
    const std::string where = here_->after("region");
    Block block;
    if (!where.empty()) block = region(where);
    grains.top = std::max(grains.top, block.hi[2]);
    if (has("particles_in_region")) grains.count += number_after("particles_in_region");
    if (has("nparticles") && here_->after("nparticles") != "INF")
      grains.count += number_after("nparticles");
    if (has("volumefraction_region"))
      volume_put_in_ += number_after("volumefraction_region") * block.volume();
    for (std::size_t n = 4; n + 4 < here_->words.size(); ++n)
      if (word(n) == "vel" && word(n + 1) == "constant")
        grains.thrown = Vec3(number(n + 2), number(n + 3), number(n + 4)).norm();
  }

  void read_couple() {
    CoupleLine& couple = scene_.couple;
    couple.command = *here_;
    std::size_t n = 4;
    for (; n + 1 < here_->words.size(); n += 2) {
      const std::string& key = word(n);
      if (key == "every")
        couple.every = static_cast<int>(number(n + 1));
      else if (key == "mode")
        couple.mode = word(n + 1);
      else if (key != "start" && key != "output" && key != "gas" && key != "gas_restart")
        break;
    }
    couple.words.assign(here_->words.begin() + std::min(n, here_->words.size()),
                        here_->words.end());
    if (couple.every < 1) fault("couple/gas needs 'every N' before the effects.");
    try {
      couple.effects = parse_effects(couple.words, here_->place());
    } catch (const Error& e) {
      faults_.emplace_back(e.what());
    }
  }

  void finish() {
    Grains& grains = scene_.grains;
    if (lots_.empty())
      for (const auto& [name, kind] : templates_) lots_.push_back({kind, 1.0});
    if (lots_.empty())
      for (const Template& kind : sets_) lots_.push_back({kind, 1.0});
    double volume = 0.0;
    double mass = 0.0;
    double volume_by_diameter = 0.0;
    for (const Lot& lot : lots_) {
      if (lot.kind.largest <= 0.0 || lot.kind.density <= 0.0) continue;
      const double share = lot.mass_share / lot.kind.density;
      const double middle = 0.5 * (lot.kind.largest + lot.kind.smallest);
      grains.largest = std::max(grains.largest, lot.kind.largest);
      grains.smallest =
          grains.smallest == 0.0 ? lot.kind.smallest : std::min(grains.smallest, lot.kind.smallest);
      volume += share;
      mass += lot.mass_share;
      volume_by_diameter += share / middle;
    }
    const std::string script = (scene_.folder / "in.liggghts").string();
    if (volume == 0.0) {
      faults_.push_back(script +
                        ": no line says how large and dense grains are. Write 'fix ID all "
                        "particletemplate/sphere SEED atom_type 1 density constant RHO radius "
                        "constant R', or 'set group all diameter D density RHO'.");
    } else {
      grains.density = mass / volume;
      grains.sauter = volume / volume_by_diameter;
      grains.count += volume_put_in_ / sphere_volume(0.5 * grains.sauter);
    }
    if (scene_.dt <= 0.0) faults_.push_back(script + ": no 'timestep' line sets the DEM step.");
    if (scene_.couple.every == 0 && scene_.couple.command.words.empty())
      faults_.push_back(script +
                        ": no line couples the particles to the gas. Add one before the first run, "
                        "for example:\n  fix gas all couple/gas every 100 drag koch_hill "
                        "pressure_gradient");
  }

  AdviseScene& scene_;
  std::vector<std::string>& faults_;
  const ScriptCommand* here_ = nullptr;
  std::map<std::string, Block> regions_;
  std::map<std::string, Template> templates_;
  std::vector<Template> sets_;
  std::vector<Lot> lots_;
  Block box_;
  double sites_ = 0.0;          // of the lattice, per volume [1/m3]
  double volume_put_in_ = 0.0;  // [m3]
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
