// The gas grid of a scene, and finer or coarser ones over the same box.
#pragma once

#include <array>
#include <string>

#include "tools/scene_copy.h"

namespace gasgrain {

struct GasCells {
  std::array<double, 3> size{};  // of the box [m]
  std::array<int, 3> cells{};

  // Throws Error when gas.toml has no readable [grid].
  explicit GasCells(const SceneCopy& scene);

  // As many cells as nearly make the number along each axis `factor` times as many; at least 1, and
  // 1 stays 1: a two-dimensional grid.
  [[nodiscard]] GasCells times(double factor) const;
  [[nodiscard]] double count() const;
  // Side of a cube of a cell's volume [m].
  [[nodiscard]] double cell_size() const;
  // Value of [grid] cells.
  [[nodiscard]] std::string text() const;
};

}  // namespace gasgrain
