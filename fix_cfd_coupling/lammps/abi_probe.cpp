// Run when the build is configured: is the installed LAMMPS the one that this dialect is written
// for, and do its headers describe its library?
#include <mpi.h>

#include "fix_cfd_coupling/fixes/abi_layout.h"
// --
#include "library.h"

int main(int argc, char** argv) {
  MPI_Init(&argc, &argv);
  const char* arguments[] = {"probe", "-screen", "none", "-log", "none", "-echo", "none"};
  LAMMPS_NS::LAMMPS host(7, const_cast<char**>(arguments), MPI_COMM_WORLD);
  if (const int version = lammps_version(&host); version != GASGRAIN_LAMMPS_VERSION) {
    std::printf("it is version %d, this dialect is of %d. ", version, GASGRAIN_LAMMPS_VERSION);
    MPI_Finalize();
    return 2;
  }
  const int faults = gasgrain::layout_faults(host, "atom_style sphere", "comm_modify vel yes");
  std::printf("%s", faults == 0 ? host.version : "");
  MPI_Finalize();
  return faults == 0 ? 0 : 1;
}
