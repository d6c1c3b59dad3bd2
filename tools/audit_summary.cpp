#include "tools/audit_summary.h"

#include <fmt/format.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "coupling/base/error.h"
#include "coupling/exchange/effect_sizes/sizes.h"
#include "gas_solver/gas_input.h"

namespace gasgrain {
namespace {

using nlohmann::json;

struct GasChoice {
  bool on = false;
  bool stands_in = false;  // for it: another model of turbulence
};

GasChoice choice_of(const std::string& effect, const GasInput& gas) {
  const TurbulenceModel model = gas.turbulence.model;
  const bool any = model != TurbulenceModel::none;
  if (effect == SizeSmagorinsky::name) {
    const bool on = model == TurbulenceModel::smagorinsky;
    return {on, any && !on};
  }
  if (effect == SizeKEpsilon::name) {
    const bool on = model == TurbulenceModel::k_epsilon;
    return {on, any && !on};
  }
  if (effect == SizeIdealGas::name) return {gas.law == GasLaw::ideal_gas, false};
  // Upwind's false stress is there with upwind only.
  if (effect == SizeConvection::name) return {gas.convection != Convection::upwind, false};
  return {gas.plane_of_spheres > 0.0, false};
}

void judge(json& row, const GasInput& gas) {
  const std::string effect = row.value("effect", "");
  const bool needed = row.value("needed", false);
  const GasChoice choice = choice_of(effect, gas);
  const std::string size = row.value("text", "");
  if (effect == SizeConvection::name) {
    row["state"] = choice.on ? "on" : "off";
    row["wrong"] = needed && !choice.on;
    row["text"] = choice.on ? "not upwind, whose false stress would have " + size + ": rightly so"
                            : fmt::format("upwind, whose false stress {}: {}", size,
                                          needed ? "wrongly" : "no harm");
    return;
  }
  row["state"] = choice.on ? "on" : "off";
  row["wrong"] = needed && !choice.on && !choice.stands_in;
  const char* verdict = choice.on          ? (needed ? "rightly on" : "on, of little use here")
                        : choice.stands_in ? "off, another model stands in for it"
                        : needed           ? "wrongly off"
                                           : "rightly off";
  row["text"] = fmt::format("{} {}: {}", choice.on ? "on," : "off, would have", size, verdict);
}

}  // namespace

std::string complete_audit(const std::filesystem::path& scene,
                           const std::filesystem::path& results) {
  std::ifstream stream(results / "audit.json");
  json audit = json::parse(stream, nullptr, false);
  if (!audit.is_object() || !audit.contains("effects")) return "";
  stream.close();
  GasInput gas;
  try {
    gas = read_gas_input((scene / "gas.toml").string(), false);
  } catch (const Error&) {
    return "";  // the run had another file of that name
  }
  std::string warnings;
  std::string others;
  bool turbulence_told = false;
  for (json& row : audit["effects"]) {
    if (row.value("state", "") == "gas.toml") judge(row, gas);
    const std::string effect = row.value("effect", "");
    const bool turbulence = effect == SizeSmagorinsky::name || effect == SizeKEpsilon::name;
    if (turbulence && turbulence_told) row["wrong"] = false;  // one model is enough
    const std::string text = fmt::format("{}: {}", effect, row.value("text", ""));
    if (row.value("wrong", false)) {
      turbulence_told = turbulence_told || turbulence;
      warnings += fmt::format("  warning: {}; {}\n", text, row.value("remedy", ""));
    } else {
      others += "  " + text + "\n";
    }
  }
  constexpr int indent = 2;
  std::ofstream(results / "audit.json") << audit.dump(indent) << "\n";
  std::ofstream(results / "audit.txt") << audit.value("heading", "") << "\n" << warnings << others;
  return warnings;
}

}  // namespace gasgrain
