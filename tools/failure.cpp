#include "tools/failure.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <csignal>
#include <cstring>
#include <regex>
#include <vector>

namespace gasgrain {
namespace {

using Lines = std::vector<std::string>;

bool starts_with(const std::string& line, const char* front) {
  return line.rfind(front, 0) == 0;
}

bool is_own_error(const std::string& line) {
  return starts_with(line, "gasgrain-") && line.find("error:") != std::string::npos;
}

void add_once(Lines& lines, const std::string& line) {
  if (std::find(lines.begin(), lines.end(), line) == lines.end()) lines.push_back(line);
}

Lines own_errors(const Lines& log) {
  Lines errors;
  bool inside = false;
  for (const auto& line : log) {
    // An empty line ends a message.
    inside = is_own_error(line) || (inside && !line.empty());
    if (inside) add_once(errors, line);
  }
  return errors;
}

Lines host_errors(const Lines& log, DemHost host) {
  const std::string name = host == DemHost::lammps ? "LAMMPS: " : "LIGGGHTS: ";
  Lines errors;
  bool told = false;
  for (const auto& line : log) {
    if (starts_with(line, "ERROR"))
      add_once(errors, name + line);
    else if (told && starts_with(line, "Last command: "))
      add_once(errors, line);
    told = starts_with(line, "ERROR");
  }
  return errors;
}

Lines killed_ranks(const Lines& log, int dem_ranks, DemHost host) {
  static const std::regex report("process rank ([0-9]+) .*exited on signal ([0-9]+)");
  Lines sentences;
  std::smatch match;
  for (const auto& line : log) {
    if (!std::regex_search(line, match, report)) continue;
    const int rank = std::stoi(match[1]);
    const int signal = std::stoi(match[2]);
    const bool dem = rank < dem_ranks;
    std::string sentence = fmt::format("{} (its rank {}) was ended by signal {} ({}).",
                                       dem ? program_name(host) : "gasgrain-gas",
                                       dem ? rank : rank - dem_ranks, signal, strsignal(signal));
    if (signal == SIGKILL) sentence += " Often the machine ran out of memory.";
    add_once(sentences, sentence);
  }
  return sentences;
}

bool is_rule(const std::string& line) {
  constexpr std::size_t shortest = 40;
  return line.size() >= shortest && line.find_first_not_of("-=") == std::string::npos;
}

// Open MPI speaks between two rules, and in lines that begin with [host:pid].
Lines without_mpi(const Lines& log) {
  static const std::regex tagged(R"(\[[^\]]*:[0-9]+\].*)");
  Lines kept;
  bool boxed = false;
  for (const auto& line : log) {
    if (is_rule(line))
      boxed = !boxed;
    else if (!boxed && !std::regex_match(line, tagged) &&
             line.find_first_not_of(" \t\r") != std::string::npos)
      kept.push_back(line);
  }
  return kept;
}

}  // namespace

std::string failure_reason(std::istream& output, int dem_ranks, DemHost host) {
  Lines log;
  for (std::string line; std::getline(output, line);) log.push_back(line);

  Lines reason = killed_ranks(log, dem_ranks, host);
  Lines words = own_errors(log);
  if (words.empty()) words = host_errors(log, host);
  reason.insert(reason.end(), words.begin(), words.end());
  if (!reason.empty()) return fmt::format("{}", fmt::join(reason, "\n"));

  constexpr std::ptrdiff_t shown = 5;
  const Lines rest = without_mpi(log);
  if (rest.empty()) return "no program said why.";
  const auto count = std::min(shown, static_cast<std::ptrdiff_t>(rest.size()));
  return fmt::format("no error was named; the last words were:\n  {}",
                     fmt::join(rest.end() - count, rest.end(), "\n  "));
}

}  // namespace gasgrain
