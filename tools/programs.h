// Where the programs of a run are: ours beside this one, mpirun on PATH.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tools/dem_host.h"

namespace gasgrain {

struct Programs {
  std::filesystem::path dem;     // gasgrain-liggghts, or lmp of PATH
  std::filesystem::path gas;     // gasgrain-gas
  std::filesystem::path mpirun;  // empty when PATH has none
  std::filesystem::path plugin;  // gasgrain.lmp, which loads gasgrain.so into lmp; else empty
};

// The folder of this executable, or $GASGRAIN_BIN_DIR where that is set.
Programs find_programs(DemHost host = DemHost::liggghts);

// A line for each program that is absent or not executable, with the remedy; of the gas's where the
// run has a gas.
std::vector<std::string> program_faults(const Programs& programs, bool gas);

bool is_executable(const std::filesystem::path& file);

}  // namespace gasgrain
