// A results folder with dumps of one big sphere and eight small ones, whose drag is known.
#pragma once

#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "coupling/base/error.h"
#include "tools/analyse/analyse_command.h"

namespace gasgrain {

namespace fs = std::filesystem;

constexpr double big_diameter = 4e-3;
constexpr double small_diameter = 1e-3;
constexpr double small_speed = 0.5;  // along -z

inline fs::path fresh_results(const char* name) {
  fs::path folder = fs::temp_directory_path() / "gasgrain-analyse" / name;
  fs::remove_all(folder);
  fs::create_directories(folder / "particles");
  return folder;
}

inline void write_text(const fs::path& file, const std::string& text) {
  std::ofstream(file) << text;
}

// The big sphere is number 9 and of type 2; the small ones are at the corners of a cube of 4 mm
// about it. `force` is the mean force on the big one since the last frame, along z.
inline std::vector<std::string> grains_of(double force, double at_z = 0.0) {
  std::vector<std::string> rows;
  int id = 0;
  for (const double x : {-2e-3, 2e-3})
    for (const double y : {-2e-3, 2e-3})
      for (const double z : {-2e-3, 2e-3})
        rows.push_back(fmt::format("{} 1 {} {} {} 0 0 {} {} 0 0 0", ++id, x, y, z + at_z,
                                   -small_speed, 0.5 * small_diameter));
  rows.push_back(fmt::format("9 2 0 0 {} 0 0 0 {} 0 0 {}", at_z, 0.5 * big_diameter, force));
  return rows;
}

constexpr const char* with_mean_force =
    "id type x y z vx vy vz radius f_mean[1] f_mean[2] f_mean[3]";

inline std::string text_frame(long step, const std::vector<std::string>& rows,
                              const std::string& columns = with_mean_force) {
  std::string text = fmt::format(
      "ITEM: TIMESTEP\n{}\nITEM: NUMBER OF ATOMS\n{}\nITEM: BOX BOUNDS ff ff ff\n0 1\n0 1\n0 1\n"
      "ITEM: ATOMS {}\n",
      step, rows.size(), columns);
  for (const auto& row : rows) text += row + "\n";
  return text;
}

// Six frames, 100 steps of 1e-5 s apart, with the mean forces 99 (of before time 0), 1, 3, 5, 7
// and 11 mN downwards: with windows of 2 ms the last one fills none.
inline constexpr double forces[] = {99e-3, 1e-3, 3e-3, 5e-3, 7e-3, 11e-3};

inline void write_facts(const fs::path& folder, const std::string& more = "") {
  write_text(folder / "analyse.toml",
             "timestep = 1e-5\nrestitution = 0.9\nfriction = 0.2\ndensity = 2000\n" + more);
}

inline fs::path known_results(const char* name) {
  fs::path folder = fresh_results(name);
  std::string text;
  for (long n = 0; n < 6; ++n) text += text_frame(100 * n, grains_of(-forces[n]));
  write_text(folder / "particles/grains.dump", text);
  write_facts(folder);
  return folder;
}

inline AnalyseOptions options_for(const fs::path& folder) {
  AnalyseOptions options;
  options.results = folder;
  options.window_s = 2e-3;
  options.sizes = {1.0};
  options.no_plots = true;
  return options;
}

// The message of the Error that an analysis throws.
inline std::string refusal_of(const AnalyseOptions& options) {
  try {
    analyse(options);
  } catch (const Error& e) {
    return e.what();
  }
  return "it was analysed";
}

}  // namespace gasgrain
