// dump ID GROUP custom/vtk N FILE*.vtk id type x y z vx vy vz radius ...
//
// Particles as files that ParaView opens: legacy VTK, binary, one a step, with the box beside it
// (FILEboundingBox_STEP.vtk). Words as of `dump custom`; x y z are needed. vx vy vz, fx fy fz and
// omegax omegay omegaz become vectors. Debian's LAMMPS has no dump of this kind; LIGGGHTS's has
// this name. Each rank's rows go to their places in the file: no rank holds all of them.
#pragma once

#include <string>
#include <vector>

#include "fix_cfd_coupling/fixes/host_error.h"
// --
#include "dump_custom.h"

namespace LAMMPS_NS {

class DumpCustomVtk : public DumpCustom {
 public:
  DumpCustomVtk(LAMMPS* host, int narg, char** arg);

 protected:
  void write_header(bigint rows) override;
  void write_data(int rows, double* values) override;

 private:
  struct Field {
    std::string name;
    std::vector<std::size_t> columns;  // of a row
    long at = 0;                       // of its values in the file
  };

  void write_values(const Field& field, int rows, const double* values);
  void write_box() const;

  std::size_t width_ = 0;  // of a row
  Field points_;
  std::vector<Field> fields_;
  long written_ = 0;  // rows
};

}  // namespace LAMMPS_NS
