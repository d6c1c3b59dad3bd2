#include "fix_cfd_coupling/liggghts/contact_limits.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <set>
#include <vector>

#include "fix_cfd_coupling/dem_physics/contact_step.h"
#include "fix_cfd_coupling/dem_physics/contact_time.h"
// --
#include "atom.h"
#include "domain.h"
#include "fix_gravity.h"
#include "fix_property_global.h"
#include "fix_wall_gran.h"
#include "force.h"
#include "modify.h"
#include "pair_gran.h"
#include "update.h"

namespace gasgrain {
namespace {

using namespace LAMMPS_NS;

constexpr double none = std::numeric_limits<double>::infinity();

// The script's material numbers; types count from 1.
class Materials {
 public:
  explicit Materials(LAMMPS& host) : modify_(*host.modify), types_(host.atom->ntypes) {}

  // Null when the script has none: the host then says so itself where it needs it.
  [[nodiscard]] FixPropertyGlobal* find(const char* name, const char* kind) const {
    const bool pair = std::strcmp(kind, "peratomtypepair") == 0;
    const bool scalar = std::strcmp(kind, "scalar") == 0;
    return static_cast<FixPropertyGlobal*>(
        modify_.find_fix_property(name, "property/global", kind, scalar ? 0 : types_,
                                  pair ? types_ : 0, "couple/gas", false));
  }

 private:
  Modify& modify_;
  int types_;
};

enum class NormalModel { hertz, hooke, hooke_stiffness, hertz_stiffness, unread };

NormalModel model_of(PairGran& pair) {
  if (pair.contact_match("normal", "hertz")) return NormalModel::hertz;
  if (pair.contact_match("normal", "hooke")) return NormalModel::hooke;
  if (pair.contact_match("normal", "hooke/stiffness")) return NormalModel::hooke_stiffness;
  if (pair.contact_match("normal", "hertz/stiffness")) return NormalModel::hertz_stiffness;
  return NormalModel::unread;
}

const char* name_of(NormalModel model) {
  switch (model) {
    case NormalModel::hertz:
      return "hertz";
    case NormalModel::hooke:
      return "hooke";
    case NormalModel::hooke_stiffness:
      return "hooke/stiffness";
    default:
      return "hertz/stiffness";
  }
}

// A grain, or a wall.
struct Body {
  int type = 0;
  double radius = none;  // [m]
  double mass = none;    // [kg]
  bool single = false;   // the only grain of its type

  [[nodiscard]] bool is_wall() const { return mass == none; }
};

double combined(double a, double b) {
  return b == none ? a : contact::effective(a, b);
}

struct Collision {
  double duration = none;  // [s]
  Body a, b;
  std::string stiffness;  // as the script writes it
};

class ContactReader {
 public:
  ContactReader(LAMMPS& host, NormalModel model, double speed)
      : model_(model), speed_(speed), materials_(host) {
    const char* pairs = "peratomtypepair";
    if (model == NormalModel::hertz || model == NormalModel::hooke) {
      youngs_ = materials_.find("youngsModulus", "peratomtype");
      poisson_ = materials_.find("poissonsRatio", "peratomtype");
      restitution_ = materials_.find("coefficientRestitution", pairs);
      velocity_ = materials_.find("characteristicVelocity", "scalar");
    } else {
      kn_ = materials_.find("kn", pairs);
    }
  }

  // Whether all that the model needs is there.
  [[nodiscard]] bool complete() const {
    if (model_ == NormalModel::hertz || model_ == NormalModel::hooke)
      return youngs_ != nullptr && poisson_ != nullptr &&
             (model_ == NormalModel::hertz || velocity_ != nullptr);
    return kn_ != nullptr;
  }

  [[nodiscard]] Collision collide(const Body& a, const Body& b) const {
    const double mass = combined(a.mass, b.mass);
    const double radius = combined(a.radius, b.radius);
    // `hooke` with the word viscous has no such table; undamped is the shorter contact.
    const double e =
        restitution_ != nullptr ? restitution_->compute_array(a.type - 1, b.type - 1) : 1.0;
    Collision met{none, a, b, ""};
    if (kn_ != nullptr) {
      const double kn = kn_->compute_array(a.type - 1, b.type - 1);
      met.stiffness = fmt::format("kn {:g}", kn);
      met.duration = model_ == NormalModel::hooke_stiffness
                         ? contact::linear_duration(kn, mass)
                         : contact::hertz_duration(kn * std::sqrt(radius), mass, speed_);
      return met;
    }
    const double youngs_a = youngs_->compute_vector(a.type - 1);
    const double youngs_b = youngs_->compute_vector(b.type - 1);
    const double modulus =
        contact::effective_modulus(youngs_a, poisson_->compute_vector(a.type - 1), youngs_b,
                                   poisson_->compute_vector(b.type - 1));
    met.stiffness = fmt::format("youngsModulus {:g} Pa", std::max(youngs_a, youngs_b));
    if (model_ == NormalModel::hertz) {
      met.duration =
          contact::hertz_duration(contact::hertz_stiffness(modulus, radius), mass, speed_, e);
    } else {
      const double v = velocity_->compute_scalar();
      met.stiffness += fmt::format(", characteristicVelocity {:g} m/s", v);
      met.duration =
          contact::linear_duration(contact::hooke_stiffness(modulus, radius, mass, v), mass, e);
    }
    return met;
  }

 private:
  NormalModel model_;
  double speed_;
  Materials materials_;
  FixPropertyGlobal* youngs_ = nullptr;
  FixPropertyGlobal* poisson_ = nullptr;
  FixPropertyGlobal* restitution_ = nullptr;
  FixPropertyGlobal* velocity_ = nullptr;
  FixPropertyGlobal* kn_ = nullptr;
};

// The smallest grain of each type on all ranks; types without grains are left out.
std::vector<Body> smallest_grains(LAMMPS& host, const Communicator& local) {
  const Atom& atom = *host.atom;
  std::vector<double> smallest(2 * static_cast<std::size_t>(atom.ntypes), none);
  for (int i = 0; i < atom.nlocal; ++i) {
    const auto t = 2 * static_cast<std::size_t>(atom.type[i] - 1);
    smallest[t] = std::min(smallest[t], atom.radius[i]);
    smallest[t + 1] = std::min(smallest[t + 1], atom.rmass[i]);
  }
  MPI_Allreduce(MPI_IN_PLACE, smallest.data(), static_cast<int>(smallest.size()), MPI_DOUBLE,
                MPI_MIN, local.handle());
  std::vector<double> counts(atom.ntypes, 0.0);
  for (int i = 0; i < atom.nlocal; ++i) counts[atom.type[i] - 1] += 1.0;
  local.sum_in_place(counts);
  std::vector<Body> grains;
  for (int t = 0; t < atom.ntypes; ++t)
    if (counts[t] > 0.0)
      grains.push_back({t + 1, smallest[2 * t], smallest[2 * t + 1], counts[t] == 1.0});
  return grains;
}

std::vector<Body> walls(LAMMPS& host) {
  std::set<int> types;
  for (int n = 0; n < host.modify->nfix; ++n) {
    if (std::strcmp(host.modify->fix[n]->style, "wall/gran") != 0) continue;
    const auto& wall = *static_cast<FixWallGran*>(host.modify->fix[n]);
    if (!wall.is_mesh_wall()) types.insert(wall.atom_type_wall());
    for (int m = 0; wall.is_mesh_wall() && m < wall.n_meshes(); ++m)
      types.insert(wall.mesh_list()[m]->atomTypeWall());
  }
  std::vector<Body> bodies;
  for (const int type : types)
    if (type >= 1 && type <= host.atom->ntypes) bodies.push_back({type, none, none, false});
  return bodies;
}

// A bed without an integrator stays as it is, whatever its contacts.
bool grains_move(LAMMPS& host) {
  for (int n = 0; n < host.modify->nfix; ++n)
    if (host.modify->fix[n]->time_integrate != 0) return true;
  return false;
}

// Of a free fall through the box, and of the fastest grain [m/s].
double expected_speed(LAMMPS& host, const Communicator& local) {
  const Atom& atom = *host.atom;
  double square = 0.0;
  for (int i = 0; i < atom.nlocal; ++i) {
    const double* v = atom.v[i];
    square = std::max(square, v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
  }
  square = local.max(square);
  for (int n = 0; n < host.modify->nfix; ++n) {
    if (std::strcmp(host.modify->fix[n]->style, "gravity") != 0) continue;
    double g[3];
    static_cast<FixGravity*>(host.modify->fix[n])->get_gravity(g);
    double fall = 0.0;
    for (int d = 0; d < 3; ++d)
      fall += 2.0 * std::abs(g[d]) * (host.domain->boxhi[d] - host.domain->boxlo[d]);
    square = std::max(square, fall);
  }
  constexpr double where_nothing_moves = 1.0;  // [m/s]
  return square > 0.0 ? std::sqrt(square) : where_nothing_moves;
}

std::string text_of(const Collision& met, NormalModel model, double speed) {
  const auto grain = [](const Body& b) {
    return fmt::format("of type {} (the smallest, {:.3g} m across)", b.type, 2.0 * b.radius);
  };
  std::string bodies = "two grains " + grain(met.a);
  if (met.b.is_wall())
    bodies = fmt::format("a grain {} and a wall of type {}", grain(met.a), met.b.type);
  else if (met.b.type != met.a.type)
    bodies = fmt::format("a grain {} and one {}", grain(met.a), grain(met.b));
  const bool with_speed = model == NormalModel::hertz || model == NormalModel::hertz_stiffness;
  return fmt::format("{} touch for {:.3g} s ({}, {}{})", bodies, met.duration, name_of(model),
                     met.stiffness, with_speed ? fmt::format(", {:.2g} m/s", speed) : "");
}

}  // namespace

ContactVerdict judge_contacts(LAMMPS& host, const Communicator& local) {
  ContactVerdict verdict;
  const std::vector<Body> grains = smallest_grains(host, local);
  verdict.had_grains = !grains.empty();
  if (grains.empty() || host.force->pair == nullptr || !grains_move(host)) return verdict;
  auto* pair = static_cast<PairGran*>(host.force->pair_match("gran", 0));
  const NormalModel model = pair == nullptr ? NormalModel::unread : model_of(*pair);
  const double speed = expected_speed(host, local);
  const ContactReader reader(host, model, speed);
  if (model == NormalModel::unread || !reader.complete()) {
    verdict.warning = fmt::format(
        "the contact model of 'pair_style {} ...' is not among those whose contact duration is "
        "known here (gran model hertz, hooke, hooke/stiffness, hertz/stiffness): nobody checks "
        "that 'timestep {:g}' is short enough for it.",
        host.force->pair_style, host.update->dt);
    return verdict;
  }
  std::vector<Body> partners = grains;
  for (const Body& wall : walls(host)) partners.push_back(wall);
  Collision shortest;
  for (const Body& a : grains)
    for (const Body& b : partners)
      if (const Collision met = reader.collide(a, b);
          met.duration < shortest.duration && !(a.single && !b.is_wall() && a.type == b.type))
        shortest = met;

  if (shortest.duration == none) return verdict;  // a grain alone

  const double dt = host.update->dt;
  const double share = dt / shortest.duration;
  if (share <= contact::resolved_share) return verdict;
  const std::string known =
      fmt::format("{}; that is {:.2g} steps", text_of(shortest, model, speed), 1.0 / share);
  const double advised = contact::two_digits_below(contact::advised_share * shortest.duration);
  if (share > contact::stable_share)
    verdict.refusal = fmt::format(
        "'timestep {:g}' is too long for the contacts: {}. With fewer than pi steps a packed bed "
        "feeds itself with energy and flies apart. Write 'timestep {:g}' (20 steps a contact), or "
        "make the contacts softer.",
        dt, known, advised);
  else
    verdict.warning = fmt::format(
        "'timestep {:g}' is long for the contacts: {}. With fewer than 10 the restitution is off "
        "by per cents. 'timestep {:g}' makes it 20.",
        dt, known, advised);
  return verdict;
}

}  // namespace gasgrain
