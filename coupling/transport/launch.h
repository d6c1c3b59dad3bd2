// Who is launched together: splits the launch into its programs and joins the two partners.
#pragma once

#include <mpi.h>

#include "coupling/base/communicator.h"

namespace gasgrain {

// A plugin_dem is a DEM program that is not ours and has loaded us: `lmp`. It ends with a barrier
// of all programs.
enum class Program : int { dem = 1, gas = 2, plugin_dem = 3 };

// The place of this rank in a launch of one program, or of two that are partners:
//   mpirun -np N gasgrain-liggghts ... : -np M gasgrain-gas ...   (in either order)
//   mpirun -np N lmp -m 0 ... : -np M gasgrain-gas ...
// The communicators live as long as the object; a plugin's local one is its host's.
class Launch {
 public:
  // Collective over MPI_COMM_WORLD. Throws Error when there are more than two programs or two of a
  // kind.
  explicit Launch(Program program);
  // Of a program that has split MPI_COMM_WORLD itself, by a colour from 0 to 99.
  Launch(Program program, MPI_Comm local);
  ~Launch();
  Launch(const Launch&) = delete;
  Launch& operator=(const Launch&) = delete;

  [[nodiscard]] const Communicator& local() const { return local_; }
  [[nodiscard]] bool has_partner() const { return partner_ != MPI_COMM_NULL; }
  // Intercommunicator to the partner program.
  [[nodiscard]] MPI_Comm partner() const { return partner_; }

  // The last word of a program that has done its work: waits where the partner's host will.
  void end() const;

 private:
  void join(Program program);

  Communicator local_;
  bool owns_local_ = false;
  MPI_Comm partner_ = MPI_COMM_NULL;
  Program partner_program_ = Program::dem;
};

}  // namespace gasgrain
