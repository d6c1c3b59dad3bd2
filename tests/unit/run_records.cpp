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
  EXPECT_NE(costs.json(Communicator()).find("\"pair forces\": {\"mean_s\": 4"), std::string::npos);
}

}  // namespace
}  // namespace gasgrain
