// What goes with which choice in gas.toml, and what contradicts it.
#include <cmath>

#include "tests/gas_input_file.h"

namespace gasgrain {
namespace {

using namespace gas_input_file;

const std::string sealed = R"([grid]
lo = [0, 0, 0]
hi = [1, 1, 1]
cells = [4, 4, 4]
[time]
end = 1
)";
const std::string jet = "[[inflow]]\nside = \"z_lo\"\nvelocity = 1\n";
const std::string plane = R"([grid]
lo = [0, -0.01, 0]
hi = [1, 0.01, 1]
cells = [4, 1, 4]
plane_of_spheres = 0.004
[time]
end = 1
)";

std::string source(const std::string& box, const std::string& rate) {
  return "[[mass_source]]\n" + box + "\nrate = " + rate + "\n";
}

const std::string half = "lo = [0, 0, 0]\nhi = [0.5, 1, 1]";

TEST(gas_input_choices, density_of_an_ideal_gas_follows_from_its_state) {
  const GasInput input = read(right + "[gas]\nlaw = \"ideal_gas\"\ntemperature = 300\n");
  EXPECT_EQ(input.law, GasLaw::ideal_gas);
  EXPECT_EQ(input.reference_pressure, 101325);
  EXPECT_NEAR(input.density, 101325 * 28.965e-3 / (8.314462618 * 300), 1e-9);
  // The velocity that goes with a mass flow is that at the reference density.
  EXPECT_EQ(input.inflows[0].mass_flow, 0.006);
  EXPECT_NEAR(input.inflows[0].velocity, 0.006 / (input.density * input.inflows[0].outline.area()),
              1e-9);
  expect_fault(right + "[gas]\nlaw = \"ideal_gas\"\ndensity = 1\n",
               "gas.density goes only with law = \"constant_density\": an ideal gas' density "
               "follows from pressure, temperature and molar_mass");
}

TEST(gas_input_choices, state_of_a_gas_of_constant_density_is_a_fault) {
  for (const char* key : {"pressure", "temperature", "molar_mass"})
    expect_fault(right + "[gas]\n" + key + " = 1\n",
                 std::string("gas.") + key + " goes only with law = \"ideal_gas\"");
}

TEST(gas_input_choices, absolute_pressure_of_an_outlet_is_above_vacuum) {
  const std::string text = with("[boundary]", "outlet_pressure = -2e5");
  EXPECT_EQ(faults_of(text), "");
  expect_fault(text + "[gas]\nlaw = \"ideal_gas\"\n",
               "boundary.outlet_pressure = -200000 is gauge");
}

TEST(gas_input_choices, outlet_pressure_needs_an_outlet) {
  expect_fault(sealed + "[boundary]\noutlet_pressure = 1\n",
               "boundary.outlet_pressure goes only with an \"outlet\" side");
}

TEST(gas_input_choices, only_an_ideal_gas_can_be_blown_into_a_sealed_box) {
  expect_fault(sealed + jet,
               "gas of constant density flows in but no side lets it out: set a side "
               "of [boundary] to \"outlet\", or gas.law to \"ideal_gas\".");
  EXPECT_EQ(faults_of(sealed + jet + "[gas]\nlaw = \"ideal_gas\"\n"), "");
}

TEST(gas_input_choices, sources_in_a_sealed_box_sum_to_zero) {
  const std::string both = sealed + source(half, "0.1") + source(half, "-0.1");
  EXPECT_EQ(faults_of(both), "");
  EXPECT_EQ(read(both).mass_sources.size(), 2U);
  expect_fault(sealed + source(half, "0.1"), "must sum to 0, they sum to 0.1 kg/s: set a side");
  EXPECT_EQ(faults_of(sealed + source(half, "0.1") + "[gas]\nlaw = \"ideal_gas\"\n"), "");
}

TEST(gas_input_choices, source_lies_in_the_grid) {
  expect_fault(sealed + source("lo = [0, 0, 0]\nhi = [0.5, 0, 1]", "0"),
               "mass_source.hi must be above lo along y, but 0 <= 0.");
  expect_fault(sealed + source("lo = [1, 0, 0]\nhi = [1.5, 1, 1]", "0"),
               "along x it covers 1 to 1.5 m, the grid 0 to 1 m.");
}

TEST(gas_input_choices, wall_moves_in_its_own_plane) {
  const GasInput input = read(sealed + "[boundary]\nz_hi_velocity = [1, 2, 0]\n");
  EXPECT_EQ(input.wall_velocity[5], Vec3(1, 2, 0));
  EXPECT_EQ(input.wall_velocity[4], Vec3(0, 0, 0));
  expect_fault(sealed + "[boundary]\nz_hi_velocity = [1, 2, 3]\n",
               "boundary.z_hi_velocity has 3 m/s along z");
  expect_fault(sealed + "[boundary]\nz_hi = \"free_slip\"\nz_hi_velocity = [1, 2, 0]\n",
               "boundary.z_hi_velocity goes only with a \"no_slip\" side: make the side");
}

TEST(gas_input_choices, inflow_follows_its_table) {
  const GasInput input = read(
      sealed + jet + "table = [[0.1, 0], [0.2, 1], [0.4, 0.5]]\n[boundary]\nx_hi = \"outlet\"\n");
  const InflowPatch& patch = input.inflows.at(0);
  for (const auto& [time, factor] : std::vector<std::pair<double, double>>{
           {0, 0}, {0.1, 0}, {0.15, 0.5}, {0.2, 1}, {0.3, 0.75}, {0.4, 0.5}, {9, 0.5}})
    EXPECT_NEAR(patch.factor(time), factor, 1e-15) << time;
}

TEST(gas_input_choices, table_of_an_inflow_rises_in_time_and_excludes_a_ramp) {
  expect_fault(right + "table = [[0, 0], [1, 1], [1, 2]]\n", "must rise, but 1 s follows 1 s");
  expect_fault(right + "table = [[0, 0], [1, 1]]\nramp = 1\n", "exclude each other");
  for (const char* table : {"[]", "[0, 1]", "[[0, 1, 2]]", "[[0, -1]]", "1", "[[0, \"1\"]]"})
    expect_fault(right + "table = " + table + "\n",
                 "inflow.table must be a list of [time in s, factor], each at least 0.");
}

TEST(gas_input_choices, blend_goes_with_its_scheme) {
  EXPECT_EQ(read(right + "[solver]\nconvection = \"blend\"\nblend = 0.25\n").blend, 0.25);
  expect_fault(right + "[solver]\nconvection = \"quick\"\nblend = 0.25\n",
               "solver.blend goes only with convection = \"blend\"");
}

TEST(gas_input_choices, outer_iterations_go_with_simple_and_simplec) {
  const GasInput simple = read(right + "[solver]\npressure_velocity = \"simple\"\n");
  EXPECT_EQ(simple.relax_velocity, 0.7);
  EXPECT_EQ(simple.relax_pressure, 0.3);
  const GasInput simplec = read(right + "[solver]\npressure_velocity = \"simplec\"\n");
  EXPECT_EQ(simplec.pressure_velocity, PressureVelocity::simplec);
  EXPECT_EQ(simplec.relax_velocity, 0.9);
  EXPECT_EQ(simplec.relax_pressure, 1.0);
  EXPECT_EQ(simplec.outer_iterations, 50);
  for (const char* key :
       {"outer_iterations", "outer_tolerance", "relax_velocity", "relax_pressure"})
    expect_fault(right + "[solver]\n" + key + " = 1\n",
                 std::string("solver.") + key +
                     " goes only with pressure_velocity = \"simple\" or \"simplec\"");
  expect_fault(right + "[solver]\npressure_velocity = \"simple\"\nrelax_pressure = 0\n",
               "must be greater than 0, at most 1.");
}

TEST(gas_input_choices, correction_passes_are_whole_and_automatic_when_absent) {
  EXPECT_EQ(read(right).correction_passes, 0);
  EXPECT_EQ(read(right + "[solver]\ncorrection_passes = 5\n").correction_passes, 5);
  for (const char* wrong : {"0", "51", "1.5", "\"1\""})
    expect_fault(right + "[solver]\ncorrection_passes = " + wrong + "\n",
                 "solver.correction_passes must be a whole number from 1 to 50.");
}

TEST(gas_input_choices, constants_of_another_turbulence_model_are_faults) {
  const GasInput les =
      read(right + "[turbulence]\nmodel = \"smagorinsky\"\nsmagorinsky_constant = 0.17\n");
  EXPECT_EQ(les.turbulence.smagorinsky_constant, 0.17);
  const GasInput rans =
      read(right + "[turbulence]\nmodel = \"k_epsilon\"\nintensity = 0.1\nlength_scale = 1e-3\n");
  EXPECT_EQ(rans.turbulence.model, TurbulenceModel::k_epsilon);
  EXPECT_EQ(rans.turbulence.intensity, 0.1);
  EXPECT_EQ(rans.turbulence.length_scale, 1e-3);
  expect_fault(right + "[turbulence]\nintensity = 0.1\n",
               "turbulence.intensity goes only with model = \"k_epsilon\"");
  expect_fault(right + "[turbulence]\nmodel = \"k_epsilon\"\nsmagorinsky_constant = 0.1\n",
               "turbulence.smagorinsky_constant goes only with model = \"smagorinsky\"");
}

TEST(gas_input_choices, plane_of_spheres_sets_the_depth_about_the_middle) {
  const GasInput input = read(plane);
  EXPECT_NEAR(input.grid.hi[1] - input.grid.lo[1], 0.004 * 2 * std::pow(3, -0.75), 1e-15);
  EXPECT_NEAR(input.grid.hi[1] + input.grid.lo[1], 0, 1e-15);
  EXPECT_EQ(input.plane_of_spheres, 0.004);
  expect_fault(with("[grid]", "plane_of_spheres = 0.004"),
               "grid.plane_of_spheres needs one cell along y, the grid has 6: set grid.cells to "
               "[36, 1, 220]");
}

TEST(gas_input_choices, plane_of_spheres_has_no_flow_through_its_faces) {
  expect_fault(plane + "[boundary]\ny_hi = \"outlet\"\n",
               "boundary.y_hi = \"outlet\" needs at least 2 cells along y");
  expect_fault(plane + "[boundary]\nz_hi = \"outlet\"\n[[inflow]]\nside = \"y_lo\"\nvelocity = 1\n",
               "an inflow on y_lo needs at least 2 cells along y");
}

TEST(gas_input_choices, schemes_and_models_are_read_by_name) {
  const GasInput input = read(with("[time]", "scheme = \"crank_nicolson\"") +
                              "[gas]\nmodel = \"B\"\n[solver]\nconvection = \"central\"\n");
  EXPECT_EQ(input.scheme, TimeScheme::crank_nicolson);
  EXPECT_EQ(input.model, GasModel::b);
  EXPECT_EQ(input.convection, Convection::central);
  EXPECT_EQ(read(right).scheme, TimeScheme::implicit_euler);
  expect_fault(with("[time]", "scheme = \"crank_nicholson\""), "Did you mean \"crank_nicolson\"?");
}

TEST(gas_input_choices, every_key_is_in_the_table_of_keys) {
  const std::string keys = gas_input_keys();
  for (const char* line :
       {"| `[grid] lo`, `hi` | m | three numbers | required |\n",
        "| `[gas] density` | kg/m3 | greater than 0 | 1.2; with law = \"constant_density\" |\n",
        "| `[[inflow]] table` |  | list of [time in s, factor], each at least 0 | none |\n",
        "| `[[mass_source]] rate` | kg/s | any finite number | required |\n"})
    EXPECT_NE(keys.find(line), std::string::npos) << line << "\n" << keys;
}

}  // namespace
}  // namespace gasgrain
