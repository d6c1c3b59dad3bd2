// Who is launched together: splits the launch into its programs and joins the two partners.
#pragma once

#include <mpi.h>

#include "coupling/base/communicator.h"

namespace gasgrain {

enum class Program : int { dem = 1, gas = 2 };

// The place of this rank in a launch of one program, or of two that are partners:
//   mpirun -np N gasgrain-liggghts ... : -np M gasgrain-gas ...   (in either order)
// The communicators live as long as the object.
class Launch {
 public:
  // Collective over MPI_COMM_WORLD. Throws Error when there are more than two programs or two of a
  // kind.
  explicit Launch(Program program);
  ~Launch();
  Launch(const Launch&) = delete;
  Launch& operator=(const Launch&) = delete;

  [[nodiscard]] const Communicator& local() const { return local_; }
  [[nodiscard]] bool has_partner() const { return partner_ != MPI_COMM_NULL; }
  // Intercommunicator to the partner program.
  [[nodiscard]] MPI_Comm partner() const { return partner_; }

 private:
  Communicator local_;
  MPI_Comm partner_ = MPI_COMM_NULL;
};

}  // namespace gasgrain
