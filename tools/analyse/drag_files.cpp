#include "tools/analyse/drag_files.h"

#include <fmt/ranges.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "tools/whole_file.h"

namespace gasgrain {

namespace {

std::string number(double value) {
  return std::isfinite(value) ? fmt::format("{:.6g}", value) : "";
}

// For the screen: "-" where there is none.
std::string rounded(double value, int digits) {
  return std::isfinite(value) ? fmt::format("{:.{}g}", value, digits) : "-";
}

std::string line_of(const std::vector<double>& values) {
  std::vector<std::string> fields;
  for (const double value : values) fields.push_back(number(value));
  return fmt::format("{}\n", fmt::join(fields, ","));
}

std::string windows_csv(const std::vector<DragRate>& rates) {
  std::string text =
      "time_s,big_id,size,side_m,alpha_s,alpha_b,u_s_x_m_s,u_s_y_m_s,u_s_z_m_s,u_b_x_m_s,u_b_y_m_s,"
      "u_b_z_m_s,dem_x_N_m3,dem_y_N_m3,dem_z_N_m3,syamlal_x_N_m3,syamlal_y_N_m3,syamlal_z_N_m3,"
      "omega\n";
  for (const auto& rate : rates) {
    std::vector<double> values{rate.time_s,     static_cast<double>(rate.big_id),
                               rate.size,       rate.side,
                               rate.s.fraction, rate.b.fraction};
    for (const Vec3* vector : {&rate.s.velocity, &rate.b.velocity, &rate.dem, &rate.syamlal})
      values.insert(values.end(), vector->begin(), vector->end());
    values.push_back(rate.omega());
    text += line_of(values);
  }
  return text;
}

std::string means_csv(const std::vector<SteadyDrag>& means) {
  std::string text =
      "size,side_m,windows,alpha_s,alpha_b,slip_m_s,dem_N_m3,syamlal_N_m3,omega,omega_error,"
      "omega_transient\n";
  for (const auto& mean : means)
    text += line_of({mean.size, mean.side, static_cast<double>(mean.windows), mean.alpha_s,
                     mean.alpha_b, mean.slip, mean.dem, mean.syamlal, mean.omega, mean.omega_error,
                     mean.omega_transient});
  return text;
}

}  // namespace

void write_drag(const std::filesystem::path& folder, const std::vector<DragRate>& rates,
                const std::vector<SteadyDrag>& means, const DragLabels& labels) {
  constexpr int indent = 2;
  const nlohmann::json json{{"command", labels.command},
                            {"force", labels.force},
                            {"window_s", labels.window_s},
                            {"steady_s", labels.steady_s}};
  write_whole(folder / "solid_drag_windows.csv", windows_csv(rates));
  write_whole(folder / "solid_drag.json", json.dump(indent) + "\n");
  write_whole(folder / "solid_drag.csv", means_csv(means));
}

std::string text_of(const std::vector<SteadyDrag>& means) {
  std::string text =
      fmt::format("  {:>9} {:>10} {:>9} {:>9} {:>10} {:>11} {:>11}  {}\n", "size", "side [m]",
                  "alpha_s", "alpha_b", "slip [m/s]", "DEM [N/m3]", "Syamlal", "omega");
  for (const auto& mean : means) {
    text += fmt::format("  {:>9.3g} {:>10.4g} {:>9.4g} {:>9.4g} {:>10.4g} {:>11} {:>11.5g}  ",
                        mean.size, mean.side, mean.alpha_s, mean.alpha_b, mean.slip,
                        rounded(mean.dem, 5), mean.syamlal);
    text += rounded(mean.omega, 3);
    if (std::isfinite(mean.omega_error)) text += fmt::format(" +- {:.2g}", mean.omega_error);
    if (std::isfinite(mean.omega_transient))
      text += fmt::format(", up to {:.3g} before", mean.omega_transient);
    text += "\n";
  }
  return text;
}

}  // namespace gasgrain
