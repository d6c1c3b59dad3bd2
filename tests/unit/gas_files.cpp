// Checkpoints, snapshots and histories of the gas solver.
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "coupling/base/error.h"
#include "gas_solver/io/history.h"
#include "gas_solver/io/snapshots.h"
#include "tests/gas_cases.h"

namespace gasgrain {
namespace {

using namespace gas_cases;

// Of this process, removed at its end.
const std::string& folder() {
  struct Folder {
    std::string name = testing::TempDir() + "gas_files_test." + std::to_string(getpid());
    Folder() { std::filesystem::create_directories(name); }
    ~Folder() { std::filesystem::remove_all(name); }
  };
  static const Folder of_this_process;
  return of_this_process.name;
}

GasInput spout(int cells_z = 14) {
  GasInput input = box({6, 4, cells_z}, Vec3(0.06, 0.04, 0.14), walls);
  input.sides[5] = &outlet;
  input.sides[2] = input.sides[3] = &periodic_side;
  InflowPatch jet;
  jet.side = 4;
  jet.outline.bounds = {{0.02, 0.0}, {0.035, 0.04}};
  jet.velocity = 20;
  jet.ramp = 0.02;
  input.inflows = {jet};
  return input;
}

void bed_at(GasSolver& gas, int n) {
  set_bed(
      gas, [n](int i, int j, int k) { return 0.45 + 0.3 * scatter(i + n, j, k); },
      [](int i, int j, int k) { return 2e3 * scatter(k, i, j); },
      [](int i, int j, int k) { return 30 * scatter(j, k, i); });
}

TEST(gas_files, run_that_goes_on_from_a_checkpoint_is_bitwise_the_same) {
  const std::string file = folder() + "/gas.checkpoint.h5";
  GasSolver whole(spout(), self());
  GasSolver second(spout(), self());
  for (int n = 0; n < 8; ++n) {
    bed_at(whole, n);
    whole.advance(1e-3);
    if (n == 4) whole.write_checkpoint(file);
  }
  second.read_checkpoint(file);
  EXPECT_EQ(second.time(), 5e-3);
  for (int n = 5; n < 8; ++n) {
    bed_at(second, n);
    second.advance(1e-3);
  }
  EXPECT_EQ(whole.time(), second.time());
  EXPECT_TRUE(std::equal(whole.state().pressure.begin(), whole.state().pressure.end(),
                         second.state().pressure.begin()));
  for (int d = 0; d < 3; ++d) {
    EXPECT_TRUE(std::equal(whole.state().velocity[d].begin(), whole.state().velocity[d].end(),
                           second.state().velocity[d].begin()));
    EXPECT_TRUE(std::equal(whole.mean_velocity()[d].begin(), whole.mean_velocity()[d].end(),
                           second.mean_velocity()[d].begin()));
  }
}

TEST(gas_files, checkpoint_restores_the_means_that_grains_see) {
  const std::string file = folder() + "/means.h5";
  GasSolver first(spout(), self());
  bed_at(first, 0);
  first.advance(1e-3);
  first.write_checkpoint(file);
  GasSolver second(spout(), self());
  second.read_checkpoint(file);
  EXPECT_TRUE(std::equal(first.mean_pressure_gradient()[2].begin(),
                         first.mean_pressure_gradient()[2].end(),
                         second.mean_pressure_gradient()[2].begin()));
}

TEST(gas_files, checkpoint_of_another_grid_is_refused_with_both_grids) {
  const std::string file = folder() + "/other.h5";
  GasSolver(spout(14), self()).write_checkpoint(file);
  GasSolver other(spout(15), self());
  try {
    other.read_checkpoint(file);
    FAIL() << "no error";
  } catch (const Error& e) {
    EXPECT_NE(std::string(e.what()).find("6 x 4 x 14 cells"), std::string::npos) << e.what();
    EXPECT_NE(std::string(e.what()).find("6 x 4 x 15 cells"), std::string::npos) << e.what();
  }
  EXPECT_THROW(other.read_checkpoint("no such file.h5"), Error);
}

TEST(gas_files, snapshots_go_on_after_a_restart_and_drop_what_came_later) {
  std::filesystem::remove(folder() + "/gas.h5");
  GasSolver gas(spout(), self());
  {
    Snapshots snapshots(folder(), gas.domain());
    for (int n = 0; n < 4; ++n) {
      snapshots.write(gas);
      gas.advance(1e-3);
    }
  }
  {
    Snapshots snapshots(folder(), gas.domain(), 1.5e-3);  // keeps t = 0 and 1 ms
    snapshots.write(gas);
  }
  std::ifstream in(folder() + "/gas.xdmf");
  const std::string text((std::istreambuf_iterator<char>(in)), {});
  EXPECT_NE(text.find("<Grid Name=\"000002\">\n        <Time Value=\"0.004\"/>"), std::string::npos)
      << text;
  EXPECT_EQ(text.find("000003"), std::string::npos);
  EXPECT_NE(text.find("Dimensions=\"14 4 6 3\""), std::string::npos);
}

TEST(gas_files, history_has_a_line_an_interval_and_goes_on_after_a_restart) {
  GasInput input = spout();
  input.pressure_probes = {0.05};
  GasReport report;
  report.probe_pressure = {12.5};
  {
    History history(folder(), input);
    for (const double time : {0.1, 0.2, 0.3}) {
      report.time = time;
      history.add(report);
    }
  }
  {
    History history(folder(), input, 0.2);
    report.time = 0.25;
    history.add(report);
  }
  std::ifstream in(folder() + "/history.csv");
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  ASSERT_EQ(lines.size(), 4U);
  EXPECT_EQ(lines[0].substr(0, 6), "time_s");
  EXPECT_EQ(lines[2].substr(0, 4), "0.2,");
  EXPECT_EQ(lines[3].substr(0, 5), "0.25,");
}

}  // namespace
}  // namespace gasgrain
