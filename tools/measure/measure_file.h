// measure.toml of a scene, and the files that a measurement leaves in the results folder.
#pragma once

#include <optional>
#include <string>

#include "tools/measure/kinds.h"

namespace gasgrain {

struct MeasureFile {
  std::string kind;
  Measure measure;
};

// Nothing when the scene has no measure.toml. Throws one Error with every fault of it.
std::optional<MeasureFile> read_measure_file(const std::filesystem::path& scene);

// Writes measured.csv (quantity,value,unit,uncertainty), measured_curve.csv and measured.json.
void write_measurement(const std::filesystem::path& results, const std::string& kind,
                       const Measurement& measured);

// A line a quantity, for the screen.
std::string text_of(const Measurement& measured);

}  // namespace gasgrain
