// A program started by this one that never outlives it.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace gasgrain {

struct Command {
  std::vector<std::string> arguments;  // the program first
  std::filesystem::path working_directory;
  std::vector<std::pair<std::string, std::string>> environment;  // where not set already
};

// The command as one line to be pasted into a shell.
std::string shell_line(const Command& command);

class ChildProcess {
 public:
  // Standard output and error go to the file descriptor, standard input is empty. The child has a
  // process group of its own: the terminal's Ctrl-C does not reach it.
  ChildProcess(const Command& command, int output);
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  // The exit status once it has ended: as of a shell, 128 + signal when a signal ended it.
  std::optional<int> poll();
  void signal(int number) const;
  // Ends the child, its process group, and whatever of its descendants is left; other objects'
  // children run on.
  void kill_all();

 private:
  pid_t pid_ = -1;
  std::optional<int> status_;
};

struct Captured {
  int status = 0;
  bool in_time = true;
  std::string output;  // standard output and error
};

// Runs a command to its end, to the time limit, or to a stop request.
Captured run_captured(const Command& command, std::chrono::seconds limit);

}  // namespace gasgrain
