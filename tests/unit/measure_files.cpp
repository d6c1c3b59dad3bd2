// measure.toml with its faults, and the files that a measurement leaves.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/unit/measure_cases.h"

namespace gasgrain {
namespace {

TEST(MeasureFile, names_every_fault_with_its_line_and_remedy) {
  const fs::path folder = fresh_folder("faults");
  EXPECT_FALSE(read_measure_file(folder));
  EXPECT_NE(refusal(folder, "[measure]\nkind = \"angle_of_respose\"\n")
                .find("Did you mean \"angle_of_repose\"?"),
            std::string::npos);
  const std::string text = refusal(folder,
                                   "[measure]\nkind = \"angle_of_repose\"\nsector = 8\n"
                                   "flank_from = 0.95\nfloor = \"low\"\n");
  EXPECT_NE(
      text.find("measure.toml:3: the key measure.sector is unknown. Did you mean \"sectors\"?"),
      std::string::npos)
      << text;
  EXPECT_NE(text.find("measure.toml:4: flank_from = 0.95 must be below flank_to = 0.9"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("measure.toml:5"), std::string::npos) << text;
}

TEST(MeasuredTable, has_a_row_a_quantity_and_refuses_what_is_no_number) {
  const fs::path folder = fresh_folder("table");
  Measurement measured;
  measured.quantities = {{"angle_of_repose", 27.93, "degree", 0.4}};
  measured.curve = {{"a", "b"}, {{1.0, std::nan("")}}};
  write_measurement(folder, "angle_of_repose", measured);
  std::ifstream stream(folder / "measured.csv");
  std::string text((std::istreambuf_iterator<char>(stream)), {});
  EXPECT_EQ(text, "quantity,value,unit,uncertainty\nangle_of_repose,27.93,degree,0.4\n");
  std::ifstream curve(folder / "measured_curve.csv");
  text.assign((std::istreambuf_iterator<char>(curve)), {});
  EXPECT_EQ(text, "a,b\n1,\n");
  measured.quantities.front().value = std::nan("");
  EXPECT_THROW(write_measurement(folder, "angle_of_repose", measured), Error);
}

}  // namespace
}  // namespace gasgrain
