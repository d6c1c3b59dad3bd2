// What the host's fixes and computes want to know of each contact, as its own loop tells it:
// compute pair/gran/local, the contact forces that fixes store, the sums of normal forces. Such a
// step takes each contact by itself; it computes the same.
#include <cmath>

#include "fix_cfd_coupling/liggghts/pair_gran_bridge.h"
// --
#include "atom.h"
#include "fix_contact_property_atom.h"
#include "force.h"
#include "neigh_list.h"
#include "neighbor.h"
#include "update.h"

namespace LAMMPS_NS {

namespace contact = gasgrain::contact;
using contact::Triple;

namespace {

void add(const LCM::ForceData& what, double* force, double* torque) {
  for (int d = 0; d < 3; ++d) {
    force[d] += what.delta_F[d];
    torque[d] += what.delta_torque[d];
  }
}

// Each of two grains has the other as its partner once, whoever of them comes first in the list.
void store_once(FixContactPropertyAtom& store, int grain, int partner, const double* values) {
  if (store.has_partner(grain, partner) == -1) store.add_partner(grain, partner, values);
}

}  // namespace

bool PairGranBridge::has_listeners(int addflag) const {
  return addflag != 0 || computeflag() == 0 || store_contact_forces_ ||
         store_contact_forces_stress_ || store_sum_normal_force();
}

void PairGranBridge::compute_and_tell(int addflag) {
  const contact::Grains of_step = grains();
  const contact::ContactRows kept = rows();
  const double factor = neighbor->contactDistanceFactor;
  const bool to_compute = addflag != 0 && cpl() != nullptr;
  LCM::SurfacesIntersectData data;
  data.computeflag = computeflag();
  data.shearupdate = shearupdate();
  for (int n = 0; n < list->inum; ++n) {
    const int i = list->ilist[n];
    for (int m = 0; m < list->numneigh[i]; ++m) {
      const int j = list->firstneigh[i][m] & NEIGHMASK;
      const Triple delta = Triple::of(atom->x[i]) - Triple::of(atom->x[j]);
      const double square = delta.dot(delta);
      const double sum = atom->radius[i] + atom->radius[j];
      int* use = kept.in_use != nullptr ? kept.in_use[i] + m : nullptr;
      double* row = kept.values != nullptr ? kept.values[i] + m * kept.width : nullptr;
      if (square >= factor * factor * sum * sum && (use == nullptr || *use == 0)) continue;
      contact::Push push;
      if (!contact_->stack().pair(of_step, i, j, delta, use, row, push)) continue;
      if (!contact_->stack().has_cohesion()) push.force_j = -push.force_i;

      // What the computes of the host, and tell(), read of its data.
      LCM::ForceData on_i, on_j;
      push.force_i.store(on_i.delta_F);
      push.torque_i.store(on_i.delta_torque);
      push.force_j.store(on_j.delta_F);
      push.torque_j.store(on_j.delta_torque);
      data.i = i;
      data.j = j;
      data.contact_flags = use;
      data.contact_history = row;
      delta.store(data.delta);
      ((1.0 / std::sqrt(square)) * delta).store(data.en);
      tell(data, on_i, on_j, to_compute);
    }
  }
  if (to_compute) cpl_pair_finalize();
  if (store_contact_forces_) fix_contact_forces_->do_forward_comm();
  if (store_contact_forces_stress_) fix_contact_forces_stress_->do_forward_comm();
}

void PairGranBridge::tell(LCM::SurfacesIntersectData& data, LCM::ForceData& on_i,
                          LCM::ForceData& on_j, bool to_compute) {
  const int i = data.i, j = data.j;
  const bool j_takes = force->newton_pair != 0 || j < atom->nlocal;
  if (data.computeflag != 0) {
    add(on_i, atom->f[i], atom->torque[i]);
    if (j_takes) add(on_j, atom->f[j], atom->torque[j]);
    if (store_sum_normal_force()) {
      const double along = Triple::of(on_i.delta_F).dot(Triple::of(data.en));
      *get_sum_normal_force_ptr(i) += along;
      if (j_takes) *get_sum_normal_force_ptr(j) += along;
    }
  }
  if (to_compute) cpl_add_pair(data, on_i);
  if (evflag != 0) acts(i, j, Triple::of(on_i.delta_F), Triple::of(data.delta));

  if (store_contact_forces_ && update->ntimestep % storeContactForcesEvery() == 0) {
    const auto values = [](const LCM::ForceData& on, double* into) {
      Triple::of(on.delta_F).store(into);
      Triple::of(on.delta_torque).store(into + 3);
    };
    double of_i[6], of_j[6];
    values(on_i, of_i);
    values(on_j, of_j);
    store_once(*fix_contact_forces_, i, atom->tag[j], of_i);
    store_once(*fix_contact_forces_, j, atom->tag[i], of_j);
  }
  if (store_contact_forces_stress_) {
    double of_i[4] = {on_i.delta_F[0], on_i.delta_F[1], on_i.delta_F[2], static_cast<double>(j)};
    double of_j[4] = {on_j.delta_F[0], on_j.delta_F[1], on_j.delta_F[2], static_cast<double>(i)};
    store_once(*fix_contact_forces_stress_, i, atom->tag[j], of_i);
    store_once(*fix_contact_forces_stress_, j, atom->tag[i], of_j);
  }
}

}  // namespace LAMMPS_NS
