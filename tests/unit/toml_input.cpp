#include "coupling/base/toml_input.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdio>
#include <fstream>

#include "coupling/base/error.h"

namespace gasgrain {
namespace {

std::string written(const std::string& text) {
  const std::string name =
      testing::TempDir() + "toml_input_test." + std::to_string(getpid()) + ".toml";
  std::ofstream(name) << text;
  return name;
}

std::string faults_of(const std::string& text) {
  TomlInput input(written(text));
  auto root = input.root();
  auto gas = root.table("gas");
  gas.number("density", std::nullopt, Range::positive(), "kg/m3");
  gas.choice("drag", "ergun", {"ergun", "koch_hill"});
  root.table("grid").int3("cells", std::nullopt, Range::within(1, 1e6));
  try {
    input.finish();
  } catch (const Error& e) {
    return e.what();
  }
  return "";
}

TEST(toml_input, a_right_file_has_no_fault) {
  EXPECT_EQ(faults_of("[gas]\ndensity = 1.2\ndrag = \"koch_hill\"\n[grid]\ncells = [1, 2, 3]\n"),
            "");
}

TEST(toml_input, all_faults_come_together_each_with_its_line) {
  const std::string faults = faults_of(
      "[gas]\ndensity = -1\ndrag = \"koch_hil\"\ndensty = 2\n[grid]\ncells = [1, 2]\n[extra]\na = "
      "1\n");
  EXPECT_NE(faults.find(":2: gas.density = -1 is out of range: it must be greater than 0 in kg/m3"),
            std::string::npos)
      << faults;
  EXPECT_NE(faults.find(":3: gas.drag = \"koch_hil\" is unknown. Did you mean \"koch_hill\"?"),
            std::string::npos)
      << faults;
  EXPECT_NE(faults.find(":4: the key gas.densty is unknown. Did you mean \"density\"?"),
            std::string::npos)
      << faults;
  EXPECT_NE(faults.find(":6: grid.cells must have three values"), std::string::npos) << faults;
  EXPECT_NE(faults.find("the key extra is unknown"), std::string::npos) << faults;
}

TEST(toml_input, a_missing_key_is_named_with_its_table) {
  EXPECT_NE(faults_of("[gas]\n[grid]\ncells = [1, 1, 1]\n").find("[gas] lacks the key density"),
            std::string::npos);
}

void read_shape(InputTable root) {
  for (InputTable& table : root.tables("shape")) {
    const bool round = table.choice("kind", "round", {"round", "square"}) == "round";
    table.when(round, "kind = \"round\"").number("diameter", std::nullopt, Range::positive(), "m");
    for (const char* edge : {"width", "height"})
      table.when(!round, "kind = \"square\"").number(edge, 1.0, Range::within(0, 2), "m");
  }
}

std::string faults_of_shape(const std::string& text) {
  TomlInput input(written(text));
  read_shape(input.root());
  try {
    input.finish();
  } catch (const Error& e) {
    return e.what();
  }
  return "";
}

TEST(toml_input, a_key_is_asked_for_with_its_choice_only) {
  EXPECT_EQ(faults_of_shape("[[shape]]\nkind = \"square\"\nwidth = 2\n"), "");
  EXPECT_NE(faults_of_shape("[[shape]]\n").find("[[shape]] lacks the key diameter."),
            std::string::npos);
  EXPECT_NE(faults_of_shape("[[shape]]\nkind = \"square\"\ndiameter = 2\n")
                .find(":3: shape.diameter goes only with kind = \"round\": set that, or leave the "
                      "key out."),
            std::string::npos);
}

TEST(toml_input, all_keys_are_listed_with_what_they_may_hold) {
  EXPECT_EQ(TomlInput::key_table(read_shape),
            "| `[[shape]] kind` |  | \"round\", \"square\" | \"round\" |\n"
            "| `[[shape]] diameter` | m | greater than 0 | required; with kind = \"round\" |\n"
            "| `[[shape]] width`, `height` | m | from 0 to 2 | 1; with kind = \"square\" |\n");
}

TEST(toml_input, a_file_that_is_not_toml_gives_its_line) {
  EXPECT_THROW(TomlInput(written("[gas\n")), Error);
  EXPECT_THROW(TomlInput("no such file.toml"), Error);
}

}  // namespace
}  // namespace gasgrain
