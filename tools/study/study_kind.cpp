#include "tools/study/study_kind.h"

#include <algorithm>
#include <cstdlib>

#include "coupling/base/error.h"

namespace gasgrain {
namespace {

std::optional<double> parsed(const std::string& word) {
  char* end = nullptr;
  const double value = std::strtod(word.c_str(), &end);
  if (end == word.c_str() || *end != '\0' || !std::isfinite(value)) return std::nullopt;
  return value;
}

}  // namespace

double number_of(const SceneCopy& scene, const std::string& variable) {
  const std::string word = scene.variable(variable);
  const auto value = parsed(word);
  if (!value)
    fail("{}: variable {} is \"{}\": this study needs a number there.", scene.script_path(),
         variable, word);
  return *value;
}

std::vector<double> values_or(const StudyOptions& options, const std::vector<double>& usual) {
  if (options.values.empty()) return usual;
  std::vector<double> values;
  for (const auto& word : options.values) {
    const auto value = parsed(word);
    if (!value || *value <= 0.0)
      fail("--values {}: study {} takes numbers above 0, for example --values {} {}", word,
           options.kind, usual.front(), usual.back());
    values.push_back(*value);
  }
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
  return values;
}

std::string text_of(double value) {
  return fmt::format("{:.6g}", value);
}

double dividing_step(double interval, double step) {
  constexpr double round_off = 1e-9;
  return interval / std::max(1.0, std::ceil(interval / step - round_off));
}

double exponent(const std::vector<StudyRow>& rows, const std::string& figure,
                const std::string& of) {
  double n = 0;
  double x = 0;
  double y = 0;
  double xx = 0;
  double xy = 0;
  for (const auto& row : rows) {
    const double u = std::log(row.figures.get(of));
    const double v = std::log(row.figures.get(figure));
    if (!row.ok() || !std::isfinite(u) || !std::isfinite(v)) continue;
    n += 1;
    x += u;
    y += v;
    xx += u * u;
    xy += u * v;
  }
  return (n * xy - x * y) / (n * xx - x * x);
}

const StudyRow* row_of(const std::vector<StudyRow>& rows, const std::string& point) {
  for (const auto& row : rows)
    if (row.point.name == point && row.ok()) return &row;
  return nullptr;
}

}  // namespace gasgrain
