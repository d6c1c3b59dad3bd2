#include "gas_solver/io/history.h"

#include <cstdio>
#include <cstdlib>
#include <vector>

#include "coupling/base/error.h"
#include "gas_solver/io/disk.h"

namespace gasgrain {
namespace {

std::string heading(const GasInput& input) {
  std::string line =
      "time_s,substeps,step_s,courant_max,pressure_iterations,outer_iterations,"
      "continuity_residual,mass_defect,mass_imbalance,mass_inflow_kg_s,mass_outflow_kg_s,"
      "mass_kg,backflow_faces,momentum_not_converged,pressure_not_converged,"
      "outer_not_converged,turbulence_clamped,turbulence_not_converged,"
      "drag_impulse_x_Ns,drag_impulse_y_Ns,drag_impulse_z_Ns,bubble_diameter_m,"
      "surface_height_m";
  for (const double z : input.pressure_probes) line += fmt::format(",pressure_at_{}_m_Pa", z);
  return line;
}

// Lines of an older run up to a time, the heading left out.
std::vector<std::string> lines_until(const std::string& name, const std::string& expected,
                                     double time) {
  std::vector<std::string> lines;
  std::ifstream in(name);
  std::string line;
  if (std::getline(in, line) && line != expected)
    fail(
        "{} has other columns than this run: restart with the pressure probes it was written with, "
        "or move it away.",
        name);
  // Times are printed with 12 digits.
  const double last = time * (1 + 1e-11);
  while (std::getline(in, line))
    if (std::strtod(line.c_str(), nullptr) <= last) lines.push_back(line);
  return lines;
}

}  // namespace

History::History(const std::string& folder, const GasInput& input, double restart_time)
    : name_(folder + "/history.csv") {
  std::vector<std::string> old;
  if (restart_time >= 0) old = lines_until(name_, heading(input), restart_time);
  // Written beside the old one, which stays when the disk is full.
  const std::string beside = name_ + ".new";
  out_.open(beside);
  out_ << heading(input);
  out_ << '\n';
  for (const std::string& line : old) out_ << line << '\n';
  flush();
  if (std::rename(beside.c_str(), name_.c_str()) != 0)
    fail("{}: cannot be written: {}.", name_, why_not_written(name_));
}

void History::add(const GasReport& r) {
  out_ << fmt::format(
      "{:.12g},{},{:.6g},{:.6g},{},{},{:.3g},{:.3g},{:.3g},{:.9g},{:.9g},{:.9g},{},{},{},{},{},{},",
      r.time, r.substeps, r.step, r.courant_max, r.pressure_iterations, r.outer_iterations,
      r.continuity_residual, r.mass_defect, r.mass_imbalance, r.mass_inflow, r.mass_outflow, r.mass,
      r.backflow_faces, r.momentum_not_converged, r.pressure_not_converged, r.outer_not_converged,
      r.turbulence_clamped, r.turbulence_not_converged);
  out_ << fmt::format("{:.9g},{:.9g},{:.9g},{:.6g},{:.6g}", r.drag_impulse[0], r.drag_impulse[1],
                      r.drag_impulse[2], r.bubble_diameter, r.surface_height);
  for (const double p : r.probe_pressure) out_ << fmt::format(",{:.9g}", p);
  out_ << '\n';
  flush();
}

void History::flush() {
  if (!out_.flush()) fail("{}: cannot be written: {}.", name_, why_not_written(name_));
}

}  // namespace gasgrain
