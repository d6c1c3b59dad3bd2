// What the script says of the grains' contacts: `fix property/global`, and the normal model of the
// pair style.
#pragma once

#include <cstring>
#include <string>

#include "fix_cfd_coupling/fixes/material.h"
// --
#include "atom.h"
#include "fix_property_global.h"
#include "force.h"
#include "modify.h"
#include "pair_gran.h"

namespace gasgrain {

// kind: scalar, peratomtype, peratomtypepair. Without any when the script has none: the host then
// says so where it needs it.
inline Material find_material(LAMMPS_NS::LAMMPS& host, const char* name, const char* kind) {
  const bool pair = std::strcmp(kind, "peratomtypepair") == 0;
  const bool scalar = std::strcmp(kind, "scalar") == 0;
  const int types = host.atom->ntypes;
  return Material(host.modify->find_fix_property(name, "property/global", kind, scalar ? 0 : types,
                                                 pair ? types : 0, "couple/gas", false));
}

// As the pair style calls it; '' where it is none of `known`, or there are no contacts.
template <class Names>
std::string normal_model_among(LAMMPS_NS::LAMMPS& host, const Names& known) {
  auto* pair = static_cast<LAMMPS_NS::PairGran*>(host.force->pair_match("gran", 0));
  if (pair == nullptr) return "";
  for (const char* name : known)
    if (pair->contact_match("normal", name)) return name;
  return "";
}

}  // namespace gasgrain
