#include "fix_cfd_coupling/fixes/grains_of_host.h"

#include "lammps.h"
// --
#include "atom.h"
#include "force.h"
#include "update.h"

namespace gasgrain {

contact::Grains grains_of(const LAMMPS_NS::LAMMPS& host, int frozen, const double* body_mass) {
  using Rows = double(*)[3];
  const LAMMPS_NS::Atom& atom = *host.atom;
  // The host's arrays are one block each; without grains there may be none.
  const bool any = atom.nlocal + atom.nghost > 0;
  const auto rows = [any](double** array) {
    return any ? reinterpret_cast<Rows>(array[0]) : nullptr;
  };
  contact::Grains grains{};
  grains.x = rows(atom.x);
  grains.v = rows(atom.v);
  grains.spin = rows(atom.omega);
  grains.radius = atom.radius;
  grains.mass = atom.rmass;
  grains.type = atom.type;
  grains.mask = atom.mask;
  grains.force = rows(atom.f);
  grains.torque = rows(atom.torque);
  grains.owned = atom.nlocal;
  grains.ghosts_take_forces = host.force->newton_pair != 0;
  grains.frozen = frozen;
  grains.body_mass = body_mass;
  grains.dt = host.update->dt;
  grains.step = host.update->ntimestep;
  grains.updates = host.update->setupflag == 0;
  return grains;
}

}  // namespace gasgrain
