// gasgrain-gas: the gas solver as a program.
#include <mpi.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <thread>

#include "coupling/base/decomposition.h"
#include "coupling/base/error.h"
#include "coupling/base/file_locks.h"
#include "coupling/transport/launch.h"
#include "gas_solver/coupled_gas_port.h"
#include "gas_solver/gas_fault.h"
#include "gas_solver/gas_step.h"
#include "gas_solver/io/cost_file.h"
#include "gas_solver/io/history.h"
#include "gas_solver/io/progress.h"
#include "gas_solver/io/run_warnings.h"
#include "gas_solver/io/snapshots.h"
#include "gas_solver/io/stop_wish.h"

namespace gasgrain {
namespace {

struct Options {
  GasFiles files;
  int ranks = 0;  // for --check; 0: as many as run
  bool check = false;
};

// The intervals of a run without particles, when [output] every names none.
constexpr double default_interval_steps = 10;

// Multiples of [output] checkpoint_every that have been reached.
long checkpoints_due(const GasSolver& gas, const GasInput& input) {
  constexpr double round_off = 1e-6;
  if (input.checkpoint_every <= 0) return 0;
  return static_cast<long>(std::floor(gas.time() / input.checkpoint_every + round_off));
}

// A gas that cannot go on leaves its state beside the good checkpoints.
GasReport advance_or_leave_autopsy(GasSolver& gas, double interval, const std::string& out) {
  try {
    return gas.advance(interval);
  } catch (const GasFault& fault) {
    const std::string file = out + "/gas.autopsy.h5";
    try {
      gas.write_checkpoint(file);
    } catch (const Error& unwritten) {
      fail("{}\nNo autopsy of it: {}", fault.what(), unwritten.what());
    }
    fail("{}\nFor an autopsy, its state is in {}", fault.what(), file);
  }
}

// The exit status. A wish to stop is met at the end of an interval.
int run_alone(const Options& options, const GasInput& input, const Communicator& comm) {
  catch_stop_wishes(comm.is_root());
  GasSolver gas(input, comm);
  CostLedger& costs = gas.costs();
  const std::size_t output = costs.task("output");
  if (comm.is_root()) std::filesystem::create_directories(options.files.out);
  MPI_Barrier(comm.handle());
  const bool restarted = !options.files.restart.empty();
  if (restarted) gas.read_checkpoint(options.files.restart);
  const double begin = restarted ? gas.time() : -1;
  std::unique_ptr<Snapshots> snapshots;
  if (input.output_every > 0)
    snapshots = std::make_unique<Snapshots>(options.files.out, gas.domain(), begin);
  std::unique_ptr<History> history;
  if (comm.is_root()) history = std::make_unique<History>(options.files.out, input, begin);
  if (snapshots && !snapshots->end_at(gas.time())) snapshots->write(gas);

  RunProgress progress(gas.time(), input.end, output_on_terminal());
  SubstepNote note(input, gas.time());
  RunWarnings warnings;
  const double interval =
      input.output_every > 0 ? input.output_every : default_interval_steps * input.step;
  const double round_off = 1e-9 * std::min(interval, input.end);
  const auto goes_on = [&] { return gas.time() < input.end - round_off; };
  if (comm.is_root() && !goes_on())
    progress.tell(fmt::format("nothing to do: the gas is at {} s, [time] end is {} s", gas.time(),
                              input.end));
  const std::string checkpoint = options.files.out + "/gas.checkpoint.h5";
  long written = checkpoints_due(gas, input);
  int wish = 0;
  while (goes_on() && wish == 0) {
    // Intervals end at multiples of their length, so that a restarted run has the same ones.
    const double next = interval * (std::floor((gas.time() + round_off) / interval) + 1);
    const GasReport report =
        advance_or_leave_autopsy(gas, std::min(next, input.end) - gas.time(), options.files.out);
    // A run that goes on from a checkpoint at this time has learnt nothing either.
    gas.forget();
    const Stopwatch watch(costs, output);
    wish = static_cast<int>(comm.max(stop_wish()));
    if (checkpoints_due(gas, input) > written && goes_on() && wish == 0) {
      gas.write_checkpoint(checkpoint);
      written = checkpoints_due(gas, input);
    }
    if (history) history->add(report);
    warnings.add(report);
    if (snapshots) snapshots->write(gas);
    if (!comm.is_root()) continue;
    if (const std::string text = note.after(report); !text.empty()) progress.tell(text);
    progress.show(report);
  }
  progress.finish();
  if (comm.is_root() && !warnings.text().empty()) progress.tell(warnings.text());
  {
    const Stopwatch watch(costs, output);
    gas.write_checkpoint(checkpoint);
  }
  write_costs(costs, options.files.out, comm);
  if (wish == 0 || !goes_on()) return 0;
  if (comm.is_root())
    progress.tell(fmt::format("stopped at t = {:.6g} of {} s: go on with --restart {}", gas.time(),
                              input.end, checkpoint));
  return status_after(wish);
}

// The exit status.
int run(const Options& options, const Launch& launch) {
  const Communicator& comm = launch.local();
  const bool alone = !options.check && !launch.has_partner();
  const GasInput input = read_gas_input(options.files.input, alone);
  rank_layout(input.grid, options.ranks > 0 ? options.ranks : comm.size());
  if (options.check) {
    if (launch.has_partner())
      fail("--check reads the input only: leave it out of a coupled launch.");
    if (comm.is_root()) fmt::print("ok\n");
  } else if (alone) {
    return run_alone(options, input, comm);
  } else {
    CoupledGas(input, options.files, comm).serve(launch.partner());
  }
  return 0;
}

// One message; every rank of both programs ends.
[[noreturn]] void stop(const Communicator& local, const std::string& message) {
  // An error that all ranks meet is the root's to tell; it ends this rank before the time is over.
  if (!local.is_root()) std::this_thread::sleep_for(std::chrono::seconds(3));
  std::fprintf(stderr, "\ngasgrain-gas: error: %s\n\n", message.c_str());
  std::fflush(nullptr);
  MPI_Abort(MPI_COMM_WORLD, 1);
  std::_Exit(1);
}

int parse(int argc, char** argv, Options& options) {
  CLI::App app("Gas solver of gasgrain: flow through beds of grains on a uniform grid");
  app.set_version_flag("--version", GASGRAIN_VERSION);
  app.add_option("input", options.files.input, "gas.toml")->required();
  app.add_option("--out", options.files.out, "folder for results")->capture_default_str();
  app.add_option("--restart", options.files.restart, "checkpoint to go on from");
  app.add_flag_callback(
      "--keys",
      [] {
        fmt::print("{}", gas_input_keys());
        throw CLI::Success();
      },
      "print the keys of gas.toml with unit, range and default");
  CLI::Option* check =
      app.add_flag("--check", options.check, "read and check the input, run nothing");
  app.add_option("--ranks", options.ranks, "with --check: number of gas ranks the grid must fit")
      ->check(CLI::Range(1, 1000000))
      ->needs(check);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    return app.exit(e) == 0 ? 0 : 1;
  }
  return -1;
}

}  // namespace
}  // namespace gasgrain

int main(int argc, char** argv) {
  gasgrain::open_files_without_semaphores();
  MPI_Init(&argc, &argv);
  // mpirun passes the wish to stop on to all; the DEM program decides when, the gas follows it. A
  // run of the gas alone catches it later.
  std::signal(SIGUSR1, SIG_IGN);
  // A file that grows over the process' limit is then an error of writing, with a message.
  std::signal(SIGXFSZ, SIG_IGN);
  gasgrain::Communicator local(MPI_COMM_WORLD);
  int status = 0;
  try {
    gasgrain::Options options;
    status = gasgrain::parse(argc, argv, options);
    if (status >= 0) {
      // A partner would wait for ever for a program that only printed its help or an error.
      if (local.size() > 1) MPI_Abort(MPI_COMM_WORLD, 1);
    } else {
      const gasgrain::Launch launch(gasgrain::Program::gas);
      local = launch.local();
      status = gasgrain::run(options, launch);
      launch.end();
    }
  } catch (const std::bad_alloc&) {
    gasgrain::stop(local, gasgrain::out_of_memory);
  } catch (const std::exception& e) {
    gasgrain::stop(local, e.what());
  }
  MPI_Finalize();
  return status;
}
