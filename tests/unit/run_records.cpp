// What a run leaves behind: history.csv, run.json, the cost ledger.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "coupling/base/cost_ledger.h"
#include "coupling/base/error.h"
#include "coupling/run_history.h"

namespace gasgrain {
namespace {

std::string content(const std::string& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

TEST(history_file, is_readable_after_every_line_and_goes_on_after_a_restart) {
  const std::string folder = testing::TempDir();
  {
    HistoryFile history(folder, {"time_s", "bed_height_m"}, false);
    history.write({0.5, 0.25});
    EXPECT_EQ(content(folder + "/history.csv"), "time_s,bed_height_m\n0.5,0.25\n");
  }
  HistoryFile history(folder, {"time_s", "bed_height_m"}, true);
  history.write({1.0, 0.125});
  EXPECT_EQ(content(folder + "/history.csv"), "time_s,bed_height_m\n0.5,0.25\n1,0.125\n");
}

TEST(history_file, says_which_folder_is_missing) {
  try {
    HistoryFile("/no/such/folder", {"time_s"}, false);
    FAIL() << "a file in a missing folder was opened";
  } catch (const Error& e) {
    EXPECT_NE(std::string(e.what()).find("/no/such/folder/history.csv"), std::string::npos);
  }
}

TEST(history_file, reports_a_full_disk) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "no /dev/full on this system";
  const std::string folder = testing::TempDir() + "/full";
  std::filesystem::create_directories(folder);
  std::filesystem::remove(folder + "/history.csv");
  std::filesystem::create_symlink("/dev/full", folder + "/history.csv");
  HistoryFile history(folder, {"time_s"}, false);
  EXPECT_THROW(history.write({1.0}), Error);
}

TEST(run_frame, names_steps_and_times) {
  const std::string folder = testing::TempDir();
  write_run_frame(folder, {100, 300, 200, 0.01, "host", "drag koch_hill"});
  const std::string text = content(folder + "/run.json");
  EXPECT_NE(text.find("\"start_step\": 200"), std::string::npos) << text;
  EXPECT_NE(text.find("\"time_end_s\": 1,"), std::string::npos) << text;
}

TEST(cost_ledger, the_unnamed_rest_is_the_total_less_the_tasks) {
  CostLedger costs;
  costs.charge(costs.task("pair forces"), 3.0);
  costs.charge(costs.task(CostLedger::total), 5.0);
  costs.charge(costs.task("pair forces"), 1.0);
  EXPECT_DOUBLE_EQ(costs.unnamed(), 1.0);
  EXPECT_NE(costs.over(Communicator()).json().find("\"pair forces\": {\"mean_s\": 4"),
            std::string::npos);
}

TEST(cost_ledger, a_closed_ledger_sums_to_its_age) {
  const WallClock before;
  CostLedger costs;
  const WallClock after;
  costs.charge(costs.task("pair forces"), 1e-9);
  while (after.seconds() < 1e-3) {
  }
  const double least = after.seconds();
  costs.close();
  EXPECT_NEAR(costs.unnamed(), 0.0, 1e-15);
  EXPECT_GE(costs.seconds(CostLedger::total), least);
  EXPECT_LE(costs.seconds(CostLedger::total), before.seconds());
  EXPECT_DOUBLE_EQ(costs.seconds("pair forces") + costs.seconds(CostLedger::other),
                   costs.seconds(CostLedger::total));
}

TEST(cost_ledger, the_table_has_the_shares_of_the_total_the_dearest_first) {
  CostLedger costs;
  costs.charge(costs.task("coupling: transport"), 1.0);
  costs.charge(costs.task("pair forces"), 3.0);
  costs.charge(costs.task(CostLedger::total), 4.0);
  const std::string text = costs.over(Communicator()).table("DEM");
  const std::size_t dearest = text.find("75.0 %");
  const std::size_t last = text.find("25.0 %");
  EXPECT_NE(text.find("DEM, 1 rank "), std::string::npos) << text;
  EXPECT_LT(text.find("100.0 %"), dearest) << text;
  EXPECT_LT(dearest, last) << text;
  EXPECT_NE(last, std::string::npos) << text;
}

}  // namespace
}  // namespace gasgrain
