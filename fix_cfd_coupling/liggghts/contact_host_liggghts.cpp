#include "fix_cfd_coupling/liggghts/contact_host_liggghts.h"

#include <cstring>
#include <utility>

#include "fix_cfd_coupling/fixes/fix_liquid.h"
#include "fix_cfd_coupling/fixes/host_error.h"
#include "fix_cfd_coupling/liggghts/pair_gran_bridge.h"
// The host's headers lean on each other's order.
#include "lammps.h"
// --
#include "atom.h"
#include "comm.h"
#include "contact_interface.h"
#include "error.h"
#include "fix_property_atom.h"
#include "fix_property_global.h"
#include "fix_wall_gran.h"
#include "force.h"
#include "modify.h"
#include "neighbor.h"
#include "pair_gran.h"
#include "update.h"

namespace gasgrain {

// A property's name is private to its fix; an explicit instantiation may name it.
struct PropertyNameTag {
  using Type = char* LAMMPS_NS::FixPropertyGlobal::*;
  friend Type property_member(PropertyNameTag);
};
template <class Tag, typename Tag::Type member>
struct RevealProperty {
  friend typename Tag::Type property_member(Tag) { return member; }
};
template struct RevealProperty<PropertyNameTag, &LAMMPS_NS::FixPropertyGlobal::variablename>;

namespace {

LAMMPS_NS::FixPropertyGlobal* find(LAMMPS_NS::LAMMPS& host, const char* name, const char* kind,
                                   int rows, int columns) {
  return static_cast<LAMMPS_NS::FixPropertyGlobal*>(host.modify->find_fix_property(
      name, "property/global", kind, rows, columns, "contact model", false));
}

LAMMPS_NS::FixPropertyAtom* find_of_grains(LAMMPS_NS::LAMMPS& host, const char* name) {
  return static_cast<LAMMPS_NS::FixPropertyAtom*>(host.modify->find_fix_property(
      name, "property/atom", "scalar", 0, 0, "contact model", false));
}

constexpr const char* charge_of_style = "q";

}  // namespace

ContactHostLiggghts::ContactHostLiggghts(LAMMPS_NS::LAMMPS& host,
                                         LIGGGHTS::IContactHistorySetup& place, std::string law)
    : ContactHost(std::move(law)),
      host_(host),
      place_(place),
      wall_(dynamic_cast<LAMMPS_NS::FixWallGran*>(&place)) {}

int ContactHostLiggghts::types() const {
  return host_.atom->ntypes;
}

std::optional<contact::PairTable<double>> ContactHostLiggghts::pairs(const char* name) const {
  if (frictionless_ && std::strcmp(name, contact::properties::friction.name) == 0)
    return contact::PairTable<double>(types());
  auto* fix = find(host_, name, "peratomtypepair", types(), types());
  if (fix == nullptr) return std::nullopt;
  contact::PairTable<double> table(types());
  for (int i = 1; i <= types(); ++i)
    for (int j = 1; j <= types(); ++j) table(i, j) = fix->compute_array(i - 1, j - 1);
  return table;
}

std::optional<std::vector<double>> ContactHostLiggghts::per_type(const char* name) const {
  auto* fix = find(host_, name, "peratomtype", types(), 0);
  if (fix == nullptr) return std::nullopt;
  std::vector<double> values(types() + 1);
  for (int i = 1; i <= types(); ++i) values[i] = fix->compute_vector(i - 1);
  return values;
}

std::optional<double> ContactHostLiggghts::scalar(const char* name) const {
  auto* fix = find(host_, name, "scalar", 0, 0);
  if (fix == nullptr) return std::nullopt;
  return fix->compute_scalar();
}

std::vector<std::string> ContactHostLiggghts::property_names() const {
  std::vector<std::string> names;
  for (int n = 0; n < host_.modify->nfix; ++n) {
    LAMMPS_NS::Fix* fix = host_.modify->fix[n];
    if (std::strcmp(fix->style, "property/global") == 0)
      names.emplace_back(
          static_cast<LAMMPS_NS::FixPropertyGlobal*>(fix)->*property_member(PropertyNameTag{}));
  }
  return names;
}

bool ContactHostLiggghts::has_own_loop() const {
  return dynamic_cast<LAMMPS_NS::PairGranBridge*>(&place_) != nullptr;
}

std::string ContactHostLiggghts::wall_id() const {
  return wall_ != nullptr ? wall_->id : "";
}

bool ContactHostLiggghts::normal_model_is(const char* name) const {
  if (wall_ != nullptr) return wall_->contact_match("normal", name);
  return dynamic_cast<LAMMPS_NS::PairGran&>(place_).contact_match("normal", name);
}

double ContactHostLiggghts::smallest_radius() const {
  return host_.force->registry.min_radius();
}
double ContactHostLiggghts::largest_radius() const {
  return host_.force->registry.max_radius();
}
int ContactHostLiggghts::grains() const {
  return host_.atom->nlocal;
}
const double* ContactHostLiggghts::radii() const {
  return host_.atom->radius;
}
const int* const* ContactHostLiggghts::numbers() const {
  return &host_.atom->tag;
}

contact::GrainScalar ContactHostLiggghts::grain_scalar(const char* name) const {
  if (auto* fix = find_of_grains(host_, name)) return {&fix->vector_atom, fix->comm_forward != 0};
  if (std::strcmp(name, charge_of_style) == 0 && host_.atom->q_flag != 0)
    return {&host_.atom->q, true};
  return {};
}

contact::GrainScalarLines ContactHostLiggghts::grain_scalar_lines(const char* name) const {
  const std::string line =
      fmt::format("'fix ID all property/atom {} scalar yes yes no VALUE'", name);
  const bool is_temperature = std::strcmp(name, "Temp") == 0;
  return {(is_temperature ? "'fix heat/gran' or " : "") + line,
          fmt::format("'set group ID property/atom {} VALUE'", name),
          "Write its second word yes: " + line};
}

// The host sends a property/atom to the ghosts only when told to.
void ContactHostLiggghts::send_to_ghosts(const contact::GrainScalar& scalar) {
  for (int n = 0; n < host_.modify->nfix; ++n) {
    auto* fix = dynamic_cast<LAMMPS_NS::FixPropertyAtom*>(host_.modify->fix[n]);
    if (fix != nullptr && scalar.values == &fix->vector_atom) fix->do_forward_comm();
  }
}

std::int64_t ContactHostLiggghts::step() const {
  return host_.update->ntimestep;
}
double ContactHostLiggghts::timestep() const {
  return host_.update->dt;
}
MPI_Comm ContactHostLiggghts::communicator() const {
  return host_.world;
}
liquid::SceneLiquid& ContactHostLiggghts::liquid() {
  return LAMMPS_NS::FixLiquid::of_scene(&host_);
}

// The host's factor is of the sum of the radii of two grains, and of one radius at a wall. Of a
// primitive wall it sees what is within the skin when the neighbour lists are made, from which
// grains may move by half of it.
void ContactHostLiggghts::reach(double gap_of_smallest, double greatest) {
  constexpr double round_off = 1e-9;
  const double radius = smallest_radius();
  LAMMPS_NS::Neighbor& neighbor = *host_.neighbor;
  neighbor.register_contact_dist_factor(1.0 + (1.0 + round_off) * gap_of_smallest /
                                                  (wall_ != nullptr ? radius : 2.0 * radius));
  if (wall_ != nullptr && !wall_->is_mesh_wall() && greatest > 0.5 * neighbor.skin)
    refuse(fmt::format(
        "the force reaches over gaps of {:.3g} m, but a primitive wall sees grains within half "
        "of the skin only, {:.3g} m. Write 'neighbor {:.3g} bin', or make the reach shorter.",
        greatest, 0.5 * neighbor.skin, 2.001 * greatest));
}

void ContactHostLiggghts::refuse_coarse_grains() const {
  if (host_.force->cg_active()) host_.error->cg(FLERR, law().c_str());
}

void ContactHostLiggghts::refuse_unfit_run() const {
  refuse_coarse_grains();
  if (std::strcmp(host_.update->unit_style, "si") != 0)
    refuse(fmt::format("it works in SI, but the script has 'units {}'. Write 'units si'.",
                       host_.update->unit_style));
}

void ContactHostLiggghts::warn(const std::string& text) const {
  if (host_.comm->me == 0) warn_from_here(text);
}
void ContactHostLiggghts::warn_from_here(const std::string& text) const {
  host_.error->warning(FLERR, text.c_str());
}
void ContactHostLiggghts::end_launch(const std::string& message) const {
  stop_everything(message);
}

}  // namespace gasgrain
