// The host keeps a grain's density beside its radius and mass.
#pragma once

#include "atom.h"

namespace gasgrain {

// After radius and mass of grain k have changed.
inline void density_follows(LAMMPS_NS::Atom& atom, int k, double volume) {
  atom.density[k] = atom.rmass[k] / volume;
}

}  // namespace gasgrain
