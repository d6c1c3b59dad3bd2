// How what fix liquid knows of a grain moves with it, between ranks and through restarts. The films
// themselves are a property of the host's, bridges between grains are in its contact history.
#include <algorithm>
#include <cstring>

#include "coupling/base/error.h"
#include "fix_cfd_coupling/fixes/fix_liquid.h"
#include "fix_cfd_coupling/fixes/host_error.h"
// --
#include "atom.h"
#include "comm.h"
#include "memory.h"

namespace LAMMPS_NS {

using gasgrain::liquid::GrainFilms;
using gasgrain::liquid::WallBridges;

namespace {

constexpr int stored_format = 1;  // raised with every change of what is stored
constexpr int grant_size = 4;     // with the grain's number
constexpr std::size_t id_length = 64;

struct StoredState {
  int format;
  int walls;
  double reach;
  double wall_reach;
  gasgrain::liquid::LiquidLedger ledger;
};
struct StoredWall {
  char id[id_length];
  gasgrain::liquid::WallFilm film;
};

}  // namespace

void FixLiquid::grow_arrays(int size) {
  const auto grains = static_cast<std::size_t>(size);
  films_.resize(grains);
  position_.resize(grains);
  number_.resize(grains);
  for (auto& wall : walls_) wall->resize(grains);
  exchanges(size_restart(0));
  const int before = grown_to_;
  memory->grow(array_atom, size, 2, "fix_liquid:array_atom");
  for (int k = before; k < size; ++k) array_atom[k][0] = array_atom[k][1] = 0.0;
  grown_to_ = size;
}

void FixLiquid::copy_arrays(int from, int to, int) {
  films_.grant(to) = films_.grant(from);
  number_[static_cast<std::size_t>(to)] = number_[static_cast<std::size_t>(from)];
  for (auto& wall : walls_) wall->slot(to) = wall->slot(from);
  std::copy_n(array_atom[from], 2, array_atom[to]);
}

void FixLiquid::set_arrays(int grain) {
  films_.grant(grain) = {};
  number_[static_cast<std::size_t>(grain)] = 0.0;
  film_.begin_grain(grain);
  for (auto& wall : walls_) wall->slot(grain) = {};
  array_atom[grain][0] = array_atom[grain][1] = 0.0;
}

int FixLiquid::pack_exchange(int grain, double* buffer) {
  double* at = buffer;
  const GrainFilms::Grant& grant = films_.grant(grain);
  *at++ = grant.scale;
  *at++ = grant.open;
  *at++ = grant.bridges;
  *at++ = number_[static_cast<std::size_t>(grain)];
  for (auto& wall : walls_) {
    std::memcpy(at, &wall->slot(grain), sizeof(WallBridges::Slot));
    at += WallBridges::slot_size;
  }
  return static_cast<int>(at - buffer);
}

int FixLiquid::unpack_exchange(int grain, double* buffer) {
  const double* at = buffer;
  films_.grant(grain) = {at[0], at[1], at[2]};
  number_[static_cast<std::size_t>(grain)] = at[3];
  at += grant_size;
  for (auto& wall : walls_) {
    std::memcpy(&wall->slot(grain), at, sizeof(WallBridges::Slot));
    at += WallBridges::slot_size;
  }
  array_atom[grain][0] = array_atom[grain][1] = 0.0;
  return static_cast<int>(at - buffer);
}

int FixLiquid::size_restart(int) {
  return 1 + grant_size + WallBridges::slot_size * static_cast<int>(walls_.size());
}

int FixLiquid::maxsize_restart() {
  return size_restart(0);
}

// The host keeps the length of a fix's share in front of it.
int FixLiquid::pack_restart(int grain, double* buffer) {
  buffer[0] = size_restart(grain);
  pack_exchange(grain, buffer + 1);
  return size_restart(grain);
}

void FixLiquid::unpack_restart(int grain, int nth) {
  double* share = atom->extra[grain];
  for (int n = 0; n < nth; ++n) share += static_cast<int>(share[0]);
  unpack_exchange(grain, share + 1);
}

// The list of contacts may be out of date here: what was counted is booked with the next step.
void FixLiquid::write_restart(FILE* file) {
  double counted[4] = {new_liquid_, gone_liquid_, new_grains_, gone_grains_};
  MPI_Allreduce(MPI_IN_PLACE, counted, 4, MPI_DOUBLE, MPI_SUM, world);
  gasgrain::liquid::LiquidLedger ledger = ledger_;
  ledger.came_in += counted[0];
  ledger.gone += counted[1];
  ledger.grains += counted[2] - counted[3];
  if (comm->me != 0) return;
  StoredState state{stored_format, static_cast<int>(walls_.size()), reach_, wall_reach_, ledger};
  const int bytes = static_cast<int>(sizeof(state) + walls_.size() * sizeof(StoredWall));
  fwrite(&bytes, sizeof(int), 1, file);
  fwrite(&state, sizeof(state), 1, file);
  for (const auto& wall : walls_) {
    StoredWall stored{};
    wall->id().copy(stored.id, id_length - 1);
    stored.film = wall->film();
    fwrite(&stored, sizeof(stored), 1, file);
  }
}

void FixLiquid::restart(char* data) {
  StoredState state;
  std::memcpy(&state, data, sizeof(state));
  if (state.format != stored_format)
    gasgrain::stop_everything(
        "the restart's fix liquid is of another version of gasgrain: start the run anew.");
  resumed_ = true;
  ledger_ = told_ = state.ledger;
  reach_ = state.reach;
  wall_reach_ = state.wall_reach;
  for (int w = 0; w < state.walls; ++w) {
    StoredWall stored;
    std::memcpy(&stored, data + sizeof(state) + static_cast<std::size_t>(w) * sizeof(stored),
                sizeof(stored));
    auto& wall = walls_.emplace_back(std::make_unique<WallBridges>(stored.id));
    wall->film() = stored.film;
    wall->resize(static_cast<std::size_t>(atom->nmax));
  }
}

double FixLiquid::memory_usage() {
  const double per_grain =
      sizeof(GrainFilms::Published) + sizeof(GrainFilms::Grant) + sizeof(GrainFilms::Tally) +
      sizeof(gasgrain::Vec3) + 2 * sizeof(double) +
      static_cast<double>(walls_.size()) * (sizeof(WallBridges::Slot) + 3 * sizeof(double));
  return per_grain * atom->nmax;
}

}  // namespace LAMMPS_NS
