// The LIST of what can be measured after a run: one kind, one file, one line in kinds.cpp.
#pragma once

#include <filesystem>
#include <functional>
#include <vector>

#include "coupling/base/toml_input.h"
#include "tools/measure/measurement.h"

namespace gasgrain {

// Measures what the script of a run wrote into its results folder. Throws Error when a file is
// absent or what it holds cannot be measured.
using Measure = std::function<Measurement(const std::filesystem::path& results)>;

struct MeasureKind {
  const char* name;
  const char* text;  // for messages and documentation
  // Reads the keys of [measure] but `kind`; faults are collected in the table.
  Measure (*read)(InputTable& table);
};

const std::vector<MeasureKind>& all_measure_kinds();

Measure read_bounce(InputTable& table);
Measure read_drained(InputTable& table);
Measure read_drum(InputTable& table);
Measure read_fragments(InputTable& table);
Measure read_heap(InputTable& table);
Measure read_impact(InputTable& table);
Measure read_pull(InputTable& table);
Measure read_shear(InputTable& table);
Measure read_uniaxial(InputTable& table);

}  // namespace gasgrain
