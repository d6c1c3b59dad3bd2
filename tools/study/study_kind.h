// What a kind of study is: which points it runs, what its error is, and what it says beside the
// findings of others.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "tools/scene_copy.h"
#include "tools/study/study_options.h"
#include "tools/study/study_point.h"

namespace gasgrain {

// Gas times of the points of a study [s] where --time does not name one. Quick: the first rise of a
// small bed, before its collisions differ by chance alone.
constexpr double quick_time_s = 0.03;
constexpr double full_time_s = 0.2;

// The figure that a study's errors are weighed against.
constexpr const char* study_cost = "wall_s_per_s";
constexpr const char* study_cost_text = "wall time a simulated second [s/s]";
// The point that ought to be the reference's equal: the same run from a bed packed 10 ms longer.
// What it differs by is the bed's own chaos; no smaller difference of another point means anything.
constexpr const char* study_twin = "twin";

struct Study {
  std::vector<StudyPoint> points;  // the first is the reference of all that name no other
  Settings packing;                // variables of in.liggghts with which the bed is packed for all
  std::string dial;                // the column along the picture's axis
  std::string dial_text;           // its axis, with the unit
  std::string series;              // a second dial: a line of the picture each; may be empty
  std::string error;               // the figure that the Pareto front weighs against the cost
  std::string error_text;
  std::string reference_text;       // what the errors are against
  bool error_is_of_the_bed = true;  // and so has a part that is chance
  // Adds the study's own figures to those of the run in this folder (point_figures.h); may be
  // empty.
  std::function<void(const StudyPoint&, const std::filesystem::path&, Figures&)> add_figures;
  // What comes out, beside what others found: a line each, agreement said plainly.
  // The rows come without the twin; `chance` is its error, 0 where there is none.
  std::function<std::vector<std::string>(const std::vector<StudyRow>&, double chance)> findings;
};

struct StudyKind {
  const char* name;
  const char* text;  // for --help
  // Throws Error when the scene lacks a dial or a value cannot be.
  Study (*plan)(const SceneCopy& scene, const StudyOptions& options);
};

// The scene's dial as a number; throws Error when it is none.
double number_of(const SceneCopy& scene, const std::string& variable);
// The options' values as numbers > 0, or those given here; throws Error on any other word.
std::vector<double> values_or(const StudyOptions& options, const std::vector<double>& usual);
// A number as short as it can be written.
std::string text_of(double value);
// A DEM step [s] not longer than this that divides the coupling interval.
double dividing_step(double interval, double step);
// n of figure ~ of^n, fitted through the logarithms of the rows that have both; NaN where less than
// two differ.
double exponent(const std::vector<StudyRow>& rows, const std::string& figure,
                const std::string& of);
// The row of a point, if it went well.
const StudyRow* row_of(const std::vector<StudyRow>& rows, const std::string& point);

}  // namespace gasgrain
