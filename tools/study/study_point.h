// One run of a study: the scene with some of its dials turned, and what came out of it.
#pragma once

#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace gasgrain {

using Settings = std::vector<std::pair<std::string, std::string>>;  // name, value

// In place of a value: the table of gas.toml is taken out.
constexpr const char* absent_table = "absent";

struct StudyPoint {
  std::string name;        // of the row, and of the point's folder
  Settings dials;          // the columns that tell what was turned: name, value
  Settings variables;      // of in.liggghts
  std::string pair_style;  // the loop over contacts, gran or gran/bridge; empty: the scene's
  Settings gas_keys;       // of gas.toml
  std::string reference;   // the point that its errors are against; empty: the study's first
  double settle_s = 0;     // time of packing after the packed bed was read, before the gas starts
  double expected_cost = 1.0;  // against the other points, for the time left
  int dem_ranks = 0;           // 0: the study's
  int gas_ranks = 0;
};

// Figures of a point by name, in the order in which they were added: the columns of the table.
class Figures {
 public:
  void set(const std::string& name, double value) {
    for (auto& figure : figures_)
      if (figure.first == name) {
        figure.second = value;
        return;
      }
    figures_.emplace_back(name, value);
  }
  // NaN where there is none: an empty field of the table.
  [[nodiscard]] double get(const std::string& name) const {
    for (const auto& figure : figures_)
      if (figure.first == name) return figure.second;
    return std::numeric_limits<double>::quiet_NaN();
  }
  [[nodiscard]] const std::vector<std::pair<std::string, double>>& all() const { return figures_; }

 private:
  std::vector<std::pair<std::string, double>> figures_;
};

struct StudyRow {
  StudyPoint point;
  std::string status;  // empty: not run yet; "ok"; else why it failed
  Figures figures;
  bool on_front = false;  // no other point is both cheaper and more accurate

  [[nodiscard]] bool ok() const { return status == "ok"; }
};

}  // namespace gasgrain
