// How what fix collisional_exchange knows of an atom moves with it, between ranks and through
// restarts. The volume of a film is a property of the host's.
#include <algorithm>

#include "fix_cfd_coupling/fixes/fix_collisional_exchange.h"
#include "fix_cfd_coupling/fixes/host_error.h"
// --
#include "atom.h"
#include "memory.h"

namespace LAMMPS_NS {

void FixCollisionalExchange::grow_arrays(int size) {
  const auto atoms = static_cast<std::size_t>(size);
  mass_.resize(atoms * count_of_species());
  known_.resize(atoms);
  if (settings_.film_temperature) temperature_.resize(atoms, *settings_.film_temperature);
  exchanges(1 + size_peratom_cols);
  if (size_peratom_cols == 0) return;
  memory->grow(array_atom, size, size_peratom_cols, "collisional_exchange:array_atom");
  for (int k = grown_to_; k < size; ++k) std::fill_n(array_atom[k], size_peratom_cols, 0.0);
  grown_to_ = size;
}

void FixCollisionalExchange::copy_arrays(int from, int to, int) {
  std::vector<double> record(static_cast<std::size_t>(maxsize_restart()));
  pack_exchange(from, record.data());
  unpack_exchange(to, record.data());
}

void FixCollisionalExchange::set_arrays(int particle) {
  const auto n = static_cast<std::size_t>(particle);
  const std::size_t species = count_of_species();
  std::fill_n(mass_.begin() + static_cast<std::ptrdiff_t>(n * species), species, 0.0);
  known_[n] = 0.0;
  film_.begin_grain(particle);
  if (settings_.film_temperature) temperature_[n] = *settings_.film_temperature;
  show(particle);
}

int FixCollisionalExchange::pack_exchange(int particle, double* buffer) {
  const auto n = static_cast<std::size_t>(particle);
  double* at = buffer;
  for (std::size_t i = 0; i < count_of_species(); ++i) *at++ = mass_[n * count_of_species() + i];
  *at++ = known_[n];
  if (settings_.film_temperature) *at++ = temperature_[n];
  return static_cast<int>(at - buffer);
}

int FixCollisionalExchange::unpack_exchange(int particle, double* buffer) {
  const auto n = static_cast<std::size_t>(particle);
  const double* at = buffer;
  for (std::size_t i = 0; i < count_of_species(); ++i) mass_[n * count_of_species() + i] = *at++;
  known_[n] = *at++;
  if (settings_.film_temperature) temperature_[n] = *at++;
  show(particle);
  return static_cast<int>(at - buffer);
}

int FixCollisionalExchange::size_restart(int) {
  return 2 + size_peratom_cols;
}

int FixCollisionalExchange::maxsize_restart() {
  return size_restart(0);
}

// The host keeps the length of a fix's share in front of it.
int FixCollisionalExchange::pack_restart(int particle, double* buffer) {
  buffer[0] = size_restart(particle);
  pack_exchange(particle, buffer + 1);
  return size_restart(particle);
}

void FixCollisionalExchange::unpack_restart(int particle, int nth) {
  double* share = atom->extra[particle];
  for (int n = 0; n < nth; ++n) share += static_cast<int>(share[0]);
  if (static_cast<int>(share[0]) != size_restart(particle))
    gasgrain::stop_everything_from_here(
        "the restart's films are of other species than fix collisional_exchange names, or of films "
        "with temperatures where these have none (or the other way round): name the same.");
  unpack_exchange(particle, share + 1);
}

double FixCollisionalExchange::memory_usage() {
  return static_cast<double>(static_cast<std::size_t>(2 * size_peratom_cols + 3) * sizeof(double)) *
         atom->nmax;
}

}  // namespace LAMMPS_NS
