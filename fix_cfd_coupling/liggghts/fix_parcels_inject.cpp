#include "fix_cfd_coupling/liggghts/fix_parcels_inject.h"

#include <cstring>
#include <string>

#include "coupling/base/error.h"
#include "fix_cfd_coupling/liggghts/fix_collisional_exchange.h"
#include "fix_cfd_coupling/liggghts/fix_parcels.h"
#include "fix_cfd_coupling/liggghts/host_error.h"
#include "fix_cfd_coupling/liggghts/host_session.h"
// --
#include "atom.h"
#include "atom_vec.h"
#include "comm.h"
#include "domain.h"
#include "modify.h"
#include "update.h"

namespace LAMMPS_NS {

FixParcelsInject::FixParcelsInject(LAMMPS* host, int narg, char** arg) : Fix(host, narg, arg) {
  try {
    parcels_ = FixParcels::of_scene(lmp);
    if (parcels_ == nullptr)
      gasgrain::fail("fix parcels/inject needs a fix parcels before it in the script.");
    exchange_ = FixCollisionalExchange::of_scene(lmp);
    const std::vector<std::string> species =
        exchange_ != nullptr ? exchange_->species() : std::vector<std::string>{"liquid"};
    species_ = species.size();
    settings_ = gasgrain::parse_injection({arg + 3, arg + narg}, species, atom->ntypes);
    const std::string fault = gasgrain::feed_fault(parcels_->settings(), settings_);
    if (!fault.empty()) gasgrain::fail("fix parcels/inject cannot be used:\n  {}", fault);
    if (domain->box_exist == 0)
      gasgrain::fail("fix parcels/inject must stand after create_box or read_restart.");
    gasgrain::BoxGrid box;
    for (int d = 0; d < 3; ++d) {
      box.lo[d] = domain->boxlo[d];
      box.hi[d] = domain->boxhi[d];
      box.periodic[d] = domain->periodicity[d] != 0;
    }
    injector_ = std::make_unique<gasgrain::Injector>(settings_, box);
  } catch (const gasgrain::Error& e) {
    gasgrain::stop_everything(e.what());
  }
  vector_flag = 1;
  size_vector = 5 + static_cast<int>(species_);
  global_freq = 1;
  extvector = 0;
  restart_global = 1;
}

int FixParcelsInject::setmask() {
  return FixConst::PRE_EXCHANGE;
}

void FixParcelsInject::init() {
  parcels_ = FixParcels::of_scene(lmp);
  exchange_ = FixCollisionalExchange::of_scene(lmp);
  if (parcels_ == nullptr)
    gasgrain::stop_everything("fix parcels/inject has no fix parcels any more.");
  const std::size_t species = exchange_ != nullptr ? exchange_->species().size() : 1;
  if (species != species_)
    gasgrain::stop_everything(
        "fix parcels/inject was made with other species than fix collisional_exchange has: put it "
        "after that fix.");
  if (done_to_ < 0) done_to_ = update->ntimestep;
}

// Called at every step of a run, before the host hands parcels to their ranks.
void FixParcelsInject::pre_exchange() {
  const double dt = update->dt;
  const auto time = static_cast<double>(done_to_) * dt;
  const auto steps = static_cast<double>(update->ntimestep - done_to_);
  done_to_ = update->ntimestep;
  if (steps <= 0.0) return;
  const std::vector<gasgrain::NewParcel> list = injector_->due(time, steps * dt);
  if (list.empty()) return;
  int last = 0;
  for (int k = 0; k < atom->nlocal; ++k) last = std::max(last, atom->tag[k]);
  MPI_Allreduce(MPI_IN_PLACE, &last, 1, MPI_INT, MPI_MAX, world);
  long made = 0;
  for (const gasgrain::NewParcel& parcel : list)
    if (make(parcel, ++last)) ++made;
  made = gasgrain::session().local.sum(made);
  if (made != static_cast<long>(list.size()))
    gasgrain::stop_everything_from_here(fmt::format(
        "fix parcels/inject {}: {} of {} new parcels are outside of the box at step {}: "
        "move the opening inwards, or turn its direction.",
        id, static_cast<long>(list.size()) - made, list.size(), update->ntimestep));
  atom->natoms += made;
  if (atom->map_style == 0) return;
  atom->nghost = 0;
  atom->map_init();
  atom->map_set();
}

// True on the rank in whose part of the box it is.
bool FixParcelsInject::make(const gasgrain::NewParcel& parcel, int number) {
  double x[3];
  for (int d = 0; d < 3; ++d) {
    x[d] = parcel.position[d];
    const double length = domain->boxhi[d] - domain->boxlo[d];
    if (domain->periodicity[d] != 0)
      x[d] -= length * std::floor((x[d] - domain->boxlo[d]) / length);
    if (!(x[d] >= domain->sublo[d] && x[d] < domain->subhi[d])) return false;
  }
  atom->avec->create_atom(parcel.type, x);
  const int k = atom->nlocal - 1;
  atom->tag[k] = number;
  atom->mask[k] = 1 | groupbit;
  for (int d = 0; d < 3; ++d) {
    atom->v[k][d] = parcel.velocity[d];
    atom->omega[k][d] = 0.0;
  }
  atom->radius[k] = parcel.radius;
  for (int n = 0; n < modify->nfix; ++n)
    if (modify->fix[n]->create_attribute != 0) modify->fix[n]->set_arrays(k);
  parcels_->admit(k, parcel);
  if (exchange_ != nullptr) exchange_->admit(k, parcel.film_mass);
  return true;
}

void FixParcelsInject::write_restart(FILE* file) {
  if (comm->me != 0) return;
  std::vector<double> state = injector_->state();
  state.push_back(static_cast<double>(done_to_));
  const int bytes = static_cast<int>(state.size() * sizeof(double));
  fwrite(&bytes, sizeof(int), 1, file);
  fwrite(state.data(), sizeof(double), state.size(), file);
}

void FixParcelsInject::restart(char* data) {
  std::vector<double> state(injector_->state().size() + 1);
  std::memcpy(state.data(), data, state.size() * sizeof(double));
  done_to_ = static_cast<bigint>(state.back());
  state.pop_back();
  injector_->set_state(state);
}

double FixParcelsInject::compute_vector(int n) {
  const gasgrain::InjectionAccount& account = injector_->account();
  switch (n) {
    case 0:
      return account.flow;
    case 1:
      return injector_->carried(static_cast<double>(done_to_) * update->dt);
    case 2:
      return account.solids;
    case 3:
      return account.particles;
    case 4:
      return account.parcels;
    default:
      return n - 5 < static_cast<int>(account.species.size())
                 ? account.species[static_cast<std::size_t>(n - 5)]
                 : 0.0;
  }
}

}  // namespace LAMMPS_NS
