// Grains of a legacy VTK file, as LIGGGHTS writes it (`dump ID all custom/vtk N p_*.vtk id ...`),
// in the columns of a text dump: x y z, each field by its name, v, f and omega as vx vy vz and so
// on, other vectors as name[1] name[2] name[3].
#pragma once

#include <filesystem>

#include "tools/measure/dump_file.h"

namespace gasgrain {

// ASCII or binary. Throws an Error that names the file when it is cut short or of another kind.
DumpFrame read_vtk_grains(const std::filesystem::path& file, long step);

}  // namespace gasgrain
