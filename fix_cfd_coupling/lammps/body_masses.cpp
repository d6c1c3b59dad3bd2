#include "fix_cfd_coupling/lammps/body_masses.h"

#include "lammps.h"
// --
#include "atom.h"
#include "fix.h"
#include "modify.h"

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

}  // namespace gasgrain
