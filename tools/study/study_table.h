// The table of a study: study.csv for a spreadsheet, study.md for a page, study.json for the plot.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tools/study/study_kind.h"

namespace gasgrain {

// Columns of the table: point, the dials, the figures in the order in which they first appear, the
// Pareto mark, the status.
std::vector<std::string> table_columns(const std::vector<StudyRow>& rows);

// Writes study.csv and study.json into the folder, and study.md with the command and the findings.
// Rows that have not been run yet are left out.
void write_study(const std::filesystem::path& folder, const Study& study,
                 const std::vector<StudyRow>& rows, const std::string& command,
                 const std::vector<std::string>& findings);

// The table for the terminal: the dials, error and cost.
std::string short_table(const Study& study, const std::vector<StudyRow>& rows);

}  // namespace gasgrain
