// What the script says of the grains' contacts: `fix property/global`, numbers among the words of
// `pair_style gran/bridge`, and its normal model. LAMMPS's own granular styles tell nothing.
#pragma once

#include <cstring>
#include <string>

#include "fix_cfd_coupling/fixes/material.h"
#include "fix_cfd_coupling/lammps/fix_property_global.h"
#include "fix_cfd_coupling/lammps/pair_gran_bridge.h"
// --
#include "atom.h"
#include "force.h"

namespace gasgrain {

inline LAMMPS_NS::PairGranBridge* grain_pair(LAMMPS_NS::LAMMPS& host) {
  return dynamic_cast<LAMMPS_NS::PairGranBridge*>(host.force->pair_match("gran/bridge", 1));
}

// kind: scalar, peratomtype, peratomtypepair. Without any when the script has none: the host then
// says so where it needs it.
inline Material find_material(LAMMPS_NS::LAMMPS& host, const char* name, const char* kind) {
  using LAMMPS_NS::FixPropertyGlobal;
  if (const auto* pair = grain_pair(host); pair != nullptr)
    if (const auto word = pair->properties().find(name); word != pair->properties().end())
      return Material(word->second);
  const auto types = static_cast<std::size_t>(host.atom->ntypes);
  const bool pairs = std::strcmp(kind, "peratomtypepair") == 0;
  const bool scalar = std::strcmp(kind, "scalar") == 0;
  return Material(FixPropertyGlobal::find(&host, name,
                                          scalar  ? FixPropertyGlobal::Kind::scalar
                                          : pairs ? FixPropertyGlobal::Kind::pairs
                                                  : FixPropertyGlobal::Kind::per_type,
                                          scalar  ? 1
                                          : pairs ? types * types
                                                  : types));
}

// As the pair style calls it; '' where it is none of `known`, or there are no contacts.
template <class Names>
std::string normal_model_among(LAMMPS_NS::LAMMPS& host, const Names& known) {
  const auto* pair = grain_pair(host);
  if (pair == nullptr) return "";
  for (const char* name : known)
    if (pair->models().normal == name) return name;
  return "";
}

}  // namespace gasgrain
