// The numbers of a scene's numerics: stiffness, steps, cells, methods; each with its reason, beside
// what Alobaid's thesis (2013), 8.1.3 and 8.1.5, recommends.
#pragma once

#include <string>
#include <vector>

#include "tools/advise_places.h"

namespace gasgrain {

struct NumericsWish {
  double overlap = 0.05;  // greatest, of a diameter
  double speed = 0.0;     // of the fastest grain [m/s]; 0: estimated
};

// What a row stands for, so that --write knows where it goes.
enum class Dial { none, youngs, dem_step, method, interval, gas_step };

struct NumberRow {
  Dial dial = Dial::none;
  std::string name;
  std::string now;
  std::string advised;
  std::string reason;
  std::string thesis;   // what it recommends
  std::string verdict;  // "agrees", "disagrees: why", or "silent"
  double value = 0.0;   // advised, SI, of a dial
  bool change = false;  // now is not good enough, or costs more than it must
};

std::vector<NumberRow> number_rows(const AdviseScene& scene, const Places& places,
                                   const NumericsWish& wish);

// Steps that a contact should last: the integration's error of the restitution is then below 1 %.
inline constexpr double steps_a_contact = 20.0;

}  // namespace gasgrain
