// gasgrain.so, a plugin of LAMMPS: the LIST of what it adds, and its three ways in.
//   1. `plugin load gasgrain.so`, in a LAMMPS with the PLUGIN package: calls lammpsplugin_init().
//   2. `include gasgrain.lmp`, in one with the PYTHON package: calls gasgrain_load().
//   3. LD_PRELOAD=gasgrain.so lmp ...: the library finds our LAMMPS::post_create().
// `clear` in a script takes the styles away in the first two: load again after it.
#include <dlfcn.h>
#include <fmt/format.h>

#include <array>
#include <cstring>

#include "coupling/base/error.h"
#include "fix_cfd_coupling/fixes/fix_collisional_exchange.h"
#include "fix_cfd_coupling/fixes/fix_couple_gas.h"
#include "fix_cfd_coupling/fixes/fix_liquid.h"
#include "fix_cfd_coupling/fixes/fix_parcels.h"
#include "fix_cfd_coupling/fixes/fix_parcels_inject.h"
#include "fix_cfd_coupling/fixes/host_error.h"
#include "fix_cfd_coupling/fixes/host_session.h"
#include "fix_cfd_coupling/lammps/compute_pair_gran_local.h"
#include "fix_cfd_coupling/lammps/dump_custom_vtk.h"
#include "fix_cfd_coupling/lammps/fix_gran_bridge_history.h"
#include "fix_cfd_coupling/lammps/fix_property_global.h"
#include "fix_cfd_coupling/lammps/fix_wall_gran_bridge.h"
#include "fix_cfd_coupling/lammps/pair_gran_bridge.h"
#include "fix_cfd_coupling/lammps/plugin_command.h"
#include "fix_cfd_coupling/lammps/plugin_session.h"
// --
#include "lammps.h"
// --
#include "force.h"
#include "lammpsplugin.h"
#include "modify.h"
#include "output.h"
#include "pair.h"

namespace {

using LAMMPS_NS::LAMMPS;

template <class Style>
void* make_fix(void* host, int narg, char** arg) {
  return static_cast<LAMMPS_NS::Fix*>(new Style(static_cast<LAMMPS*>(host), narg, arg));
}

template <class Style>
void* make_compute(void* host, int narg, char** arg) {
  return static_cast<LAMMPS_NS::Compute*>(new Style(static_cast<LAMMPS*>(host), narg, arg));
}

template <class Style>
void* make_pair(void* host) {
  return static_cast<LAMMPS_NS::Pair*>(new Style(static_cast<LAMMPS*>(host)));
}

template <class Style>
LAMMPS_NS::Dump* make_dump(LAMMPS* host, int narg, char** arg) {
  return new Style(host, narg, arg);
}

// A fix or a compute; a pair style.
struct StyleEntry {
  const char* name;
  lammpsplugin_factory2* make;
};
struct PairEntry {
  const char* name;
  lammpsplugin_factory1* make;
};

// What a script may name.
constexpr std::array fixes{
    StyleEntry{"couple/gas", &make_fix<LAMMPS_NS::FixCoupleGas>},
    StyleEntry{"liquid", &make_fix<LAMMPS_NS::FixLiquid>},
    StyleEntry{"parcels", &make_fix<LAMMPS_NS::FixParcels>},
    StyleEntry{"parcels/inject", &make_fix<LAMMPS_NS::FixParcelsInject>},
    StyleEntry{"collisional_exchange", &make_fix<LAMMPS_NS::FixCollisionalExchange>},
    StyleEntry{"exchange/bgk", &make_fix<LAMMPS_NS::FixCollisionalExchange>},
    StyleEntry{"property/global", &make_fix<LAMMPS_NS::FixPropertyGlobal>},
    StyleEntry{"NEIGH_HISTORY/gran/bridge", &make_fix<LAMMPS_NS::FixGranBridgeHistory>},
    StyleEntry{"wall/gran/bridge", &make_fix<LAMMPS_NS::FixWallGranBridge>}};
constexpr std::array computes{
    StyleEntry{"pair/gran/local", &make_compute<LAMMPS_NS::ComputePairGranLocal>}};
constexpr std::array pairs{PairEntry{"gran/bridge", &make_pair<LAMMPS_NS::PairGranBridge>}};

// The PLUGIN package knows no dumps.
void add_dumps(LAMMPS& host) {
  (*host.output->dump_map)["custom/vtk"] = &make_dump<LAMMPS_NS::DumpCustomVtk>;
}

// Does what the PLUGIN package does, for a host without it.
void add_to_maps(lammpsplugin_t* style, void* host_pointer) {
  auto& host = *static_cast<LAMMPS*>(host_pointer);
  if (std::strcmp(style->style, "fix") == 0)
    (*host.modify->fix_map)[style->name] =
        reinterpret_cast<LAMMPS_NS::Modify::FixCreator>(style->creator.v2);
  else if (std::strcmp(style->style, "compute") == 0)
    (*host.modify->compute_map)[style->name] =
        reinterpret_cast<LAMMPS_NS::Modify::ComputeCreator>(style->creator.v2);
  else
    (*host.force->pair_map)[style->name] =
        reinterpret_cast<LAMMPS_NS::Force::PairCreator>(style->creator.v1);
}

// Asked of the program that loads us, not of the headers.
int version_of(void* host) {
  const auto ask = reinterpret_cast<int (*)(void*)>(dlsym(RTLD_DEFAULT, "lammps_version"));
  return ask == nullptr ? 0 : ask(host);
}

void refuse_other_versions(void* host) {
  if (const int version = version_of(host); version != GASGRAIN_LAMMPS_VERSION) {
    gasgrain::set_host(nullptr);  // what is where in it is not known
    gasgrain::stop_everything_from_here(
        fmt::format("this gasgrain.so needs LAMMPS {}, version {}; the program that loads it is "
                    "version {}. Use the first, or build gasgrain where the other is installed.",
                    GASGRAIN_LAMMPS_VERSION_TEXT, GASGRAIN_LAMMPS_VERSION, version));
  }
}

}  // namespace

extern "C" void lammpsplugin_init(void* host, void* handle, void* register_function) {
  refuse_other_versions(host);
  gasgrain::set_host(static_cast<LAMMPS*>(host));
  try {
    gasgrain::begin_session(*static_cast<LAMMPS*>(host));
  } catch (const gasgrain::Error& e) {
    gasgrain::stop_everything(e.what());
  }
  const auto add = reinterpret_cast<lammpsplugin_regfunc>(register_function);
  lammpsplugin_t entry{};
  entry.version = "29 Sep 2021";
  entry.author = "the authors of gasgrain";
  entry.handle = handle;
  const auto add_all = [&](const char* kind, const auto& styles) {
    entry.style = kind;
    for (const StyleEntry& style : styles) {
      entry.name = entry.info = style.name;
      entry.creator.v2 = style.make;
      add(&entry, host);
    }
  };
  add_all("fix", fixes);
  add_all("compute", computes);
  entry.style = "pair";
  for (const PairEntry& pair : pairs) {
    entry.name = entry.info = pair.name;
    entry.creator.v1 = pair.make;
    add(&entry, host);
  }
  add_dumps(*static_cast<LAMMPS*>(host));
  gasgrain::add_plugin_command(*static_cast<LAMMPS*>(host));
}

extern "C" void gasgrain_load(void* host) {
  lammpsplugin_init(host, nullptr, reinterpret_cast<void*>(&add_to_maps));
}

// Found first by the library where this is preloaded.
void LAMMPS_NS::LAMMPS::post_create() {
  using PostCreate = void (*)(LAMMPS*);
  static const auto of_library =
      reinterpret_cast<PostCreate>(dlsym(RTLD_NEXT, "_ZN9LAMMPS_NS6LAMMPS11post_createEv"));
  of_library(this);
  gasgrain_load(this);
}
