#include "fix_cfd_coupling/fixes/host_error.h"

#include <fmt/format.h>

#include <chrono>
#include <cstdio>
#include <thread>
#include <vector>

#include "coupling/base/error.h"
#include "fix_cfd_coupling/fixes/host_session.h"
#include "fix_cfd_coupling/fixes/script_line.h"
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

LAMMPS_NS::LAMMPS* the_host = nullptr;

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

// ' Did you mean ...?' for the host's messages about unknown styles and commands.
std::string hint(const std::string& message) {
  if (the_host == nullptr) return "";
  const auto quoted = [&](char quote) {
    const auto from = message.find(quote);
    const auto to = message.find(quote, from + 1);
    return from == std::string::npos || to == std::string::npos
               ? std::string()
               : message.substr(from + 1, to - from - 1);
  };
  if (message.find("Invalid model specified") != std::string::npos) {
    const LAMMPS_NS::Input& line = *the_host->input;
    return misspelt_model({line.arg, line.arg + line.narg});
  }
  std::string word;
  std::vector<std::string> known;
  if (message.find("fix style") != std::string::npos) {
    word = quoted('"');
    known = names_of(fix_map(*the_host));
  } else if (message.find("Unknown command: ") == 0) {
    word = message.substr(17, message.find(' ', 17) - 17);
    known = names_of(command_map(*the_host));
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

void print_message(const std::string& message) {
  std::fprintf(stderr, "\ngasgrain-liggghts: error: %s%s%s\n\n", script_place().c_str(),
               with_fault(message).c_str(), hint(message).c_str());
  std::fflush(nullptr);
}

}  // namespace

void set_host(LAMMPS_NS::LAMMPS* host) {
  the_host = host;
}

std::string script_place() {
  return the_host == nullptr ? "" : place_in_script(the_host->infile);
}

void stop_everything(const std::string& message) {
  // An error that all ranks meet is rank 0's to tell; it ends this rank before the time is over.
  if (!session().local.is_root()) std::this_thread::sleep_for(std::chrono::seconds(3));
  print_message(message);
  abort_launch();
}

void stop_everything_from_here(const std::string& message) {
  print_message(message);
  abort_launch();
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
