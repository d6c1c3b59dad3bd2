// What a fix of ours is in this host: the calls whose names and moments differ from host to host.
#pragma once

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

  int setmask() final { return mask(); }
  void post_create() final {
    make_properties();
    begin();
  }
  void pre_delete(bool unfixed) final {
    for (const std::string& name : properties_)
      if (unfixed) modify->delete_fix(name.c_str());
  }
  int pack_comm(int count, int* list, double* buffer, int, int*) final {
    pack_ghosts(count, list, buffer);
    return comm_forward;
  }
  void unpack_comm(int count, int first, double* buffer) final {
    unpack_ghosts(count, first, buffer);
  }

  // The moments at which the host calls the fix (FixConst).
  virtual int mask() = 0;

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

  // Grains that were there before the fix have their values: without this the host gives them
  // those of a new grain when the first run begins.
  void grains_have_values() { just_created = 0; }
  // In the host's way, by rank 0.
  void host_warning(const std::string& text) const {
    if (comm->me == 0) error->warning(FLERR, text.c_str());
  }
  void host_message(const std::string& text) const {
    if (comm->me == 0) error->message(FLERR, text.c_str());
  }
  // Values of a grain that go with it to another rank.
  void exchanges(int) {}

 private:
  std::vector<std::string> properties_;
};

}  // namespace LAMMPS_NS
