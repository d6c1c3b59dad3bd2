// Run when the build is configured: do LIGGGHTS's headers describe its library?
#include <mpi.h>

#include "fix_cfd_coupling/fixes/abi_layout.h"
// --
#include "universe.h"

int main(int argc, char** argv) {
  MPI_Init(&argc, &argv);
  const char* arguments[] = {"probe", "-screen", "none", "-log", "none", "-echo", "none"};
  LAMMPS_NS::LAMMPS host(7, const_cast<char**>(arguments), MPI_COMM_WORLD);
  const int faults =
      gasgrain::layout_faults(host, "atom_style granular", "communicate single vel yes");
  std::printf("%s", faults == 0 ? host.universe->version : "");
  MPI_Finalize();
  return faults == 0 ? 0 : 1;
}
