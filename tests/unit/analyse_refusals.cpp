// What `gasgrain analyse` refuses, and what it says then.
#include <gtest/gtest.h>

#include "tests/unit/analyse_cases.h"

namespace gasgrain {
namespace {

void expect_told(const std::string& text, const std::vector<std::string>& parts) {
  for (const auto& part : parts)
    EXPECT_NE(text.find(part), std::string::npos) << part << "\n" << text;
}

TEST(AnalysisRefused, tells_all_faults_of_the_command_line_together) {
  const fs::path folder = known_results("faults");
  fs::remove(folder / "analyse.toml");
  auto options = options_for(folder);
  options.window_s = 0.0;
  options.sizes = {1.0, -2.0, 1.0};
  options.steady_s = {2.0, 1.0};
  options.big = "tpye=2";
  options.dump = "grain.dump";
  options.restitution = 1.5;
  options.unexpected = {"--wndow", "2"};
  options.known = {"--dump", "--window"};
  expect_told(refusal_of(options),
              {"--wndow is unknown. Did you mean \"--window\"?", "\"2\" was not expected",
               "--window 0 must be", "--sizes -2 must be above 0", "--sizes 1 is given twice",
               "--steady must be two times", "\"tpye\" is unknown. Did you mean \"type\"?",
               "Did you mean \"grains.dump\"?", "--restitution 1.5 must be from 0 to 1",
               "--timestep is missing", "--friction is missing", "--density is missing"});
}

TEST(AnalysisRefused, names_the_nearest_folder_and_key) {
  const fs::path folder = known_results("nearest");
  auto options = options_for(folder.parent_path() / "naerest");
  expect_told(refusal_of(options), {"is absent", "Did you mean", "nearest"});
  write_facts(folder, "reech = 0.1\n");
  expect_told(refusal_of(options_for(folder)),
              {"analyse.toml:5", "reech", "Did you mean \"reach\"?"});
}

TEST(AnalysisRefused, has_words_for_a_choice_of_big_grains_that_is_none) {
  const fs::path folder = known_results("choice");
  for (const auto& [big, told] : std::vector<std::pair<std::string, std::string>>{
           {"type", "must read type=2"},
           {"id=1,x", "\"x\" of \"id=1,x\" must be a number"},
           {"above=1,2", "must read"},
           {"largest=3", "largest has no value"},
           {"type=3", "no such grain"},
           {"above=1e-9", "no small grains"}}) {
    auto options = options_for(folder);
    options.big = big;
    expect_told(refusal_of(options), {told});
  }
}

TEST(AnalysisRefused, does_not_take_small_grains_for_the_largest_before_the_big_ones_are_there) {
  const fs::path folder = fresh_results("largest");
  write_facts(folder);
  auto small = grains_of(0.0);
  small.pop_back();
  write_text(folder / "particles/grains.dump",
             text_frame(0, small) + text_frame(100, small) + text_frame(200, grains_of(-1e-3)) +
                 text_frame(300, grains_of(-1e-3)) + text_frame(400, grains_of(-1e-3)));
  auto options = options_for(folder);
  expect_told(refusal_of(options), {"of 0.001 m first, of 0.004 m at step 200", "type=..."});
  options.big = "type=2";
  EXPECT_EQ(refusal_of(options), "it was analysed");
}

TEST(AnalysisRefused, does_not_look_beyond_what_the_dumps_hold) {
  const fs::path folder = known_results("reach");
  write_facts(folder, "reach = 0.004\n");
  auto options = options_for(folder);
  EXPECT_EQ(refusal_of(options), "it was analysed");
  options.sizes = {1.0, 2.0};
  expect_told(refusal_of(options), {"--sizes 2", "beyond what the dumps hold", "At most 1.6"});
}

TEST(AnalysisRefused, needs_dumps_that_are_evenly_spaced_and_fill_windows) {
  const fs::path folder = known_results("spacing");
  auto options = options_for(folder);
  options.window_s = 1.5e-3;
  expect_told(refusal_of(options), {"--window 0.0015", "0.001 s from dump to dump", "0.002"});
  options.window_s = 1e-2;
  expect_told(refusal_of(options), {"fill no window"});
  options = options_for(folder);
  const auto frame = [](long step) { return text_frame(step, grains_of(-1e-3)); };
  write_text(folder / "particles/grains.dump", frame(0) + frame(100) + frame(250));
  expect_told(refusal_of(options), {"evenly spaced", "150", "100"});
  write_text(folder / "particles/grains.dump", frame(0) + frame(100) + frame(100));
  expect_told(refusal_of(options), {"step 100 comes after step 100"});
  write_text(folder / "particles/grains.dump", frame(0));
  expect_told(refusal_of(options), {"one frame alone"});
  options = options_for(known_results("late"));
  options.steady_s = {1.0, 2.0};
  expect_told(refusal_of(options), {"no window ends between 1 and 2 s"});
}

TEST(AnalysisRefused, says_which_dumps_and_columns_there_are) {
  const fs::path folder = known_results("columns");
  auto options = options_for(folder);
  options.force = "f_maen";
  expect_told(refusal_of(options), {"no column f_maen[1]", "f_mean[1]"});
  write_text(folder / "particles/others.10.dump", "");
  expect_told(refusal_of(options_for(folder)),
              {"several dumps", "--dump \"grains.dump\"", "--dump \"others.*.dump\""});
  const fs::path empty = fresh_results("empty");
  write_facts(empty);
  expect_told(refusal_of(options_for(empty)), {"has no dumps", "dump grains all custom"});
  const fs::path broken = fresh_results("broken");
  write_facts(broken);
  write_text(broken / "particles/p_0.vtk",
             "# vtk DataFile Version 5.1\nx\nASCII\nDATASET POLYDATA\nPOINTS 2 float\n0 0 0 1\n");
  expect_told(refusal_of(options_for(broken)), {"p_0.vtk is cut short"});
}

}  // namespace
}  // namespace gasgrain
