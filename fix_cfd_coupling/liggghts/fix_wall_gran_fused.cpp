#include "fix_cfd_coupling/liggghts/fix_wall_gran_fused.h"

#include <algorithm>

#include "coupling/base/error.h"
#include "fix_cfd_coupling/fixes/grains_of_host.h"
#include "fix_cfd_coupling/liggghts/neighbor_sorted.h"
#include "fix_cfd_coupling/liggghts/pair_gran_bridge.h"
// --
#include "atom.h"
#include "comm.h"
#include "fix_property_atom.h"
#include "force.h"
#include "neighbor.h"
#include "primitive_wall.h"

namespace LAMMPS_NS {

namespace contact = gasgrain::contact;

FixWallGranFused::FixWallGranFused(LAMMPS* host, int narg, char** arg)
    : FixWallGran(host, narg, arg) {
  if (!is_mesh_wall()) read(std::vector<std::string>(arg + 3, arg + narg));
}

// CONTACT primitive type T SHAPE NUMBER...; the host has found them right.
void FixWallGranFused::read(const std::vector<std::string>& words) {
  const auto primitive = std::find(words.begin(), words.end(), "primitive");
  const std::string& kind = primitive[3];
  const auto number = [&](int n) { return force->numeric(FLERR, primitive[4 + n].c_str()); };
  shape_.axis = kind[0] - 'x';
  shape_.round = kind.substr(1) == "cylinder";
  if (shape_.round) {
    shape_.radius = number(0);
    shape_.centre = {number(1), number(2)};
  } else {
    shape_.place = number(0);
  }
  try {
    contact_ = std::make_unique<gasgrain::CompiledContact>(
        std::vector<std::string>(words.begin(), primitive), true);
  } catch (const gasgrain::Error&) {
    contact_.reset();
  }
}

bool FixWallGranFused::is_beside_own_loop() const {
  return dynamic_cast<PairGranBridge*>(force->pair) != nullptr;
}

std::string FixWallGranFused::needs_host() const {
  if (contact_ == nullptr || static_cast<int>(contact_->stack().history().size()) != dnum_)
    return "its models and words are not compiled";
  if (contact_->stack().has_cohesion()) return "of its cohesion";
  // Nothing would be gained, and a cohesion of 0 would differ from none by round-off.
  if (contact_->stack().instructions() == contact::InstructionSet::portable)
    return "one contact comes after the other";
  if (igroup != 0) return "its group is not 'all'";
  if (shear_ != 0) return "of its 'shear'";
  if (fix_rigid_ != nullptr) return "of 'fix rigid'";
  if (heattransfer_flag_) return "of its temperature";
  if (store_force_ || store_force_contact_ || store_force_contact_stress_ ||
      store_sum_normal_force() || track_energy_ || fix_store_multicontact_data_ != nullptr)
    return "forces or energies of its contacts are stored";
  return "";
}

void FixWallGranFused::init() {
  FixWallGran::init();
  if (is_mesh_wall() || !is_beside_own_loop()) return;
  const std::string why = needs_host();
  if (why.empty()) contact_->connect(*lmp, *this);
  near_.clear();
  is_near_.clear();
  if (said_ == why) return;
  said_ = why;
  if (why.empty() || comm->me != 0) return;
  for (FILE* file : {screen, logfile})
    if (file != nullptr)
      fmt::print(file, "fix {} wall/gran: LIGGGHTS's own models take its contacts, because {}\n",
                 id, why);
}

bool FixWallGranFused::follows_renewed_lists() const {
  return !is_mesh_wall() && needs_host().empty();
}

void FixWallGranFused::pre_force(int vflag) {
  // Of a list that is made anew it is not known who has touched.
  if (rebuildPrimitiveNeighlist_) is_near_.clear();
  FixWallGran::pre_force(vflag);
}

// Those that the host has found when all lists were made, and those of the grains that got new
// pairs since then which are as near.
void FixWallGranFused::take_near_grains() {
  if (is_near_.empty()) {
    int* near = nullptr;
    const int count = primitiveWall_->getNeighbors(near);
    near_.assign(near, near + count);
    in_use_.assign(count, 1);
    is_near_.assign(atom->nlocal, 0);
    for (const int i : near_) is_near_[i] = 1;
  }
  for (const int i : gasgrain::NeighborSorted::of(*lmp).renewed_now()) {
    if (is_near_[i] != 0 || primitiveWall_->isNear(i, 0.5 * neighbor->skin) == 0) continue;
    is_near_[i] = 1;
    near_.push_back(i);
    in_use_.push_back(1);
  }
}

void FixWallGranFused::post_force_primitive(int vflag) {
  if (!is_beside_own_loop() || !needs_host().empty()) {
    FixWallGran::post_force_primitive(vflag);
    return;
  }
  take_near_grains();
  if (addflag_ != 0 || computeflag_ == 0) {
    // The host's list is of the time when all lists were made.
    primitiveWall_->buildNeighList(0.5 * neighbor->skin, atom->x, atom->radius, atom->nlocal);
    FixWallGran::post_force_primitive(vflag);
    std::fill(in_use_.begin(), in_use_.end(), 1);
    return;
  }
  const bool remembers = dnum_ > 0;
  contact::Grains grains = gasgrain::grains_of(*lmp, 0, nullptr);
  grains.updates = shearupdate_ != 0;
  contact_->stack().wall(grains,
                         {static_cast<int>(near_.size()), near_.data(),
                          remembers ? fix_history_primitive_->array_atom : nullptr,
                          remembers ? in_use_.data() : nullptr},
                         shape_, atom_type_wall_, nullptr);
}

}  // namespace LAMMPS_NS
