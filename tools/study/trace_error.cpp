#include "tools/study/trace_error.h"

#include <algorithm>

#include "tools/history.h"

namespace gasgrain {
namespace {

struct Trace {
  std::vector<double> time_s;
  std::vector<double> value;

  [[nodiscard]] double at(double time) const {
    const auto after = std::upper_bound(time_s.begin(), time_s.end(), time);
    if (after == time_s.begin()) return value.front();
    if (after == time_s.end()) return value.back();
    const auto n = static_cast<std::size_t>(after - time_s.begin());
    const double share = (time - time_s[n - 1]) / (time_s[n] - time_s[n - 1]);
    return value[n - 1] + share * (value[n] - value[n - 1]);
  }
};

// Of the gas stage; without its first line, which is the bed before the gas has done anything.
Trace trace(const History& history, const std::string& column) {
  Trace read;
  for (std::size_t row = 0; row < history.rows(); ++row) {
    const auto time = history.value(row, "time_s");
    const auto value = history.value(row, column);
    if (!time || !value || *time <= 0.0) continue;
    read.time_s.push_back(*time);
    read.value.push_back(*value);
  }
  return read;
}

struct Difference {
  double rms = 0.0;
  double reference_rms = 0.0;
  double mean = 0.0;
  double reference_mean = 0.0;
};

// Nothing where the runs share no time.
std::optional<Difference> difference(const Trace& run, const Trace& reference) {
  if (run.time_s.empty() || reference.time_s.empty()) return std::nullopt;
  constexpr double round_off = 1e-9;
  Difference found;
  double count = 0;
  for (std::size_t n = 0; n < run.time_s.size(); ++n) {
    if (run.time_s[n] > reference.time_s.back() * (1.0 + round_off)) break;
    const double there = reference.at(run.time_s[n]);
    found.rms += (run.value[n] - there) * (run.value[n] - there);
    found.reference_rms += there * there;
    found.mean += run.value[n];
    found.reference_mean += there;
    ++count;
  }
  if (count == 0) return std::nullopt;
  found.rms = std::sqrt(found.rms / count);
  found.reference_rms = std::sqrt(found.reference_rms / count);
  found.mean /= count;
  found.reference_mean /= count;
  return found;
}

}  // namespace

void add_trace_errors(const std::filesystem::path& history, const std::filesystem::path& reference,
                      Figures& figures) {
  History run(history);
  History other(reference);
  run.read_on();
  other.read_on();
  const auto compared = [&](const char* column) {
    return difference(trace(run, column), trace(other, column));
  };
  if (const auto height = compared("bed_height_m"); height && height->reference_mean > 0.0)
    figures.set("height_error", height->rms / height->reference_mean);
  if (const auto bubble = compared("bubble_diameter_m"); bubble && bubble->reference_mean > 0.0)
    figures.set("bubble_error",
                std::abs(bubble->mean - bubble->reference_mean) / bubble->reference_mean);
  if (const auto energy = compared("kinetic_energy_J"); energy && energy->reference_rms > 0.0)
    figures.set("energy_error", energy->rms / energy->reference_rms);
  const auto probe = run.lowest_probe();
  if (!probe) return;
  if (const auto pressure = compared(probe->c_str()); pressure && pressure->reference_rms > 0.0)
    figures.set("pressure_error", pressure->rms / pressure->reference_rms);
}

}  // namespace gasgrain
