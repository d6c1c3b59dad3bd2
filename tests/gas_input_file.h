// A gas.toml without faults, and what changes of it bring.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <string>

#include "coupling/base/error.h"
#include "gas_solver/gas_input.h"

namespace gasgrain::gas_input_file {

inline const std::string right = R"([grid]
lo = [0, 0, 0]
hi = [0.15, 0.02, 1.0]
cells = [36, 6, 220]
[time]
end = 1
[boundary]
z_hi = "outlet"
[[inflow]]
side = "z_lo"
shape = "circle"
center = [0.075, 0.01]
diameter = 0.005
mass_flow = 0.006
)";

inline std::string written(const std::string& text) {
  const std::string name =
      testing::TempDir() + "gas_input_test." + std::to_string(getpid()) + ".toml";
  std::ofstream(name) << text;
  return name;
}

inline GasInput read(const std::string& text, bool alone = true) {
  const std::string name = written(text);
  struct Removed {
    const std::string& name;
    ~Removed() { std::remove(name.c_str()); }
  } removed{name};
  return read_gas_input(name, alone);
}

inline std::string faults_of(const std::string& text) {
  try {
    read(text);
  } catch (const Error& e) {
    return e.what();
  }
  return "";
}

inline std::string changed(const std::string& from, const std::string& to) {
  std::string text = right;
  const auto at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

// The right file with lines put after one of its headings, e.g. "[time]".
inline std::string with(const std::string& heading, const std::string& lines) {
  return changed(heading + "\n", heading + "\n" + lines + "\n");
}

inline void expect_fault(const std::string& text, const std::string& fault) {
  const std::string faults = faults_of(text);
  EXPECT_NE(faults.find(fault), std::string::npos) << "expected: " << fault << "\ngot: " << faults;
}

}  // namespace gasgrain::gas_input_file
