#include "coupling/audit_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>

#include "coupling/base/error.h"
#include "coupling/exchange/effect_sizes/sizes.h"

namespace gasgrain {
namespace {

std::string percent(double share) {
  constexpr double nothing = 1e-9;
  const double value = 100.0 * share;
  if (share < nothing) return "0 %";
  return value < 100.0 ? fmt::format("{:.2g} %", value) : fmt::format("{:.0f} %", value);
}

// What the gas program has on is in its gas.toml.
bool of_gas_program(const std::string& effect) {
  return effect == SizeSmagorinsky::name || effect == SizeKEpsilon::name ||
         effect == SizeIdealGas::name || effect == SizeConvection::name ||
         effect == SizeDepthCorrection::name;
}

// Where a larger size speaks against what is on.
bool is_an_error(const std::string& effect) {
  return effect == SizeOverlapped::name || effect == SizeMomentumSharing::name ||
         effect == SizeModelB::name;
}

std::string remedy_of(const std::string& effect, bool on) {
  if (effect == SizeSmagorinsky::name) return "[turbulence] model = \"smagorinsky\" in gas.toml";
  if (effect == SizeKEpsilon::name) return "[turbulence] model = \"k_epsilon\" in gas.toml";
  if (effect == SizeIdealGas::name) return "[gas] law = \"ideal_gas\" in gas.toml";
  if (effect == SizeConvection::name) return "[solver] convection = \"tvd\" in gas.toml";
  if (effect == SizeDepthCorrection::name) return "[grid] plane_of_spheres in gas.toml";
  if (effect == SizeModelB::name) return "[gas] model = \"A\" in gas.toml";
  if (effect == SizeOverlapped::name)
    return "mode in_turn, or a shorter interval, on the couple/gas line";
  if (effect == SizeMomentumSharing::name)
    return "momentum_sharing scheme_3 on the couple/gas line";
  if (effect == SizeSelfDisturbance::name) return "self_disturbance undone on the couple/gas line";
  return fmt::format("{} \"{}\" {} the couple/gas line", on ? "take" : "write", effect,
                     on ? "from" : "on");
}

bool is_on(const std::string& effect, const Effects& effects, const AuditSetting& setting) {
  if (effect == SizePolydisperse::name) return effects.drag && effects.polydisperse;
  if (effect == SizeSelfDisturbance::name) return !effects.ignore_self_disturbance;
  if (effect == SizeMomentumSharing::name) return effects.by_mean_velocity();
  if (effect == SizeOverlapped::name) return setting.overlapped;
  if (effect == SizeModelB::name) return setting.gas.whole_pressure_gradient;
  const auto names = effects.names();
  return std::find(names.begin(), names.end(), effect) != names.end();
}

bool is_torque(const std::string& effect) {
  bool torque = false;
  for_each_choice<Force>([&](auto force) {
    torque = torque || (force.kind == ForceKind::torque && force.name == effect);
  });
  return torque;
}

// Sum of |impulse| of an effect over that of drag; negative where the ledger has none. A torque's
// is taken over the greatest radius.
double ledger_share(const Ledger& ledger, const std::string& effect, double radius) {
  const auto columns = ledger.column_names();
  const auto values = ledger.column_values();
  const auto value = [&](const std::string& name) {
    const auto found =
        std::find(columns.begin(), columns.end(), fmt::format("impulse_of_{}_Ns", name));
    return found == columns.end() ? -1.0
                                  : values[static_cast<std::size_t>(found - columns.begin())];
  };
  const double own = value(effect);
  const double drag = value(std::string(SizeDrag::name));
  if (own < 0.0 || drag <= 0.0) return -1.0;
  return own / drag / (is_torque(effect) ? radius : 1.0);
}

void judge(AuditRow& row) {
  const std::string size = fmt::format(
      "{} of what moves a grain, {} of drag in the mean, {:g} % or more for {} of the "
      "grains",
      percent(row.greatest), percent(row.of_drag), 100.0 * needed_share, percent(row.often));
  const bool out_of_range = row.often == 0.0 && row.greatest >= needed_share;
  const char* note = out_of_range ? " (beyond the range of its law, where that means little)" : "";
  const bool on = row.state == AuditRow::State::on;
  row.remedy = remedy_of(row.effect, on);
  if (row.state == AuditRow::State::of_gas_program) {
    row.text = "reached " + size;
    return;
  }
  if (!on) {
    row.wrong = row.needed;
    row.text = fmt::format("off, would have reached {}{}: {} off", size, note,
                           row.wrong ? "wrongly" : "rightly");
    return;
  }
  const bool large = row.needed || row.of_drag >= needed_share;
  const bool free = row.effect == SizeDrag::name || row.effect == SizeSelfDisturbance::name ||
                    row.effect == ForcePressureGradient::name;
  row.wrong = is_an_error(row.effect) ? large : !large && !free;
  const char* verdict = !row.wrong                ? "rightly on"
                        : is_an_error(row.effect) ? "a wrong choice here"
                                                  : "not worth its time here";
  row.text = fmt::format("on, reached {}{}: {}", size, note, verdict);
}

}  // namespace

AuditReport audit_report(const Audit& whole, const Effects& effects, const AuditSetting& setting,
                         const Ledger& ledger) {
  AuditReport report;
  const Audit::Extremes& most = whole.extremes();
  report.heading = fmt::format(
      "audit of {} couplings, {:.0f} grains seen in the mean; greatest of any grain: slip {:.3g} "
      "m/s "
      "(Re {:.2g}), speed {:.3g} m/s, spin {:.3g} rad/s, shear of the gas {:.3g} 1/s, its "
      "acceleration {:.3g} m/s2",
      whole.couplings(), whole.grains() / static_cast<double>(std::max(1L, whole.couplings())),
      most.slip, most.reynolds, most.speed, most.spin, most.vorticity, most.gas_acceleration);
  if (!whole.gas_known()) {
    report.heading += ". No drag, so no gas velocity was lent: nothing else is known";
    return report;
  }
  std::string missing;
  for (const GasFieldInfo& field : gas_field_list)
    if (whole.estimated().has(field.field))
      missing += (missing.empty() ? "" : ", ") + std::string(field.name);
  if (!missing.empty())
    report.heading += fmt::format(". Not lent, estimated from the gas velocity: {}", missing);
  for (const Audit::Seen& seen : whole.seen()) {
    AuditRow row;
    row.effect = seen.name;
    const bool on = is_on(seen.name, effects, setting);
    // What is not on and would be wrong if it were.
    if (!on && is_an_error(seen.name)) continue;
    row.state = of_gas_program(seen.name) ? AuditRow::State::of_gas_program
                                          : (on ? AuditRow::State::on : AuditRow::State::off);
    row.of_drag = row.estimated = ratio(seen.force, whole.drag());
    row.of_weight = ratio(seen.force, whole.weight());
    if (on) {
      const double share = ledger_share(ledger, seen.name, 0.5 * most.diameter);
      if (share >= 0.0) row.of_drag = share;
    }
    row.greatest = seen.greatest;
    row.often = ratio(seen.needed, whole.grains());
    row.needed = row.often >= needed_often;
    judge(row);
    report.rows.push_back(std::move(row));
  }
  return report;
}

std::string AuditReport::text() const {
  std::string warnings;
  std::string others;
  for (const AuditRow& row : rows) {
    if (row.wrong)
      warnings += fmt::format("  warning: {}: {}; {}\n", row.effect, row.text, row.remedy);
    else
      others += fmt::format("  {}: {}{}\n", row.effect,
                            row.state == AuditRow::State::of_gas_program ? "(of gas.toml) " : "",
                            row.text);
  }
  return heading + "\n" + warnings + others;
}

std::string AuditReport::json() const {
  std::string list;
  const auto quoted = [](const std::string& plain) {
    std::string text;
    for (const char c : plain) text += c == '"' ? std::string("\\\"") : std::string(1, c);
    return "\"" + text + "\"";
  };
  const auto number = [](double value) {
    return std::isfinite(value) ? fmt::format("{:.6g}", value) : std::string("null");
  };
  for (const AuditRow& row : rows) {
    const char* state = row.state == AuditRow::State::on    ? "on"
                        : row.state == AuditRow::State::off ? "off"
                                                            : "gas.toml";
    list += fmt::format(
        "{}\n  {{\"effect\": {}, \"state\": \"{}\", \"needed\": {}, \"wrong\": {}, "
        "\"of_drag\": {}, \"estimated_of_drag\": {}, \"of_weight\": {}, \"greatest\": {}, "
        "\"often\": {}, \"text\": {}, \"remedy\": {}}}",
        list.empty() ? "" : ",", quoted(row.effect), state, row.needed, row.wrong,
        number(row.of_drag), number(row.estimated), number(row.of_weight), number(row.greatest),
        number(row.often), quoted(row.text), quoted(row.remedy));
  }
  return fmt::format("{{\"heading\": {}, \"effects\": [{}\n]}}\n", quoted(heading), list);
}

void write_audit(const std::string& folder, const AuditReport& report) {
  for (const auto& [name, text] :
       {std::pair{"/audit.txt", report.text()}, std::pair{"/audit.json", report.json()}}) {
    std::ofstream file(folder + name);
    file << text;
    file.flush();
    if (!file) fail("{}{} cannot be written: free some space.", folder, name);
  }
}

}  // namespace gasgrain
