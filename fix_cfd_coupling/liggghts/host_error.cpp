// Errors of LIGGGHTS itself become ours: one message, with the nearest name, and both programs end.
#include "fix_cfd_coupling/fixes/host_error.h"

#include <fmt/format.h>

#include <cstring>
#include <vector>

#include "coupling/base/error.h"
#include "fix_cfd_coupling/liggghts/contact_styles_words.h"
#include "fix_cfd_coupling/liggghts/host_access.h"
#include "fix_cfd_coupling/liggghts/mpi_redirect.h"
// --
#include "compute.h"
#include "error.h"
#include "force.h"
#include "input.h"

namespace gasgrain {
namespace {

template <class Map>
std::vector<std::string> names_of(const Map& map) {
  std::vector<std::string> names;
  names.reserve(map.size());
  for (const auto& entry : map) names.push_back(entry.first);
  return names;
}

// Commands that the host compares by hand and keeps in no map (LIGGGHTS 3.8 manual, 'Commands').
const std::vector<std::string> built_in_commands{
    "atom_modify",   "atom_style",   "boundary",       "box",
    "communicate",   "compute",      "coarsegraining", "dimension",
    "dump",          "dump_modify",  "echo",           "fix",
    "fix_modify",    "group",        "hard_particles", "if",
    "include",       "jump",         "label",          "lattice",
    "log",           "mass",         "modify_timing",  "neigh_modify",
    "neighbor",      "newton",       "next",           "pair_coeff",
    "pair_style",    "partition",    "print",          "processors",
    "quit",          "region",       "reset_timestep", "restart",
    "run_style",     "shell",        "soft_particles", "thermo",
    "thermo_modify", "thermo_style", "timestep",       "uncompute",
    "undump",        "unfix",        "units",          "variable"};

}  // namespace

const char* program_name() {
  return "gasgrain-liggghts";
}

// ' Did you mean ...?' for the host's messages about unknown styles and commands.
std::string hint(const std::string& message) {
  LAMMPS_NS::LAMMPS* host = current_host();
  if (host == nullptr) return "";
  const auto quoted = [&](char quote) {
    const auto from = message.find(quote);
    const auto to = message.find(quote, from + 1);
    return from == std::string::npos || to == std::string::npos
               ? std::string()
               : message.substr(from + 1, to - from - 1);
  };
  if (message.find("Invalid model specified") != std::string::npos) {
    const LAMMPS_NS::Input& line = *host->input;
    return misspelt_model({line.arg, line.arg + line.narg});
  }
  std::string word;
  std::vector<std::string> known;
  if (message.find("fix style") != std::string::npos) {
    word = quoted('"');
    known = names_of(fix_map(*host));
  } else if (message.find("Invalid pair style") != std::string::npos && host->input->narg > 0) {
    word = host->input->arg[0];
    known = names_of(*host->force->pair_map);
  } else if (message.find("unknown primitive wall style") != std::string::npos) {
    const LAMMPS_NS::Input& line = *host->input;
    for (int n = 0; n + 3 < line.narg; ++n)
      if (std::strcmp(line.arg[n], "primitive") == 0) word = line.arg[n + 3];
    known = {"xplane", "yplane", "zplane", "xcylinder", "ycylinder", "zcylinder"};
  } else if (message.find("Unknown command: ") == 0) {
    word = message.substr(17, message.find(' ', 17) - 17);
    known = names_of(command_map(*host));
    known.insert(known.end(), built_in_commands.begin(), built_in_commands.end());
  } else if (message.find("Unknown argument or wrong keyword order: '") != std::string::npos) {
    // of pair_style gran and fix wall/gran
    word = quoted('\'');
    known = contact_words();
  } else {
    return "";
  }
  const std::string nearest = nearest_name(word, known);
  return nearest.empty() ? " See LIGGGHTS's manual, or docs/liggghts.md for the styles added here."
                         : fmt::format(" Did you mean \"{}\"?", nearest);
}

}  // namespace gasgrain

// The library calls these through the dynamic linker; its own would finalize MPI and hang the
// partner.
namespace LAMMPS_NS {

void Error::all(const char*, int, const char* text) {
  gasgrain::stop_everything(text);
}

void Error::one(const char*, int, const char* text) {
  gasgrain::stop_everything_from_here(text);
}

void Error::fix_error(const char*, int, Fix* fix, const char* text) {
  gasgrain::stop_everything(fmt::format("fix {} (id {}): {}", fix->style, fix->id, text));
}

void Error::fix_error(const char*, int, Fix* fix, const char* name, const char* text) {
  gasgrain::stop_everything(fmt::format("fix {} (id {}): {}", name, fix->id, text));
}

// The command `quit` ends the script, not the process: main closes the coupling and MPI in order.
void Error::done() {
  throw gasgrain::ScriptQuit{};
}

void Error::compute_error(const char*, int, Compute* compute, const char* text) {
  gasgrain::stop_everything(
      fmt::format("compute {} (id {}): {}", compute->style, compute->id, text));
}

}  // namespace LAMMPS_NS
