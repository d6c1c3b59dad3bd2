// What a script says of its grains: how large, how dense, how many, and where they are put in.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "coupling/base/vec3.h"
#include "tools/command_words.h"

namespace gasgrain {

struct Grains {
  double largest = 0.0;      // diameter [m]
  double smallest = 0.0;     // diameter [m]
  double sauter = 0.0;       // six times the volume of all over their surface [m]
  double density = 0.0;      // of the solid volume's mean [kg/m3]; 0: no line says
  double count = 0.0;        // 0: not known, as grains come in by a rate
  double top = 0.0;          // of what they are put into [m]
  double thrown = 0.0;       // speed of insertion [m/s]
  double of_a_parcel = 1.0;  // particles; 1: grains
};

// Takes the commands of a script in their order.
class GrainReader {
 public:
  void read(const ScriptCommand& command, std::vector<std::string>& faults);
  [[nodiscard]] Grains grains() const;

 private:
  struct Block {
    Vec3 lo = Vec3::Zero();
    Vec3 hi = Vec3::Zero();
    [[nodiscard]] double volume() const { return (hi - lo).prod(); }
  };
  struct Kind {
    double largest = 0.0;  // diameters [m]
    double smallest = 0.0;
    double density = 0.0;
    double mass_share = 1.0;
  };

  void read_region(CommandWords words);
  Block region(CommandWords words, const std::string& name) const;
  void read_lattice(CommandWords words);
  void read_create(CommandWords words);
  void read_feed(CommandWords words);
  void read_set(CommandWords words);
  void read_template(CommandWords words);
  void read_distribution(CommandWords words);
  void read_insertion(CommandWords words);

  Grains found_;
  std::map<std::string, Block> regions_;
  std::map<std::string, Kind> templates_;
  std::vector<Kind> of_distributions_;
  std::vector<Kind> of_sets_;
  Block box_;
  double sites_ = 0.0;          // of the lattice, per volume [1/m3]
  double volume_put_in_ = 0.0;  // [m3]
};

}  // namespace gasgrain
