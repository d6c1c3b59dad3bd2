// The `gasgrain` command: reads the command line and hands over to the subcommand.
#include <CLI/CLI.hpp>
#include <cstdio>

#include "coupling/base/error.h"
#include "tools/run_command.h"

namespace {

constexpr const char* run_examples = R"(Examples:
  gasgrain run inputs/spouted_bed_small
      2 DEM ranks and 1 gas rank, results in results/spouted_bed_small
  gasgrain run inputs/spouted_bed_small --time 0.5 --out results/short
      half a second of gas flow, in a folder of its own
  gasgrain run inputs/spouted_bed_small --dem-ranks 4 --gas-ranks 2
      more ranks; the side that waits sleeps, so ranks may outnumber cores
  gasgrain run inputs/spouted_bed_small --restart
      goes on from the newest checkpoint of results/spouted_bed_small
  gasgrain run inputs/spouted_bed_small --var inlet_velocity 30 --var seed 7
      sets variables of in.liggghts

Ctrl-C writes a checkpoint and ends the run; a second Ctrl-C ends it at once.)";

void add_run(CLI::App& app, gasgrain::RunOptions& options) {
  CLI::App* run = app.add_subcommand("run", "Checks a scene, runs it, and plots what came out");
  run->add_option("SCENE", options.scene, "Folder with in.liggghts and gas.toml")->required();
  run->add_option("--dem-ranks", options.dem_ranks, "MPI ranks of the DEM side")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  run->add_option("--gas-ranks", options.gas_ranks, "MPI ranks of the gas side")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  run->add_option("--time", options.time_s, "Simulated time [s] instead of the scene's own")
      ->check(CLI::PositiveNumber);
  run->add_option("--out", options.out, "Results folder (default: results/<scene name>)");
  run->add_flag("--restart", options.restart, "Go on from the newest checkpoint in the folder");
  run->add_flag("--no-plots", options.no_plots, "Leave out history.png and bed.png");
  run->add_option("--var", options.variables, "NAME VALUE: a variable of in.liggghts; repeatable")
      ->type_name("NAME VALUE")
      ->allow_extra_args(false);
  run->footer(run_examples);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    CLI::App app{"Gas and particles, coupled: a DEM code and a gas solver run as one."};
    app.set_version_flag("--version", "gasgrain " GASGRAIN_VERSION);
    app.require_subcommand(1);
    app.footer("Help on a subcommand, with examples: gasgrain run --help");
    gasgrain::RunOptions options;
    add_run(app, options);
    CLI11_PARSE(app, argc, argv);
    return gasgrain::run(options);
  } catch (const std::exception& e) {
    std::fprintf(stderr, "gasgrain: error: %s\n", e.what());
    return 1;
  }
}
