#include "tools/advise_grains.h"

#include <cmath>

#include "coupling/exchange/sphere.h"

namespace gasgrain {

void GrainReader::read(const ScriptCommand& command, std::vector<std::string>& faults) {
  CommandWords words(command, faults);
  const std::string verb = words.word(0);
  const std::string style = verb == "fix" ? words.word(3) : "";
  if (verb == "region") {
    read_region(words);
  } else if (verb == "create_box") {
    box_ = region(words, words.word(2));
  } else if (verb == "lattice") {
    read_lattice(words);
  } else if (verb == "create_atoms") {
    read_create(words);
  } else if (verb == "set") {
    read_set(words);
  } else if (style == "particletemplate/sphere") {
    read_template(words);
  } else if (style == "particledistribution/discrete") {
    read_distribution(words);
  } else if (style == "parcels") {
    if (words.has("particles")) found_.of_a_parcel = words.number_after("particles");
  } else if (style == "parcels/inject") {
    read_feed(words);
  } else if (style.rfind("insert/", 0) == 0) {
    read_insertion(words);
  }
}

void GrainReader::read_region(CommandWords words) {
  Block block;
  if (words.word(2) == "block") {
    for (int d = 0; d < 3; ++d) {
      block.lo[d] = words.bound(3 + 2 * d, box_.lo[d]);
      block.hi[d] = words.bound(4 + 2 * d, box_.hi[d]);
    }
  } else if (words.word(2) == "cylinder") {
    // As a box of its volume and height.
    const int axis = words.word(3) == "x" ? 0 : (words.word(3) == "y" ? 1 : 2);
    const double half = 0.5 * std::sqrt(pi) * words.number(6);
    for (int d = 0, n = 4; d < 3; ++d) {
      if (d == axis) continue;
      const double centre = words.number(n++);
      block.lo[d] = centre - half;
      block.hi[d] = centre + half;
    }
    block.lo[axis] = words.bound(7, box_.lo[axis]);
    block.hi[axis] = words.bound(8, box_.hi[axis]);
  } else {
    return;
  }
  regions_[words.word(1)] = block;
}

GrainReader::Block GrainReader::region(CommandWords words, const std::string& name) const {
  const auto found = regions_.find(name);
  if (found != regions_.end()) return found->second;
  if (name != "box")
    words.fault("the region \"{}\" is not a block or cylinder that stands above.", name);
  return box_;
}

// `custom` with axes along those of the box: SCALE a1 X 0 0 a2 0 Y 0 a3 0 0 Z basis ...
void GrainReader::read_lattice(CommandWords words) {
  const std::map<std::string, double> in_cell{{"sc", 1.0}, {"bcc", 2.0}, {"fcc", 4.0}};
  const auto found = in_cell.find(words.word(1));
  if (found != in_cell.end()) sites_ = found->second / std::pow(words.number(2), 3);
  if (words.word(1) != "custom") return;
  double volume = std::pow(words.number(2), 3);
  double basis = 0.0;
  for (std::size_t n = 3; n + 3 < words.size(); ++n) {
    const std::string word = words.word(n);
    if (word == "basis") basis += 1.0;
    if (word.size() == 2 && word[0] == 'a' && word[1] >= '1' && word[1] <= '3')
      volume *= words.number(n + 1 + static_cast<std::size_t>(word[1] - '1'));
  }
  sites_ = basis / volume;
}

// Solids alone: droplets are no grains of the bed.
void GrainReader::read_feed(CommandWords words) {
  if (!words.has("solid") || words.after("size") != "constant") return;
  const double diameter = 2.0 * words.number_after("constant");
  of_sets_.push_back({diameter, diameter, words.number_after("solid")});
  found_.thrown = std::max(found_.thrown, words.number_after("speed"));
}

void GrainReader::read_create(CommandWords words) {
  const std::string how = words.word(2);
  if (how == "single") {
    found_.count += 1.0;
    found_.top = std::max(found_.top, words.number(5));
  } else if (how == "random") {
    found_.count += words.number(3);
  } else {
    const Block block = region(words, how == "region" ? words.word(3) : "box");
    found_.count += std::floor(sites_ * block.volume() + 0.5);
    found_.top = std::max(found_.top, block.hi[2]);
  }
}

// One line may have both, or one each.
void GrainReader::read_set(CommandWords words) {
  const double density = words.has("density") ? words.number_after("density") : 0.0;
  if (words.has("diameter")) {
    const double diameter = words.number_after("diameter");
    const double before = of_sets_.empty() ? 0.0 : of_sets_.back().density;
    of_sets_.push_back({diameter, diameter, density > 0.0 ? density : before});
  } else if (density > 0.0) {
    if (of_sets_.empty()) of_sets_.emplace_back();
    for (Kind& kind : of_sets_)
      if (kind.density == 0.0) kind.density = density;
  }
}

void GrainReader::read_template(CommandWords words) {
  Kind kind;
  for (std::size_t n = 5; n + 2 < words.size(); ++n) {
    if (words.word(n) == "density") kind.density = words.number(n + 2);
    if (words.word(n) != "radius") continue;
    kind.smallest = kind.largest = 2.0 * words.number(n + 2);
    if (words.word(n + 1) == "uniform") kind.largest = 2.0 * words.number(n + 3);
    if (words.word(n + 1) == "gaussian") {
      // Mean and standard deviation: two of these on either side.
      const double spread = 4.0 * words.number(n + 3);
      kind.smallest = std::max(0.1 * kind.largest, kind.largest - spread);
      kind.largest += spread;
    }
  }
  templates_[words.word(1)] = kind;
}

// particledistribution/discrete SEED NUMBER (TEMPLATE SHARE) ..., shares of the mass
void GrainReader::read_distribution(CommandWords words) {
  for (std::size_t n = 6; n + 1 < words.size(); n += 2) {
    const auto found = templates_.find(words.word(n));
    if (found == templates_.end()) {
      words.fault("the template \"{}\" does not stand above.", words.word(n));
      continue;
    }
    of_distributions_.push_back(found->second);
    of_distributions_.back().mass_share = words.number(n + 1);
  }
}

void GrainReader::read_insertion(CommandWords words) {
  Block block;
  if (words.has("region")) block = region(words, words.after("region"));
  found_.top = std::max(found_.top, block.hi[2]);
  if (words.has("particles_in_region")) found_.count += words.number_after("particles_in_region");
  if (words.has("nparticles") && words.after("nparticles") != "INF")
    found_.count += words.number_after("nparticles");
  if (words.has("volumefraction_region"))
    volume_put_in_ += words.number_after("volumefraction_region") * block.volume();
  for (std::size_t n = 4; n + 4 < words.size(); ++n)
    if (words.word(n) == "vel" && words.word(n + 1) == "constant")
      found_.thrown = Vec3(words.number(n + 2), words.number(n + 3), words.number(n + 4)).norm();
}

Grains GrainReader::grains() const {
  std::vector<Kind> kinds = of_distributions_;
  if (kinds.empty())
    for (const auto& [name, kind] : templates_) kinds.push_back(kind);
  if (kinds.empty()) kinds = of_sets_;
  Grains all = found_;
  double volume = 0.0;
  double mass = 0.0;
  double volume_by_diameter = 0.0;
  for (const Kind& kind : kinds) {
    if (kind.largest <= 0.0 || kind.density <= 0.0) continue;
    const double share = kind.mass_share / kind.density;
    all.largest = std::max(all.largest, kind.largest);
    all.smallest = all.smallest == 0.0 ? kind.smallest : std::min(all.smallest, kind.smallest);
    volume += share;
    mass += kind.mass_share;
    volume_by_diameter += share / (0.5 * (kind.largest + kind.smallest));
  }
  if (volume == 0.0) return all;
  all.density = mass / volume;
  all.sauter = volume / volume_by_diameter;
  all.count *= found_.of_a_parcel;
  all.count += volume_put_in_ / sphere_volume(0.5 * all.sauter);
  return all;
}

}  // namespace gasgrain
