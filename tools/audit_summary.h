// The audit of a run (coupling/audit_report.h), completed by what only the scene tells: which of
// the gas solver's own effects were on.
#pragma once

#include <filesystem>
#include <string>

namespace gasgrain {

// Writes audit.json and audit.txt anew with their verdicts, and returns the warnings, a line each,
// for the summary. Empty without an audit, or with nothing to warn of.
std::string complete_audit(const std::filesystem::path& scene,
                           const std::filesystem::path& results);

}  // namespace gasgrain
