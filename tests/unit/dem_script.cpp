// What `gasgrain advise` reads of a DEM script: tools/dem_script.h, tools/dem_formula.h.
#include "tools/dem_script.h"

#include <gtest/gtest.h>

#include <fstream>

#include "coupling/base/error.h"
#include "tools/dem_formula.h"

namespace gasgrain {
namespace {

namespace fs = std::filesystem;

class DemScripts : public testing::Test {
 protected:
  DemScripts() {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = fs::temp_directory_path() / (std::string("gasgrain-dem-script-") + test->name());
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  ~DemScripts() override { fs::remove_all(folder_); }

  fs::path file(const std::string& text, const std::string& name = "in.liggghts") {
    std::ofstream(folder_ / name) << text;
    return folder_ / name;
  }
  // The words of all commands, a line each.
  static std::string words_of(const DemScript& script) {
    std::string text;
    for (const auto& command : script.commands()) {
      for (const auto& word : command.words) text += "[" + word + "]";
      text += "\n";
    }
    return text;
  }
  std::string error_of(const std::string& text) {
    try {
      const DemScript script(file(text));
    } catch (const Error& e) {
      std::string what = e.what();
      const auto place = what.find(folder_.string());
      if (place != std::string::npos) what.erase(place, folder_.string().size() + 1);
      return what;
    }
    return "";
  }

  fs::path folder_;
};

TEST_F(DemScripts, joins_continued_lines_and_leaves_out_comments) {
  const DemScript script(
      file("timestep 1e-5 # us\n"
           "\n"
           "# all of this\n"
           "fix gas all couple/gas &  # goes on\n"
           "    every 10 &\n"
           "  drag tang\n"
           "print \"# no comment\"\n"));
  EXPECT_EQ(words_of(script),
            "[timestep][1e-5]\n[fix][gas][all][couple/gas][every][10][drag][tang]\n"
            "[print][# no comment]\n");
  EXPECT_EQ(script.commands()[1].line, 4);
  EXPECT_EQ(script.commands()[1].last_line, 6);
}

TEST_F(DemScripts, puts_variables_and_their_formulas_in) {
  const DemScript script(
      file("variable dt index 1e-5\n"
           "variable c index \"hertz tangential history\"\n"
           "variable pack equal 20000\n"
           "variable last equal ${pack}+round(0.5/${dt})\n"
           "variable half equal v_last/2\n"
           "variable later equal step*2\n"
           "pair_style gran/bridge model $c\n"
           "run ${last} upto ${half}\n"));
  EXPECT_EQ(
      words_of(script),
      "[pair_style][gran/bridge][model][hertz][tangential][history]\n[run][70000][upto][35000]\n");
}

TEST_F(DemScripts, leaves_alone_what_the_command_line_or_an_earlier_line_has_set) {
  const std::string text =
      "variable a index 1\nvariable a index 2\nvariable b equal 3\n"
      "variable b equal 4\nrun ${a} ${b}\n";
  EXPECT_EQ(words_of(DemScript(file(text))), "[run][1][4]\n");
  EXPECT_EQ(words_of(DemScript(file(text), {{"a", "7"}})), "[run][7][4]\n");
}

TEST_F(DemScripts, follows_jumps_forward_and_reads_a_loop_once) {
  const DemScript script(
      file("variable restart index 0\n"
           "if \"${restart} > 0\" then \"jump SELF resume\"\n"
           "create_box 1 box\n"
           "jump SELF bed\n"
           "label resume\n"
           "read_restart x\n"
           "label bed\n"
           "if \"${restart} > 0 && 1 < 2\" then \"run 1\" &\n"
           "  elif \"${restart} == 0\" \"run 2\" \"run 3\" else \"run 4\"\n"
           "label again\n"
           "run 5\n"
           "jump SELF again\n"
           "quit\n"
           "run 6\n"));
  EXPECT_EQ(words_of(script), "[create_box][1][box]\n[run][2]\n[run][3]\n[run][5]\n");
}

TEST_F(DemScripts, includes_files_beside_the_script) {
  file("timestep ${dt}\n", "in.more");
  const DemScript script(file("variable dt index 2e-5\ninclude in.more\nrun 1\n"));
  EXPECT_EQ(words_of(script), "[timestep][2e-5]\n[run][1]\n");
  EXPECT_EQ(script.commands()[0].place(), (folder_ / "in.more").string() + ":1");
}

TEST_F(DemScripts, errors_name_the_line_and_the_remedy) {
  EXPECT_EQ(error_of("variable timestep index 1\nrun ${timestp}\n"),
            "in.liggghts:2: the variable \"timestp\" is not set. Did you mean \"timestep\"? Add "
            "'variable timestp index VALUE' above.");
  EXPECT_NE(
      error_of("variable a equal ke/2\nrun ${a}\n").find("in.liggghts:2: \"ke/2\" has no value"),
      std::string::npos);
  EXPECT_EQ(error_of("\njump SELF end\nrun 1\n"),
            "in.liggghts:2: there is no 'label end' to jump to.");
  EXPECT_EQ(error_of("if 1 run 2\n"),
            "in.liggghts:1: 'if' reads: if \"condition\" then \"command\".");
  EXPECT_EQ(error_of("jump other.in\n"),
            "in.liggghts:1: a jump to another file, other.in, cannot be followed. Use 'include' "
            "instead.");
  EXPECT_NE(error_of("include none.in\n").find("in.liggghts:1: "), std::string::npos);
  EXPECT_NE(error_of("include in.liggghts\n").find("includes itself"), std::string::npos);
  EXPECT_EQ(error_of("run ${a\n"), "in.liggghts:1: \"${\" has no \"}\".");
}

TEST(DemFormula, has_the_functions_and_the_precedence_of_the_scripts) {
  EXPECT_EQ(formula_value("20000+round(0.5/1e-5)"), 70000.0);
  EXPECT_EQ(formula_value("2*3^2-4/2"), 16.0);
  EXPECT_EQ(formula_value("log(1000)+ln(exp(2))"), 5.0);
  EXPECT_EQ(formula_value("!(3 > 2) || 1 == 1"), 1.0);
  EXPECT_NEAR(formula_value("sin(PI/2)+floor(-1.5)+ceil(1.2)"), 1.0, 1e-15);
  EXPECT_THROW(formula_value("vcm(all,x)"), Error);
  EXPECT_THROW(formula_value("2 +"), Error);
  EXPECT_THROW(formula_value(""), Error);
}

}  // namespace
}  // namespace gasgrain
