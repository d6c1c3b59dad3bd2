// The words of the fix of parcels.
#include <gtest/gtest.h>

#include <sstream>

#include "coupling/base/error.h"
#include "fix_cfd_coupling/dem_physics/parcels/parcel_settings.h"

namespace gasgrain {
namespace {

ParcelSettings settings_of(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> words;
  for (std::string word; stream >> word;) words.push_back(word);
  return parse_parcels(words);
}

TEST(parcel_words, without_any_give_the_documented_defaults) {
  const ParcelSettings s = settings_of("");
  EXPECT_EQ(s.particles, 1.0);
  EXPECT_EQ(s.close_packing, 0.6);
  EXPECT_TRUE(s.stress);
  EXPECT_EQ(s.stress_constant, 100.0);
  EXPECT_EQ(s.stress_exponent, 3.0);
  EXPECT_EQ(s.stress_epsilon, 1e-7);
  EXPECT_EQ(s.restitution, 0.4);
  EXPECT_EQ(s.walls.retention_normal, 0.3);
  EXPECT_EQ(s.walls.retention_tangential, 0.99);
  for (const auto& axis : s.walls.side)
    for (const bool wall : axis) EXPECT_FALSE(wall);
  EXPECT_FALSE(s.damping);
  EXPECT_FALSE(s.isotropy);
  EXPECT_FALSE(s.cells.has_value());
  EXPECT_EQ(s.seed, 1U);
}

TEST(parcel_words, are_read_in_any_order) {
  const ParcelSettings s = settings_of(
      "seed 4 isotropy on 0.99 0.4 walls x_lo z_hi y_lo retention 0.2 0.9 cells 4 5 6 damping on "
      "0.95 restitution 0.1 stress 10 2 1e-8 close_packing 0.62 particles 250.5");
  EXPECT_EQ(s.seed, 4U);
  EXPECT_TRUE(s.isotropy);
  EXPECT_EQ(s.isotropy_restitution, 0.99);
  EXPECT_EQ(s.isotropy_share, 0.4);
  EXPECT_TRUE(s.walls.side[0][0] && s.walls.side[2][1] && s.walls.side[1][0]);
  EXPECT_FALSE(s.walls.side[0][1] || s.walls.side[2][0] || s.walls.side[1][1]);
  EXPECT_EQ(s.walls.retention_normal, 0.2);
  EXPECT_EQ(s.walls.retention_tangential, 0.9);
  EXPECT_EQ(*s.cells, (Int3{4, 5, 6}));
  EXPECT_TRUE(s.damping);
  EXPECT_EQ(s.damping_restitution, 0.95);
  EXPECT_EQ(s.restitution, 0.1);
  EXPECT_EQ(s.stress_constant, 10.0);
  EXPECT_EQ(s.stress_exponent, 2.0);
  EXPECT_EQ(s.stress_epsilon, 1e-8);
  EXPECT_EQ(s.close_packing, 0.62);
  EXPECT_EQ(s.particles, 250.5);
  EXPECT_FALSE(settings_of("stress off").stress);
}

TEST(parcel_words, that_are_wrong_are_all_told_with_their_remedies) {
  std::string text;
  try {
    settings_of(
        "close_packing 1.2 walls x_low damping maybe stres off restitution two retention 2 1");
  } catch (const Error& error) {
    text = error.what();
  }
  for (const char* part :
       {"close_packing 1.2: must be from 0.1 to 0.9", "Did you mean \"x_lo\"",
        "damping maybe: must be 'on' with its numbers, or 'off'", "Did you mean \"stress\"",
        "restitution two: must be a number", "retention 2: must be from 0 to 1"})
    EXPECT_NE(text.find(part), std::string::npos) << part << "\nin\n" << text;
  EXPECT_THROW(settings_of("retention 0.3 0.99"), Error);
}

}  // namespace
}  // namespace gasgrain
