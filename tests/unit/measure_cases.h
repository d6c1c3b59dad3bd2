// A results folder as a run leaves it, and what is measured or refused of it.
#pragma once

#include <fstream>
#include <string>
#include <vector>

#include "coupling/base/error.h"
#include "tools/measure/measure_file.h"

namespace gasgrain {

namespace fs = std::filesystem;

inline fs::path fresh_folder(const char* name) {
  fs::path folder = fs::temp_directory_path() / "gasgrain-measure" / name;
  fs::remove_all(folder);
  fs::create_directories(folder / "particles");
  return folder;
}

inline void write(const fs::path& file, const std::string& text) {
  std::ofstream(file) << text;
}

inline std::string frame(long step, const std::string& columns,
                         const std::vector<std::string>& lines) {
  std::string text = fmt::format(
      "ITEM: TIMESTEP\n{}\nITEM: NUMBER OF ATOMS\n{}\nITEM: BOX BOUNDS ff ff ff\n0 1\n0 1\n0 1\n"
      "ITEM: ATOMS {}\n",
      step, lines.size(), columns);
  for (const auto& line : lines) text += line + "\n";
  return text;
}

inline Measurement measured(const fs::path& folder, const std::string& toml) {
  write(folder / "measure.toml", toml);
  return read_measure_file(folder)->measure(folder);
}

// The message of the Error that measuring throws.
inline std::string refusal(const fs::path& folder, const std::string& toml) {
  try {
    measured(folder, toml);
  } catch (const Error& e) {
    return e.what();
  }
  return "it was measured";
}

}  // namespace gasgrain
