// Run when the build is configured: is the installed LAMMPS the one that this dialect is written
// for, and does what the headers say of the library's classes hold? Values set through the
// library's own commands are read back through the headers' layouts; any shift shows.
#include <mpi.h>

#include <cstdio>
#include <cstring>

#include "lammps.h"
// --
#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "fix.h"
#include "force.h"
#include "input.h"
#include "library.h"
#include "modify.h"
#include "neighbor.h"
#include "update.h"

namespace {

int faults = 0;

void expect(bool holds, const char* what) {
  if (holds) return;
  std::printf("%s is not where the headers say. ", what);
  ++faults;
}

}  // namespace

int main(int argc, char** argv) {
  MPI_Init(&argc, &argv);
  const char* arguments[] = {"probe", "-screen", "none", "-log", "none", "-echo", "none"};
  LAMMPS_NS::LAMMPS host(7, const_cast<char**>(arguments), MPI_COMM_WORLD);
  if (const int version = lammps_version(&host); version != GASGRAIN_LAMMPS_VERSION) {
    std::printf("it is version %d, this dialect is of %d. ", version, GASGRAIN_LAMMPS_VERSION);
    MPI_Finalize();
    return 2;
  }
  for (const char* line :
       {"units si", "atom_style sphere", "atom_modify map array", "boundary f f p", "newton off",
        "comm_modify vel yes", "region box block 0 3 0 5 0 7 units box", "create_box 1 box",
        "neighbor 0.125 bin", "timestep 0.0625", "reset_timestep 4711",
        "create_atoms 1 single 1 2 3", "set group all diameter 0.5", "fix probe all nve/sphere"})
    host.input->one(line);
  expect(host.num_ver == GASGRAIN_LAMMPS_VERSION, "LAMMPS::num_ver");
  expect(host.update->dt == 0.0625, "Update::dt");
  expect(host.update->ntimestep == 4711, "Update::ntimestep");
  expect(host.domain->box_exist == 1 && host.domain->boxhi[1] == 5.0, "Domain::boxhi");
  expect(host.domain->sublo[2] == 0.0 && host.domain->subhi[2] == 7.0, "Domain::subhi");
  expect(host.domain->periodicity[2] == 1, "Domain::periodicity");
  expect(host.force->newton_pair == 0, "Force::newton_pair");
  expect(host.neighbor->skin == 0.125, "Neighbor::skin");
  expect(host.atom->nlocal == 1 && host.atom->x[0][2] == 3.0, "Atom::x");
  expect(host.atom->radius != nullptr && host.atom->radius[0] == 0.25, "Atom::radius");
  expect(host.atom->rmass != nullptr && host.atom->rmass[0] > 0.0, "Atom::rmass");
  expect(host.comm->nprocs == 1, "Comm::nprocs");
  const int nfix = host.modify->nfix;
  expect(nfix > 0 && std::strcmp(host.modify->fix[nfix - 1]->style, "nve/sphere") == 0,
         "Fix::style");
  std::printf("%s", faults == 0 ? host.version : "");
  MPI_Finalize();
  return faults == 0 ? 0 : 1;
}
