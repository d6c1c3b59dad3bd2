// `fix ID all property/global NAME KIND VALUES`: a property of the scene's materials, as LIGGGHTS
// scripts have it, that contact models ask for by its name.
//
//   scalar VALUE; vector VALUES; peratomtype VALUES, one a type;
//   peratomtypepair N VALUES, N types, N x N values in rows, symmetric
//
// Output: f_ID of a scalar, f_ID[n] of a vector or types, f_ID[i][j] of pairs. Not in restarts: a
// script that goes on gives its properties again.
#ifndef GASGRAIN_LAMMPS_FIX_PROPERTY_GLOBAL_H
#define GASGRAIN_LAMMPS_FIX_PROPERTY_GLOBAL_H

#include <string>
#include <vector>

#include "fix.h"

namespace LAMMPS_NS {

class FixPropertyGlobal : public Fix {
 public:
  enum class Kind { scalar, vector, per_type, pairs };

  FixPropertyGlobal(LAMMPS* host, int narg, char** arg);
  int setmask() override { return 0; }
  double compute_scalar() override { return values_[0]; }
  double compute_vector(int n) override { return values_[n]; }
  double compute_array(int i, int j) override { return values_[i * size_array_cols + j]; }

  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] Kind kind() const { return kind_; }
  [[nodiscard]] const std::vector<double>& values() const { return values_; }

  // The script's property of this name and kind, with so many values; null if it has none.
  static FixPropertyGlobal* find(LAMMPS* host, const std::string& name, Kind kind,
                                 std::size_t values);
  static std::vector<std::string> names(LAMMPS* host);

 private:
  void check_size() const;

  std::string name_;
  Kind kind_;
  std::vector<double> values_;
};

}  // namespace LAMMPS_NS
#endif
