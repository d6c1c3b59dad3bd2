// Entry of every test program: MPI for the whole life of it; on several ranks a failure on any of
// them fails the program.
#include <gtest/gtest.h>
#include <mpi.h>

#include "coupling/base/file_locks.h"

int main(int argc, char** argv) {
  gasgrain::open_files_without_semaphores();
  MPI_Init(&argc, &argv);
  testing::InitGoogleTest(&argc, argv);
  int failed = RUN_ALL_TESTS();
  MPI_Allreduce(MPI_IN_PLACE, &failed, 1, MPI_INT, MPI_MAX, MPI_COMM_WORLD);
  MPI_Finalize();
  return failed;
}
