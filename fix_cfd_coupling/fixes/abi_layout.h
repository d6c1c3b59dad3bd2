// What the probes of both hosts look at when the build is configured: does what the headers say of
// the library's classes hold? Values set through the library's own commands are read back through
// the headers' layouts; any shift shows.
#pragma once

#include <cstdio>
#include <cstring>

#include "lammps.h"
// --
#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "fix.h"
#include "input.h"
#include "modify.h"
#include "neighbor.h"
#include "update.h"

namespace gasgrain {

// Prints what is elsewhere, and returns how many are. `style` and `speeds` are the host's lines for
// grains and for sending their velocities.
inline int layout_faults(LAMMPS_NS::LAMMPS& host, const char* style, const char* speeds) {
  int faults = 0;
  const auto expect = [&](bool holds, const char* what) {
    if (holds) return;
    std::printf("%s is not where the headers say. ", what);
    ++faults;
  };
  for (const char* line :
       {"units si", style, "atom_modify map array", "boundary f f p", "newton off", speeds,
        "region box block 0 3 0 5 0 7 units box", "create_box 1 box", "neighbor 0.125 bin",
        "timestep 0.0625", "reset_timestep 4711", "create_atoms 1 single 1 2 3",
        "set group all diameter 0.5", "fix probe all nve/sphere"})
    host.input->one(line);
  expect(host.update->dt == 0.0625, "Update::dt");
  expect(host.update->ntimestep == 4711, "Update::ntimestep");
  expect(host.domain->box_exist == 1 && host.domain->boxhi[1] == 5.0, "Domain::boxhi");
  expect(host.domain->sublo[2] == 0.0 && host.domain->subhi[2] == 7.0, "Domain::subhi");
  expect(host.domain->periodicity[2] == 1, "Domain::periodicity");
  expect(host.neighbor->skin == 0.125, "Neighbor::skin");
  expect(host.atom->nlocal == 1 && host.atom->x[0][2] == 3.0, "Atom::x");
  expect(host.atom->radius != nullptr && host.atom->radius[0] == 0.25, "Atom::radius");
  expect(host.atom->rmass != nullptr && host.atom->rmass[0] > 0.0, "Atom::rmass");
  expect(host.comm->nprocs == 1, "Comm::nprocs");
  const int nfix = host.modify->nfix;
  expect(nfix > 0 && std::strcmp(host.modify->fix[nfix - 1]->style, "nve/sphere") == 0,
         "Fix::style");
  return faults;
}

}  // namespace gasgrain
