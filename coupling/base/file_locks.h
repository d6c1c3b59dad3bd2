// Open MPI opens a file with a semaphore that is named after the file and belongs to the whole
// machine (its "sm" way to share file pointers, which nobody uses here). A program that is killed
// at that moment leaves it taken, and every later run with a file of this name, of whatever user
// and folder, would wait for ever.
#pragma once

#include <cstdlib>

namespace gasgrain {

// Makes MPI open files in another way; a choice of the user's own (OMPI_MCA_sharedfp) stays. Call
// it before MPI_Init.
inline void open_files_without_semaphores() {
  constexpr int keep_the_user_s = 0;
  setenv("OMPI_MCA_sharedfp", "^sm", keep_the_user_s);
}

}  // namespace gasgrain
