// The host keeps no density beside a grain's radius and mass.
#pragma once

namespace LAMMPS_NS {
class Atom;
}

namespace gasgrain {

// After radius and mass of grain k have changed.
inline void density_follows(LAMMPS_NS::Atom&, int /*k*/, double /*volume*/) {}

}  // namespace gasgrain
