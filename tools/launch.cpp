#include "tools/launch.h"

#include <fmt/format.h>
#include <unistd.h>

#include "tools/results_folder.h"
#include "tools/script_scan.h"

namespace gasgrain {

int dem_ranks(const RunOptions& options) {
  return options.dem_ranks_given || !is_without_gas(options.scene, options.host) ? options.dem_ranks
                                                                                 : 1;
}

Command launch_command(const RunOptions& options, const Programs& programs,
                       const std::filesystem::path& results, std::optional<long> restart_step) {
  Command command;
  command.working_directory = std::filesystem::absolute(options.scene).lexically_normal();
  // Ranks may outnumber cores, hence the waiting that yields; the single-copy mechanism of Open
  // MPI needs a system call that containers forbid, and complains. Large pages save the programs
  // looking up where the grains lie, which they read in any order.
  command.environment = {{"OMPI_MCA_mpi_yield_when_idle", "1"},
                         {"OMPI_MCA_btl_vader_single_copy_mechanism", "none"},
                         {"OMP_NUM_THREADS", "1"},
                         {"GLIBC_TUNABLES", "glibc.malloc.hugetlb=1"}};

  auto& words = command.arguments;
  words = {programs.mpirun, "--oversubscribe", "--bind-to", "none"};
  if (geteuid() == 0) words.emplace_back("--allow-run-as-root");

  const bool gas = !is_without_gas(options.scene, options.host);
  words.insert(words.end(), {"-np", std::to_string(dem_ranks(options)), programs.dem});
  // A stock lmp else takes the ranks of the gas for its own.
  if (options.host == DemHost::lammps && gas) words.insert(words.end(), {"-m", "0"});
  // What the DEM says is in run.log; a log of its own would land in the scene folder.
  words.insert(words.end(),
               {"-in", script_name(options.host), "-log", "none", "-var", "out", results});
  if (options.host == DemHost::lammps)
    words.insert(words.end(), {"-var", "gasgrain", programs.plugin});
  if (options.time_s)
    words.insert(words.end(), {"-var", "time", fmt::format("{}", *options.time_s)});
  if (gas) words.insert(words.end(), {"-var", "restart", std::to_string(restart_step.value_or(0))});
  for (const auto& [name, value] : options.variables)
    words.insert(words.end(), {"-var", name, value});

  if (!gas) return command;
  words.insert(words.end(), {":", "-np", std::to_string(options.gas_ranks), programs.gas});
  words.insert(words.end(), {options.gas_input, "--out", results});
  if (restart_step)
    words.insert(words.end(), {"--restart", gas_checkpoint(results, *restart_step)});
  return command;
}

std::string restart_line(const RunOptions& options) {
  std::string line = fmt::format("gasgrain run {}", options.scene.string());
  if (options.host == DemHost::lammps) line += " --host lammps";
  if (options.dem_ranks != RunOptions{}.dem_ranks)
    line += fmt::format(" --dem-ranks {}", options.dem_ranks);
  if (options.gas_ranks != RunOptions{}.gas_ranks)
    line += fmt::format(" --gas-ranks {}", options.gas_ranks);
  if (options.gas_input != RunOptions{}.gas_input)
    line += fmt::format(" --gas {}", options.gas_input);
  if (options.time_s) line += fmt::format(" --time {}", *options.time_s);
  if (!options.out.empty()) line += fmt::format(" --out {}", options.out.string());
  for (const auto& [name, value] : options.variables)
    line += fmt::format(" --var {} {}", name, value);
  return line + " --restart";
}

}  // namespace gasgrain
