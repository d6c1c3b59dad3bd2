// Reading gas.toml.
#include "gas_solver/gas_input.h"

#include <gtest/gtest.h>

#include "tests/gas_input_file.h"

namespace gasgrain {
namespace {

using namespace gas_input_file;

TEST(gas_input, a_right_file_is_read_with_its_defaults) {
  const GasInput input = read(right);
  EXPECT_EQ(input.grid.cells, (Int3{36, 6, 220}));
  EXPECT_EQ(input.sides[5], &outlet);
  EXPECT_EQ(input.sides[0], &wall_no_slip);
  EXPECT_EQ(input.density, 1.2);
  EXPECT_EQ(input.viscosity, 18.27e-6);
  ASSERT_EQ(input.inflows.size(), 1U);
  const double area = M_PI * 0.0025 * 0.0025;
  EXPECT_NEAR(input.inflows[0].velocity, 0.006 / (1.2 * area), 1e-9);
}

TEST(gas_input, end_of_time_is_required_only_without_particles) {
  const std::string text = changed("end = 1\n", "");
  expect_fault(text, "[time] lacks the key end");
  EXPECT_NO_THROW(read(text, false));
}

TEST(gas_input, all_faults_come_at_once) {
  const std::string faults = faults_of(R"([grid]
lo = [0, 0, 0]
hi = [1, 1, 1]
cells = [4, 4, 4]
[gas]
densty = 1
[time]
end = -1
[boundary]
x_lo = "periodic"
z_hi = "outlt"
[solver]
pressure = "fft"
[output]
pressure_probes = [0.5, 1.5]
)");
  for (const char* fault :
       {":6: the key gas.densty is unknown. Did you mean \"density\"?",
        ":8: time.end = -1 is out of range",
        ":10: boundary.x_lo is \"periodic\" but x_hi is not: set both, or neither.",
        ":11: boundary.z_hi = \"outlt\" is unknown. Did you mean \"outlet\"?",
        ":13: solver.pressure = \"fft\" is unknown.",
        ":15: the pressure probe at z = 1.5 m is outside of the grid, 0 to 1 m."})
    EXPECT_NE(faults.find(fault), std::string::npos) << fault << "\n" << faults;
}

TEST(gas_input, negative_cell_count_is_told_with_what_is_allowed) {
  const std::string faults = faults_of(changed("[36, 6, 220]", "[36, -6, 220]"));
  EXPECT_NE(faults.find(":4: every value of grid.cells must be a number from 1 to 100000, -6 is "
                        "not."),
            std::string::npos)
      << faults;
  expect_fault(changed("[36, 6, 220]", "[36, 6.5, 220]"), "must be three whole numbers");
  expect_fault(changed("[36, 6, 220]", "[36, 6]"), "must have three values, it has 2");
}

TEST(gas_input, patch_outside_its_side_names_both_extents) {
  expect_fault(changed("[0.075, 0.01]", "[0.149, 0.01]"),
               "the inflow covers x 0.1465 to 0.1515, y 0.0075 to 0.0125 m, which leaves its side "
               "z_lo: x 0 to 0.15, y 0 to 0.02 m.");
}

TEST(gas_input, keys_of_another_shape_are_not_ignored) {
  expect_fault(changed("end = 1\n",
                       "end = 1\n[[inflow]]\nside = \"z_lo\"\ncenter = [0.5, 0.5]\n"
                       "size = [0.1, 0.1]\nvelocity = 1\n"),
               "inflow.size goes only with shape = \"rectangle\"");
}

TEST(gas_input, inflow_needs_an_outlet) {
  expect_fault(changed("z_hi = \"outlet\"", ""), "no side lets it out");
}

TEST(gas_input, overlapping_patches_are_found_and_touching_ones_allowed) {
  const auto second = [](const std::string& shape) {
    return right + "[[inflow]]\nside = \"z_lo\"\nvelocity = 1\n" + shape;
  };
  expect_fault(second("shape = \"circle\"\ncenter = [0.079, 0.01]\ndiameter = 0.005\n"),
               "overlaps");
  expect_fault(second("shape = \"whole\"\n"), "overlaps the 1. inflow");
  EXPECT_EQ(
      faults_of(second("shape = \"rectangle\"\ncenter = [0.08, 0.01]\nsize = [0.005, 0.02]\n")),
      "");
}

TEST(gas_input, patch_lies_on_a_wall_only) {
  expect_fault(changed("side = \"z_lo\"", "side = \"z_hi\""),
               "an inflow cannot lie on z_hi, which is \"outlet\"");
}

TEST(gas_input, strength_is_given_once) {
  expect_fault(changed("mass_flow = 0.006", "mass_flow = 0.006\nvelocity = 1"), "not both");
  expect_fault(changed("mass_flow = 0.006\n", ""), "has neither");
}

TEST(gas_input, faulty_grid_does_not_raise_faults_of_what_lies_in_it) {
  const std::string faults =
      faults_of(changed("hi = [0.15, 0.02, 1.0]", "hi = [0.15, -0.02, 1.0]"));
  EXPECT_NE(faults.find("grid.hi must be above grid.lo along y"), std::string::npos) << faults;
  EXPECT_EQ(faults.find("inflow"), std::string::npos) << faults;
}

TEST(gas_input, corner_of_the_grid_that_is_no_number_is_one_fault) {
  for (const char* corner :
       {"[0.15, nan, 1.0]", "[0.15, \"wide\", 1.0]", "[inf, 0.02, 1.0]", "[0.15, 0.02]", "0.15"}) {
    const std::string hi = faults_of(changed("[0.15, 0.02, 1.0]", corner));
    EXPECT_NE(hi.find(":3: "), std::string::npos) << hi;
    EXPECT_EQ(hi.find('\n'), std::string::npos) << hi;
    const std::string lo = faults_of(changed("[0, 0, 0]", corner));
    EXPECT_NE(lo.find(":2: "), std::string::npos) << lo;
    EXPECT_EQ(lo.find('\n'), std::string::npos) << lo;
  }
  expect_fault(changed("[0.15, 0.02, 1.0]", "[0.15, nan, 1.0]"),
               "every value of grid.hi must be a finite number in m, nan is not.");
}

TEST(gas_input, corner_of_a_mass_source_that_is_no_number_is_one_fault) {
  const std::string faults =
      faults_of(right + "[[mass_source]]\nlo = [0, 0, 0]\nhi = [0.1, nan, 0.1]\nrate = 0\n");
  EXPECT_NE(faults.find("every value of mass_source.hi"), std::string::npos) << faults;
  EXPECT_EQ(faults.find('\n'), std::string::npos) << faults;
}

TEST(gas_input, table_in_place_of_a_list_of_tables_is_one_fault_and_is_read) {
  const std::string faults = faults_of(changed("[[inflow]]", "[inflow]"));
  EXPECT_NE(faults.find(":9: inflow must be a list of tables: [[inflow]]."), std::string::npos)
      << faults;
  EXPECT_EQ(faults.find('\n'), std::string::npos) << faults;
  expect_fault(changed("[[inflow]]\nside = \"z_lo\"", "[inflow]\nsid = \"z_lo\""),
               "the key inflow.sid is unknown. Did you mean \"side\"?");
}

TEST(gas_input, list_of_tables_in_place_of_a_table_is_one_fault_and_is_read) {
  const std::string faults = faults_of(changed("[grid]", "[[grid]]"));
  EXPECT_NE(faults.find(":1: grid must be a table: [grid]."), std::string::npos) << faults;
  EXPECT_EQ(faults.find('\n'), std::string::npos) << faults;
}

TEST(gas_input, end_of_time_is_finite) {
  expect_fault(changed("end = 1\n", "end = inf\n"),
               ":6: time.end = inf is not finite: it must be at least 0 in s.");
  expect_fault(changed("end = 1\n", "end = nan\n"), "time.end = nan is not finite");
}

TEST(gas_input, more_steps_than_times_can_tell_apart_are_refused_with_a_step_that_fits) {
  expect_fault(changed("end = 1\n", "end = 1\nstep = 1e-10\n"),
               ":6: time.end = 1 s takes 1e+10 steps of time.step = 1e-10 s, at most 1e+09 fit: "
               "raise time.step to 1.01e-09 s, or lower time.end.");
  EXPECT_EQ(faults_of(changed("end = 1\n", "end = 1\nstep = 1e-9\n")), "");
  EXPECT_EQ(faults_of(changed("end = 1\n", "end = 1e7\nstep = -1\n")).find("fit"),
            std::string::npos);
}

TEST(gas_input, more_snapshots_than_times_can_tell_apart_are_refused_with_an_interval_that_fits) {
  expect_fault(right + "[output]\nevery = 1e-10\n",
               ":16: output.every = 1e-10 s makes 1e+10 snapshots until time.end = 1 s, at most "
               "1e+09 fit: raise it to 1.01e-09 s, or leave it out.");
  EXPECT_EQ(faults_of(right + "[output]\nevery = 1e-9\n"), "");
  EXPECT_EQ(faults_of(right + "[output]\nevery = 0\n"), "");
}

TEST(gas_input, faulty_patch_does_not_raise_faults_of_where_it_lies) {
  for (const char* line : {"diameter = 0.005", "center = [0.075, 0.01]"}) {
    const std::string faults =
        faults_of(changed(line, "") +
                  "[[inflow]]\nside = \"z_lo\"\n"
                  "shape = \"rectangle\"\ncenter = [0.02]\nsize = [1e-3, 1e-3]\nvelocity = 1\n");
    EXPECT_NE(faults.find("[[inflow]] lacks the key"), std::string::npos) << faults;
    EXPECT_NE(faults.find("inflow.center must have two values, it has 1."), std::string::npos)
        << faults;
    EXPECT_EQ(faults.find("overlaps"), std::string::npos) << faults;
    EXPECT_EQ(faults.find("leaves its side"), std::string::npos) << faults;
  }
}

TEST(gas_input, circle_and_rectangles_have_exact_common_areas) {
  const Outline circle{{{-1, -1}, {1, 1}}, true};
  EXPECT_NEAR(common_area(circle, {{-2, -2}, {2, 2}}), M_PI, 1e-14);
  EXPECT_NEAR(common_area(circle, {{0, 0}, {2, 2}}), M_PI / 4, 1e-14);
  EXPECT_NEAR(common_area(circle, {{-0.5, -0.5}, {0.5, 0.5}}), 1.0, 1e-14);
  EXPECT_NEAR(common_area(circle, {{0.5, -2}, {2, 2}}), M_PI / 3 - std::sqrt(3.0) / 4, 1e-14);
  EXPECT_EQ(common_area(circle, {{0.8, 0.8}, {1, 1}}), 0.0);
  double sum = 0;
  for (int i = 0; i < 7; ++i)
    for (int j = 0; j < 7; ++j)
      sum += common_area(circle, {{-1 + 2.0 * i / 7, -1 + 2.0 * j / 7},
                                  {-1 + 2.0 * (i + 1) / 7, -1 + 2.0 * (j + 1) / 7}});
  EXPECT_NEAR(sum, M_PI, 1e-13);
}

}  // namespace
}  // namespace gasgrain
