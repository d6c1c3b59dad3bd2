// What a fix of ours is in this host: the calls whose names and moments differ from host to host.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "comm.h"
#include "error.h"
#include "fix.h"
#include "modify.h"

namespace LAMMPS_NS {

class HostFix : public Fix {
 public:
  using Fix::Fix;
  ~HostFix() override {
    for (const std::string& name : properties_) {
      // One that stands before the fix is the script's, and deleting it now would mix up the
      // host's list.
      const int place = modify->nfix > 0 ? modify->find_fix(name) : -1;
      if (place > modify->find_fix(id)) modify->delete_fix(place);
    }
  }

  // The host asks for this last of all when it makes the fix, after it has handed back what a
  // restart file holds; post_constructor() comes before that.
  int setmask() final {
    begin();
    return mask();
  }
  void post_constructor() final { make_properties(); }
  int pack_forward_comm(int count, int* list, double* buffer, int, int*) final {
    pack_ghosts(count, list, buffer);
    return count * comm_forward;
  }
  void unpack_forward_comm(int count, int first, double* buffer) final {
    unpack_ghosts(count, first, buffer);
  }

  // The moments at which the host calls the fix (FixConst).
  virtual int mask() = 0;
  [[nodiscard]] bool uses(const std::string& name) const {
    return std::find(scalars_.begin(), scalars_.end(), name) != scalars_.end();
  }

 protected:
  friend class GrainScalar;

  // Once, when the host knows the fix: it may ask for properties of the grains here.
  virtual void make_properties() {}
  // Those of these names go when the script takes the fix away.
  void take_along(const std::string& name) { properties_.push_back(name); }
  // Once, when what a restart file holds of the fix has been handed back.
  virtual void begin() {}

  // `comm_forward` values of each grain of the list, and of as many ghosts.
  virtual void pack_ghosts(int, const int*, double*) {}
  virtual void unpack_ghosts(int, int, const double*) {}
  void send_to_ghosts() { comm->forward_comm_fix(this); }

  // This host gives grains no values when a run begins.
  void grains_have_values() {}
  // In the host's way, by rank 0.
  void host_warning(const std::string& text) const {
    if (comm->me == 0) error->warning(FLERR, text);
  }
  void host_message(const std::string& text) const {
    if (comm->me == 0) error->message(FLERR, text);
  }
  // Values of a grain that go with it to another rank.
  void exchanges(int values) { maxexchange = values; }

 private:
  std::vector<std::string> properties_;
  std::vector<std::string> scalars_;
};

}  // namespace LAMMPS_NS
