// Study of the scene's effects: each switched off in turn, what it costs and what it changes.
#include <fmt/ranges.h>

#include <algorithm>
#include <sstream>

#include "coupling/base/error.h"
#include "coupling/exchange/effects.h"
#include "tools/study/kinds.h"

namespace gasgrain {
namespace {

using Words = std::vector<std::string>;

Words words_of(const std::string& text) {
  std::istringstream stream(text);
  Words words;
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

std::string joined(const Words& words) {
  return fmt::format("{}", fmt::join(words, " "));
}

// The effects of a line, each with the words that belong to it.
std::vector<Words> effects_of(const std::string& line) {
  const Words known = effect_words();
  std::vector<Words> effects;
  for (const auto& word : words_of(line)) {
    const bool begins = std::find(known.begin(), known.end(), word) != known.end();
    // `drag NAME`: a name is never an effect's own word.
    if (begins || effects.empty()) effects.emplace_back();
    effects.back().push_back(word);
  }
  return effects;
}

// What only changes drag goes with it.
bool needs_drag(const std::string& effect) {
  return effect == "polydisperse" || effect == "momentum_sharing" || effect == "self_disturbance";
}

std::string without(const std::vector<Words>& effects, const std::string& name) {
  Words left;
  for (const auto& effect : effects)
    if (effect.front() != name && !(name == "drag" && needs_drag(effect.front())))
      left.insert(left.end(), effect.begin(), effect.end());
  return joined(left);
}

// `hertz tangential history` without its `tangential`, and so on.
std::vector<std::pair<std::string, std::string>> contacts_without(const std::string& contact) {
  const Words words = words_of(contact);
  std::vector<std::pair<std::string, std::string>> found;
  for (std::size_t n = 1; n + 1 < words.size(); n += 2) {
    Words left = words;
    left.erase(left.begin() + static_cast<long>(n), left.begin() + static_cast<long>(n) + 2);
    found.emplace_back(words[n], joined(left));
  }
  return found;
}

std::vector<std::string> findings(const std::vector<StudyRow>& rows, double chance) {
  std::vector<std::string> lines;
  const StudyRow& whole = rows.front();
  if (!whole.ok()) return lines;
  for (const auto& row : rows) {
    if (!row.ok() || &row == &whole) continue;
    const double change = row.figures.get("energy_error");
    lines.push_back(fmt::format(
        "{}: with it the run takes {:+.0f} % wall time; without it the kinetic energy differs by "
        "{:.2g} %, the bed height by {:.2g} %: {}.",
        row.point.dials[0].second,
        100.0 * (whole.figures.get(study_cost) / row.figures.get(study_cost) - 1.0), 100.0 * change,
        100.0 * row.figures.get("height_error"),
        change > 2.0 * chance ? "it matters" : "no more than chance"));
  }
  return lines;
}

}  // namespace

Study plan_effects(const SceneCopy& scene, const StudyOptions& options) {
  const auto effects = effects_of(scene.variable("effects"));
  Study study;
  study.dial = "without";
  study.dial_text = "switched off";
  study.error = "energy_error";
  study.error_text = "kinetic energy, rms difference from the whole";
  study.reference_text = "the whole scene";
  StudyPoint whole;
  whole.name = "all";
  whole.dials = {{"without", "nothing"}};
  study.points.push_back(whole);
  std::vector<std::string> known;
  const auto add = [&](const std::string& name, const Settings& variables,
                       const Settings& gas_keys) {
    known.push_back(name);
    const auto& wanted = options.values;
    if (!wanted.empty() && std::find(wanted.begin(), wanted.end(), name) == wanted.end()) return;
    StudyPoint point;
    point.name = "without_" + name;
    point.dials = {{"without", name}};
    point.variables = variables;
    point.gas_keys = gas_keys;
    study.points.push_back(point);
  };
  for (const auto& effect : effects)
    add(effect.front(), {{"effects", without(effects, effect.front())}}, {});
  const auto has = [&](const std::string& name) {
    return std::any_of(effects.begin(), effects.end(),
                       [&](const Words& effect) { return effect.front() == name; });
  };
  if (has("drag") && !has("self_disturbance"))
    add("self_disturbance", {{"effects", scene.variable("effects") + " self_disturbance ignored"}},
        {});
  if (scene.has_variable("contact"))
    for (const auto& [name, contact] : contacts_without(scene.variable("contact")))
      add(name, {{"contact", contact}}, {});
  if (scene.has_gas_key("turbulence")) add("turbulence", {}, {{"turbulence", absent_table}});
  for (const auto& name : options.values)
    if (std::find(known.begin(), known.end(), name) == known.end())
      fail("--values {}: the scene has no such effect.{}", name, suggestion(name, known));
  study.findings = findings;
  return study;
}

}  // namespace gasgrain
