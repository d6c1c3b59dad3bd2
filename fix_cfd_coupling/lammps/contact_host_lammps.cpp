#include "fix_cfd_coupling/lammps/contact_host_lammps.h"

#include <algorithm>
#include <cstring>
#include <limits>

#include "fix_cfd_coupling/dem_physics/liquid/scene_liquid.h"
#include "fix_cfd_coupling/fixes/host_error.h"
#include "fix_cfd_coupling/lammps/fix_property_global.h"
#include "fix_cfd_coupling/lammps/pair_gran_bridge.h"
#include "lammps.h"
// --
#include "atom.h"
#include "comm.h"
#include "error.h"
#include "fix.h"
#include "modify.h"
#include "update.h"

namespace gasgrain {

using LAMMPS_NS::FixPropertyGlobal;

int LammpsContactHost::types() const {
  return owner_.host->atom->ntypes;
}

std::optional<contact::PairTable<double>> LammpsContactHost::pairs(const char* name) const {
  contact::PairTable<double> table(types());
  const auto given = owner_.properties->find(name);
  const FixPropertyGlobal* fix =
      FixPropertyGlobal::find(owner_.host, name, FixPropertyGlobal::Kind::pairs,
                              static_cast<std::size_t>(types()) * types());
  if (given == owner_.properties->end() && fix == nullptr) return std::nullopt;
  for (int i = 1; i <= types(); ++i)
    for (int j = 1; j <= types(); ++j)
      table(i, j) = given != owner_.properties->end() ? given->second
                                                      : fix->values()[(i - 1) * types() + j - 1];
  return table;
}

std::optional<std::vector<double>> LammpsContactHost::per_type(const char* name) const {
  const FixPropertyGlobal* fix = FixPropertyGlobal::find(
      owner_.host, name, FixPropertyGlobal::Kind::per_type, static_cast<std::size_t>(types()));
  if (fix == nullptr) return std::nullopt;
  std::vector<double> values(1, 0.0);  // types count from 1
  values.insert(values.end(), fix->values().begin(), fix->values().end());
  return values;
}

std::optional<double> LammpsContactHost::scalar(const char* name) const {
  const FixPropertyGlobal* fix =
      FixPropertyGlobal::find(owner_.host, name, FixPropertyGlobal::Kind::scalar, 1);
  if (fix == nullptr) return std::nullopt;
  return fix->values()[0];
}

std::vector<std::string> LammpsContactHost::property_names() const {
  return FixPropertyGlobal::names(owner_.host);
}

double LammpsContactHost::smallest_radius() const {
  double least = std::numeric_limits<double>::infinity();
  for (int k = 0; k < grains(); ++k) least = std::min(least, radii()[k]);
  MPI_Allreduce(MPI_IN_PLACE, &least, 1, MPI_DOUBLE, MPI_MIN, communicator());
  if (!(least < std::numeric_limits<double>::infinity()))
    refuse(
        "it needs the radius of the smallest grain, and there are no grains yet. Make some "
        "before the first run.");
  return least;
}

double LammpsContactHost::largest_radius() const {
  double most = 0.0;
  for (int k = 0; k < grains(); ++k) most = std::max(most, radii()[k]);
  MPI_Allreduce(MPI_IN_PLACE, &most, 1, MPI_DOUBLE, MPI_MAX, communicator());
  return most;
}

int LammpsContactHost::grains() const {
  return owner_.host->atom->nlocal;
}
const double* LammpsContactHost::radii() const {
  return owner_.host->atom->radius;
}
const int* const* LammpsContactHost::numbers() const {
  return &owner_.host->atom->tag;
}

contact::GrainScalar LammpsContactHost::grain_scalar(const char* name) const {
  LAMMPS_NS::Atom* atom = owner_.host->atom;
  if (std::strcmp(name, "q") == 0) {
    if (atom->q_flag == 0) return {};
    return {&atom->q, true};
  }
  int is_double = 0, columns = 0;
  const int at = atom->find_custom(name, is_double, columns);
  if (at < 0 || is_double == 0 || columns != 0) return {};
  return {&atom->dvector[at], true};
}

contact::GrainScalarLines LammpsContactHost::grain_scalar_lines(const char* name) const {
  if (std::strcmp(name, "q") == 0)
    return {"'fix ID all property/atom q ghost yes'", "'set group ID charge VALUE'",
            "add 'ghost yes' to its line"};
  return {fmt::format("'fix ID all property/atom d_{} ghost yes' and 'set group all d_{} VALUE'",
                      name, name),
          fmt::format("'set group ID d_{} VALUE'", name), "add 'ghost yes' to its line"};
}

void LammpsContactHost::send_to_ghosts(const contact::GrainScalar& scalar) {
  if (owner_.pair != nullptr) owner_.pair->send_to_ghosts(const_cast<double*>(*scalar.values));
}

std::int64_t LammpsContactHost::step() const {
  return owner_.host->update->ntimestep;
}
double LammpsContactHost::timestep() const {
  return owner_.host->update->dt;
}
MPI_Comm LammpsContactHost::communicator() const {
  return owner_.host->world;
}

liquid::SceneLiquid& LammpsContactHost::liquid() {
  for (int n = 0; n < owner_.host->modify->nfix; ++n)
    if (auto* found = dynamic_cast<liquid::SceneLiquid*>(owner_.host->modify->fix[n]))
      return *found;
  refuse(
      "it has no liquid: add a line before the first run, for instance\n"
      "  fix liquid all liquid content 0.01 surface_tension 0.0728 contact_angle 0.35");
}

void LammpsContactHost::reach(double gap_of_smallest, double greatest) {
  contact::Reach& reach = *owner_.reach;
  constexpr double round_off = 1e-9;
  reach.gap =
      std::max({reach.gap, gap_of_smallest * (1.0 + round_off), greatest * (1.0 + round_off)});
}

void LammpsContactHost::refuse_unfit_run() const {
  if (std::strcmp(owner_.host->update->unit_style, "si") != 0)
    refuse(fmt::format("it works in SI, but the script has 'units {}'. Write 'units si'.",
                       owner_.host->update->unit_style));
}

void LammpsContactHost::warn(const std::string& text) const {
  if (owner_.host->comm->me == 0) owner_.host->error->warning(FLERR, text);
}
void LammpsContactHost::warn_from_here(const std::string& text) const {
  owner_.host->error->warning(FLERR, text);
}

void LammpsContactHost::end_launch(const std::string& message) const {
  stop_everything(message);
}

}  // namespace gasgrain
