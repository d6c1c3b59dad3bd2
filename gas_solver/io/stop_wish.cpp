#include "gas_solver/io/stop_wish.h"

#include <time.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <initializer_list>
#include <string_view>

namespace gasgrain {
namespace {

constexpr std::string_view told =
    "\nstopping: ending the interval, writing a checkpoint (again: ends the run at once)\n";

volatile std::sig_atomic_t wish = 0;
bool tells_at_once = false;
timespec first{};

double seconds_since_first() {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  constexpr double nanosecond = 1e-9;
  return static_cast<double>(now.tv_sec - first.tv_sec) +
         nanosecond * static_cast<double>(now.tv_nsec - first.tv_nsec);
}

// Calls only what POSIX allows in a handler.
void remember(int signal) {
  // Some launchers (timeout, batch systems) send one wish twice, to a process and to its group.
  constexpr double one_wish = 0.3;  // s
  if (wish == 0) {
    clock_gettime(CLOCK_MONOTONIC, &first);
    wish = signal;
    const int error = errno;
    if (tells_at_once && write(STDOUT_FILENO, told.data(), told.size()) < 0) errno = error;
  } else if (seconds_since_first() > one_wish) {
    std::signal(signal, SIG_DFL);
    raise(signal);
  }
}

}  // namespace

void catch_stop_wishes(bool tells) {
  tells_at_once = tells;
  struct sigaction action {};
  action.sa_handler = remember;
  action.sa_flags = SA_RESTART;  // of files and connections that are being read and written
  for (const int one : {SIGUSR1, SIGINT, SIGTERM}) sigaddset(&action.sa_mask, one);
  for (const int one : {SIGUSR1, SIGINT, SIGTERM}) sigaction(one, &action, nullptr);
}

int stop_wish() {
  return wish;
}

int status_after(int stop_wish) {
  constexpr int after_ctrl_c = 130;
  return stop_wish == SIGUSR1 ? 0 : after_ctrl_c;
}

}  // namespace gasgrain
