#include "tools/study/bounce.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>
#include <vector>

#include "coupling/base/error.h"
#include "fix_cfd_coupling/dem_physics/contact_time.h"
#include "tools/child_process.h"
#include "tools/failure.h"
#include "tools/programs.h"
#include "tools/study/pair_style.h"

namespace gasgrain {

namespace fs = std::filesystem;

namespace {

constexpr int phases = 8;

// A grain against another one, or against a wall.
struct Pair {
  double mass;
  double radius;
  double modulus;
};

double modulus_of(const GrainMaterial& m) {
  return contact::effective_modulus(m.youngs, m.poisson, m.youngs, m.poisson);
}

Pair two_grains(const GrainMaterial& m) {
  return {contact::effective(m.mass(), m.mass()), contact::effective(m.radius, m.radius),
          modulus_of(m)};
}

Pair grain_and_wall(const GrainMaterial& m) {
  return {m.mass(), m.radius, modulus_of(m)};
}

bool is_model(const std::string& contact, const std::string& name) {
  return contact.substr(0, contact.find(' ')) == name;
}

std::optional<double> duration(const Pair& pair, const GrainMaterial& m, const std::string& contact,
                               double speed, double restitution) {
  if (is_model(contact, "hertz"))
    return contact::hertz_duration(contact::hertz_stiffness(pair.modulus, pair.radius), pair.mass,
                                   speed, restitution);
  if (is_model(contact, "hooke"))
    return contact::linear_duration(
        contact::hooke_stiffness(pair.modulus, pair.radius, pair.mass, m.characteristic_velocity),
        pair.mass, restitution);
  return std::nullopt;
}

// Distance [m] of grain n's surface from the wall at the start: the phases of a step.
double first_gap(int n, double step, double speed) {
  return speed * step * (1.0 + (n + 0.5) / phases);
}

std::string script(const GrainMaterial& m, const std::string& contact, double restitution,
                   double step, double speed, long steps) {
  const double pitch = 4.0 * m.radius;
  std::string text = fmt::format(
      "atom_style granular\natom_modify map array\nunits si\nboundary f f f\nnewton off\n"
      "communicate single vel yes\n"
      "region box block 0 {0} 0 {1} 0 {1} units box\ncreate_box 1 box\n"
      "neighbor {2} bin\ntimestep {3}\n"
      "fix youngs all property/global youngsModulus peratomtype {4}\n"
      "fix poisson all property/global poissonsRatio peratomtype {5}\n"
      "fix restitution all property/global coefficientRestitution peratomtypepair 1 {6}\n"
      "fix friction all property/global coefficientFriction peratomtypepair 1 {7}\n"
      "fix speed all property/global characteristicVelocity scalar {8}\n"
      "pair_style {10} model {9}\npair_coeff * *\n"
      "fix wall all wall/gran model {9} primitive type 1 zplane 0.0\n"
      "fix motion all nve/sphere\n",
      pitch * phases, pitch, 0.5 * m.radius, step, m.youngs, m.poisson, restitution, m.friction,
      m.characteristic_velocity, contact, own_loop_has(contact) ? own_pair_style : host_pair_style);
  for (int n = 0; n < phases; ++n)
    text += fmt::format("create_atoms 1 single {:.17g} {:.17g} {:.17g} units box\n",
                        pitch * (n + 0.5), 0.5 * pitch, m.radius + first_gap(n, step, speed));
  text += fmt::format(
      "set group all diameter {:.17g} density {:.17g}\n"
      "velocity all set 0.0 0.0 {:.17g} units box\n"
      "dump course all custom 1 course.txt id z vz\n"
      "dump_modify course sort id format \"%d %.17g %.17g\"\n"
      "thermo_modify lost error norm no\nthermo {}\nrun {}\n",
      2.0 * m.radius, m.density, -speed, steps, steps);
  return text;
}

struct Moment {
  double z;
  double vz;
};

// The grains' courses, a line of moments each, a moment a step.
std::vector<std::vector<Moment>> read_courses(const fs::path& file) {
  std::vector<std::vector<Moment>> courses(phases);
  std::ifstream stream(file);
  bool in_atoms = false;
  for (std::string line; std::getline(stream, line);) {
    if (line.rfind("ITEM:", 0) == 0) {
      in_atoms = line.rfind("ITEM: ATOMS", 0) == 0;
      continue;
    }
    std::istringstream words(line);
    int id = 0;
    Moment now{};
    if (in_atoms && words >> id >> now.z >> now.vz && id >= 1 && id <= phases)
      courses[static_cast<std::size_t>(id - 1)].push_back(now);
  }
  return courses;
}

struct Bounce {
  double restitution;
  double duration_s;
};

// Free flight before and after is uniform, so that both ends of the contact are known exactly from
// one moment each.
Bounce bounce_of(const std::vector<Moment>& course, double radius, double step) {
  for (std::size_t n = 1; n < course.size(); ++n) {
    const bool left = course[n].vz > 0.0 && course[n].z >= radius;
    if (!left) continue;
    const double began = (course[0].z - radius) / -course[0].vz;
    const double ended = static_cast<double>(n) * step - (course[n].z - radius) / course[n].vz;
    return {course[n].vz / -course[0].vz, ended - began};
  }
  fail("a grain did not come back from the wall: the DEM step of {:.3g} s is too long.", step);
}

std::vector<Bounce> run(const GrainMaterial& m, const std::string& contact, double restitution,
                        double step, double speed, const fs::path& folder) {
  const double exact = duration(grain_and_wall(m), m, contact, speed, restitution).value_or(0.0);
  constexpr int after = 10;  // steps, and as many again as the contact's own
  const long steps = std::lround(std::ceil(2.0 * exact / step)) + after;
  fs::create_directories(folder);
  std::ofstream(folder / "in.bounce") << script(m, contact, restitution, step, speed, steps);
  const Programs programs = find_programs();
  const Command command{{programs.dem, "-in", "in.bounce", "-log", "none"}, folder, {}};
  constexpr std::chrono::seconds limit{60};
  const Captured answer = run_captured(command, limit);
  std::istringstream said(answer.output);
  if (!answer.in_time || answer.status != 0)
    fail("the bounce of one grain failed: {}", failure_reason(said, 1));
  std::vector<Bounce> bounces;
  for (const auto& course : read_courses(folder / "course.txt"))
    bounces.push_back(bounce_of(course, m.radius, step));
  return bounces;
}

}  // namespace

double GrainMaterial::mass() const {
  return 4.0 / 3.0 * contact::pi * radius * radius * radius * density;
}

double linear_stiffness(const GrainMaterial& material, double speed) {
  const Pair pair = two_grains(material);
  return contact::hooke_stiffness(pair.modulus, pair.radius, pair.mass, speed);
}

std::optional<double> contact_duration(const GrainMaterial& material, const std::string& contact,
                                       double speed) {
  return duration(two_grains(material), material, contact, speed, material.restitution);
}

std::optional<BounceErrors> measure_bounce(const GrainMaterial& material,
                                           const std::string& contact, double step, double speed,
                                           const fs::path& folder) {
  const auto exact =
      duration(grain_and_wall(material), material, contact, speed, material.restitution);
  if (!exact) return std::nullopt;
  BounceErrors errors;
  for (const Bounce& bounce :
       run(material, contact, material.restitution, step, speed, folder / "damped")) {
    errors.restitution =
        std::max(errors.restitution,
                 std::abs(bounce.restitution - material.restitution) / material.restitution);
    errors.contact_time =
        std::max(errors.contact_time, std::abs(bounce.duration_s - *exact) / *exact);
    errors.contact_time_s += bounce.duration_s / phases;
  }
  for (const Bounce& bounce : run(material, contact, 1.0, step, speed, folder / "elastic"))
    errors.energy =
        std::max(errors.energy, std::abs(bounce.restitution * bounce.restitution - 1.0));
  return errors;
}

void add_bounce_figures(const GrainMaterial& material, const std::string& contact, double step,
                        const fs::path& folder, Figures& figures) {
  const auto bounce = measure_bounce(material, contact, step, study_impact_speed, folder);
  if (!bounce) return;
  figures.set("restitution_error", bounce->restitution);
  figures.set("contact_time_error", bounce->contact_time);
  figures.set("energy_drift", bounce->energy);
  figures.set("contact_time_s", bounce->contact_time_s);
}

}  // namespace gasgrain
