// Text dumps of LIGGGHTS (`dump ID group custom N FILE id x y z ...`, or `local` with its entries
// for grains), frame by frame.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "coupling/base/vec3.h"

namespace gasgrain {

struct Grain {
  Vec3 position = Vec3::Zero();  // m
  double radius = 0.0;           // m
};

class DumpFrame {
 public:
  DumpFrame(std::string file, long step, std::vector<std::string> columns)
      : file_(std::move(file)), step_(step), columns_(std::move(columns)) {}

  [[nodiscard]] long step() const { return step_; }
  [[nodiscard]] std::size_t size() const { return rows_.size(); }
  // Number of a column; throws an Error that names the file and the nearest column.
  [[nodiscard]] std::size_t column(const std::string& name) const;
  [[nodiscard]] double value(std::size_t row, std::size_t column) const {
    return rows_[row][column];
  }
  // Of the columns x, y, z, radius.
  [[nodiscard]] std::vector<Grain> grains() const;
  void add(std::vector<double> row) { rows_.push_back(std::move(row)); }
  // Rows in the order of the column `id`, which a dump does not keep.
  void sort_by_id();

 private:
  std::string file_;
  long step_;
  std::vector<std::string> columns_;
  std::vector<std::vector<double>> rows_;
};

// All frames in their order; throws Error when there is none or one is cut short.
std::vector<DumpFrame> read_dump(const std::filesystem::path& file);

}  // namespace gasgrain
