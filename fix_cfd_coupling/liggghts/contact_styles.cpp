#include "fix_cfd_coupling/liggghts/contact_styles.h"

#include <cstdlib>
#include <map>
#include <string>
#include <utility>

#include "fix_cfd_coupling/liggghts/contact_styles_runtime.h"
#include "fix_cfd_coupling/liggghts/pair_gran_bridge.h"
// --
#include "granular_pair_style.h"
#include "granular_wall.h"
// --
#include "fix_wall_gran_base.h"
#include "pair_gran_base.h"

namespace gasgrain {

// Made by the build, one file a model.
#define COHESION_LAW(Law, name, id) void add_compiled_cohesion_##name();
#include "fix_cfd_coupling/dem_physics/contact/cohesion_laws.h"
#undef COHESION_LAW
#define ROLLING_LAW(Law, name, id) void add_compiled_rolling_##name();
#include "fix_cfd_coupling/dem_physics/contact/rolling_laws.h"
#undef ROLLING_LAW

namespace {

template <class Style>
using CreatorOf = Style* (*)(LAMMPS_NS::LAMMPS*, typename Style::ParentType*, int64_t);
template <class Style>
using TableOf = std::map<std::pair<std::string, int>, CreatorOf<Style>>;

}  // namespace

// The host's tables of combinations are private; an explicit instantiation may name them.
using PairStyle = LIGGGHTS::PairStyles::IGranularPairStyle;
using WallStyle = LIGGGHTS::Walls::IGranularWall;
struct PairTableTag {
  using Type = TableOf<PairStyle> LIGGGHTS::Utils::AbstractFactory<PairStyle>::*;
  friend Type table_member(PairTableTag);
};
struct WallTableTag {
  using Type = TableOf<WallStyle> LIGGGHTS::Utils::AbstractFactory<WallStyle>::*;
  friend Type table_member(WallTableTag);
};
template <class Tag, typename Tag::Type member>
struct RevealTable {
  friend typename Tag::Type table_member(Tag) { return member; }
};
template struct RevealTable<PairTableTag, &LIGGGHTS::Utils::AbstractFactory<PairStyle>::styleTable>;
template struct RevealTable<WallTableTag, &LIGGGHTS::Utils::AbstractFactory<WallStyle>::styleTable>;

namespace {

bool has_own_loop(LIGGGHTS::IContactHistorySetup* parent) {
  return dynamic_cast<LAMMPS_NS::PairGranBridge*>(parent) != nullptr;
}

// The host makes a combination that is in no table by the creator under the hash of no models. Ours
// takes that place, and leaves to the host's own what holds no model of ours and runs: its warning
// of a slow loop would be about one that stands idle.
template <class Style, class Tag, class Runtime>
struct LastResort {
  static inline CreatorOf<Style> of_host = nullptr;

  static Style* create(LAMMPS_NS::LAMMPS* host, typename Style::ParentType* parent, int64_t hash) {
    if (ContactIds(hash).hold_ours() || has_own_loop(parent))
      return new Runtime(host, parent, hash);
    return of_host(host, parent, hash);
  }
  static void install(LIGGGHTS::Utils::AbstractFactory<Style>& factory) {
    using namespace LIGGGHTS;
    const auto no_models = static_cast<int>(
        Utils::generate_gran_hashcode(ContactModels::NORMAL_OFF, ContactModels::TANGENTIAL_OFF,
                                      ContactModels::COHESION_OFF, ContactModels::ROLLING_OFF, 0));
    auto& table = factory.*table_member(Tag{});
    const auto at = table.find({"gran", no_models});
    if (at == table.end())
      stop_everything("this libliggghts cannot combine contact models at run time.");
    of_host = at->second;
    at->second = &create;
  }
};

bool compiled_wanted() {
  const char* wish = std::getenv("GASGRAIN_CONTACT_STYLES");
  return wish == nullptr || std::string(wish) != "runtime";
}

}  // namespace

void register_contact_styles() {
  static bool done = false;
  if (done) return;
  done = true;

  auto& names = contact_models::Factory::instance();
#define COHESION_LAW(Law, name, id) names.addCohesionModel(#name, id);
#include "fix_cfd_coupling/dem_physics/contact/cohesion_laws.h"
#undef COHESION_LAW
#define ROLLING_LAW(Law, name, id) names.addRollingModel(#name, id);
#include "fix_cfd_coupling/dem_physics/contact/rolling_laws.h"
#undef ROLLING_LAW

  LastResort<PairStyle, PairTableTag, LIGGGHTS::PairStyles::Granular<RuntimeContactModel>>::install(
      LIGGGHTS::PairStyles::Factory::instance());
  LastResort<WallStyle, WallTableTag, LIGGGHTS::Walls::Granular<RuntimeContactModel>>::install(
      LIGGGHTS::Walls::Factory::instance());

  if (!compiled_wanted()) return;
#define COHESION_LAW(Law, name, id) add_compiled_cohesion_##name();
#include "fix_cfd_coupling/dem_physics/contact/cohesion_laws.h"
#undef COHESION_LAW
#define ROLLING_LAW(Law, name, id) add_compiled_rolling_##name();
#include "fix_cfd_coupling/dem_physics/contact/rolling_laws.h"
#undef ROLLING_LAW
}

}  // namespace gasgrain
