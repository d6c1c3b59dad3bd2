#include "tools/history.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

namespace gasgrain {
namespace {

std::vector<std::string> fields(const std::string& line) {
  std::vector<std::string> words;
  std::istringstream text(line);
  for (std::string word; std::getline(text, word, ',');) {
    const auto first = word.find_first_not_of(" \t\r\"");
    const auto last = word.find_last_not_of(" \t\r\"");
    words.push_back(first == std::string::npos ? "" : word.substr(first, last - first + 1));
  }
  return words;
}

double number(const std::string& word) {
  char* end = nullptr;
  const double value = std::strtod(word.c_str(), &end);
  return end == word.c_str() ? std::nan("") : value;
}

}  // namespace

std::optional<RunPlan> read_run_plan(const std::filesystem::path& file) {
  std::ifstream stream(file);
  const auto json = nlohmann::json::parse(stream, nullptr, false);
  if (!json.is_object()) return std::nullopt;
  for (const char* key : {"first_step", "start_step", "dt_s", "time_end_s"})
    if (!json.contains(key) || !json[key].is_number()) return std::nullopt;
  return RunPlan{json["first_step"], json["start_step"], json["dt_s"], json["time_end_s"]};
}

void History::read_on() {
  std::error_code absent;
  const auto size = std::filesystem::file_size(file_, absent);
  if (absent || size == position_) return;
  if (size < position_) {  // begun anew
    position_ = 0;
    columns_.clear();
    rows_.clear();
  }
  std::ifstream stream(file_);
  stream.seekg(static_cast<std::streamoff>(position_));
  for (std::string line; std::getline(stream, line) && !stream.eof();) {
    position_ += line.size() + 1;
    const auto words = fields(line);
    if (columns_.empty()) {
      columns_ = words;
      continue;
    }
    std::vector<double> row(words.size());
    std::transform(words.begin(), words.end(), row.begin(), number);
    rows_.push_back(std::move(row));
  }
}

std::optional<double> History::value(std::size_t row, const std::string& column) const {
  const auto found = std::find(columns_.begin(), columns_.end(), column);
  const auto at = static_cast<std::size_t>(found - columns_.begin());
  if (row >= rows_.size() || at >= rows_[row].size() || !std::isfinite(rows_[row][at]))
    return std::nullopt;
  return rows_[row][at];
}

std::optional<double> History::last(const std::string& column) const {
  return rows_.empty() ? std::nullopt : value(rows_.size() - 1, column);
}

std::optional<std::string> History::lowest_probe() const {
  const auto found = std::find_if(columns_.begin(), columns_.end(), [](const std::string& column) {
    return column.rfind("p_", 0) == 0;
  });
  return found == columns_.end() ? std::nullopt : std::optional(*found);
}

}  // namespace gasgrain
