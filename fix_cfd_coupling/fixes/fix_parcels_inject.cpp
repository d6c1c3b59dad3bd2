#include "fix_cfd_coupling/fixes/fix_parcels_inject.h"

#include <cstring>
#include <string>

#include "coupling/base/error.h"
#include "fix_cfd_coupling/fixes/fix_collisional_exchange.h"
#include "fix_cfd_coupling/fixes/fix_parcels.h"
#include "fix_cfd_coupling/fixes/host_error.h"
#include "fix_cfd_coupling/fixes/host_session.h"
// --
#include "atom.h"
#include "atom_vec.h"
#include "comm.h"
#include "domain.h"
#include "modify.h"
#include "update.h"

namespace LAMMPS_NS {

FixParcelsInject::FixParcelsInject(LAMMPS* host, int narg, char** arg) : HostFix(host, narg, arg) {
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
    for (int d = 0; d < 3; ++d) {
      box_.lo[d] = domain->boxlo[d];
      box_.hi[d] = domain->boxhi[d];
      box_.periodic[d] = domain->periodicity[d] != 0;
    }
    injector_ = std::make_unique<gasgrain::Injector>(settings_, box_);
  } catch (const gasgrain::Error& e) {
    gasgrain::stop_everything(e.what());
  }
  vector_flag = 1;
  size_vector = 5 + static_cast<int>(species_);
  global_freq = 1;
  extvector = 0;
  restart_global = 1;
}

int FixParcelsInject::mask() {
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
  if (done_to_ < 0) begin_at(static_cast<double>(update->ntimestep) * update->dt);
  if (done_to_ != update->ntimestep) {  // reset_timestep
    clock_time_ = now();
    done_to_ = clock_step_ = update->ntimestep;
  }
}

void FixParcelsInject::begin_at(double time) {
  done_to_ = clock_step_ = update->ntimestep;
  clock_time_ = begun_ = time;
  clock_dt_ = update->dt;
  if (begun_ <= settings_.from) return;
  settings_.from = std::min(begun_, settings_.to);
  injector_ = std::make_unique<gasgrain::Injector>(settings_, box_);
}

double FixParcelsInject::now() const {
  return clock_time_ + static_cast<double>(done_to_ - clock_step_) * clock_dt_;
}

void FixParcelsInject::follow_clock() {
  if (update->dt == clock_dt_) return;
  clock_time_ = now();
  clock_step_ = done_to_;
  clock_dt_ = update->dt;
}

// Called at every step of a run, before the host hands parcels to their ranks.
void FixParcelsInject::pre_exchange() {
  follow_clock();
  const double time = now();
  done_to_ = update->ntimestep;
  const std::vector<gasgrain::NewParcel> list = injector_->due(time, now() - time);
  if (list.empty()) return;
  int last = 0;
  for (int k = 0; k < atom->nlocal; ++k) last = std::max(last, atom->tag[k]);
  MPI_Allreduce(MPI_IN_PLACE, &last, 1, MPI_INT, MPI_MAX, world);
  long made = 0;
  for (const gasgrain::NewParcel& parcel : list)
    if (make(parcel, ++last)) ++made;
  made = gasgrain::session().local.sum(made);
  if (made != static_cast<long>(list.size()))
    gasgrain::stop_everything(fmt::format(
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
  for (const double number : {static_cast<double>(done_to_), begun_, clock_time_,
                              static_cast<double>(clock_step_), clock_dt_})
    state.push_back(number);
  state.insert(state.begin(), static_cast<double>(state.size()));
  const int bytes = static_cast<int>(state.size() * sizeof(double));
  fwrite(&bytes, sizeof(int), 1, file);
  fwrite(state.data(), sizeof(double), state.size(), file);
}

void FixParcelsInject::restart(char* data) {
  double count;
  std::memcpy(&count, data, sizeof(count));
  std::vector<double> state(static_cast<std::size_t>(count));
  std::memcpy(state.data(), data + sizeof(count), state.size() * sizeof(double));
  const auto take = [&] {
    const double number = state.back();
    state.pop_back();
    return number;
  };
  const double dt = take();
  const auto step = static_cast<bigint>(take());
  const double time = take();
  begin_at(take());
  clock_dt_ = dt;
  clock_step_ = step;
  clock_time_ = time;
  done_to_ = static_cast<bigint>(take());
  try {
    injector_->set_state(state);
  } catch (const gasgrain::Error& e) {
    gasgrain::stop_everything(e.what());
  }
}

double FixParcelsInject::compute_vector(int n) {
  const gasgrain::InjectionAccount& account = injector_->account();
  switch (n) {
    case 0:
      return account.flow;
    case 1:
      return injector_->carried(now());
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
