// What `gasgrain run` measures of a broken agglomerate, of known bonds.
#include <gtest/gtest.h>

#include "tests/unit/measure_cases.h"

namespace gasgrain {
namespace {

constexpr const char* fragments = "[measure]\nkind = \"fragments\"\n";

std::string bonds(long step, const std::vector<std::string>& pairs) {
  std::string text = fmt::format(
      "ITEM: TIMESTEP\n{}\nITEM: NUMBER OF ENTRIES\n{}\nITEM: BOX BOUNDS ff ff ff\n0 1\n0 1\n0 1\n"
      "ITEM: ENTRIES c_pairs[1] c_pairs[2]\n",
      step, pairs.size());
  for (const auto& pair : pairs) text += pair + "\n";
  return text;
}

fs::path chain_of_six(const char* name, const std::vector<std::string>& left) {
  const fs::path folder = fresh_folder(name);
  const std::vector<std::string> grains{"6 0 0 0 1", "5 0 0 0 1", "4 0 0 0 1",
                                        "3 0 0 0 1", "2 0 0 0 1", "1 0 0 0 1"};
  write(folder / "particles/grains.dump",
        frame(0, "id x y z radius", grains) + frame(9, "id x y z radius", grains));
  write(folder / "particles/bonds.dump",
        bonds(0, {"1 2", "2 3", "4 3", "4 5", "6 5"}) + bonds(9, left));
  return folder;
}

TEST(Fragments, of_a_chain_that_broke_once_are_its_parts) {
  // 2 - 3 broke; 1 - 3 is new and makes one fragment again of 1 to 3 ... but 2 is left alone
  const auto found = measured(chain_of_six("chain", {"3 1", "3 4", "5 4", "5 6"}), fragments);
  ASSERT_EQ(found.quantities.size(), 3U);
  EXPECT_EQ(found.quantities[0].name, "damage_ratio");
  EXPECT_DOUBLE_EQ(found.quantities[0].value, 2.0 / 5.0);  // 1 - 2 and 2 - 3
  EXPECT_DOUBLE_EQ(found.quantities[1].value, 5.0 / 6.0);
  EXPECT_DOUBLE_EQ(found.quantities[2].value, 1.0);
  EXPECT_DOUBLE_EQ(found.curve.rows.front()[1], 1.0 / 6.0);
  EXPECT_DOUBLE_EQ(found.curve.rows.back()[1], 1.0);
  EXPECT_TRUE(found.notes.empty());
}

TEST(Fragments, without_an_agglomerate_or_a_second_frame_are_refused) {
  const fs::path folder = chain_of_six("chain_refused", {});
  EXPECT_DOUBLE_EQ(measured(folder, fragments).quantities[0].value, 1.0);
  write(folder / "particles/bonds.dump", bonds(0, {}) + bonds(9, {}));
  EXPECT_NE(refusal(folder, fragments).find("the first frame has no bond"), std::string::npos);
  write(folder / "particles/bonds.dump", bonds(0, {"1 2"}));
  EXPECT_NE(refusal(folder, fragments).find("has one frame"), std::string::npos);
  write(folder / "particles/bonds.dump", bonds(0, {"1 2"}) + bonds(9, {"1 7"}));
  EXPECT_NE(refusal(folder, fragments).find("grains 1 and 7 are bonded"), std::string::npos);
}

}  // namespace
}  // namespace gasgrain
