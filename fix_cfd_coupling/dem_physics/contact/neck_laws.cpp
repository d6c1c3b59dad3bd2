#include "fix_cfd_coupling/dem_physics/contact/neck_laws.h"

#include <cmath>
#include <limits>

#include "fix_cfd_coupling/dem_physics/contact_time.h"

namespace gasgrain::contact {
namespace {

// What went wrong in `check`, or nothing.
template <class Check>
std::string faults_of(Check check_something) {
  try {
    check_something();
  } catch (const Error& error) {
    return std::string("\n") + error.what();
  }
  return "";
}

std::string faults_of_words(const NeckWords& words) {
  return faults_of([&] {
    InputFaults("The words after the model's name")
        .positive("greatest_gap", words.greatest_gap, "m",
                  "give the gap beyond which a stretched neck breaks, such as 1e-3 of the radius")
        .not_negative("neck_temperature", words.temperature, "K",
                      "give it in K, or leave it out to take the property/atom Temp")
        .require(words.micro_contacts == std::floor(words.micro_contacts), "micro_contacts",
                 words.micro_contacts, "", "1, 3 or 9",
                 "1 for smooth grains, 3 or 9 for rough ones")
        .refuse();
  });
}

}  // namespace

// Found by checked_laws() for its argument's namespace.
static void check(const NeckLaw& law) {
  const std::string faults =
      faults_of([&] { check(law.growth); }) + faults_of([&] { check(law.strength); }) +
      faults_of([&] {
        InputFaults("A neck's stiffness")
            .not_negative("neckStiffness", law.stiffness, "N/m",
                          "give that of the contact, or leave the property out with hooke")
            .require(!(law.growth.surface_tension > 0.0) || law.strength.tensile > 0.0,
                     "neckTensileStrength", law.strength.tensile, "Pa",
                     "above 0 where necks grow (neckSurfaceTension above 0)",
                     "hot metals bear some 1e7 Pa")
            .refuse();
      });
  if (!faults.empty()) fail("{}", faults.substr(1));
}

void NeckLaws::read(const ContactHost& host, const NeckWords& words, const NormalKind& normal) {
  words_ = words;
  normal_ = normal;
  const auto tension = host.need_pairs("neckSurfaceTension", "N/m");
  const auto tensile = host.need_pairs("neckTensileStrength", "Pa");
  const auto shear = host.need_pairs("neckShearStrength", "Pa");
  adhesion::Sintering growth;
  growth.lattice_constant = host.need_scalar("neckLatticeConstant", "m");
  growth.surface.prefactor = host.need_scalar("surfaceDiffusionPrefactor", "m2/s");
  growth.surface.activation_energy = host.need_scalar("surfaceDiffusionEnergy", "J/mol");
  growth.volume.prefactor = host.need_scalar("volumeDiffusionPrefactor", "m2/s");
  growth.volume.activation_energy = host.need_scalar("volumeDiffusionEnergy", "J/mol");
  growth.volume_diffusion_from = words.volume_diffusion_from;
  growth.micro_contacts = static_cast<int>(words.micro_contacts);
  const auto stiffness = host.pairs("neckStiffness");
  own_stiffness_ = stiffness.has_value();
  if (!own_stiffness_ && !normal.linear)
    host.refuse_missing(
        "neckStiffness",
        fmt::format("fix ID all property/global neckStiffness peratomtypepair {} VALUES  (N/m)\n"
                    "since only 'model hooke' and 'model hooke/stiffness' have a stiffness that a "
                    "neck could take over at zero overlap",
                    host.types()));
  const auto friction = host.pairs("coefficientFriction");

  laws_ = checked_laws(
      host,
      "neckSurfaceTension, neckTensileStrength, neckShearStrength, neckStiffness, "
      "neckLatticeConstant, surfaceDiffusion..., volumeDiffusion...",
      [&](int i, int j) {
        NeckLaw law{growth, {tensile(i, j), shear(i, j)}, 0.0, 0.0};
        law.growth.surface_tension = tension(i, j);
        if (stiffness) law.stiffness = (*stiffness)(i, j);
        if (friction) law.friction = (*friction)(i, j);
        return law;
      },
      faults_of_words(words));
  act_ = false;
  for (int i = 1; i <= host.types(); ++i)
    for (int j = 1; j <= host.types(); ++j) act_ = act_ || tension(i, j) > 0.0;
  read_temperature(host);
  if (words.correct_contact_time) read_real_contact(host);
}

void NeckLaws::read_temperature(const ContactHost& host) {
  temperature_ = {};
  if (words_.temperature > 0.0) return;
  constexpr auto property = "Temp";
  temperature_ = host.grain_scalar(property);
  const GrainScalarLines lines = host.grain_scalar_lines(property);
  if (!temperature_)
    host.refuse(
        fmt::format("it needs a temperature. Write 'neck_temperature VALUE' (K) after the model's "
                    "name, or give the grains theirs by {}.",
                    lines.make));
  if (!temperature_.on_ghosts)
    host.refuse(
        fmt::format("the temperatures of the property/atom Temp are not sent to the other ranks. "
                    "{}.",
                    lines.send));
  double lowest = std::numeric_limits<double>::infinity();
  for (int i = 0; i < host.grains(); ++i) lowest = std::min(lowest, temperature_[i]);
  MPI_Allreduce(MPI_IN_PLACE, &lowest, 1, MPI_DOUBLE, MPI_MIN, host.communicator());
  if (!(lowest > 0.0))
    host.refuse(fmt::format(
        "a grain has the temperature Temp = {:g} K; it must be above 0. Give it in K.", lowest));
}

void NeckLaws::read_real_contact(const ContactHost& host) {
  if (!normal_.linear && !normal_.hertzian)
    host.refuse(
        "contact_time_correction knows the collisions of 'model hooke', 'hooke/stiffness', 'hertz' "
        "and 'hertz/stiffness'. Write one of them, or 'contact_time_correction off'.");
  const auto youngs = host.need_per_type("youngsModulusReal", "Pa");
  const auto poisson = host.need_per_type("poissonsRatio", "no unit");
  const int types = host.types();
  const auto restitution = host.pairs("coefficientRestitution");
  real_modulus_ = PairTable<double>(types);
  restitution_ = PairTable<double>(types);
  for (int i = 1; i <= types; ++i) {
    if (!(youngs[i] > 0.0))
      host.refuse(
          fmt::format("youngsModulusReal = {:g} Pa of type {} must be above 0: steel has 2e11 Pa.",
                      youngs[i], i));
    for (int j = 1; j <= types; ++j) {
      real_modulus_(i, j) =
          contact::effective_modulus(youngs[i], poisson[i], youngs[j], poisson[j]);
      restitution_(i, j) = restitution ? (*restitution)(i, j) : 1.0;
    }
  }
}

void NeckLaws::send_temperatures(ContactHost& host) const {
  if (temperature_ && act_) host.send_to_ghosts(temperature_);
}

double NeckLaws::temperature(int i, int j) const {
  if (!temperature_) return words_.temperature;
  return 0.5 * (temperature_[i] + temperature_[j]);
}

adhesion::CollisionDurations NeckLaws::durations(const Meeting& m) const {
  constexpr adhesion::CollisionDurations uncorrected{1.0, 1.0};
  constexpr double at_rest = 1e-9;  // [m/s]: such bodies do not collide
  if (!words_.correct_contact_time || m.speed < at_rest || m.overlap <= 0.0) return uncorrected;
  const double e = restitution_(m.itype, m.jtype);
  const double real = contact::hertz_duration(
      contact::hertz_stiffness(real_modulus_(m.itype, m.jtype), m.reduced_radius), m.mass, m.speed,
      e);
  const double in_dem = normal_.linear ? contact::linear_duration(m.stiffness, m.mass, e)
                                       : contact::hertz_duration(m.stiffness / std::sqrt(m.overlap),
                                                                 m.mass, m.speed, e);
  return {in_dem, real};
}

}  // namespace gasgrain::contact
