// The host's maps of styles and commands and what it does about lost grains; they are private
// members of its classes.
#pragma once

#include <map>
#include <string>

#include "lammps.h"
// --
#include "fix.h"

namespace LAMMPS_NS {
class FixContactHistory;
}

namespace gasgrain {

using FixCreator = LAMMPS_NS::Fix* (*)(LAMMPS_NS::LAMMPS*, int, char**);
using CommandCreator = void (*)(LAMMPS_NS::LAMMPS*, int, char**);

std::map<std::string, FixCreator>& fix_map(LAMMPS_NS::LAMMPS& host);
std::map<std::string, CommandCreator>& command_map(LAMMPS_NS::LAMMPS& host);

// `thermo_modify lost`: error (true), or ignore, warn: grains may leave the box.
bool lost_grains_are_errors(LAMMPS_NS::LAMMPS& host);

// Stores the contacts of the pair style's list with their grains, as the host does before it makes
// new lists; it then does not do so again from this list.
void store_contacts_now(LAMMPS_NS::FixContactHistory& stored);

}  // namespace gasgrain
