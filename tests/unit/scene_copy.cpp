// Copies of scenes with other dials: tools/scene_copy.h.
#include "tools/scene_copy.h"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "coupling/base/error.h"

namespace gasgrain {
namespace {

namespace fs = std::filesystem;

std::string text_of(const fs::path& file) {
  std::ifstream stream(file);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

class SceneCopies : public testing::Test {
 protected:
  SceneCopies() {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    root_ = fs::temp_directory_path() / (std::string("gasgrain-scene-copy-") + test->name());
    fs::remove_all(root_);
    fs::create_directories(root_ / "scene");
    std::ofstream(root_ / "scene" / "in.liggghts")
        << "variable dt       index 1.0e-5   # step [s]\n"
           "variable contact  index \"hertz tangential history\"\n"
           "variable last     equal 100\n"
           "fix gas all couple/gas every 100 drag koch_hill\n";
    std::ofstream(root_ / "scene" / "gas.toml") << "[grid]\n"
                                                   "cells = [14, 3,\n"
                                                   "         66]  # odd\n"
                                                   "[time]\n"
                                                   "step = 1e-3  # s\n";
  }
  ~SceneCopies() override { fs::remove_all(root_); }
  fs::path root_;
};

TEST_F(SceneCopies, turned_dials_change_their_values_alone) {
  SceneCopy copy(root_ / "scene", root_ / "copy");
  EXPECT_EQ(copy.variable("contact"), "hertz tangential history");
  EXPECT_EQ(copy.gas_numbers("grid.cells"), (std::vector<double>{14, 3, 66}));
  EXPECT_EQ(copy.gas_numbers("time.step"), std::vector<double>{1e-3});
  EXPECT_TRUE(copy.gas_numbers("time.end").empty());
  copy.set_variable("dt", "2e-6");
  copy.set_variable("contact", "hooke");
  copy.replace_in_script(4, "every 100", "every 500");
  copy.set_gas_key("grid.cells", "[28, 6, 132]");
  copy.set_gas_key("time.courant_max", "2");
  copy.set_gas_key("solver.convection", "\"upwind\"");
  copy.write();
  EXPECT_EQ(text_of(root_ / "copy" / "in.liggghts"),
            "variable dt       index 2e-6   # step [s]\n"
            "variable contact  index hooke\n"
            "variable last     equal 100\n"
            "fix gas all couple/gas every 500 drag koch_hill\n");
  EXPECT_EQ(text_of(root_ / "copy" / "gas.toml"),
            "[grid]\n"
            "cells = [28, 6, 132]  # odd\n"
            "[time]\n"
            "courant_max = 2\n"
            "step = 1e-3  # s\n"
            "\n"
            "[solver]\n"
            "convection = \"upwind\"\n");
}

TEST_F(SceneCopies, a_table_goes_with_its_keys) {
  SceneCopy copy(root_ / "scene", root_ / "copy");
  EXPECT_TRUE(copy.has_gas_key("grid.cells"));
  copy.remove_gas_table("grid");
  copy.remove_gas_table("turbulence");  // is none
  EXPECT_FALSE(copy.has_gas_key("grid.cells"));
  copy.write();
  EXPECT_EQ(text_of(root_ / "copy" / "gas.toml"),
            "[time]\n"
            "step = 1e-3  # s\n");
}

TEST_F(SceneCopies, words_are_quoted_again) {
  SceneCopy copy(root_ / "scene", root_ / "copy");
  copy.set_variable("contact", "hooke tangential history");
  EXPECT_EQ(copy.variable("contact"), "hooke tangential history");
  copy.set_variable("contact", "");
  EXPECT_EQ(copy.variable("contact"), "");
}

TEST_F(SceneCopies, an_absent_variable_is_told_with_the_line_to_add) {
  SceneCopy copy(root_ / "scene", root_ / "copy");
  EXPECT_FALSE(copy.has_variable("contacts"));
  try {
    copy.set_variable("contacts", "hooke");
    FAIL() << "no error";
  } catch (const Error& e) {
    const std::string message = e.what();
    EXPECT_NE(message.find("variable contacts index VALUE"), std::string::npos) << message;
    EXPECT_NE(message.find("There is \"contact\""), std::string::npos) << message;
  }
  // `equal` variables are results, no dials.
  EXPECT_FALSE(copy.has_variable("last"));
}

TEST_F(SceneCopies, the_scene_itself_and_absent_text_are_refused) {
  EXPECT_THROW(SceneCopy(root_ / "scene", root_ / "scene" / "."), Error);
  SceneCopy copy(root_ / "scene", root_ / "copy");
  EXPECT_THROW(copy.replace_in_script(4, "every 200", "every 1"), Error);
  EXPECT_THROW(copy.replace_in_script(9, "every", "x"), Error);
}

}  // namespace
}  // namespace gasgrain
