// What `gasgrain advise` knows of a scene: the numbers of its DEM script and of its gas.toml.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "coupling/exchange/effects.h"
#include "gas_solver/gas_input.h"
#include "tools/advise_grains.h"
#include "tools/dem_script.h"

namespace gasgrain {

struct Contacts {
  std::string normal;      // hertz, hooke, ...; empty: no granular pair style
  std::string tangential;  // "history", "no_history", or empty
  std::string cohesion;    // "bridge", "sjkr", ..., or empty
  double youngs = 0.0;     // [Pa]
  double poisson = 0.0;
  double restitution = 1.0;              // the least of all pairs
  double friction = 0.0;                 // the greatest
  double characteristic_velocity = 0.0;  // of hooke [m/s]
};

// The line that couples.
struct CoupleLine {
  ScriptCommand command;
  int every = 0;
  std::string mode = "in_turn";
  std::vector<std::string> words;  // of the effects
  Effects effects;
};

struct AdviseScene {
  std::filesystem::path folder;
  DemScript script;
  Grains grains;
  Contacts contacts;
  CoupleLine couple;
  double dt = 0.0;       // DEM step [s]
  double gravity = 0.0;  // [m/s2]
  bool rotates = false;  // an integrator that turns grains
  bool moves = false;    // an integrator at all
  GasInput gas;
  bool parcels = false;  // instead of grains

  [[nodiscard]] double interval() const { return couple.every * dt; }
};

// Throws one Error with all faults, a line each, each with its remedy.
AdviseScene read_scene(const std::filesystem::path& folder,
                       const std::vector<std::pair<std::string, std::string>>& variables);

}  // namespace gasgrain
