#include "fix_cfd_coupling/liggghts/pair_gran_bridge.h"

#include <algorithm>
#include <cstring>
#include <sstream>
#include <string>

#include "coupling/base/error.h"
#include "fix_cfd_coupling/dem_physics/contact/tangential_damped_history.h"
#include "fix_cfd_coupling/dem_physics/contact/tangential_no_history.h"
#include "fix_cfd_coupling/fixes/host_error.h"
// --
#include "atom.h"
#include "force.h"
#include "neigh_list.h"
#include "neighbor.h"
#include "update.h"

namespace LAMMPS_NS {

namespace contact = gasgrain::contact;

namespace {

[[noreturn]] void refuse(const std::string& why) {
  gasgrain::stop_everything("pair_style gran/bridge: " + why);
}

// Without those that no script of LIGGGHTS can name: it lists what is compiled, line by line.
std::string of_this_host(const std::string& text) {
  std::istringstream lines(text);
  std::string kept;
  for (std::string line; std::getline(lines, line);)
    if (line.find(contact::TangentialDampedHistory::name) == std::string::npos) kept += line + '\n';
  return kept;
}

// `tangential off`, or no such word, is LIGGGHTS's way to leave friction out: a model of friction
// whose coefficient is then 0 does the same. Whether the words are so.
bool name_no_friction(std::vector<std::string>& words) {
  const auto at = std::find(words.begin(), words.end(), "tangential");
  if (at == words.end()) {
    words.insert(words.end(), {"tangential", contact::TangentialNoHistory::name});
    return true;
  }
  if (at + 1 == words.end() || at[1] != "off") return false;
  at[1] = contact::TangentialNoHistory::name;
  return true;
}

}  // namespace

PairGranOfHost::PairGranOfHost(LAMMPS* host) : PairGranProxy(host) {}

void PairGranOfHost::settings(int narg, char** arg) {
  if (force->pair != this)
    refuse("it is the only pair style of a script. Write 'gran' among those of 'hybrid'.");
  constexpr char name[] = "gran";
  static_assert(sizeof(name) <= sizeof("gran/bridge"));
  std::strcpy(force->pair_style, name);
  PairGranProxy::settings(narg, arg);
}

PairGranBridge::PairGranBridge(LAMMPS* host) : PairGranOfHost(host) {}
PairGranBridge::~PairGranBridge() = default;

void PairGranBridge::settings(int narg, char** arg) {
  std::vector<std::string> words(arg, arg + narg);
  PairGranOfHost::settings(narg, arg);
  frictionless_ = name_no_friction(words);
  try {
    choice_ = contact::read_contact(words, false);
  } catch (const gasgrain::Error& e) {
    refuse(of_this_host(e.what()) +
           "Every other model and word of LIGGGHTS is taken by 'pair_style gran'.");
  }
  choice_.stack->put_cohesion_first();
  check_history();
}

// Both must have a contact's values in the same places: restart files, fixes and computes of the
// host go by its own.
void PairGranBridge::check_history() const {
  const auto ours = choice_.stack->history();
  bool same = ours.size() == history_arg.size();
  for (std::size_t n = 0; same && n < ours.size(); ++n)
    same = history_arg[n].name == ours[n].name &&
           history_arg[n].newtonflag == (ours[n].changes_sign ? "1" : "0");
  if (same) return;
  const auto names = [](const auto& values) {
    std::string text;
    for (const auto& value : values) text += std::string(text.empty() ? "" : ", ") + value.name;
    return text.empty() ? std::string("nothing") : text;
  };
  refuse(
      fmt::format("LIGGGHTS keeps of a contact: {}; these laws: {}. Write 'pair_style gran' here.",
                  names(history_arg), names(ours)));
}

void PairGranBridge::check_grains() {
  if (atom->sphere_flag == 0 || atom->rmass == nullptr || atom->shapetype_flag != 0)
    refuse("its laws are of spheres. Write 'atom_style granular' or sphere, or 'pair_style gran'.");
  if (storeSumDelta())
    refuse(
        "a fix wants radii that grow with the other contacts of a grain. Write 'pair_style gran' "
        "with 'surface multicontact'.");
}

void PairGranBridge::init_granular() {
  check_grains();
  PairGranProxy::init_granular();
  hosts_.clear();
  choice_.stack->connect(
      choice_.name, [this](const std::string& law, int offset) -> contact::ContactHost& {
        auto& host =
            *hosts_.emplace_back(std::make_unique<gasgrain::ContactHostLiggghts>(*lmp, *this, law));
        host.set_history_offset(offset);
        host.set_frictionless(frictionless_);
        return host;
      });
}

contact::Grains PairGranBridge::grains() const {
  using Rows = double(*)[3];
  // The host's arrays are one block each; without grains there may be none.
  const bool any = atom->nlocal + atom->nghost > 0;
  const auto rows = [any](double** array) {
    return any ? reinterpret_cast<Rows>(array[0]) : nullptr;
  };
  contact::Grains grains{};
  grains.x = rows(atom->x);
  grains.v = rows(atom->v);
  grains.spin = rows(atom->omega);
  grains.radius = atom->radius;
  grains.mass = atom->rmass;
  grains.type = atom->type;
  grains.mask = atom->mask;
  grains.force = rows(atom->f);
  grains.torque = rows(atom->torque);
  grains.owned = atom->nlocal;
  grains.ghosts_take_forces = force->newton_pair != 0;
  grains.frozen = freeze_group_bit();
  grains.body_mass = fr_pair() != nullptr ? mr_pair() : nullptr;
  grains.dt = update->dt;
  grains.step = update->ntimestep;
  grains.updates = computeflag() != 0 && shearupdate() != 0;
  return grains;
}

contact::ContactRows PairGranBridge::rows() {
  if (listgranhistory == nullptr) return {};
  return {listgranhistory->firstneigh, listgranhistory->firstdouble, dnum()};
}

void PairGranBridge::compute_force(int eflag, int vflag, int addflag) {
  if (eflag != 0 || vflag != 0)
    ev_setup(eflag, vflag);
  else
    evflag = vflag_fdotr = 0;
  // Walls and fixes ask for it too, and after the pair style.
  choice_.stack->set_reach({neighbor->contactDistanceFactor, 0.0});
  choice_.stack->begin_pass();
  if (has_listeners(addflag)) {
    compute_and_tell(addflag);
    return;
  }
  const contact::NeighbourList neighbours{list->inum, list->ilist, list->numneigh, list->firstneigh,
                                          NEIGHMASK};
  choice_.stack->pairs(grains(), neighbours, rows(), evflag != 0 ? this : nullptr);
}

void PairGranBridge::acts(int i, int j, const contact::Triple& f, const contact::Triple& delta) {
  ev_tally_xyz(i, j, atom->nlocal, force->newton_pair, 0.0, 0.0, f.x, f.y, f.z, delta.x, delta.y,
               delta.z);
}

}  // namespace LAMMPS_NS
