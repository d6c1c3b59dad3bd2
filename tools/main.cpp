// The `gasgrain` command: reads the command line and hands over to the subcommand.
#include <CLI/CLI.hpp>
#include <cstdio>

#include "coupling/base/error.h"
#include "tools/advise_command.h"
#include "tools/analyse/analyse_command.h"
#include "tools/calibrate/calibrate_command.h"
#include "tools/run_command.h"
#include "tools/study/study_command.h"

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
  gasgrain run inputs/spouted_bed_small --host lammps
      the same scene in the machine's LAMMPS, by its in.lammps
  gasgrain run inputs/calibration/angle_of_repose_pile --set friction=0.3 --set quick=1
      a scene of grains alone: no gas, and what measure.toml asks for is measured

Ctrl-C writes a checkpoint and ends the run; a second Ctrl-C ends it at once.)";

void add_run(CLI::App& app, gasgrain::RunOptions& options) {
  CLI::App* run = app.add_subcommand("run", "Checks a scene, runs it, and plots what came out");
  run->add_option(
         "SCENE", options.scene,
         "Folder with in.liggghts (in.lammps) and gas.toml (without gas.toml: grains alone)")
      ->required();
  run->add_option_function<std::string>(
         "--host",
         [&options](const std::string& name) {
           if (name != "liggghts" && name != "lammps")
             throw CLI::ValidationError(
                 "--host", fmt::format("\"{}\" is unknown.{}", name,
                                       gasgrain::suggestion(name, {"liggghts", "lammps"})));
           options.host =
               name == "lammps" ? gasgrain::DemHost::lammps : gasgrain::DemHost::liggghts;
         },
         "DEM program, whose script of the scene is run: in.liggghts or in.lammps")
      ->type_name("liggghts|lammps")
      ->default_str("liggghts");
  const auto* dem_ranks =
      run->add_option("--dem-ranks", options.dem_ranks,
                      "MPI ranks of the DEM side (1 for grains alone, unless given)")
          ->check(CLI::PositiveNumber)
          ->capture_default_str();
  const auto* gas_ranks =
      run->add_option("--gas-ranks", options.gas_ranks, "MPI ranks of the gas side")
          ->check(CLI::PositiveNumber)
          ->capture_default_str();
  run->parse_complete_callback([&options, dem_ranks, gas_ranks] {
    options.dem_ranks_given = dem_ranks->count() > 0;
    options.gas_ranks_given = gas_ranks->count() > 0;
  });
  run->add_option("--time", options.time_s, "Simulated time [s] instead of the scene's own")
      ->check(CLI::PositiveNumber);
  run->add_option("--out", options.out, "Results folder (default: results/<scene name>)");
  run->add_option("--gas", options.gas_input,
                  "Another input of the gas in the scene's folder, as of a finer grid")
      ->type_name("FILE")
      ->capture_default_str();
  run->add_flag("--restart", options.restart, "Go on from the newest checkpoint in the folder");
  run->add_flag("--no-plots", options.no_plots, "Leave out history.png and bed.png");
  run->add_option("--var", options.variables, "NAME VALUE: a variable of the script; repeatable")
      ->type_name("NAME VALUE")
      ->allow_extra_args(false);
  run->add_option_function<std::vector<std::string>>(
         "--set",
         [&options](const std::vector<std::string>& settings) {
           for (const auto& setting : settings) {
             const auto equals = setting.find('=');
             if (equals == 0 || equals == std::string::npos)
               throw CLI::ValidationError("--set", '"' + setting + "\" must read NAME=VALUE");
             options.variables.emplace_back(setting.substr(0, equals), setting.substr(equals + 1));
           }
         },
         "NAME=VALUE: as --var, in one word; repeatable")
      ->type_name("NAME=VALUE")
      ->allow_extra_args(false);
  run->footer(run_examples);
}

constexpr const char* study_examples = R"(Examples:
  gasgrain study void-fraction inputs/spouted_bed_small --quick
      all methods on two grids, some minutes; table and picture in results/study/...
  gasgrain study coupling-interval inputs/spouted_bed_small --values 1e-3 2e-3 --time 0.1
      two intervals, each in turn and overlapped, 0.1 s of gas
  gasgrain study contact-model inputs/spouted_bed_small --values "hertz tangential history" hooke
      two contact models
  gasgrain study stiffness inputs/spouted_bed --repeats 3
      the bed of Alobaid (2013): hours

A scene offers its dials as variables of in.liggghts (inputs/spouted_bed_small has all of them).
Ctrl-C ends a study; the same command goes on from the points that are done. A point that fails is a
row of the table that says why.)";

void add_study(CLI::App& app, gasgrain::StudyOptions& options) {
  CLI::App* study =
      app.add_subcommand("study", "Sweeps a dial of a scene: what its accuracy costs in time");
  std::string kinds = "What is turned:";
  for (const auto& [name, text] : gasgrain::study_kinds())
    kinds += fmt::format("\n  {:<18} {}", name, text);
  study->add_option("KIND", options.kind, kinds)->required();
  study->add_option("SCENE", options.scene, "Folder with in.liggghts and gas.toml")->required();
  study->add_option("--values", options.values, "Values of the dial instead of the study's own");
  study->add_option("--time", options.time_s, "Gas time of each point [s]")
      ->check(CLI::PositiveNumber);
  study->add_flag("--quick", options.quick, "Few values, short runs: minutes on a small bed");
  study->add_option("--repeats", options.repeats, "Runs a point; its cost is their median")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  study->add_option("--dem-ranks", options.dem_ranks, "MPI ranks of the DEM side")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  study->add_option("--gas-ranks", options.gas_ranks, "MPI ranks of the gas side")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  study->add_option("--out", options.out, "Folder (default: results/study/<scene name>/KIND)");
  study->add_flag("--no-plots", options.no_plots, "Leave out study.png");
  study->footer(study_examples);
}

constexpr const char* advise_examples = R"(Examples:
  gasgrain advise inputs/spouted_bed
      every effect: its size, on or off, advised; then stiffness, steps, cells, methods
  gasgrain advise inputs/spouted_bed --overlap 2 --speed 8
      the stiffness for an overlap of 2 % of a diameter at 8 m/s, e.g. from a run's audit
  gasgrain advise inputs/spouted_bed --write scenes/advised
      a copy of the scene with the advice put in, each change told; then gasgrain run scenes/advised)";

void add_advise(CLI::App& app, gasgrain::AdviseOptions& options) {
  CLI::App* advise =
      app.add_subcommand("advise", "Says which effects and numerics a scene calls for");
  advise->add_option("SCENE", options.scene, "Folder with in.liggghts and gas.toml")->required();
  advise
      ->add_option("--overlap", options.overlap_percent, "Greatest overlap, percent of a diameter")
      ->check(CLI::Range(0.01, 50.0))
      ->capture_default_str();
  advise
      ->add_option("--speed", options.speed,
                   "Speed of the fastest grain [m/s] (default: estimated)")
      ->check(CLI::PositiveNumber);
  advise->add_flag("--json", options.json, "The same as JSON");
  advise->add_option("--write", options.write,
                     "Folder for a copy of the scene that has the advice");
  advise
      ->add_option("--var", options.variables, "NAME VALUE: a variable of in.liggghts; repeatable")
      ->type_name("NAME VALUE")
      ->allow_extra_args(false);
  advise->footer(advise_examples);
}

constexpr const char* calibrate_examples = R"(Examples:
  gasgrain calibrate inputs/calibration/angle_of_repose_pile --target angle_of_repose=28
      --vary friction=0.1:0.8 --quick
      some ten runs, two at a time; results in results/calibrate/angle_of_repose_pile
  gasgrain calibrate SCENE --target angle_of_repose=28 --tolerance 0.5 --vary friction=0.1:0.8
      --seeds 6
      the mean of six seeds within half a degree
  gasgrain calibrate SCENE --target A=28 --target B=0.4 --vary friction=0.1:0.8
      --vary rolling_friction=0:0.3
      two measured values, two parameters

A scene to be calibrated measures: it has a measure.toml, as those in inputs/calibration.
The status is 0 when every target is met, 2 when it is not. Ctrl-C ends a calibration; the same
command goes on from the runs that are done.)";

void add_calibrate(CLI::App& app, gasgrain::CalibrateOptions& options) {
  CLI::App* calibrate = app.add_subcommand(
      "calibrate", "Finds the parameters at which a scene gives what is measured");
  calibrate->add_option("SCENE", options.scene, "Folder with in.liggghts and measure.toml")
      ->required();
  const auto add = [&](const char* name, std::vector<std::string>& texts, const char* help,
                       const char* type) {
    return calibrate->add_option(name, texts, help)->type_name(type)->allow_extra_args(false);
  };
  add("--target", options.targets, "Measured value of a quantity of the scene; repeatable",
      "NAME=VALUE")
      ->required();
  add("--vary", options.varied,
      "Variable of in.liggghts to be found, and its range; repeatable, no more of them than "
      "targets",
      "NAME=LOW:HIGH")
      ->required();
  add("--tolerance", options.tolerances,
      "How near the mean must come, in the target's unit (default: 2 % of the target); repeatable",
      "[NAME=]VALUE");
  calibrate
      ->add_option(
          "--seeds", options.seeds,
          "Runs with different seeds at the result (default: 3; 1 without a variable seed)")
      ->check(CLI::PositiveNumber);
  calibrate->add_flag("--quick", options.quick, "The scene's quick preset: variable quick is 1");
  calibrate->add_option("--jobs", options.jobs, "Runs at a time")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  calibrate->add_option("--dem-ranks", options.dem_ranks, "MPI ranks of each run")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  calibrate->add_option("--out", options.out, "Folder (default: results/calibrate/<scene name>)");
  calibrate->add_flag("--no-plots", options.no_plots, "Leave out calibration.png");
  calibrate->footer(calibrate_examples);
}

constexpr const char* analyse_examples = R"(Examples:
  gasgrain analyse results/big_sphere_in_stream
      force on the big sphere, Syamlal's drag in four cubes about it, and the factor between them
  gasgrain analyse results/big_sphere_in_stream --sizes 1.25 --window 5e-3 --steady 0.05 0.1
      one cube of 1.25 (d_s + d_b), longer windows, means of a period of one's own
  gasgrain analyse results/mixture --big above=0.002 --timestep 1e-5 --restitution 0.9
      --friction 0.3 --density 2500
      any run with text or VTK dumps: grains above 2 mm are the big ones

Of the dumps it reads id x y z vx vy vz radius, type where that chooses, and the force: the columns
f_mean[1] f_mean[2] f_mean[3] (means over all steps, by 'fix mean big ave/atom'), else fx fy fz.)";

void add_analyse(CLI::App& app, gasgrain::AnalyseOptions& options) {
  CLI::App* analyse =
      app.add_subcommand("analyse", "Drag between big and small grains, from the dumps of a run");
  analyse->add_option("RESULTS", options.results, "Folder of a run, or a file of its dumps")
      ->required();
  analyse->add_option("--dump", options.dump,
                      "Which dumps of RESULTS/particles: \"grains.*.dump\"");
  analyse
      ->add_option("--big", options.big,
                   "The big grains: largest, type=2, id=1,7 or above=0.002 (diameter, m)")
      ->capture_default_str();
  analyse->add_option("--force", options.force, "Columns of the force: f_NAME of a fix, or f");
  analyse->add_option("--window", options.window_s, "Time of a window [s]")->capture_default_str();
  analyse
      ->add_option("--sizes", options.sizes,
                   "Sides of the cubes about a big grain, in the two diameters' sum")
      ->capture_default_str();
  analyse
      ->add_option("--steady", options.steady_s,
                   "From and to [s]: what the means are of (default: the middle half of the "
                   "encounter)")
      ->expected(2);
  analyse->add_option("--timestep", options.timestep_s, "DEM step [s]");
  analyse->add_option("--restitution", options.restitution, "Of small on big");
  analyse->add_option("--friction", options.friction, "Of small on big");
  analyse->add_option("--density", options.density, "Of the grains [kg/m3]");
  analyse->add_option("--density-big", options.density_big, "Of the big ones, where it is another");
  analyse->add_option("--out", options.out, "Folder (default: that of RESULTS)");
  analyse->add_flag("--no-plots", options.no_plots, "Leave out solid_drag.png");
  analyse->allow_extras();  // which analyse() tells with its other faults
  analyse->parse_complete_callback([&options, analyse] {
    options.unexpected = analyse->remaining();
    for (const CLI::Option* option : analyse->get_options())
      for (const auto& name : option->get_lnames()) options.known.push_back("--" + name);
  });
  analyse->footer(analyse_examples);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    CLI::App app{"Gas and particles, coupled: a DEM code and a gas solver run as one."};
    app.set_version_flag("--version", "gasgrain " GASGRAIN_VERSION);
    app.require_subcommand(1);
    app.footer("Help on a subcommand, with examples: gasgrain run --help, gasgrain advise --help");
    gasgrain::RunOptions run_options;
    gasgrain::StudyOptions study_options;
    gasgrain::AdviseOptions advise_options;
    add_run(app, run_options);
    add_advise(app, advise_options);
    add_study(app, study_options);
    gasgrain::CalibrateOptions calibrate_options;
    add_calibrate(app, calibrate_options);
    gasgrain::AnalyseOptions analyse_options;
    add_analyse(app, analyse_options);
    CLI11_PARSE(app, argc, argv);
    if (app.got_subcommand("calibrate")) return gasgrain::calibrate(calibrate_options);
    if (app.got_subcommand("analyse")) return gasgrain::analyse(analyse_options);
    if (app.got_subcommand("advise")) return gasgrain::advise(advise_options);
    return app.got_subcommand("study") ? gasgrain::study(study_options)
                                       : gasgrain::run(run_options);
  } catch (const std::exception& e) {
    std::fprintf(stderr, "gasgrain: error: %s\n", e.what());
    return 1;
  }
}
