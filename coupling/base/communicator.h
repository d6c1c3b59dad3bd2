// A group of MPI ranks, and waiting that leaves the core to others.
#pragma once

#include <mpi.h>

#include <vector>

#include "coupling/base/vec3.h"

namespace gasgrain {

// A borrowed MPI communicator with its rank and size; copying copies the handle.
class Communicator {
 public:
  Communicator() = default;
  explicit Communicator(MPI_Comm comm);

  [[nodiscard]] MPI_Comm handle() const { return comm_; }
  [[nodiscard]] int rank() const { return rank_; }
  [[nodiscard]] int size() const { return size_; }
  [[nodiscard]] bool is_root() const { return rank_ == 0; }

  // Collective over the group. Sums are taken in the order of the ranks' tree: the same for the
  // same number of ranks.
  [[nodiscard]] double sum(double value) const;
  [[nodiscard]] double max(double value) const;
  [[nodiscard]] double min(double value) const;
  [[nodiscard]] Vec3 sum(const Vec3& value) const;
  [[nodiscard]] long sum(long value) const;
  void sum_in_place(std::vector<double>& values) const;

 private:
  MPI_Comm comm_ = MPI_COMM_SELF;
  int rank_ = 0;
  int size_ = 1;
};

// A copy of a communicator: messages of one do not meet those of another.
class OwnCommunicator {
 public:
  explicit OwnCommunicator(const Communicator& like) {
    MPI_Comm copy = MPI_COMM_NULL;
    MPI_Comm_dup(like.handle(), &copy);
    comm_ = Communicator(copy);
  }
  ~OwnCommunicator() {
    MPI_Comm handle = comm_.handle();
    MPI_Comm_free(&handle);
  }
  OwnCommunicator(const OwnCommunicator&) = delete;
  OwnCommunicator& operator=(const OwnCommunicator&) = delete;
  [[nodiscard]] const Communicator& get() const { return comm_; }

 private:
  Communicator comm_;
};

// Waits for all requests. A rank that waits for the partner program sleeps between looks instead
// of spinning (Open MPI's own wait spins): 20 us at first, up to 1 ms, so that a wait is at most
// about 5 % longer than it must be and the core is free for whoever computes.
void wait_sleeping(std::vector<MPI_Request>& requests);
void wait_sleeping(MPI_Request& request);

}  // namespace gasgrain
