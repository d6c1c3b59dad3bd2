// Keeps the host and the libraries below it away from the partner program.
//
// In a launch of two programs MPI_COMM_WORLD spans both. LIGGGHTS's timing summary gathers on it,
// VTK's controller is started on it by every VTK dump, and LIGGGHTS's errors call MPI_Finalize,
// which waits for the partner: each would hang. The MPI calls that these use are therefore defined
// in the executable (the dynamic linker finds them first) and go on through MPI's profiling
// interface, with the DEM ranks' communicator in the place of the world; MPI_Finalize before the
// end of main aborts the launch instead.
#pragma once

#include <mpi.h>

#include <string>

namespace gasgrain {

// From here on the host's MPI_COMM_WORLD is `local`.
void redirect_world_to(MPI_Comm local);

// The one orderly end: finalizes MPI.
void end_normally();

}  // namespace gasgrain
