#include "tools/stop_request.h"

#include <csignal>
#include <initializer_list>

namespace gasgrain {
namespace {

volatile std::sig_atomic_t requests = 0;

void count_request(int /*signal*/) {
  requests = requests + 1;
}

}  // namespace

void catch_stop_requests() {
  struct sigaction action {};
  action.sa_handler = count_request;
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) sigaction(signal, &action, nullptr);
}

int stop_requests() {
  return requests;
}

}  // namespace gasgrain
