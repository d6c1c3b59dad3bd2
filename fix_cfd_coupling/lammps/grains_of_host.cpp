#include "fix_cfd_coupling/lammps/grains_of_host.h"

#include "lammps.h"
// --
#include "atom.h"
#include "fix.h"
#include "force.h"
#include "modify.h"
#include "update.h"

namespace gasgrain {

void BodyMasses::find_fix(LAMMPS_NS::LAMMPS& host) {
  fix_ = nullptr;
  for (int n = 0; n < host.modify->nfix && fix_ == nullptr; ++n)
    if (host.modify->fix[n]->rigid_flag != 0) fix_ = host.modify->fix[n];
}

void BodyMasses::take(LAMMPS_NS::LAMMPS& host) {
  masses_.resize(host.atom->nmax);
  int dimension = 0;
  const auto* body = static_cast<const int*>(fix_->extract("body", dimension));
  const auto* mass = static_cast<const double*>(fix_->extract("masstotal", dimension));
  for (int k = 0; k < host.atom->nlocal; ++k) masses_[k] = body[k] >= 0 ? mass[body[k]] : 0.0;
}

contact::Grains grains_of(LAMMPS_NS::LAMMPS& host, int frozen, const BodyMasses& bodies) {
  LAMMPS_NS::Atom& atom = *host.atom;
  using Rows = double(*)[3];
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
  grains.body_mass = bodies.data();
  grains.dt = host.update->dt;
  grains.step = host.update->ntimestep;
  grains.updates = host.update->setupflag == 0;
  return grains;
}

}  // namespace gasgrain
