// What a fix of ours is in this host: the calls whose names and moments differ from host to host.
#pragma once

#include "comm.h"
#include "fix.h"
#include "modify.h"

namespace LAMMPS_NS {

class HostFix : public Fix {
 public:
  using Fix::Fix;

  void post_create() final {
    make_properties();
    begin();
  }
  void pre_delete(bool unfixed) final {
    if (unfixed) remove_properties();
  }
  int pack_comm(int count, int* list, double* buffer, int, int*) final {
    pack_ghosts(count, list, buffer);
    return comm_forward;
  }
  void unpack_comm(int count, int first, double* buffer) final {
    unpack_ghosts(count, first, buffer);
  }

 protected:
  // Once, when the host knows the fix: it may ask for properties of the grains here.
  virtual void make_properties() {}
  // The script takes the fix away.
  virtual void remove_properties() {}
  // Once, when what a restart file holds of the fix has been handed back.
  virtual void begin() {}

  // `comm_forward` values of each grain of the list, and of as many ghosts.
  virtual void pack_ghosts(int, const int*, double*) {}
  virtual void unpack_ghosts(int, int, const double*) {}
  void send_to_ghosts() { comm->forward_comm_fix(this); }

  // Grains that were there before the fix have their values: without this the host gives them
  // those of a new grain when the first run begins.
  void grains_have_values() { just_created = 0; }
  // Values of a grain that go with it to another rank.
  void exchanges(int) {}
};

}  // namespace LAMMPS_NS
