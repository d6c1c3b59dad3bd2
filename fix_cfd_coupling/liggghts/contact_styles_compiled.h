// The combinations of contact sub-models that are compiled, as pair style and as wall.
//
// With each cohesion model of ours: hertz, hooke x history, no_history x rolling off, cdt, epsd,
// epsd2. With each rolling model of ours, and no cohesion: hertz, hooke x history, no_history.
#pragma once

#include "fix_cfd_coupling/liggghts/contact_styles_ids.h"
// --
#include "granular_pair_style.h"
#include "granular_wall.h"
// --
#include "fix_wall_gran_base.h"
#include "pair_gran_base.h"

namespace gasgrain {

template <int normal, int tangential, int cohesion, int rolling>
void add_combination() {
  using namespace LIGGGHTS;
  using Style = ContactModels::GranStyle<normal, tangential, cohesion, rolling>;
  using Model = ContactModels::ContactModel<Style>;
  PairStyles::Factory::instance().addStyle("gran", static_cast<int>(Style::HASHCODE),
                                           [](LAMMPS_NS::LAMMPS* host, LAMMPS_NS::PairGran* pair,
                                              int64_t hash) -> PairStyles::IGranularPairStyle* {
                                             return new PairStyles::Granular<Model>(host, pair,
                                                                                    hash);
                                           });
  Walls::Factory::instance().addStyle("gran", static_cast<int>(Style::HASHCODE),
                                      [](LAMMPS_NS::LAMMPS* host, LAMMPS_NS::FixWallGran* wall,
                                         int64_t hash) -> Walls::IGranularWall* {
                                        return new Walls::Granular<Model>(host, wall, hash);
                                      });
}

template <int cohesion, int rolling>
void add_with_rolling() {
  using namespace LIGGGHTS::ContactModels;
  add_combination<HERTZ, TANGENTIAL_HISTORY, cohesion, rolling>();
  add_combination<HERTZ, TANGENTIAL_NO_HISTORY, cohesion, rolling>();
  add_combination<HOOKE, TANGENTIAL_HISTORY, cohesion, rolling>();
  add_combination<HOOKE, TANGENTIAL_NO_HISTORY, cohesion, rolling>();
}

template <int cohesion>
void add_with_cohesion() {
  using namespace LIGGGHTS::ContactModels;
  add_with_rolling<cohesion, ROLLING_OFF>();
  add_with_rolling<cohesion, ROLLING_CDT>();
  add_with_rolling<cohesion, ROLLING_EPSD>();
  add_with_rolling<cohesion, ROLLING_EPSD2>();
}

}  // namespace gasgrain
