#include "fix_cfd_coupling/lammps/pair_gran_bridge.h"

#include <algorithm>
#include <cmath>

#include "coupling/base/error.h"
#include "fix_cfd_coupling/fixes/grains_of_host.h"
#include "fix_cfd_coupling/fixes/host_error.h"
#include "fix_cfd_coupling/lammps/fix_gran_bridge_history.h"
// --
#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "force.h"
#include "memory.h"
#include "modify.h"
#include "neigh_list.h"
#include "neigh_request.h"
#include "neighbor.h"
#include "update.h"
#include "utils.h"

namespace LAMMPS_NS {

namespace contact = gasgrain::contact;

namespace {

constexpr const char* style_name = "pair_style gran/bridge";

[[noreturn]] void refuse(const std::string& why) {
  gasgrain::stop_everything(fmt::format("{}: {}", style_name, why));
}

// Of `single()`: what LAMMPS's own granular styles give there.
constexpr int singles = 10;

}  // namespace

PairGranBridge::PairGranBridge(LAMMPS* host) : Pair(host) {
  single_enable = 1;
  no_virial_fdotr_compute = 1;
  centroidstressflag = CENTROID_NOTAVAIL;
  finitecutflag = 1;
  single_extra = singles;
  svector = new double[singles];
  comm_forward = 1;
  nondefault_history_transfer = 1;
  // Restart files know the history by this name: the same for the only pair style of each script.
  int number = 0;
  do history_id_ = fmt::format("NEIGH_HISTORY_GRAN_BRIDGE{}", number++);
  while (modify->find_fix(history_id_) >= 0 || modify->find_fix(history_id_ + "_DUMMY") >= 0);
  // Keeps the place of the history's fix in the order of fixes, until it is known what it holds.
  modify->add_fix(history_id_ + "_DUMMY all DUMMY");
}

PairGranBridge::~PairGranBridge() {
  delete[] svector;
  modify->delete_fix(history_id_ + (fix_history_ == nullptr ? "_DUMMY" : ""));
  if (allocated) {
    memory->destroy(setflag);
    memory->destroy(cutsq);
  }
}

void PairGranBridge::allocate() {
  allocated = 1;
  const int n = atom->ntypes;
  memory->create(setflag, n + 1, n + 1, "pair:setflag");
  memory->create(cutsq, n + 1, n + 1, "pair:cutsq");
  for (int i = 1; i <= n; ++i)
    for (int j = i; j <= n; ++j) setflag[i][j] = 0;
}

void PairGranBridge::settings(int narg, char** arg) {
  set_words(std::vector<std::string>(arg, arg + narg));
}

void PairGranBridge::set_words(const std::vector<std::string>& words) {
  const int width_before = history_width();
  const bool had_words = !words_.empty();
  try {
    choice_ = contact::read_contact(words, false);
  } catch (const gasgrain::Error& e) {
    refuse(e.what());
  }
  words_ = words;
  history_values_ = choice_.stack->history();
  history_.clear();
  for (const auto& value : history_values_) history_.push_back(value.changes_sign ? -1.0 : 1.0);
  if (had_words && history_width() != width_before)
    refuse(fmt::format(
        "these models keep {} values of a contact, those of the restart file or of the line before "
        "{}. Go on with the same models, or write the grains by write_data and read them again.",
        history_width(), width_before));
  beyond_contact = choice_.stack->has_cohesion() ? 1 : 0;
}

void PairGranBridge::coeff(int narg, char** arg) {
  if (narg != 2)
    refuse(
        "pair_coeff has the types alone, 'pair_coeff * *': properties are 'fix ID all "
        "property/global NAME ...'.");
  if (!allocated) allocate();
  int ilo = 0, ihi = 0, jlo = 0, jhi = 0;
  utils::bounds(FLERR, arg[0], 1, atom->ntypes, ilo, ihi, error);
  utils::bounds(FLERR, arg[1], 1, atom->ntypes, jlo, jhi, error);
  for (int i = ilo; i <= ihi; ++i)
    for (int j = std::max(jlo, i); j <= jhi; ++j) setflag[i][j] = 1;
}

void PairGranBridge::init_style() {
  if (atom->radius_flag == 0 || atom->rmass_flag == 0 || atom->omega_flag == 0)
    refuse("grains need radius, mass and spin. Write 'atom_style sphere'.");
  if (comm->ghost_velocity == 0)
    refuse("contacts need the velocities of the neighbours. Write 'comm_modify vel yes'.");
  if (domain->dimension != 3) refuse("its laws are of spheres. Write 'dimension 3'.");
  if (force->nktv2p != 1.0)
    refuse(fmt::format("its properties are not of 'units {}'. Write 'units si', cgs or lj.",
                       update->unit_style));
  if (choice_.stack->has_cohesion() && force->newton_pair != 0)
    refuse("cohesion needs a pair whole on each of its ranks. Write 'newton off'.");

  const int request = neighbor->request(this, instance_me);
  // Lists by the size of each grain end at contact; those by types reach as far as init_one() says.
  neighbor->requests[request]->size = choice_.stack->has_cohesion() ? 0 : 1;
  neighbor->requests[request]->history = history_width() > 0 ? 1 : 0;
  make_history_fix();

  const int freeze = modify->find_fix_by_style("^freeze");
  frozen_ = freeze < 0 ? 0 : modify->fix[freeze]->groupbit;
  bodies_.find_fix(*lmp);
  find_largest_radii();
  connect_laws();
}

void PairGranBridge::make_history_fix() {
  if (history_width() == 0) return;
  if (fix_history_ == nullptr) {
    modify->replace_fix(
        history_id_ + "_DUMMY",
        fmt::format("{} all NEIGH_HISTORY/gran/bridge {}", history_id_, history_width()), 1);
  }
  const int at = modify->find_fix(history_id_);
  if (at < 0) refuse("the fix that keeps its history was deleted.");
  fix_history_ = static_cast<FixGranBridgeHistory*>(modify->fix[at]);
  fix_history_->pair = this;
}

void PairGranBridge::find_largest_radii() {
  const int types = atom->ntypes;
  largest_moving_.assign(types + 1, 0.0);
  largest_frozen_.assign(types + 1, 0.0);
  // Grains that are still to come count as moving ones.
  for (const char* source : {"^pour", "^deposit"}) {
    const int at = modify->find_fix_by_style(source);
    if (at < 0) continue;
    for (int type = 1; type <= types; ++type) {
      int of_type = type;
      if (const auto* radius = static_cast<double*>(modify->fix[at]->extract("radius", of_type)))
        largest_moving_[type] = std::max(largest_moving_[type], *radius);
    }
  }
  for (int k = 0; k < atom->nlocal; ++k) {
    const bool is_frozen = (atom->mask[k] & frozen_) != 0;
    double& largest = (is_frozen ? largest_frozen_ : largest_moving_)[atom->type[k]];
    largest = std::max(largest, atom->radius[k]);
  }
  for (auto* largest : {&largest_moving_, &largest_frozen_})
    MPI_Allreduce(MPI_IN_PLACE, largest->data(), types + 1, MPI_DOUBLE, MPI_MAX, world);
}

void PairGranBridge::connect_laws() {
  const gasgrain::ContactOwner owner{
      lmp, style_name, "", choice_.name.normal, &choice_.properties, &reach_, this};
  hosts_.connect(owner, *choice_.stack, choice_.name);
  choice_.stack->set_reach(reach_);
}

void PairGranBridge::reach_at_least(double times) {
  reach_.times = std::max(reach_.times, times);
  choice_.stack->set_reach(reach_);
}

double PairGranBridge::init_one(int i, int j) {
  if (!allocated) allocate();
  // Frozen grains do not act on each other.
  return reach_.of(
      std::max({largest_moving_[i] + largest_moving_[j], largest_frozen_[i] + largest_moving_[j],
                largest_moving_[i] + largest_frozen_[j]}));
}

contact::ContactRows PairGranBridge::rows() const {
  if (fix_history_ == nullptr) return {};
  return {fix_history_->firstflag, fix_history_->firstvalue, history_width()};
}

void PairGranBridge::compute(int eflag, int vflag) {
  ev_init(eflag, vflag);
  if (bodies_.exist() && neighbor->ago == 0) {
    bodies_.take(*lmp);
    send_to_ghosts(const_cast<double*>(bodies_.data()));
  }
  const contact::NeighbourList neighbours{list->inum, list->ilist, list->numneigh, list->firstneigh,
                                          NEIGHMASK};
  choice_.stack->begin_pass();
  choice_.stack->pairs(gasgrain::grains_of(*lmp, frozen_, bodies_.data()), neighbours, rows(),
                       evflag != 0 ? this : nullptr);
  if (vflag_fdotr != 0) virial_fdotr_compute();
}

void PairGranBridge::acts(int i, int j, const contact::Triple& f, const contact::Triple& delta) {
  ev_tally_xyz(i, j, atom->nlocal, force->newton_pair, 0.0, 0.0, f.x, f.y, f.z, delta.x, delta.y,
               delta.z);
}

double PairGranBridge::single(int i, int j, int, int, double rsq, double, double, double& fforce) {
  fforce = 0.0;
  std::fill_n(svector, singles, 0.0);
  auto grains = gasgrain::grains_of(*lmp, frozen_, bodies_.data());
  grains.updates = false;
  std::vector<double> row(history_.size(), 0.0);
  int use = 0;
  const int count = list->numneigh[i];
  for (int m = 0; m < count && fix_history_ != nullptr; ++m) {
    if ((list->firstneigh[i][m] & NEIGHMASK) != j) continue;
    std::copy_n(fix_history_->firstvalue[i] + m * row.size(), row.size(), row.data());
    use = fix_history_->firstflag[i][m];
    break;
  }
  const contact::Triple delta = contact::Triple::of(atom->x[i]) - contact::Triple::of(atom->x[j]);
  const double sum = atom->radius[i] + atom->radius[j];
  if (rsq >= sum * sum && use == 0 && beyond_contact == 0) return 0.0;
  contact::Push push;
  if (!choice_.stack->pair(grains, i, j, delta, row.empty() ? nullptr : &use,
                           row.empty() ? nullptr : row.data(), push))
    return 0.0;
  const contact::Triple normal = (1.0 / delta.norm()) * delta;
  const contact::Triple velocity =
      contact::Triple::of(atom->v[i]) - contact::Triple::of(atom->v[j]);
  const double along = push.force_i.dot(normal);
  const contact::Triple across = push.force_i - along * normal;
  const contact::Triple parting = velocity.dot(normal) * normal;
  across.store(svector);
  parting.store(svector + 4);
  (velocity - parting).store(svector + 7);
  svector[3] = across.norm();
  fforce = along / std::sqrt(rsq);
  return 0.0;
}

void PairGranBridge::transfer_history(double* from, double* to) {
  for (std::size_t n = 0; n < history_.size(); ++n) to[n] = history_[n] * from[n];
}

void PairGranBridge::write_restart(FILE* file) {
  write_restart_settings(file);
  for (int i = 1; i <= atom->ntypes; ++i)
    fwrite(&setflag[i][i], sizeof(int), atom->ntypes - i + 1, file);
}

void PairGranBridge::read_restart(FILE* file) {
  read_restart_settings(file);
  allocate();
  for (int i = 1; i <= atom->ntypes; ++i) {
    const int count = atom->ntypes - i + 1;
    if (comm->me == 0)
      utils::sfread(FLERR, &setflag[i][i], sizeof(int), count, file, nullptr, error);
    MPI_Bcast(&setflag[i][i], count, MPI_INT, 0, world);
  }
}

// The words of the script's line, each with a 0 after it.
void PairGranBridge::write_restart_settings(FILE* file) {
  std::string text;
  for (const auto& word : words_) text += word + '\0';
  const int size = static_cast<int>(text.size());
  fwrite(&size, sizeof(int), 1, file);
  fwrite(text.data(), 1, text.size(), file);
}

void PairGranBridge::read_restart_settings(FILE* file) {
  int size = 0;
  if (comm->me == 0) utils::sfread(FLERR, &size, sizeof(int), 1, file, nullptr, error);
  MPI_Bcast(&size, 1, MPI_INT, 0, world);
  std::string text(size, '\0');
  if (comm->me == 0) utils::sfread(FLERR, text.data(), 1, size, file, nullptr, error);
  MPI_Bcast(text.data(), size, MPI_CHAR, 0, world);
  std::vector<std::string> words;
  for (std::size_t at = 0; at < text.size(); at += words.back().size() + 1)
    words.emplace_back(text.c_str() + at);
  set_words(words);
}

void PairGranBridge::send_to_ghosts(double* values) {
  to_ghosts_ = values;
  comm->forward_comm_pair(this);
}

int PairGranBridge::pack_forward_comm(int n, int* grains, double* buffer, int, int*) {
  for (int k = 0; k < n; ++k) buffer[k] = to_ghosts_[grains[k]];
  return n;
}

void PairGranBridge::unpack_forward_comm(int n, int first, double* buffer) {
  std::copy_n(buffer, n, to_ghosts_ + first);
}

double PairGranBridge::atom2cut(int i) {
  return reach_.of(2.0 * atom->radius[i]);
}
double PairGranBridge::radii2cut(double r1, double r2) {
  return reach_.of(r1 + r2);
}

}  // namespace LAMMPS_NS
