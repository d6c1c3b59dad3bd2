// Which effects a scene calls for: a row for every effect that the program knows.
#pragma once

#include <string>
#include <vector>

#include "tools/advise_places.h"

namespace gasgrain {

// Of an effect at a place.
struct SizeThere {
  double of_weight = 0.0;
  double of_drag = 0.0;
};

struct EffectRow {
  std::string name;
  std::string number_name;
  std::string threshold;
  double number = 0.0;           // where it is largest
  std::vector<SizeThere> sizes;  // at the places, in their order
  double share = 0.0;            // of the greater of weight and drag, where it is largest
  bool needed = false;           // at some place
  std::string now;               // on, off, or a choice's name
  std::string advised;
  std::string price;  // of having it on
  std::string note;   // why, where the size alone does not say it

  [[nodiscard]] bool agrees() const { return now == advised; }
};

std::vector<EffectRow> effect_rows(const AdviseScene& scene, const Places& places);

// What an effect costs where it is on, as measured (docs/effects.md has the commands).
std::string effect_price(const std::string& name);

}  // namespace gasgrain
