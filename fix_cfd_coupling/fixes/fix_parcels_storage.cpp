// How what fix parcels knows of an atom moves with it, between ranks and through restarts, and the
// balance of masses. Particles a parcel are a property of the host's.
#include <algorithm>
#include <cmath>
#include <cstring>

#include "fix_cfd_coupling/fixes/fix_parcels.h"
#include "fix_cfd_coupling/fixes/host_error.h"
#include "fix_cfd_coupling/fixes/host_session.h"
// --
#include "atom.h"
#include "comm.h"
#include "update.h"

namespace LAMMPS_NS {

namespace {

constexpr int stored_format = 2;  // raised with every change of what is stored
constexpr int record_size = 3;

struct StoredState {
  int format;
  double came[2];
  double gone[2];
};

}  // namespace

void FixParcels::grow_arrays(int size) {
  solid_mass_.resize(static_cast<std::size_t>(size));
  solid_volume_.resize(static_cast<std::size_t>(size));
  known_mass_.resize(static_cast<std::size_t>(size));
  exchanges(record_size);
}

void FixParcels::copy_arrays(int from, int to, int) {
  solid_mass_[static_cast<std::size_t>(to)] = solid_mass_[static_cast<std::size_t>(from)];
  solid_volume_[static_cast<std::size_t>(to)] = solid_volume_[static_cast<std::size_t>(from)];
  known_mass_[static_cast<std::size_t>(to)] = known_mass_[static_cast<std::size_t>(from)];
}

void FixParcels::set_arrays(int parcel) {
  solid_mass_[static_cast<std::size_t>(parcel)] = 0.0;
  solid_volume_[static_cast<std::size_t>(parcel)] = 0.0;
  size_.begin_grain(parcel);
}

int FixParcels::pack_exchange(int parcel, double* buffer) {
  buffer[0] = solid_mass_[static_cast<std::size_t>(parcel)];
  buffer[1] = solid_volume_[static_cast<std::size_t>(parcel)];
  buffer[2] = known_mass_[static_cast<std::size_t>(parcel)];
  return record_size;
}

int FixParcels::unpack_exchange(int parcel, double* buffer) {
  solid_mass_[static_cast<std::size_t>(parcel)] = buffer[0];
  solid_volume_[static_cast<std::size_t>(parcel)] = buffer[1];
  known_mass_[static_cast<std::size_t>(parcel)] = buffer[2];
  return record_size;
}

int FixParcels::size_restart(int) {
  return 1 + record_size;
}

int FixParcels::maxsize_restart() {
  return 1 + record_size;
}

// The host keeps the length of a fix's share in front of it.
int FixParcels::pack_restart(int parcel, double* buffer) {
  buffer[0] = size_restart(parcel);
  pack_exchange(parcel, buffer + 1);
  return size_restart(parcel);
}

void FixParcels::unpack_restart(int parcel, int nth) {
  double* share = atom->extra[parcel];
  for (int n = 0; n < nth; ++n) share += static_cast<int>(share[0]);
  unpack_exchange(parcel, share + 1);
}

void FixParcels::write_restart(FILE* file) {
  const Stock stock = take_stock();
  if (comm->me != 0) return;
  const StoredState state{stored_format,
                          {stock.came.solids, stock.came.liquid},
                          {stock.gone.solids, stock.gone.liquid}};
  const int bytes = sizeof(state);
  fwrite(&bytes, sizeof(int), 1, file);
  fwrite(&state, sizeof(state), 1, file);
}

void FixParcels::restart(char* data) {
  StoredState state;
  std::memcpy(&state, data, sizeof(state));
  if (state.format != stored_format)
    gasgrain::stop_everything(
        "the restart's fix parcels is of another version of gasgrain: start the run anew.");
  if (comm->me != 0) return;
  came_ += {state.came[0], state.came[1]};
  gone_ += {state.gone[0], state.gone[1]};
}

FixParcels::Masses FixParcels::masses_of(int k) const {
  const double core = solid_mass_[static_cast<std::size_t>(k)];
  if (core == 0.0) return {};
  const double size = size_[k];
  return {size * core, size * (atom->rmass[k] - core)};
}

FixParcels::Stock FixParcels::take_stock() const {
  Account held;
  gasgrain::ExactSum particles;
  for (int k = 0; k < atom->nlocal; ++k) {
    held += masses_of(k);
    particles += size_[k];
  }
  const Masses h = held.value(), c = came_.value(), g = gone_.value();
  double all[8] = {static_cast<double>(atom->nlocal),
                   particles.value(),
                   h.solids,
                   h.liquid,
                   c.solids,
                   c.liquid,
                   g.solids,
                   g.liquid};
  MPI_Allreduce(MPI_IN_PLACE, all, 8, MPI_DOUBLE, MPI_SUM, world);
  return {all[0], all[1], {all[2], all[3]}, {all[4], all[5]}, {all[6], all[7]}};
}

double FixParcels::Stock::residual() const {
  const auto of = [](double in, double out, double there) {
    const double whole = std::max({in, out, there});
    return whole > 0.0 ? std::abs(in - out - there) / whole : 0.0;
  };
  return std::max(of(came.solids, gone.solids, held.solids),
                  of(came.liquid, gone.liquid, held.liquid));
}

void FixParcels::show() {
  if (shown_at_ == update->ntimestep) return;
  shown_at_ = update->ntimestep;
  const Stock stock = take_stock();
  const gasgrain::Vec3& lost = limits_.lost_momentum;
  double all[5] = {limited_now_, lost[0], lost[1], lost[2], limits_.damped_energy};
  MPI_Allreduce(MPI_IN_PLACE, all, 5, MPI_DOUBLE, MPI_SUM, world);
  const double fraction = gasgrain::session().local.max(fraction_now_) / settings_.close_packing;
  shown_ = {stock.parcels,
            stock.particles,
            stock.held.solids,
            stock.held.liquid,
            stock.came.solids,
            stock.came.liquid,
            stock.gone.solids,
            stock.gone.liquid,
            stock.residual(),
            fraction,
            all[0],
            all[1],
            all[2],
            all[3],
            all[4]};
}

// Asked for on all ranks.
double FixParcels::compute_vector(int n) {
  show();
  return shown_[static_cast<std::size_t>(n)];
}

double FixParcels::memory_usage() {
  return static_cast<double>(record_size * sizeof(double)) * atom->nmax;
}

}  // namespace LAMMPS_NS
