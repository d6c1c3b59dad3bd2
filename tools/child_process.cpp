#include "tools/child_process.h"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <fstream>
#include <memory>
#include <sstream>
#include <thread>

#include "coupling/base/error.h"
#include "tools/stop_request.h"

namespace gasgrain {

namespace fs = std::filesystem;

namespace {

std::string quoted(const std::string& word) {
  const bool plain = !word.empty() && word.find_first_not_of(
                                          "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ"
                                          "0123456789_-+=./:,@%") == std::string::npos;
  if (plain) return word;
  std::string text = "'";
  for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return text + "'";
}

// Runs in the child between fork and exec.
[[noreturn]] void become(const Command& command, int output, pid_t parent) {
  setpgid(0, 0);
  // SIGTERM, not SIGKILL: mpirun then ends its ranks, which are in groups of their own.
  prctl(PR_SET_PDEATHSIG, SIGTERM);
  if (getppid() != parent) _exit(1);
  for (const int number : {SIGINT, SIGTERM, SIGHUP}) std::signal(number, SIG_DFL);
  const int nothing = open("/dev/null", O_RDONLY);
  dup2(nothing, STDIN_FILENO);
  dup2(output, STDOUT_FILENO);
  dup2(output, STDERR_FILENO);
  if (chdir(command.working_directory.c_str()) != 0) {
    std::perror(command.working_directory.c_str());
    _exit(1);
  }
  for (const auto& [name, value] : command.environment) setenv(name.c_str(), value.c_str(), 0);
  std::vector<char*> arguments;
  for (const auto& word : command.arguments) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  execvp(arguments[0], arguments.data());
  std::perror(arguments[0]);
  constexpr int not_found = 127;
  _exit(not_found);
}

// Children that an object still answers for.
std::vector<pid_t>& started() {
  static std::vector<pid_t> pids;
  return pids;
}

void forget(pid_t pid) {
  started().erase(std::remove(started().begin(), started().end(), pid), started().end());
}

// Children of this process that no other object answers for, those included that it inherited from
// a child that died.
std::vector<pid_t> children() {
  std::vector<pid_t> found;
  for (const auto& entry : fs::directory_iterator("/proc")) {
    const std::string name = entry.path().filename();
    if (name.find_first_not_of("0123456789") != std::string::npos) continue;
    std::ifstream file(entry.path() / "stat");
    const std::string stat((std::istreambuf_iterator<char>(file)), {});
    const auto name_end = stat.rfind(')');  // the program's name may hold spaces
    if (name_end == std::string::npos) continue;
    std::istringstream rest(stat.substr(name_end + 1));
    char state = ' ';
    pid_t parent = 0;
    const pid_t pid = std::stoi(name);
    if (rest >> state >> parent && parent == getpid() &&
        std::find(started().begin(), started().end(), pid) == started().end())
      found.push_back(pid);
  }
  return found;
}

}  // namespace

std::string shell_line(const Command& command) {
  std::string line = "cd " + quoted(command.working_directory) + " &&";
  for (const auto& [name, value] : command.environment) line += " " + name + "=" + quoted(value);
  for (const auto& word : command.arguments) line += " " + quoted(word);
  return line;
}

ChildProcess::ChildProcess(const Command& command, int output) {
  // Ranks that lose mpirun become our children, so that kill_all() finds them.
  prctl(PR_SET_CHILD_SUBREAPER, 1);
  const pid_t parent = getpid();
  pid_ = fork();
  if (pid_ < 0)
    fail("cannot start {}: the system allows no further process.", command.arguments[0]);
  if (pid_ == 0) become(command, output, parent);
  setpgid(pid_, pid_);
  started().push_back(pid_);
}

ChildProcess::~ChildProcess() {
  kill_all();
}

std::optional<int> ChildProcess::poll() {
  int state = 0;
  if (!status_ && waitpid(pid_, &state, WNOHANG) == pid_) {
    status_ = WIFEXITED(state) ? WEXITSTATUS(state) : 128 + WTERMSIG(state);
    forget(pid_);
  }
  return status_;
}

void ChildProcess::signal(int number) const {
  if (!status_) kill(pid_, number);
}

void ChildProcess::kill_all() {
  if (!poll()) kill(-pid_, SIGKILL);
  forget(pid_);
  // Each death may hand us the children of the dead.
  for (auto left = children(); !left.empty(); left = children()) {
    for (const pid_t pid : left) kill(pid, SIGKILL);
    for (const pid_t pid : left) {
      int state = 0;
      waitpid(pid, &state, 0);
      if (pid == pid_) status_ = WIFEXITED(state) ? WEXITSTATUS(state) : 128 + WTERMSIG(state);
    }
  }
}

Captured run_captured(const Command& command, std::chrono::seconds limit) {
  using std::chrono::steady_clock;
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::tmpfile(), &std::fclose);
  if (!file) fail("cannot make a temporary file for the output of {}.", command.arguments[0]);
  const int stops = stop_requests();
  const auto end = steady_clock::now() + limit;
  Captured result;
  ChildProcess child(command, fileno(file.get()));
  while (!child.poll() && stop_requests() == stops) {
    result.in_time = steady_clock::now() < end;
    if (!result.in_time) break;
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  child.kill_all();
  result.status = child.poll().value_or(1);
  std::rewind(file.get());
  for (int c = std::fgetc(file.get()); c != EOF; c = std::fgetc(file.get()))
    result.output += static_cast<char>(c);
  while (!result.output.empty() && std::isspace(result.output.back()) != 0)
    result.output.pop_back();
  return result;
}

}  // namespace gasgrain
