// How the advice is shown: two tables for people, or JSON.
#pragma once

#include <string>
#include <vector>

#include "tools/advise_effects.h"
#include "tools/advise_numerics.h"

namespace gasgrain {

struct Advice {
  AdviseScene scene;
  Places places;
  std::vector<EffectRow> effects;
  std::vector<NumberRow> numbers;
};

std::string advice_text(const Advice& advice);
std::string advice_json(const Advice& advice);

}  // namespace gasgrain
