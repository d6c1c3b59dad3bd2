#include "fix_cfd_coupling/fixes/contact_limits.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "fix_cfd_coupling/dem_physics/contact_step.h"
#include "fix_cfd_coupling/dem_physics/contact_time.h"
// --
#include "atom.h"
#include "dialect_gravity.h"
#include "dialect_materials.h"
#include "dialect_walls.h"
#include "dialect_words.h"
#include "domain.h"
#include "force.h"
#include "modify.h"
#include "update.h"

namespace gasgrain {
namespace {

using namespace LAMMPS_NS;

constexpr double none = std::numeric_limits<double>::infinity();

enum class NormalModel { hertz, hooke, hooke_stiffness, hertz_stiffness, unread };

constexpr std::array<const char*, 4> model_names{"hertz", "hooke", "hooke/stiffness",
                                                 "hertz/stiffness"};

NormalModel model_of(LAMMPS& host) {
  const std::string name = normal_model_among(host, model_names);
  for (std::size_t n = 0; n < model_names.size(); ++n)
    if (name == model_names[n]) return static_cast<NormalModel>(n);
  return NormalModel::unread;
}

const char* name_of(NormalModel model) {
  return model_names[static_cast<std::size_t>(model)];
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
  ContactReader(LAMMPS& host, NormalModel model, double speed) : model_(model), speed_(speed) {
    const char* pairs = "peratomtypepair";
    if (model == NormalModel::hertz || model == NormalModel::hooke) {
      youngs_ = find_material(host, "youngsModulus", "peratomtype");
      poisson_ = find_material(host, "poissonsRatio", "peratomtype");
      restitution_ = find_material(host, "coefficientRestitution", pairs);
      velocity_ = find_material(host, "characteristicVelocity", "scalar");
    } else {
      kn_ = find_material(host, "kn", pairs);
    }
  }

  // Whether all that the model needs is there.
  [[nodiscard]] bool complete() const {
    if (model_ == NormalModel::hertz || model_ == NormalModel::hooke)
      return youngs_ && poisson_ && (model_ == NormalModel::hertz || velocity_);
    return static_cast<bool>(kn_);
  }

  [[nodiscard]] Collision collide(const Body& a, const Body& b) const {
    const double mass = combined(a.mass, b.mass);
    const double radius = combined(a.radius, b.radius);
    // `hooke` with the word viscous has no such table; undamped is the shorter contact.
    const double e = restitution_ ? restitution_.of(a.type, b.type) : 1.0;
    Collision met{none, a, b, ""};
    if (kn_) {
      const double kn = kn_.of(a.type, b.type);
      met.stiffness = fmt::format("kn {:g}", kn);
      met.duration = model_ == NormalModel::hooke_stiffness
                         ? contact::linear_duration(kn, mass)
                         : contact::hertz_duration(kn * std::sqrt(radius), mass, speed_);
      return met;
    }
    const double youngs_a = youngs_.of(a.type);
    const double youngs_b = youngs_.of(b.type);
    const double modulus =
        contact::effective_modulus(youngs_a, poisson_.of(a.type), youngs_b, poisson_.of(b.type));
    met.stiffness = fmt::format("youngsModulus {:g} Pa", std::max(youngs_a, youngs_b));
    if (model_ == NormalModel::hertz) {
      met.duration =
          contact::hertz_duration(contact::hertz_stiffness(modulus, radius), mass, speed_, e);
    } else {
      const double v = velocity_.value();
      met.stiffness += fmt::format(", characteristicVelocity {:g} m/s", v);
      met.duration =
          contact::linear_duration(contact::hooke_stiffness(modulus, radius, mass, v), mass, e);
    }
    return met;
  }

 private:
  NormalModel model_;
  double speed_;
  Material youngs_;
  Material poisson_;
  Material restitution_;
  Material velocity_;
  Material kn_;
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
  std::vector<Body> bodies;
  for (const int type : wall_types(host))
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
  const Vec3 g = gravity_of(*host.modify);
  double fall = 0.0;
  for (int d = 0; d < 3; ++d)
    fall += 2.0 * std::abs(g[d]) * (host.domain->boxhi[d] - host.domain->boxlo[d]);
  square = std::max(square, fall);
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
  const NormalModel model = model_of(host);
  const double speed = expected_speed(host, local);
  const ContactReader reader(host, model, speed);
  if (model == NormalModel::unread || !reader.complete()) {
    verdict.warning = fmt::format(
        "the contact model of 'pair_style {} ...' is not among those whose contact duration is "
        "known here ({}): nobody checks that 'timestep {:g}' is short enough for it.",
        host.force->pair_style, words::contact_models, host.update->dt);
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
