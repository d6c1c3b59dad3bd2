#include "fix_cfd_coupling/liggghts/contact_styles_words.h"

#include <algorithm>
#include <map>
#include <set>

#include "coupling/base/error.h"
#include "fix_cfd_coupling/liggghts/contact_styles_outer.h"

namespace gasgrain {
namespace {

using Names = std::vector<std::string>;

std::set<std::string>& words_of_laws() {
  static std::set<std::string> words;
  return words;
}

// The word before a model's name, and the names: the host's, ours, those loaded.
std::map<std::string, Names> names_of_models() {
  std::map<std::string, Names> names;
#define NORMAL_MODEL(constant, name, id) names["model"].emplace_back(#name);
#include "style_normal_model.h"
#undef NORMAL_MODEL
#define TANGENTIAL_MODEL(constant, name, id) names["tangential"].emplace_back(#name);
#include "style_tangential_model.h"
#undef TANGENTIAL_MODEL
#define SURFACE_MODEL(constant, name, id) names["surface"].emplace_back(#name);
#include "style_surface_model.h"
#undef SURFACE_MODEL
#define COHESION_MODEL(constant, name, id) names["cohesion"].emplace_back(#name);
#include "style_cohesion_model.h"
#undef COHESION_MODEL
#define ROLLING_MODEL(constant, name, id) names["rolling_friction"].emplace_back(#name);
#include "style_rolling_model.h"
#undef ROLLING_MODEL
#define COHESION_LAW(Law, name, id) names["cohesion"].emplace_back(#name);
#include "fix_cfd_coupling/dem_physics/contact/cohesion_laws.h"
#undef COHESION_LAW
#define ROLLING_LAW(Law, name, id) names["rolling_friction"].emplace_back(#name);
#include "fix_cfd_coupling/dem_physics/contact/rolling_laws.h"
#undef ROLLING_LAW
  for (const auto& [id, law] : outer_cohesion_laws()) names["cohesion"].push_back(law.name);
  for (const auto& [id, law] : outer_rolling_laws()) names["rolling_friction"].push_back(law.name);
  for (auto& [kind, of_kind] : names) of_kind.emplace_back("off");
  return names;
}

}  // namespace

void know_contact_word(const std::string& word) {
  words_of_laws().insert(word);
}

Names contact_words() {
  Names words(words_of_laws().begin(), words_of_laws().end());
  for (const auto& [kind, names] : names_of_models()) {
    words.push_back(kind);
    words.insert(words.end(), names.begin(), names.end());
  }
  return words;
}

std::string misspelt_model(const Names& words) {
  const auto all = names_of_models();
  for (std::size_t n = 0; n + 1 < words.size(); ++n) {
    const auto names = all.find(words[n]);
    if (names == all.end()) continue;
    const auto& known = names->second;
    if (std::find(known.begin(), known.end(), words[n + 1]) == known.end())
      return fmt::format(" {} \"{}\" is unknown.{}", words[n], words[n + 1],
                         suggestion(words[n + 1], known));
  }
  return "";
}

}  // namespace gasgrain
