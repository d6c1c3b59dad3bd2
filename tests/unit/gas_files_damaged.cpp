// Files that are cut short, foreign or cannot be written: a clear error, and the last good
// checkpoint stays.
#include <gtest/gtest.h>
#include <hdf5.h>
#include <sys/resource.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "coupling/base/error.h"
#include "gas_solver/io/checkpoint.h"
#include "gas_solver/io/history.h"
#include "gas_solver/io/snapshots.h"
#include "tests/gas_cases.h"

namespace gasgrain {
namespace {

using namespace gas_cases;
namespace fs = std::filesystem;

// The limit of a file's size stands for the disk's end.
class FileLimit {
 public:
  explicit FileLimit(rlim_t bytes) : signal_(std::signal(SIGXFSZ, SIG_IGN)) {
    getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit{bytes, before_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FileLimit() {
    setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, signal_);
  }
  FileLimit(const FileLimit&) = delete;
  FileLimit& operator=(const FileLimit&) = delete;

 private:
  void (*signal_)(int);
  rlimit before_{};
};

class gas_files_damaged : public testing::Test {
 protected:
  gas_files_damaged()
      : folder_(testing::TempDir() + "gas_files_damaged." + std::to_string(getpid())),
        file_(folder_ + "/gas.checkpoint.h5"),
        gas_(input(), self()) {
    fs::create_directories(folder_);
    gas_.advance(1e-3);
  }
  ~gas_files_damaged() override { fs::remove_all(folder_); }

  static GasInput input() { return box({6, 4, 12}, Vec3(0.06, 0.04, 0.12), column); }

  void expect_refused(const std::string& words) {
    try {
      gas_.read_checkpoint(file_);
      FAIL() << "no error";
    } catch (const Error& e) {
      EXPECT_NE(std::string(e.what()).find(file_), std::string::npos) << e.what();
      EXPECT_NE(std::string(e.what()).find(words), std::string::npos) << e.what();
    }
  }
  void expect_good(double time) {
    GasSolver other(input(), self());
    other.read_checkpoint(file_);
    EXPECT_EQ(other.time(), time);
    EXPECT_FALSE(fs::exists(file_ + ".new"));
  }
  void put(const std::string& text) { std::ofstream(file_) << text; }

  std::string folder_;
  std::string file_;
  GasSolver gas_;
};

template <class Call>
std::string error_of(const Call& call) {
  try {
    call();
  } catch (const Error& e) {
    return e.what();
  }
  return "no error";
}

void expect_in(const std::string& words, const std::string& text) {
  EXPECT_NE(text.find(words), std::string::npos) << text;
}

TEST_F(gas_files_damaged, checkpoint_cut_short_is_refused_wherever_it_is_cut) {
  gas_.write_checkpoint(file_);
  const auto size = fs::file_size(file_);
  for (const double share : {0.99, 0.5, 0.1}) {
    gas_.write_checkpoint(file_);
    fs::resize_file(file_, static_cast<std::uintmax_t>(share * static_cast<double>(size)));
    expect_refused("it is cut short or damaged");
  }
  fs::resize_file(file_, 0);
  expect_refused("it is empty");
}

TEST_F(gas_files_damaged, checkpoint_that_is_missing_or_foreign_is_refused) {
  expect_refused("No such file or directory");
  put("time_s,substeps\n0.1,5\n");
  expect_refused("it is not an HDF5 file");
  H5Fclose(H5Fcreate(file_.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT));
  expect_refused("is an HDF5 file, but no gas checkpoint");
}

TEST_F(gas_files_damaged, checkpoint_of_another_version_is_refused) {
  gas_.write_checkpoint(file_);
  const hid_t file = H5Fopen(file_.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
  const hid_t version = H5Aopen(file, "gas_checkpoint_version", H5P_DEFAULT);
  const double other = 99;
  H5Awrite(version, H5T_NATIVE_DOUBLE, &other);
  H5Aclose(version);
  H5Fclose(file);
  expect_refused("is a gas checkpoint of version 99, this program reads version");
}

TEST_F(gas_files_damaged, what_a_killed_run_left_beside_is_overwritten) {
  std::ofstream(file_ + ".new") << "half a checkpoint";
  gas_.write_checkpoint(file_);
  expect_good(gas_.time());
}

TEST_F(gas_files_damaged, checkpoint_for_which_there_is_no_room_leaves_the_last_one) {
  gas_.write_checkpoint(file_);
  const double time = gas_.time();
  gas_.advance(1e-3);
  {
    const FileLimit limit(30000);
    const std::string error = error_of([&] { gas_.write_checkpoint(file_); });
    expect_in(file_ + ".new cannot be written: 0.0", error);
    expect_in("left of the limit of a file's size", error);
  }
  expect_good(time);
}

TEST_F(gas_files_damaged, checkpoint_that_fails_when_it_is_finished_leaves_the_last_one) {
  gas_.write_checkpoint(file_);
  // In a process of its own, which ends as the program does: HDF5 crashes when it is ended in
  // order after such a failure.
  const auto finish_without_room = [&] {
    const std::string error = error_of([&] {
      CheckpointWriter writer(file_, gas_.domain());
      writer.number("time", 1);
      const FileLimit limit(100);
      writer.finish();
    });
    std::fprintf(stderr, "%s\n", error.c_str());
    std::_Exit(3);
  };
  EXPECT_EXIT(finish_without_room(), testing::ExitedWithCode(3),
              "checkpoint.h5.new: cannot be flushed: File too large.");
  expect_good(gas_.time());
}

TEST_F(gas_files_damaged, writer_that_is_not_finished_leaves_the_last_checkpoint) {
  gas_.write_checkpoint(file_);
  { CheckpointWriter(file_, gas_.domain()).number("time", 1); }
  expect_good(gas_.time());
}

TEST_F(gas_files_damaged, snapshot_for_which_there_is_no_room_leaves_those_before) {
  const std::string name = folder_ + "/gas.h5";
  {
    Snapshots snapshots(folder_, gas_.domain());
    snapshots.write(gas_);
    gas_.advance(1e-3);
    const FileLimit limit(fs::file_size(name) + 66000);
    expect_in(name + " cannot be written", error_of([&] { snapshots.write(gas_); }));
  }
  Snapshots again(folder_, gas_.domain(), 1);  // drops the one that was not finished
  again.write(gas_);
  std::ifstream in(folder_ + "/gas.xdmf");
  const std::string text((std::istreambuf_iterator<char>(in)), {});
  expect_in("<Grid Name=\"000001\">\n        <Time Value=\"0.002\"/>", text);
}

TEST_F(gas_files_damaged, history_on_a_full_disk_is_an_error_that_names_the_cause) {
  const std::string name = folder_ + "/history.csv";
  History history(folder_, input());
  history.add(GasReport{});
  {
    const FileLimit limit(fs::file_size(name));
    expect_in(name + ": cannot be written: File too large.",
              error_of([&] { history.add(GasReport{}); }));
  }
  // A run that goes on rewrites it: what was there stays when that fails.
  std::error_code none;
  fs::create_symlink("/dev/full", name + ".new", none);
  expect_in(name + ": cannot be written", error_of([&] { History(folder_, input(), 1.0); }));
  EXPECT_GT(fs::file_size(name), 100U);
}

}  // namespace
}  // namespace gasgrain
