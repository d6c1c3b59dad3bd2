// A restart file of the host, written now.
#pragma once

#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <string>

#include "fix_cfd_coupling/fixes/host_error.h"
#include "fix_cfd_coupling/fixes/host_session.h"
// --
#include "write_restart.h"

namespace gasgrain {

// Collective over the DEM ranks. The host would end alone where it cannot write, and nobody would
// learn why the file was wanted.
inline void write_restart_file(LAMMPS_NS::LAMMPS& host, const std::string& name) {
  if (session().local.is_root()) {
    std::FILE* file = std::fopen(name.c_str(), "wb");
    if (file == nullptr)
      stop_everything_from_here(
          fmt::format("Cannot open restart file {}: {}.", name, std::strerror(errno)));
    std::fclose(file);
  }
  LAMMPS_NS::WriteRestart writer(&host);
  writer.multiproc_options(0, 0, 0, nullptr);  // one file
  writer.write(name);
}

}  // namespace gasgrain
