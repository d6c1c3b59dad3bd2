#include "tools/advise_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace gasgrain {
namespace {

using nlohmann::json;

constexpr std::size_t width = 98;

std::string percent(double share) {
  if (!std::isfinite(share)) return "-";
  const double value = 100.0 * share;
  if (value == 0.0) return "0";
  if (value >= 1000.0) return fmt::format("{:.1e}", value);
  return fmt::format("{:.2g}", value < 100.0 ? value : std::round(value));
}

// Words in lines of `width`, the first one after `lead`, the others indented as far.
std::string wrapped(const std::string& lead, const std::string& text, std::size_t indent) {
  std::string result = lead;
  std::size_t column = lead.size();
  std::size_t begin = 0;
  while (begin < text.size()) {
    const std::size_t end = std::min(text.find(' ', begin), text.size());
    const std::string word = text.substr(begin, end - begin);
    if (column + word.size() + 1 > width && column > indent) {
      result += "\n" + std::string(indent, ' ');
      column = indent;
    } else if (column > indent) {
      result += " ";
      ++column;
    }
    result += word;
    column += word.size();
    begin = end + 1;
  }
  return result + "\n";
}

std::string scene_lines(const Advice& advice) {
  const Grains& grains = advice.scene.grains;
  const Places& places = advice.places;
  std::string text = fmt::format("{}\n  {:.0f} grains of {:.3g}", advice.scene.folder.string(),
                                 grains.count, 1e3 * grains.smallest);
  if (grains.largest > grains.smallest) text += fmt::format(" to {:.3g}", 1e3 * grains.largest);
  text += fmt::format(" mm, {:.4g} kg/m3; gas of {:.3g} kg/m3, {:.3g} Pa s\n", grains.density,
                      places.list.front().scales.gas_density, places.list.front().scales.viscosity);
  if (places.superficial > 0.0)
    text += fmt::format(
        "  superficial velocity {:.3g} m/s, minimum fluidisation {:.3g} m/s; bed {:.2g} m high\n",
        places.superficial, places.minimum_fluidisation, places.bed_height);
  for (const Place& place : places.list) {
    const Scales& at = place.scales;
    text += fmt::format(
        "  {}: slip {:.3g} m/s (Re {:.2g}), drag {:.2g} of the weight, shear {:.2g} 1/s, spin "
        "{:.2g} "
        "rad/s\n",
        place.name, at.slip, at.reynolds(), ratio(at.drag, at.weight()), at.vorticity, at.spin);
  }
  return text;
}

std::string effect_table(const Advice& advice) {
  std::string places;
  for (const Place& place : advice.places.list)
    places += (places.empty() ? "" : " / ") + place.name;
  std::string text =
      fmt::format("\n  {:<24}{:>9}  {:>15}  {:>15}  {:<9}{:<10}{}\n  {:<24}{:>9}  {:>15}  {:>15}\n",
                  "effect", "number", "% of weight", "% of drag", "now", "advised", "price of on",
                  "", "", places, places);
  for (const EffectRow& row : advice.effects) {
    std::string weight;
    std::string drag;
    for (const SizeThere& size : row.sizes) {
      weight += (weight.empty() ? "" : " / ") + percent(size.of_weight);
      drag += (drag.empty() ? "" : " / ") + percent(size.of_drag);
    }
    text += fmt::format("{} {:<24}{:>9}  {:>15}  {:>15}  {:<9}{:<10}{}\n", row.agrees() ? " " : "*",
                        row.name, fmt::format("{:.2g}", row.number), weight, drag, row.now,
                        row.advised, row.price);
  }
  text += fmt::format(
      "  *: advised otherwise. Advised on: {:g} % or more of the greater of weight and drag, "
      "somewhere.\n  gas 13 %*: of the gas's step, once for all that need its fields. Orders of "
      "magnitude;\n  the audit at a run's end has the true sizes. Numbers, thresholds, sources: "
      "docs/effects.md\n",
      100.0 * needed_share);
  for (const EffectRow& row : advice.effects)
    if (!row.agrees())
      text += wrapped(fmt::format("  {}:", row.name),
                      fmt::format("{} = {:.2g}; {}{}", row.number_name, row.number, row.threshold,
                                  row.note.empty() ? "" : " (" + row.note + ")"),
                      4);
  return text;
}

std::string number_table(const Advice& advice) {
  std::string text = "\n";
  for (const NumberRow& row : advice.numbers) {
    text += fmt::format("{} {:<19}{}{}\n", row.change ? "*" : " ", row.name,
                        row.now.empty() ? "" : "now " + row.now + "; ",
                        row.change || row.now.empty() ? "advised " + row.advised : "keep it");
    text += wrapped(std::string(6, ' ') + "why:", row.reason, 6);
    text += wrapped(std::string(6, ' ') + "thesis:", row.thesis + "; " + row.verdict, 6);
  }
  return text;
}

}  // namespace

std::string advice_text(const Advice& advice) {
  return scene_lines(advice) + effect_table(advice) + number_table(advice);
}

std::string advice_json(const Advice& advice) {
  json effects = json::array();
  for (const EffectRow& row : advice.effects) {
    json entry{{"effect", row.name},   {"number_name", row.number_name},
               {"number", row.number}, {"share", row.share},
               {"now", row.now},       {"advised", row.advised},
               {"price", row.price},   {"threshold", row.threshold},
               {"note", row.note}};
    for (std::size_t n = 0; n < row.sizes.size(); ++n)
      entry["places"][advice.places.list[n].name] = {{"of_weight", row.sizes[n].of_weight},
                                                     {"of_drag", row.sizes[n].of_drag}};
    effects.push_back(entry);
  }
  json numbers = json::array();
  for (const NumberRow& row : advice.numbers)
    numbers.push_back({{"name", row.name},
                       {"now", row.now},
                       {"advised", row.advised},
                       {"value", row.value},
                       {"change", row.change},
                       {"reason", row.reason},
                       {"thesis", row.thesis},
                       {"verdict", row.verdict}});
  json places;
  for (const Place& place : advice.places.list)
    places[place.name] = {{"slip_m_s", place.scales.slip},
                          {"reynolds", place.scales.reynolds()},
                          {"drag_N", place.scales.drag},
                          {"weight_N", place.scales.weight()},
                          {"vorticity_1_s", place.scales.vorticity},
                          {"spin_rad_s", place.scales.spin},
                          {"gas_acceleration_m_s2", place.scales.gas_acceleration}};
  constexpr int indent = 2;
  return json{{"scene", advice.scene.folder.string()},
              {"fastest_grain_m_s", advice.places.fastest},
              {"places", places},
              {"effects", effects},
              {"numbers", numbers}}
             .dump(indent) +
         "\n";
}

}  // namespace gasgrain
