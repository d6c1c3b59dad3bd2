#include "fix_cfd_coupling/liggghts/pair_gran_bridge.h"

#include <cstring>
#include <string>

#include "coupling/base/error.h"
#include "fix_cfd_coupling/fixes/grains_of_host.h"
#include "fix_cfd_coupling/fixes/host_error.h"
#include "fix_cfd_coupling/liggghts/neighbor_sorted.h"
// --
#include "atom.h"
#include "comm.h"
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
  const std::vector<std::string> words(arg, arg + narg);
  PairGranOfHost::settings(narg, arg);
  try {
    contact_ = std::make_unique<gasgrain::CompiledContact>(words, false);
  } catch (const gasgrain::Error& e) {
    refuse(std::string(e.what()) +
           "Every other model and word of LIGGGHTS is taken by 'pair_style gran'.");
  }
  check_history();
}

// Both must have a contact's values in the same places: restart files, fixes and computes of the
// host go by its own.
void PairGranBridge::check_history() const {
  const auto ours = contact_->stack().history();
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
  contact_->connect(*lmp, *this);
  if (comm->me != 0 || said_how_) return;
  said_how_ = true;
  const std::string set = contact::name_of(contact_->stack().instructions());
  for (FILE* file : {screen, logfile})
    if (file != nullptr) fmt::print(file, "pair_style gran/bridge: instructions {}\n", set);
}

contact::Grains PairGranBridge::grains() const {
  contact::Grains grains =
      gasgrain::grains_of(*lmp, freeze_group_bit(), fr_pair() != nullptr ? mr_pair() : nullptr);
  grains.updates = computeflag() != 0 && shearupdate() != 0;
  return grains;
}

contact::ContactRows PairGranBridge::rows() {
  if (listgranhistory == nullptr) return {};
  return {listgranhistory->firstneigh, listgranhistory->firstdouble, dnum()};
}

// Bridges and adhesion keep more of a pair than what its row holds while it touches. And where one
// contact comes after the other, a cohesion of 0 is none to the last bit: the order must be the
// same.
bool PairGranBridge::follows_renewed_lists() const {
  const contact::ContactStack& stack = contact_->stack();
  return !stack.has_cohesion() && !stack.history().empty() &&
         stack.instructions() != contact::InstructionSet::portable;
}

void PairGranBridge::compute_force(int eflag, int vflag, int addflag) {
  gasgrain::NeighborSorted::of(*lmp).renew_lists(*list);
  if (eflag != 0 || vflag != 0)
    ev_setup(eflag, vflag);
  else
    evflag = vflag_fdotr = 0;
  // Walls and fixes ask for it too, and after the pair style.
  contact_->stack().set_reach({neighbor->contactDistanceFactor, 0.0});
  contact_->stack().begin_pass();
  if (has_listeners(addflag)) {
    compute_and_tell(addflag);
    return;
  }
  const contact::NeighbourList neighbours{list->inum, list->ilist, list->numneigh, list->firstneigh,
                                          NEIGHMASK};
  contact_->stack().pairs(grains(), neighbours, rows(), evflag != 0 ? this : nullptr);
}

void PairGranBridge::acts(int i, int j, const contact::Triple& f, const contact::Triple& delta) {
  ev_tally_xyz(i, j, atom->nlocal, force->newton_pair, 0.0, 0.0, f.x, f.y, f.z, delta.x, delta.y,
               delta.z);
}

}  // namespace LAMMPS_NS
