#include "tools/study/study_table.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

#include "coupling/base/error.h"
#include "tools/whole_file.h"

namespace gasgrain {

namespace fs = std::filesystem;

namespace {

// A field of a CSV file: quoted where it must be, on one line.
std::string field(std::string text) {
  std::replace(text.begin(), text.end(), '\n', ' ');
  if (text.find_first_of(",\"") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + '"';
}

std::string number(double value) {
  return std::isfinite(value) ? fmt::format("{:.5g}", value) : "";
}

std::vector<std::string> cells(const StudyRow& row, const std::vector<std::string>& columns) {
  std::vector<std::string> texts;
  for (const auto& column : columns) {
    if (column == "point") {
      texts.push_back(row.point.name);
    } else if (column == "pareto") {
      texts.emplace_back(row.on_front ? "1" : "0");
    } else if (column == "status") {
      texts.push_back(row.status);
    } else {
      const auto dial = std::find_if(row.point.dials.begin(), row.point.dials.end(),
                                     [&](const auto& entry) { return entry.first == column; });
      texts.push_back(dial != row.point.dials.end() ? dial->second
                                                    : number(row.figures.get(column)));
    }
  }
  return texts;
}

std::string csv(const std::vector<StudyRow>& rows) {
  const auto columns = table_columns(rows);
  std::string text = fmt::format("{}\n", fmt::join(columns, ","));
  for (const auto& row : rows) {
    if (row.status.empty()) continue;
    auto texts = cells(row, columns);
    std::transform(texts.begin(), texts.end(), texts.begin(), field);
    text += fmt::format("{}\n", fmt::join(texts, ","));
  }
  return text;
}

std::string markdown(const Study& study, const std::vector<StudyRow>& rows,
                     const std::string& command, const std::vector<std::string>& findings) {
  std::string text = fmt::format("    {}\n\n", command);
  for (const auto& finding : findings) text += fmt::format("- {}\n", finding);
  text += fmt::format("\nErrors: {}. * is on the Pareto front.\n\n", study.reference_text);
  auto columns = table_columns(rows);
  columns.erase(std::remove(columns.begin(), columns.end(), "pareto"), columns.end());
  text += fmt::format("| {} |\n|", fmt::join(columns, " | "));
  for (std::size_t n = 0; n < columns.size(); ++n) text += "---|";
  text += "\n";
  for (const auto& row : rows) {
    if (row.status.empty()) continue;
    auto texts = cells(row, columns);
    if (row.on_front) texts.front() += " *";
    for (auto& cell : texts) std::replace(cell.begin(), cell.end(), '\n', ' ');
    text += fmt::format("| {} |\n", fmt::join(texts, " | "));
  }
  return text;
}

}  // namespace

std::vector<std::string> table_columns(const std::vector<StudyRow>& rows) {
  std::vector<std::string> columns{"point"};
  const auto add = [&columns](const std::string& name) {
    if (std::find(columns.begin(), columns.end(), name) == columns.end()) columns.push_back(name);
  };
  for (const auto& row : rows)
    for (const auto& dial : row.point.dials) add(dial.first);
  for (const auto& row : rows)
    for (const auto& figure : row.figures.all()) add(figure.first);
  add("pareto");
  add("status");
  return columns;
}

void write_study(const fs::path& folder, const Study& study, const std::vector<StudyRow>& rows,
                 const std::string& command, const std::vector<std::string>& findings) {
  write_whole(folder / "study.csv", csv(rows));
  write_whole(folder / "study.md", markdown(study, rows, command, findings));
  const nlohmann::json labels{{"command", command},
                              {"dial", study.dial},
                              {"dial_text", study.dial_text},
                              {"series", study.series},
                              {"error", study.error},
                              {"error_text", study.error_text},
                              {"error_is_of_the_bed", study.error_is_of_the_bed},
                              {"cost", study_cost},
                              {"cost_text", study_cost_text},
                              {"reference", rows.front().point.name},
                              {"twin", study_twin}};
  constexpr int indent = 2;
  write_whole(folder / "study.json", labels.dump(indent) + "\n");
}

std::string short_table(const Study& study, const std::vector<StudyRow>& rows) {
  std::size_t widest = 0;
  for (const auto& row : rows) widest = std::max(widest, row.point.name.size());
  std::string text = fmt::format("  {:<{}}  {:>14}  {:>14}\n", "", widest, study.error, study_cost);
  for (const auto& row : rows) {
    if (row.status.empty()) continue;
    text += fmt::format("{} {:<{}}  {:>14}  {:>14}  {}\n", row.on_front ? '*' : ' ', row.point.name,
                        widest, number(row.figures.get(study.error)),
                        number(row.figures.get(study_cost)),
                        row.ok() ? "" : field(row.status).substr(0, 100));
  }
  return text + "* on the Pareto front: no other point is both cheaper and more accurate\n";
}

}  // namespace gasgrain
