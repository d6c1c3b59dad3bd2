// Films on the grains of this rank and on its copies of others'.
#include "fix_cfd_coupling/fixes/fix_liquid.h"
// --
#include "atom.h"
#include "domain.h"

namespace LAMMPS_NS {

using gasgrain::Vec3;
using gasgrain::liquid::GrainFilms;

// Grains that the host has inserted get their film here, where their radius is known.
void FixLiquid::meet_new_grains() {
  for (int k = 0; k < atom->nlocal; ++k) {
    double& film = film_[k];
    if (film != unmet_) continue;
    film = settings_.film_at_first(atom->radius[k]);
    new_liquid_ += film;
    new_grains_ += 1.0;
  }
}

void FixLiquid::publish_films() {
  if (!wet_) return;
  for (int k = 0; k < atom->nlocal; ++k) {
    films_.publish(k, film_[k], atom->radius[k], atom->rmass[k]);
    number_[static_cast<std::size_t>(k)] = atom->tag[k];
    position_[static_cast<std::size_t>(k)] = Vec3(atom->x[k][0], atom->x[k][1], atom->x[k][2]);
  }
  send_to_ghosts();
}

void FixLiquid::pack_ghosts(int count, const int* list, double* buffer) {
  for (int n = 0; n < count; ++n) {
    const int k = list[n];
    const GrainFilms::Published& p = films_.published(k);
    *buffer++ = p.film;
    *buffer++ = p.thickness;
    *buffer++ = p.scale;
    *buffer++ = p.open;
    *buffer++ = p.bridges_over_mass;
    if (!periodic_) continue;
    for (int d = 0; d < 3; ++d) *buffer++ = position_[static_cast<std::size_t>(k)][d];
  }
}

void FixLiquid::unpack_ghosts(int count, int first, const double* buffer) {
  for (int k = first; k < first + count; ++k) {
    films_.published(k) = {buffer[0], buffer[1], buffer[2], buffer[3], buffer[4]};
    buffer += GrainFilms::Published::size;
    if (!periodic_) continue;
    position_[static_cast<std::size_t>(k)] = Vec3(buffer[0], buffer[1], buffer[2]);
    buffer += 3;
  }
}

Vec3 FixLiquid::between(int i, int k) const {
  Vec3 d = position_[static_cast<std::size_t>(i)] - position_[static_cast<std::size_t>(k)];
  domain->minimum_image(d[0], d[1], d[2]);
  return d;
}

}  // namespace LAMMPS_NS
