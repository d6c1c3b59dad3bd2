// One value of each grain that the script can set and dump: the host's `fix property/atom d_NAME`,
// under the fix ID NAME.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "fix_cfd_coupling/fixes/host_error.h"
#include "fix_cfd_coupling/lammps/dialect/dialect_fix.h"
// --
#include "atom.h"
#include "modify.h"

namespace LAMMPS_NS {

class GrainScalar {
 public:
  enum class Stays { with_the_fix, with_the_grains };

  // Finds it, or makes it: a grain has `at_first` until somebody sets it.
  void make(HostFix& owner, LAMMPS& host, const char* name, double at_first, Stays stays) {
    name_ = name;
    at_first_ = at_first;
    atom_ = host.atom;
    if (stays == Stays::with_the_fix) owner.take_along(name);
    owner.scalars_.push_back(name);
    index_ = look();
    if (index_ < 0) {
      const Fix* made = host.modify->add_fix(fmt::format("{0} all property/atom d_{0}", name));
      index_ = look();
      // Else they are those of a restart file.
      if (made->restart_reset == 0) std::fill_n(atom_->dvector[index_], atom_->nlocal, at_first);
    }
    see_who_begins(owner, *host.modify);
  }
  // When a run begins: the script may have made another one.
  void find(HostFix& owner, LAMMPS& host) {
    index_ = look();
    if (index_ < 0)
      gasgrain::stop_everything(
          fmt::format("fix {} {} has lost its property d_{}: a line such as 'unfix {}' took it "
                      "away. Leave that out.",
                      owner.id, owner.style, name_, name_));
    see_who_begins(owner, *host.modify);
  }

  double& operator[](int grain) const { return atom_->dvector[index_][grain]; }
  // By grain; valid until the host makes place for more.
  [[nodiscard]] const double* values() const { return atom_->dvector[index_]; }
  explicit operator bool() const { return atom_ != nullptr; }

  // Of a grain that was just made, from set_arrays(): this host leaves what stood in its place.
  void begin_grain(int grain) const {
    if (begins_) (*this)[grain] = at_first_;
  }
  void grains_have_values() {}

 private:
  [[nodiscard]] int look() const {
    int is_double = 0, columns = 0;
    const int index = atom_->find_custom(name_.c_str(), is_double, columns);
    return is_double != 0 && columns == 0 ? index : -1;
  }
  // Of the fixes that share it the first one; it meets the grain first, too.
  void see_who_begins(const HostFix& owner, const Modify& modify) {
    begins_ = true;
    for (int n = 0; n < modify.nfix && modify.fix[n] != &owner; ++n)
      if (const auto* other = dynamic_cast<const HostFix*>(modify.fix[n]);
          other != nullptr && other->uses(name_))
        begins_ = false;
  }

  std::string name_;
  double at_first_ = 0.0;
  Atom* atom_ = nullptr;
  int index_ = -1;
  bool begins_ = false;  // this fix gives new grains their first value
};

}  // namespace LAMMPS_NS
