#include "tools/measure/measure_file.h"

#include <fmt/ranges.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "coupling/base/error.h"

namespace gasgrain {

namespace fs = std::filesystem;

namespace {

void write_text(const fs::path& file, const std::string& text) {
  std::ofstream stream(file);
  stream << text;
  stream.close();
  if (!stream) fail("{} cannot be written.", file.string());
}

std::string field(double value) {
  return std::isfinite(value) ? fmt::format("{:.6g}", value) : "";
}

std::string csv_of(const Curve& curve) {
  std::string text = fmt::format("{}\n", fmt::join(curve.columns, ","));
  for (const auto& row : curve.rows) {
    std::vector<std::string> fields;
    for (const double value : row) fields.push_back(field(value));
    text += fmt::format("{}\n", fmt::join(fields, ","));
  }
  return text;
}

}  // namespace

std::optional<MeasureFile> read_measure_file(const fs::path& scene) {
  const fs::path file = scene / "measure.toml";
  if (!fs::exists(file)) return std::nullopt;
  TomlInput input(file);
  InputTable root = input.root();
  InputTable table = root.table("measure");
  std::vector<std::string> names;
  for (const auto& kind : all_measure_kinds()) names.emplace_back(kind.name);
  MeasureFile read;
  read.kind = table.choice("kind", std::nullopt, names);
  for (const auto& kind : all_measure_kinds())
    if (read.kind == kind.name && !table.at_fault("kind")) read.measure = kind.read(table);
  input.finish();
  return read;
}

void write_measurement(const fs::path& results, const std::string& kind,
                       const Measurement& measured) {
  std::string text = "quantity,value,unit,uncertainty\n";
  nlohmann::json quantities = nlohmann::json::array();
  for (const auto& one : measured.quantities) {
    if (!std::isfinite(one.value) || !std::isfinite(one.uncertainty))
      fail("{}: the value is no finite number: what the run wrote cannot be measured.", one.name);
    text += fmt::format("{},{:.6g},{},{:.3g}\n", one.name, one.value, one.unit, one.uncertainty);
    quantities.push_back({{"name", one.name},
                          {"value", one.value},
                          {"unit", one.unit},
                          {"uncertainty", one.uncertainty}});
  }
  constexpr int indent = 2;
  write_text(results / "measured_curve.csv", csv_of(measured.curve));
  write_text(
      results / "measured.json",
      nlohmann::json{{"kind", kind}, {"quantities", quantities}, {"notes", measured.notes}}.dump(
          indent) +
          "\n");
  write_text(results / "measured.csv", text);  // last: it tells that all is there
}

std::string text_of(const Measurement& measured) {
  std::string text;
  for (const auto& one : measured.quantities) {
    text += fmt::format("  {:<26}{:.5g}", one.name, one.value);
    if (one.uncertainty > 0.0) text += fmt::format(" +- {:.2g}", one.uncertainty);
    text += one.unit == "1" ? "\n" : fmt::format(" {}\n", one.unit);
  }
  for (const auto& note : measured.notes) text += fmt::format("  note: {}\n", note);
  return text;
}

}  // namespace gasgrain
