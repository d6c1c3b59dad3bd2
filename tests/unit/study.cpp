// The pure parts of `gasgrain study`: courses compared, the Pareto front, the table, grids, steps.
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "coupling/base/error.h"
#include "tools/study/bounce.h"
#include "tools/study/gas_cells.h"
#include "tools/study/kinds.h"
#include "tools/study/pareto_front.h"
#include "tools/study/scene_material.h"
#include "tools/study/study_table.h"
#include "tools/study/trace_error.h"

namespace gasgrain {
namespace {

namespace fs = std::filesystem;

fs::path fresh_folder(const char* name) {
  fs::path folder = fs::temp_directory_path() / "gasgrain-study" / name;
  fs::remove_all(folder);
  fs::create_directories(folder);
  return folder;
}

// A course of 100 lines a second: height 2 + offset, energy scale * t, pressure -> 0 throughout.
void write_course(const fs::path& file, double interval, double offset, double scale) {
  std::ofstream stream(file);
  stream << "time_s,bed_height_m,bubble_diameter_m,kinetic_energy_J,p_0.01m_Pa\n";
  for (int n = -5; n * interval <= 1.0 + 1e-12; ++n)
    stream << n * interval << ',' << 2.0 + (n > 0 ? offset : 99.0) << ',' << 0.1 * scale << ','
           << scale * n * interval << ",0\n";
}

TEST(TraceErrors, are_those_of_known_courses) {
  const fs::path folder = fresh_folder("traces");
  write_course(folder / "reference.csv", 0.01, 0.0, 1.0);
  write_course(folder / "run.csv", 0.03, 0.1, 1.25);
  Figures figures;
  add_trace_errors(folder / "run.csv", folder / "reference.csv", figures);
  // Packing, at negative times and 0, does not count; linear courses are interpolated exactly.
  EXPECT_NEAR(figures.get("height_error"), 0.05, 1e-12);
  EXPECT_NEAR(figures.get("energy_error"), 0.25, 1e-12);
  EXPECT_NEAR(figures.get("bubble_error"), 0.25, 1e-12);
  // A reference that is 0 throughout has no relative error.
  EXPECT_TRUE(std::isnan(figures.get("pressure_error")));
}

TEST(TraceErrors, of_a_run_without_gas_time_are_left_out) {
  const fs::path folder = fresh_folder("empty");
  write_course(folder / "reference.csv", 0.01, 0.0, 1.0);
  std::ofstream(folder / "run.csv") << "time_s,bed_height_m\n";
  Figures figures;
  add_trace_errors(folder / "run.csv", folder / "reference.csv", figures);
  EXPECT_TRUE(figures.all().empty());
}

StudyRow row(const std::string& name, double cost, double error, const std::string& status = "ok") {
  StudyRow made;
  made.point.name = name;
  made.status = status;
  made.figures.set("cost", cost);
  if (std::isfinite(error)) made.figures.set("error", error);
  return made;
}

TEST(ParetoFront, is_what_nobody_beats) {
  std::vector<StudyRow> rows{row("reference", 10, std::nan("")),
                             row(study_twin, 1, 0.0),
                             row("cheap", 1, 0.5),
                             row("dear", 3, 0.1),
                             row("beaten", 4, 0.1),
                             row("beaten too", 1, 0.6),
                             row("failed", 0.1, 0.0, "out of memory"),
                             row("same", 3, 0.1)};
  mark_pareto_front(rows, "cost", "error");
  std::string front;
  for (const auto& entry : rows)
    if (entry.on_front) front += entry.point.name + " ";
  EXPECT_EQ(front, "cheap dear same ");
}

TEST(Exponents, of_a_power_law_are_its_own) {
  std::vector<StudyRow> rows;
  for (const double x : {1.0, 10.0, 500.0}) rows.push_back(row("", x, 3.0 * std::pow(x, -0.5)));
  rows.push_back(row("", 7.0, 1.0, "failed"));
  EXPECT_NEAR(exponent(rows, "error", "cost"), -0.5, 1e-12);
  rows.resize(1);
  EXPECT_TRUE(std::isnan(exponent(rows, "error", "cost")));
}

TEST(StudyTables, keep_failures_as_rows_and_quote_what_must_be) {
  const fs::path folder = fresh_folder("table");
  std::vector<StudyRow> rows{row("a", 1, std::nan("")), row("b", 2, 0.25),
                             row("c", 3, 0.0, "no, \"gas\"\nhere")};
  rows[0].point.dials = {{"dial", "1"}};
  rows[1].point.dials = {{"dial", "2"}};
  rows[2].point.dials = {{"dial", "3"}};
  rows.push_back({});  // not run yet
  rows[2].figures = {};
  write_study(folder, {}, rows, "gasgrain study", {"A finding."});
  std::ifstream stream(folder / "study.csv");
  std::ostringstream text;
  text << stream.rdbuf();
  EXPECT_EQ(text.str(),
            "point,dial,cost,error,pareto,status\n"
            "a,1,1,,0,ok\n"
            "b,2,2,0.25,0,ok\n"
            "c,3,,,0,\"no, \"\"gas\"\" here\"\n");
}

TEST(DividingSteps, are_not_longer_and_divide_the_interval) {
  EXPECT_DOUBLE_EQ(dividing_step(1e-3, 1e-5), 1e-5);
  EXPECT_DOUBLE_EQ(dividing_step(1e-3, 0.99e-5), 1e-3 / 102.0);
  EXPECT_DOUBLE_EQ(dividing_step(1e-3, 1.0), 1e-3);
}

TEST(Values, other_than_numbers_above_0_are_refused) {
  StudyOptions options;
  options.values = {"2e-3", "1e-3", "2e-3"};
  EXPECT_EQ(values_or(options, {1.0}), (std::vector<double>{1e-3, 2e-3}));
  for (const char* word : {"-1", "0", "fast", "1e-3s", "nan"}) {
    options.values = {word};
    EXPECT_THROW(values_or(options, {1.0}), Error) << word;
  }
}

TEST(StudyKinds, plan_the_shipped_scene_with_a_reference_for_every_point) {
  const fs::path scene = fs::path(GASGRAIN_SOURCE) / "inputs" / "spouted_bed_small";
  const SceneCopy copy(scene, fresh_folder("plans") / "scene");
  for (const bool quick : {true, false})
    for (const auto& kind : all_study_kinds()) {
      StudyOptions options;
      options.kind = kind.name;
      options.scene = scene;
      options.quick = quick;
      const Study study = kind.plan(copy, options);
      ASSERT_GE(study.points.size(), 2U) << kind.name;
      EXPECT_FALSE(study.error.empty() || study.dial.empty() || !study.findings) << kind.name;
      std::vector<std::string> names;
      for (const auto& point : study.points) {
        EXPECT_EQ(std::count(names.begin(), names.end(), point.name), 0) << point.name;
        names.push_back(point.name);
        EXPECT_EQ(point.name.find_first_of(" /\""), std::string::npos) << point.name;
        for (const auto& [name, value] : point.variables)
          EXPECT_TRUE(copy.has_variable(name)) << kind.name << " " << name;
      }
      for (const auto& point : study.points)
        EXPECT_TRUE(point.reference.empty() ||
                    std::count(names.begin(), names.end(), point.reference) == 1)
            << point.name;
    }
}

TEST(SceneMaterials, are_those_of_the_script) {
  const GrainMaterial grain =
      scene_material(fs::path(GASGRAIN_SOURCE) / "inputs" / "spouted_bed_small");
  EXPECT_DOUBLE_EQ(grain.radius, 0.00125);
  EXPECT_DOUBLE_EQ(grain.density, 2500.0);
  EXPECT_DOUBLE_EQ(grain.youngs, 1e7);
  EXPECT_DOUBLE_EQ(grain.poisson, 0.17);
  EXPECT_DOUBLE_EQ(grain.restitution, 0.97);
  EXPECT_DOUBLE_EQ(grain.friction, 0.1);
  // 16/15 sqrt(R*) E* (15 m* v^2 / (16 sqrt(R*) E*))^(1/5) by hand: E* 5.149e6, R* 0.625 mm,
  // m* 1.0227e-5 kg.
  EXPECT_NEAR(linear_stiffness(grain, 1.0), 1294.0, 1.0);
}

TEST(GasGrids, keep_a_single_layer_of_cells) {
  const fs::path folder = fresh_folder("grid");
  std::ofstream(folder / "in.liggghts") << "\n";
  std::ofstream(folder / "gas.toml") << "[grid]\nlo = [0, 0, 0]\nhi = [0.1, 0.01, 0.4]\n"
                                        "cells = [10, 1, 41]\n";
  const GasCells grid(SceneCopy(folder, folder / "copy"));
  EXPECT_EQ(grid.times(0.5).text(), "[5, 1, 21]");
  EXPECT_EQ(grid.times(0.01).text(), "[1, 1, 1]");
  EXPECT_DOUBLE_EQ(grid.count(), 410.0);
}

}  // namespace
}  // namespace gasgrain
