// What `gasgrain run` measures: slopes of heaps of known angle, restitutions of known velocities,
// and its words where a run left nothing to be measured.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <random>

#include "coupling/base/error.h"
#include "tools/measure/measure_file.h"

namespace gasgrain {
namespace {

namespace fs = std::filesystem;

fs::path fresh_folder(const char* name) {
  fs::path folder = fs::temp_directory_path() / "gasgrain-measure" / name;
  fs::remove_all(folder);
  fs::create_directories(folder / "particles");
  return folder;
}

void write(const fs::path& file, const std::string& text) {
  std::ofstream(file) << text;
}

std::string frame(long step, const std::string& columns, const std::vector<std::string>& lines) {
  std::string text = fmt::format(
      "ITEM: TIMESTEP\n{}\nITEM: NUMBER OF ATOMS\n{}\nITEM: BOX BOUNDS ff ff ff\n0 1\n0 1\n0 1\n"
      "ITEM: ATOMS {}\n",
      step, lines.size(), columns);
  for (const auto& line : lines) text += line + "\n";
  return text;
}

Measurement measured(const fs::path& folder, const std::string& toml) {
  write(folder / "measure.toml", toml);
  return read_measure_file(folder)->measure(folder);
}

// The message of the Error that measuring throws.
std::string refusal(const fs::path& folder, const std::string& toml) {
  try {
    measured(folder, toml);
  } catch (const Error& e) {
    return e.what();
  }
  return "it was measured";
}

// Grains of 0.6 mm, strewn densely through a cone of this angle, 40 mm wide, at (0.05, -0.02).
std::vector<std::string> cone(double degrees) {
  constexpr double d = 6e-4;
  constexpr double foot = 0.02;
  constexpr double grains_per_cube = 2.0;  // of a side d: nowhere is the floor seen
  const double slope = std::tan(degrees * M_PI / 180.0);
  std::mt19937 chance(1);
  std::uniform_real_distribution<double> across(-foot, foot);
  std::uniform_real_distribution<double> up(0.0, slope * foot);
  std::vector<std::string> lines;
  const double cubes = 4.0 * foot * foot * slope * foot / (d * d * d);
  for (int n = 0; n < grains_per_cube * cubes; ++n) {
    const double x = across(chance);
    const double y = across(chance);
    const double z = up(chance);
    if (z < slope * (foot - std::hypot(x, y)))
      lines.push_back(fmt::format("{} {} {} {} {}", n, 0.05 + x, -0.02 + y, z, 0.5 * d));
  }
  return lines;
}

TEST(AngleOfRepose, of_a_cone_is_the_cones_angle) {
  for (const double degrees : {10.0, 20.0, 30.0, 40.0}) {
    const fs::path folder = fresh_folder("cone");
    write(folder / "particles/heap.dump", frame(5, "id x y z radius", cone(degrees)));
    const Measurement cone = measured(folder, "[measure]\nkind = \"angle_of_repose\"\n");
    ASSERT_EQ(cone.quantities.front().name, "angle_of_repose");
    // A scatter of 0.3 grains in the height of some 1000 grains that are seen, over 20 of flank.
    EXPECT_NEAR(cone.quantities.front().value, degrees, 0.5);
    EXPECT_GT(cone.quantities.front().uncertainty, 0.0);
    EXPECT_LT(cone.quantities.front().uncertainty, 1.0);
  }
}

TEST(AngleOfRepose, of_the_last_frame_counts) {
  const fs::path folder = fresh_folder("frames");
  write(folder / "particles/heap.dump",
        frame(5, "id x y z radius", cone(40.0)) + frame(6, "id x y z radius", cone(20.0)));
  const auto heap = measured(folder, "[measure]\nkind = \"angle_of_repose\"\n");
  EXPECT_NEAR(heap.quantities.front().value, 20.0, 0.5);
}

TEST(AngleOfRepose, is_refused_where_there_is_no_heap) {
  const fs::path folder = fresh_folder("no_heap");
  const std::string toml = "[measure]\nkind = \"angle_of_repose\"\n";
  EXPECT_NE(refusal(folder, toml).find("heap.dump is absent"), std::string::npos);
  write(folder / "particles/heap.dump", frame(5, "id x y z radius", {"1 0 0 0.1 0.1"}));
  EXPECT_NE(refusal(folder, toml).find("1 grains lie above z = 0 m"), std::string::npos);
  write(folder / "particles/heap.dump", frame(5, "id x y height radius", cone(20.0)));
  EXPECT_NE(refusal(folder, toml).find("the dump has no column z"), std::string::npos);
  const std::string whole = frame(5, "id x y z radius", cone(20.0));
  write(folder / "particles/heap.dump", whole.substr(0, whole.rfind(' ')));
  EXPECT_NE(refusal(folder, toml).find("is cut short"), std::string::npos);
  std::vector<std::string> layer;
  for (int n = 0; n < 400; ++n) layer.push_back(fmt::format("{} {} {} 0.5 0.5", n, n % 20, n / 20));
  write(folder / "particles/heap.dump", frame(5, "id x y z radius", layer));
  EXPECT_NE(refusal(folder, toml).find("diameters: that is no heap"), std::string::npos);
}

TEST(NormalRestitution, is_the_mean_of_the_grains) {
  const fs::path folder = fresh_folder("bounce");
  const std::string columns = "id z vz radius";
  write(folder / "particles/bounce.dump", frame(0, columns, {"1 2 -1 1", "2 2 -2 1"}) +
                                              frame(9, columns, {"2 2 1.2 1", "1 2 0.8 1"}));
  const auto bounce = measured(folder, "[measure]\nkind = \"normal_restitution\"\n");
  EXPECT_NEAR(bounce.quantities.front().value, 0.7, 1e-12);
  EXPECT_NEAR(bounce.quantities.front().uncertainty, 0.1, 1e-12);
  EXPECT_TRUE(bounce.notes.empty());
}

TEST(NormalRestitution, of_a_grain_that_stays_is_zero_and_is_told) {
  const fs::path folder = fresh_folder("stuck");
  const std::string columns = "id z vz radius";
  write(folder / "particles/bounce.dump",
        frame(0, columns, {"1 2 -1 1"}) + frame(9, columns, {"1 0.9 0 1"}));
  const auto bounce = measured(folder, "[measure]\nkind = \"normal_restitution\"\n");
  EXPECT_EQ(bounce.quantities.front().value, 0.0);
  EXPECT_EQ(bounce.notes.size(), 1U);
}

TEST(NormalRestitution, is_refused_where_the_impact_is_not_over) {
  const fs::path folder = fresh_folder("short");
  const std::string columns = "id z vz radius";
  const std::string toml = "[measure]\nkind = \"normal_restitution\"\n";
  const std::string before = frame(0, columns, {"1 2 -1 1"});
  write(folder / "particles/bounce.dump", before);
  EXPECT_NE(refusal(folder, toml).find("in 1 frames"), std::string::npos);
  write(folder / "particles/bounce.dump", before + frame(9, columns, {"1 0.9 0.5 1"}));
  EXPECT_NE(refusal(folder, toml).find("in touch with the plate"), std::string::npos);
  write(folder / "particles/bounce.dump", before + frame(9, columns, {"1 1.5 -1 1"}));
  EXPECT_NE(refusal(folder, toml).find("has not come to the plate"), std::string::npos);
}

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
