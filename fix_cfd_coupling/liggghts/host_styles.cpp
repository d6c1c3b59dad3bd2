// Registers our styles with the host: the LIST of what a script may name.
//
// The library calls LAMMPS::post_create() from the constructor and from the command `clear`,
// through the dynamic linker: the executable's definition comes first, calls the library's own,
// then adds.
#include <dlfcn.h>

#include <cstdlib>
#include <string>

#include "coupling/base/error.h"
#include "fix_cfd_coupling/fixes/fix_collisional_exchange.h"
#include "fix_cfd_coupling/fixes/fix_couple_gas.h"
#include "fix_cfd_coupling/fixes/fix_liquid.h"
#include "fix_cfd_coupling/fixes/fix_parcels.h"
#include "fix_cfd_coupling/fixes/fix_parcels_inject.h"
#include "fix_cfd_coupling/fixes/host_error.h"
#include "fix_cfd_coupling/liggghts/contact_styles.h"
#include "fix_cfd_coupling/liggghts/fix_contact_history_packed.h"
#include "fix_cfd_coupling/liggghts/fix_wall_gran_fused.h"
#include "fix_cfd_coupling/liggghts/host_access.h"
#include "fix_cfd_coupling/liggghts/neighbor_sorted.h"
#include "fix_cfd_coupling/liggghts/pair_gran_bridge.h"
#include "fix_cfd_coupling/liggghts/plugin_command.h"
// --
#include "force.h"

namespace {

template <class FixStyle>
LAMMPS_NS::Fix* make_fix(LAMMPS_NS::LAMMPS* host, int narg, char** arg) {
  return new FixStyle(host, narg, arg);
}

template <class PairStyle>
LAMMPS_NS::Pair* make_pair(LAMMPS_NS::LAMMPS* host) {
  return new PairStyle(host);
}

// The environment's GASGRAIN_PAIR_STYLE=gran puts the host's own loop in the place of ours, for
// comparisons.
bool own_loop_wanted() {
  const char* wish = std::getenv("GASGRAIN_PAIR_STYLE");
  const std::string style = wish == nullptr || *wish == '\0' ? "gran/bridge" : wish;
  if (style != "gran" && style != "gran/bridge")
    gasgrain::stop_everything(
        fmt::format("GASGRAIN_PAIR_STYLE={}: it is gran, LIGGGHTS's own loop over contacts in the "
                    "place of gran/bridge, or gran/bridge, which is as without it.",
                    style));
  return style != "gran";
}

void register_styles(LAMMPS_NS::LAMMPS& host) {
  gasgrain::register_contact_styles();
  (*host.force->pair_map)["gran/bridge"] = own_loop_wanted()
                                               ? &make_pair<LAMMPS_NS::PairGranBridge>
                                               : &make_pair<LAMMPS_NS::PairGranOfHost>;
  gasgrain::fix_map(host)["couple/gas"] = &make_fix<LAMMPS_NS::FixCoupleGas>;
  gasgrain::fix_map(host)["liquid"] = &make_fix<LAMMPS_NS::FixLiquid>;
  gasgrain::fix_map(host)["parcels"] = &make_fix<LAMMPS_NS::FixParcels>;
  gasgrain::fix_map(host)["parcels/inject"] = &make_fix<LAMMPS_NS::FixParcelsInject>;
  // The second name is that of its model (Bhatnagar, Gross and Krook).
  for (const char* name : {"collisional_exchange", "exchange/bgk"})
    gasgrain::fix_map(host)[name] = &make_fix<LAMMPS_NS::FixCollisionalExchange>;
  // In the place of the host's own.
  gasgrain::fix_map(host)["wall/gran"] = &make_fix<LAMMPS_NS::FixWallGranFused>;
  gasgrain::fix_map(host)["contacthistory"] = &make_fix<LAMMPS_NS::FixContactHistoryPacked>;
  gasgrain::command_map(host)["plugin"] = &gasgrain::plugin_command;
}

}  // namespace

void LAMMPS_NS::LAMMPS::post_create() {
  using PostCreate = void (*)(LAMMPS*);
  static const auto library_post_create =
      reinterpret_cast<PostCreate>(dlsym(RTLD_NEXT, "_ZN9LAMMPS_NS6LAMMPS11post_createEv"));
  if (library_post_create == nullptr)
    gasgrain::stop_everything(
        "this libliggghts has no LAMMPS::post_create: rebuild gasgrain with it.");
  library_post_create(this);
  gasgrain::set_host(this);
  register_styles(*this);
  // Nobody has asked it for anything yet; all others reach it through this pointer.
  delete neighbor;
  neighbor = new gasgrain::NeighborSorted(this);
}
