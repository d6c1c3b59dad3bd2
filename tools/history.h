// What a run tells of itself while it goes: run.json (its plan) and history.csv (its course).
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace gasgrain {

// run.json, written by the DEM side at its start. Time 0 is when the gas starts.
struct RunPlan {
  long first_step = 0;  // of this launch: 0, or the checkpoint's
  long start_step = 0;  // when the gas starts
  double dt_s = 0.0;
  double time_end_s = 0.0;

  [[nodiscard]] double first_s() const {
    return static_cast<double>(first_step - start_step) * dt_s;
  }
};

// Nothing while the file is absent or still being written.
std::optional<RunPlan> read_run_plan(const std::filesystem::path& file);

// history.csv, one line a coupling; values are asked for by the column's name.
class History {
 public:
  explicit History(std::filesystem::path file) : file_(std::move(file)) {}

  // Takes in the lines completed since the last call.
  void read_on();
  // Lets go of the lines read so far.
  void forget_rows() { rows_.clear(); }
  [[nodiscard]] std::size_t rows() const { return rows_.size(); }
  // Nothing where the column is absent or the value is no finite number.
  [[nodiscard]] std::optional<double> value(std::size_t row, const std::string& column) const;
  [[nodiscard]] std::optional<double> last(const std::string& column) const;
  // Column of the first pressure probe, "p_<height>m_Pa"; nothing where the scene has none.
  [[nodiscard]] std::optional<std::string> lowest_probe() const;

 private:
  std::filesystem::path file_;
  std::uintmax_t position_ = 0;
  std::vector<std::string> columns_;
  std::vector<std::vector<double>> rows_;
};

}  // namespace gasgrain
