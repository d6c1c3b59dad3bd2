#include "coupling/base/communicator.h"

#include <algorithm>
#include <chrono>
#include <thread>

namespace gasgrain {

Communicator::Communicator(MPI_Comm comm) : comm_(comm) {
  MPI_Comm_rank(comm_, &rank_);
  MPI_Comm_size(comm_, &size_);
}

double Communicator::sum(double value) const {
  MPI_Allreduce(MPI_IN_PLACE, &value, 1, MPI_DOUBLE, MPI_SUM, comm_);
  return value;
}

double Communicator::max(double value) const {
  MPI_Allreduce(MPI_IN_PLACE, &value, 1, MPI_DOUBLE, MPI_MAX, comm_);
  return value;
}

double Communicator::min(double value) const {
  MPI_Allreduce(MPI_IN_PLACE, &value, 1, MPI_DOUBLE, MPI_MIN, comm_);
  return value;
}

Vec3 Communicator::sum(const Vec3& value) const {
  Vec3 total = value;
  MPI_Allreduce(MPI_IN_PLACE, total.data(), 3, MPI_DOUBLE, MPI_SUM, comm_);
  return total;
}

long Communicator::sum(long value) const {
  MPI_Allreduce(MPI_IN_PLACE, &value, 1, MPI_LONG, MPI_SUM, comm_);
  return value;
}

void Communicator::sum_in_place(std::vector<double>& values) const {
  MPI_Allreduce(MPI_IN_PLACE, values.data(), static_cast<int>(values.size()), MPI_DOUBLE, MPI_SUM,
                comm_);
}

void wait_sleeping(std::vector<MPI_Request>& requests) {
  using namespace std::chrono;
  const auto start = steady_clock::now();
  int done = 0;
  while (true) {
    MPI_Testall(static_cast<int>(requests.size()), requests.data(), &done, MPI_STATUSES_IGNORE);
    if (done != 0) return;
    // Sleep in proportion to the wait so far: a twentieth of it, within the two bounds.
    const auto waited = duration_cast<microseconds>(steady_clock::now() - start);
    std::this_thread::sleep_for(std::clamp(waited / 20, microseconds(20), microseconds(500)));
  }
}

void wait_sleeping(MPI_Request& request) {
  std::vector<MPI_Request> one{request};
  wait_sleeping(one);
  request = one.front();
}

}  // namespace gasgrain
