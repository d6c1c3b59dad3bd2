#include "fix_cfd_coupling/liggghts/fix_contact_history_packed.h"

#include <fmt/core.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "fix_cfd_coupling/liggghts/neighbor_sorted.h"
// --
#include "atom.h"
#include "comm.h"
#include "error.h"
#include "neigh_list.h"
#include "pair.h"

namespace LAMMPS_NS {

int FixContactHistoryPacked::setmask() {
  return FixContactHistory::setmask() | FixConst::POST_RUN;
}

void FixContactHistoryPacked::post_run() {
  const auto& lists = gasgrain::NeighborSorted::of(*lmp);
  if (!lists.renews()) return;
  std::int64_t renewals = lists.renewals();
  MPI_Allreduce(MPI_IN_PLACE, &renewals, 1, MPI_INT64_T, MPI_SUM, world);
  if (comm->me != 0) return;
  for (FILE* file : {screen, logfile})
    if (file != nullptr)
      fmt::print(file, "Neighbour lists: {} times a grain got new pairs by itself\n", renewals);
}

void FixContactHistoryPacked::pre_exchange() {
  // From now on the grains have what is newest.
  *computeflag_ = 0;
  pick_contacts();
  const NeighList& list = *pair_gran_->list;
  // Grains may have come since the list was made.
  const int grains = atom->nlocal;
  const int listed = list.inum > 0 ? list.ilist[list.inum - 1] + 1 : 0;

  std::fill_n(npartner_, grains, 0);
  for (std::size_t c = 0; c < picked_; ++c) {
    const Contact& contact = contacts_[c];
    ++npartner_[contact.i];
    if (contact.j < listed) ++npartner_[contact.j];
  }
  ipage_->reset();
  dpage_->reset();
  for (int n = 0; n < list.inum; ++n) {
    const int i = list.ilist[n];
    partner_[i] = ipage_->get(npartner_[i]);
    contacthistory_[i] = dpage_->get(dnum_ * npartner_[i]);
    if (partner_[i] == nullptr || contacthistory_[i] == nullptr)
      error->one(FLERR, "Contact history overflow, boost neigh_modify one");
  }

  std::fill_n(npartner_, grains, 0);
  const int* const tag = atom->tag;
  for (std::size_t c = 0; c < picked_; ++c) {
    const Contact& contact = contacts_[c];
    const int i = contact.i, j = contact.j;
    const int m = npartner_[i]++;
    partner_[i][m] = tag[j];
    std::copy_n(contact.values, dnum_, contacthistory_[i] + m * dnum_);
    if (j >= listed) continue;
    const int k = npartner_[j]++;
    partner_[j][k] = tag[i];
    double* const seen_from_j = contacthistory_[j] + k * dnum_;
    for (int d = 0; d < dnum_; ++d)
      seen_from_j[d] = newtonflag_[d] != 0 ? -contact.values[d] : contact.values[d];
  }

  maxtouch_ = grains > 0 ? *std::max_element(npartner_, npartner_ + grains) : 0;
  comm->maxexchange_fix = std::max(comm->maxexchange_fix, (dnum_ + 1) * maxtouch_ + 1);
}

void FixContactHistoryPacked::pick_contacts() {
  const NeighList& list = *pair_gran_->list;
  const NeighList& rows = *list.listgranhistory;
  picked_ = 0;
  for (int n = 0; n < list.inum; ++n) {
    const int i = list.ilist[n], pairs = list.numneigh[i];
    if (const auto room = picked_ + static_cast<std::size_t>(pairs) + 1; room > contacts_.size())
      contacts_.resize(2 * room);
    const int* const partners = list.firstneigh[i];
    const int* const in_contact = rows.firstneigh[i];
    const double* values = rows.firstdouble[i];
    for (int m = 0; m < pairs; ++m, values += dnum_) {
      contacts_[picked_] = {i, partners[m] & NEIGHMASK, values};
      picked_ += static_cast<std::size_t>(in_contact[m] != 0);
    }
  }
}

}  // namespace LAMMPS_NS
