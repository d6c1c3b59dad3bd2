#include "tools/advise_write.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "coupling/base/error.h"
#include "tools/scene_copy.h"
#include "tools/script_edit.h"

namespace gasgrain {
namespace {

class AdviceWriter {
 public:
  AdviceWriter(const Advice& advice, const std::filesystem::path& folder)
      : scene_(advice.scene), advice_(advice), copy_(advice.scene.folder, folder) {}

  std::vector<std::string> write() {
    for (const NumberRow& row : advice_.numbers)
      if (row.change) put_number(row);
    for (const EffectRow& row : advice_.effects)
      if (!row.agrees()) put_effect(row);
    if (!to_add_.empty()) add_words();
    put_interval();
    copy_.write();
    return edit_.told();
  }

 private:
  // The first command that begins with these words, of which "*" is any.
  [[nodiscard]] const ScriptCommand* command(const std::vector<std::string>& begin) const {
    for (const ScriptCommand& found : scene_.script.commands()) {
      bool fits = found.words.size() >= begin.size();
      for (std::size_t n = 0; fits && n < begin.size(); ++n)
        fits = begin[n] == "*" || begin[n] == found.words[n];
      if (fits) return &found;
    }
    return nullptr;
  }

  void put_number(const NumberRow& row) {
    const std::string value = fmt::format("{:.3g}", row.value);
    bool done = false;
    if (row.dial == Dial::youngs) {
      const auto* line = command({"fix", "*", "*", "property/global", "youngsModulus"});
      const auto raw = script_words(line->text);
      done = raw.size() == 7 && edit_.put(*line, raw[6], value);
    } else if (row.dial == Dial::dem_step) {
      const auto* line = command({"timestep"});
      done = edit_.put(*line, script_words(line->text)[1], value);
      if (done) dt_ = row.value;
    } else if (row.dial == Dial::interval) {
      interval_ = row.value;
      done = true;  // with the step, put_interval()
    } else if (row.dial == Dial::gas_step) {
      put_gas("time.step", fmt::format("{:.6g}", row.value));
      done = true;
    } else if (row.dial == Dial::method) {
      done = put_method(row.advised);
    } else {
      edit_.by_hand(row.name, row.reason + ".");
      return;
    }
    if (!done)
      edit_.by_hand(row.name, fmt::format("Write {} where the script has it.", row.advised));
  }

  // `every` counts DEM steps, so that it goes with both; or follows by itself where the script has
  // it from a variable `interval`.
  void put_interval() {
    if (dt_ == 0.0 && interval_ == 0.0) return;
    const double dt = dt_ > 0.0 ? dt_ : scene_.dt;
    const double interval = interval_ > 0.0 ? interval_ : scene_.interval();
    const ScriptCommand& line = scene_.couple.command;
    const int every = std::max(1, static_cast<int>(std::lround(interval / dt)));
    const std::string name = variable_in(raw_after(line, "every"));
    if (!name.empty() && !copy_.has_variable(name) && copy_.has_variable("interval")) {
      if (interval_ > 0.0) edit_.put_variable("interval", fmt::format("{:.3g}", every * dt));
      return;
    }
    if (every != scene_.couple.every && !edit_.put_after(line, "every", std::to_string(every)))
      edit_.by_hand("every", fmt::format("Write 'every {}' in {}.", every, line.place()));
  }

  bool put_method(const std::string& method) {
    const ScriptCommand& line = scene_.couple.command;
    // A number of its own follows `kernel` and `particle_grid`: that goes too.
    const std::string name = raw_after(line, "void_fraction");
    const std::string number = raw_after(line, name);
    const bool has_number = !number.empty() && variable_in(name).empty() &&
                            number.find_first_not_of("0123456789.e+-") == std::string::npos;
    return has_number ? edit_.put(line, name + " " + number, method)
                      : edit_.put_after(line, "void_fraction", method);
  }

  void put_gas(const std::string& key, const std::string& value) {
    const auto dot = key.find('.');
    copy_.set_gas_key(key, value);
    edit_.tell("gas.toml", fmt::format("[{}] {}", key.substr(0, dot), key.substr(dot + 1)), value);
  }

  void put_effect(const EffectRow& row) {
    const bool on = row.advised == "on";
    if (row.name == "turbulence smagorinsky" || row.name == "turbulence k_epsilon") {
      const std::string model = row.name.substr(row.name.find(' ') + 1);
      if (on)
        put_gas("turbulence.model", '"' + model + '"');
      else if (turbulence_stays_off())
        put_gas("turbulence.model", "\"none\"");
    } else if (row.name == "law ideal_gas") {
      edit_.by_hand(row.name, on ? "Write [gas] law = \"ideal_gas\" with pressure, temperature and "
                                   "molar_mass instead of density."
                                 : "Write [gas] density instead of the law's keys.");
    } else if (row.name == "model B") {
      put_gas("gas.model", "\"A\"");
    } else if (row.name == "convection") {
      put_gas("solver.convection", "\"tvd\"");
    } else if (row.name == "plane_of_spheres") {
      if (on)
        put_gas("grid.plane_of_spheres", fmt::format("{:.6g}", scene_.grains.largest));
      else
        edit_.by_hand(row.name, "Remove [grid] plane_of_spheres.");
    } else if (row.name == "rotation") {
      edit_.by_hand(row.name,
                    on ? "Write nve/sphere in place of nve."
                       : "Write nve in place of nve/sphere, if the grains' spin is of no use.");
    } else if (row.name == "tangential history") {
      edit_.by_hand(row.name, on ? "Write 'tangential history' in pair_style and the walls."
                                 : "Write 'tangential no_history' in pair_style and the walls.");
    } else if (row.name == "mode overlapped") {
      if (!edit_.put_after(scene_.couple.command, "mode", "in_turn"))
        edit_.by_hand(row.name, "Write 'mode in_turn' on the couple/gas line.");
    } else if (row.name == "momentum_sharing") {
      if (!edit_.put_after(scene_.couple.command, "momentum_sharing", row.advised) &&
          !remove_words("momentum_sharing " + row.now))
        edit_.by_hand(row.name, "Write 'momentum_sharing scheme_3' on the couple/gas line.");
    } else if (row.name == "self_disturbance") {
      if (!remove_words("self_disturbance ignored"))
        edit_.by_hand(row.name, "Remove 'self_disturbance ignored' from the couple/gas line.");
    } else if (row.name == "drag") {
      to_add_.insert(to_add_.begin(), "drag tang");
    } else if (row.name == "van der Waals") {
      edit_.by_hand(row.name,
                    "Add 'cohesion van_der_waals' to pair_style gran/bridge and to the walls, and "
                    "'hamakerConstant' (docs/liggghts.md).");
    } else if (row.now == "absent") {
      edit_.by_hand(row.name, "It is not in this version.");
    } else if (on) {
      to_add_.push_back(row.name);
    } else if (!remove_words(row.name)) {
      edit_.by_hand(row.name, "Remove it from the couple/gas line.");
    }
  }
  [[nodiscard]] bool turbulence_stays_off() const {
    return std::none_of(advice_.effects.begin(), advice_.effects.end(), [](const EffectRow& row) {
      return row.name.rfind("turbulence", 0) == 0 && row.advised == "on";
    });
  }

  void add_words() {
    const std::string words = fmt::format("{}", fmt::join(to_add_, " "));
    const ScriptCommand& line = scene_.couple.command;
    if (!edit_.append(line, words))
      edit_.by_hand(words, fmt::format("Write it at the end of {}.", line.place()));
  }
  bool remove_words(const std::string& words) {
    return edit_.remove(scene_.couple.command, words + parameters_of(words));
  }
  // " tolerance 0.01 horizon 100" of basset, as the line has them.
  [[nodiscard]] std::string parameters_of(const std::string& force) const {
    const auto& words = scene_.couple.words;
    auto word = std::find(words.begin(), words.end(), force);
    std::string text;
    if (force != ForceBasset::name || word == words.end()) return text;
    for (++word; word != words.end() && word + 1 != words.end() &&
                 (*word == "tolerance" || *word == "horizon");
         word += 2)
      text += " " + *word + " " + *(word + 1);
    return text;
  }

  const AdviseScene& scene_;
  const Advice& advice_;
  SceneCopy copy_;
  ScriptEdit edit_{copy_};
  std::vector<std::string> to_add_;  // words of effects
  double dt_ = 0.0;                  // put in; 0: the scene's own
  double interval_ = 0.0;            // put in; 0: the scene's own
};

}  // namespace

std::vector<std::string> write_advice(
    const Advice& advice, const std::filesystem::path& folder,
    const std::vector<std::pair<std::string, std::string>>& variables) {
  std::vector<std::string> told = AdviceWriter(advice, folder).write();
  // What was written must say what was meant.
  const AdviseScene copy = read_scene(folder, variables);
  const double interval = advice.scene.interval();
  for (const NumberRow& row : advice.numbers) {
    if (!row.change) continue;
    constexpr double digits = 0.02;  // an interval is a whole number of steps
    const bool off =
        (row.dial == Dial::dem_step && std::abs(copy.dt - row.value) > digits * row.value) ||
        (row.dial == Dial::youngs &&
         std::abs(copy.contacts.youngs - row.value) > digits * row.value) ||
        (row.dial == Dial::interval &&
         std::abs(copy.interval() - row.value) > 0.5 * copy.dt + digits * row.value);
    if (off)
      told.push_back(
          fmt::format("to be looked at: {} is not {} in the copy", row.name, row.advised));
  }
  const bool interval_advised =
      std::any_of(advice.numbers.begin(), advice.numbers.end(),
                  [](const NumberRow& row) { return row.dial == Dial::interval && row.change; });
  if (!interval_advised && std::abs(copy.interval() - interval) > 0.5 * copy.dt + 0.02 * interval)
    told.push_back(fmt::format("to be looked at: the coupling interval is {:.3g} s in the copy",
                               copy.interval()));
  return told;
}

}  // namespace gasgrain
