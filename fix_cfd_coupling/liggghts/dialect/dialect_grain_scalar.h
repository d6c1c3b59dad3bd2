// One value of each grain that the script can set and dump: the host's `fix property/atom`.
#pragma once

#include <string>

#include "fix_cfd_coupling/liggghts/dialect/dialect_fix.h"
// --
#include "fix_property_atom.h"
#include "modify.h"

namespace LAMMPS_NS {

class GrainScalar {
 public:
  enum class Stays { with_the_fix, with_the_grains };

  // Finds it, or makes it: a grain has `at_first` until somebody sets it.
  void make(HostFix& owner, LAMMPS& host, const char* name, double at_first, Stays stays) {
    Modify& modify = *host.modify;
    name_ = name;
    if (stays == Stays::with_the_fix) owner.take_along(name);
    fix_ = look(owner, modify, false);
    if (fix_ != nullptr) return;
    std::string first = std::to_string(at_first), property = name;
    const char* words[] = {name, "all", "property/atom", name, "scalar", "yes", "no", "no", ""};
    words[8] = first.c_str();
    fix_ = modify.add_fix_property_atom(9, const_cast<char**>(words), owner.style);
  }
  // When a run begins: the script may have made another one.
  void find(HostFix& owner, LAMMPS& host) { fix_ = look(owner, *host.modify, true); }

  double& operator[](int grain) const { return fix_->vector_atom[grain]; }
  // By grain; valid until the host makes place for more.
  [[nodiscard]] const double* values() const { return fix_->vector_atom; }
  explicit operator bool() const { return fix_ != nullptr; }

  // Of a grain that was just made: this host does it by itself.
  void begin_grain(int) const {}
  // As HostFix::grains_have_values().
  void grains_have_values() { fix_->just_created = 0; }

 private:
  FixPropertyAtom* look(HostFix& owner, Modify& modify, bool must_be) const {
    return static_cast<FixPropertyAtom*>(modify.find_fix_property(
        name_.c_str(), "property/atom", "scalar", 0, 0, owner.style, must_be));
  }

  std::string name_;
  FixPropertyAtom* fix_ = nullptr;
};

}  // namespace LAMMPS_NS
