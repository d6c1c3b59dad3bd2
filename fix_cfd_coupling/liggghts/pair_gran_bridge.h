// `pair_style gran/bridge`: LIGGGHTS's `pair_style gran`, with the same words, whose loop over
// contacts is one of dem_physics/contact: all laws of a contact compiled into it, where the host
// calls its models one after the other.
//
// The host's style stays underneath: it reads the words and the properties, keeps the history,
// writes restart files and answers fixes, walls and computes as ever. Of it compute_force() alone
// does not run. The host looks for the name `gran` of it in many places, and writes it to restart
// files: once made, it goes by that name.
#ifndef GASGRAIN_LIGGGHTS_PAIR_GRAN_BRIDGE_H
#define GASGRAIN_LIGGGHTS_PAIR_GRAN_BRIDGE_H

#include <memory>

#include "fix_cfd_coupling/liggghts/compiled_contact.h"
// The host's headers lean on each other's order.
#include "fix_insert_stream.h"
// --
#include "contact_models.h"
// --
#include "pair_gran_proxy.h"

namespace LAMMPS_NS {

// The host's own style under our name: what is compared with ours.
class [[gnu::visibility("default")]] PairGranOfHost : public PairGranProxy {
 public:
  explicit PairGranOfHost(LAMMPS * host);
  void settings(int narg, char** arg) override;
};

class [[gnu::visibility("default")]] PairGranBridge final
    : public PairGranOfHost,
      private gasgrain::contact::ContactObserver {
 public:
  explicit PairGranBridge(LAMMPS * host);
  ~PairGranBridge() override;

  void settings(int narg, char** arg) override;
  void init_granular() override;
  void compute_force(int eflag, int vflag, int addflag) override;

  // Whether neighbour lists may get new pairs of single grains (neighbor_sorted.h).
  [[nodiscard]] bool follows_renewed_lists() const;

 private:
  void check_history() const;
  void check_grains();
  [[nodiscard]] gasgrain::contact::Grains grains() const;
  [[nodiscard]] gasgrain::contact::ContactRows rows();

  // Of each contact that acts, for the virial.
  void acts(int i, int j, const gasgrain::contact::Triple& force,
            const gasgrain::contact::Triple& delta) override;
  // Who else wants to know of each contact; pair_gran_bridge_listeners.cpp.
  [[nodiscard]] bool has_listeners(int addflag) const;
  void compute_and_tell(int addflag);
  void tell(LCM::SurfacesIntersectData & data, LCM::ForceData & on_i, LCM::ForceData & on_j,
            bool to_compute);

  std::unique_ptr<gasgrain::CompiledContact> contact_;
  bool said_how_ = false;  // it computes
};

}  // namespace LAMMPS_NS
#endif
