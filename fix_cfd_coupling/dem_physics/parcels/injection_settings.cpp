#include "fix_cfd_coupling/dem_physics/parcels/injection_settings.h"

#include <cmath>
#include <numeric>

#include "coupling/base/word_reader.h"

namespace gasgrain {

namespace {

const std::vector<std::string> sides{"x_lo", "x_hi", "y_lo", "y_hi", "z_lo", "z_hi"};

class Reader : WordReader {
 public:
  Reader(const std::vector<std::string>& words, const std::vector<std::string>& species, int types)
      : WordReader(words), species_(species), types_(types) {
    settings_.mass_fraction.assign(species.size(), 0.0);
  }

  InjectionSettings read() {
    read_keywords(keywords());
    check_place();
    check_matter();
    check_division();
    throw_faults("fix all parcels/inject");
    return settings_;
  }

 private:
  Keywords keywords() {
    InjectionSettings& s = settings_;
    return {
        {"at", [&] { s.at = vector("at", "m"); }},
        {"nozzle_radius",
         [&] { s.nozzle_radius = number("nozzle_radius", 0.0, 100.0, "m; 0: a point"); }},
        {"direction", [&] { read_direction(); }},
        {"half_angle",
         [&] {
           s.half_angle = M_PI / 180.0 * number("half_angle", 0.0, 180.0, "degrees, of the cone");
         }},
        {"mass_flow", [&] { s.mass_flow = positive("mass_flow", 1e6, "kg/s"); }},
        {"face", [&] { read_face(); }},
        {"rectangle",
         [&] {
           s.rectangle.emplace();
           for (double& x : *s.rectangle)
             x = number("rectangle", -1e6, 1e6, "low and high of the side's two axes in m");
         }},
        {"fraction",
         [&] { s.fraction = positive("fraction", 0.9, "volume fraction of the particles fed"); }},
        {"speed", [&] { s.speed = positive("speed", 1e4, "m/s"); }},
        {"size", [&] { read_size(); }},
        {"solid", [&] { s.density = positive("solid", 1e5, "density of the solid in kg/m3"); }},
        {"liquid", [&] { read_liquid(); }},
        {"core",
         [&] {
           s.core_radius = positive("core", 1.0, "radius of a droplet's core in m");
           s.core_density = positive("core", 1e5, "density of a droplet's core in kg/m3");
         }},
        {"particles", [&] { read_division(ParcelsBy::particles, "particles", "a parcel"); }},
        {"parcels_per_second",
         [&] { read_division(ParcelsBy::second, "parcels_per_second", "1/s"); }},
        {"parcels_per_step", [&] { read_division(ParcelsBy::step, "parcels_per_step", "a step"); }},
        {"from", [&] { s.from = number("from", -1e9, 1e9, "s"); }},
        {"to", [&] { s.to = number("to", -1e9, 1e9, "s"); }},
        {"type",
         [&] {
           s.type = whole("type", 1, "of the host's atoms");
           if (s.type > types_)
             fault("type {}: the scene has {} atom types. Raise them in create_box.", s.type,
                   types_);
         }},
        {"seed",
         [&] { s.seed = static_cast<std::uint64_t>(whole("seed", 0, "of random numbers")); }},
    };
  }

  double positive(std::string_view key, double high, std::string_view what) {
    return number(key, 1e-30, high, fmt::format("{}, above 0", what));
  }

  Vec3 vector(std::string_view key, std::string_view unit) {
    Vec3 x;
    for (int d = 0; d < 3; ++d) x[d] = number(key, -1e6, 1e6, unit);
    return x;
  }

  void read_direction() {
    const Vec3 direction = vector("direction", "of any length");
    if (direction.norm() > 0.0)
      settings_.direction = direction.normalized();
    else
      fault("direction 0 0 0: has no length. Give where the parcels go, for instance 0 0 -1.");
  }

  void read_face() {
    const auto text = word("face", "a side of the box");
    if (!text) return;
    for (std::size_t n = 0; n < sides.size(); ++n) {
      if (*text != sides[n]) continue;
      settings_.face_axis = static_cast<int>(n / 2);
      settings_.face_high = n % 2 == 1;
      return;
    }
    fault("face {}: is no side of the box.{}", *text, suggestion(*text, sides));
  }

  void read_size() {
    SizeDistribution& size = settings_.size;
    const std::vector<std::string> laws{"constant", "lognormal", "rosin_rammler", "list"};
    const auto law = word("size", fmt::format("one of {}", fmt::join(laws, ", ")));
    if (!law) return;
    if (*law == "list") {
      size.law = SizeDistribution::Law::list;
      const std::vector<double> values = numbers();
      bool right = !values.empty() && values.size() % 2 == 0;
      for (const double value : values) right = right && value > 0.0;
      if (!right) {
        fault("size list: give pairs of a radius in m and its share of the mass, all above 0.");
        return;
      }
      for (std::size_t n = 0; n < values.size(); n += 2)
        size.list.emplace_back(values[n], values[n + 1]);
      size.radius = size.list.front().first;
      return;
    }
    size.radius = positive("size", 1.0, "radius in m");
    if (*law == "constant") {
      size.law = SizeDistribution::Law::constant;
    } else if (*law == "lognormal") {
      size.law = SizeDistribution::Law::lognormal;
      size.width = number("size lognormal", 1e-6, 3.0, "standard deviation of ln R");
    } else if (*law == "rosin_rammler") {
      size.law = SizeDistribution::Law::rosin_rammler;
      size.width = number("size rosin_rammler", 0.3, 100.0, "exponent, 1.5 to 4 are usual");
    } else {
      fault("size \"{}\" is unknown.{}", *law, suggestion(*law, laws));
    }
  }

  void read_liquid() {
    settings_.liquid = true;
    settings_.density = positive("liquid", 1e5, "density of the liquid in kg/m3");
    double sum = 0.0;
    for (std::size_t n = 0; n < species_.size(); ++n)
      if (take(species_[n])) {
        settings_.mass_fraction[n] +=
            positive("liquid " + species_[n], 1.0, "mass fraction of the species");
        sum += settings_.mass_fraction[n];
        n = static_cast<std::size_t>(-1);  // any order: from the first again
        if (sum > 1.0 + 1e-9) break;
      }
    if (species_.empty())
      fault("liquid: the scene has no liquid species. Name them in the fix of the exchange.");
    else if (std::abs(sum - 1.0) > 1e-9)
      fault(
          "liquid: the mass fractions add up to {}, not 1. Write 'liquid RHO NAME X ...' with "
          "species of the scene: {}.",
          sum, fmt::join(species_, ", "));
    if (sum > 0.0)
      for (double& fraction : settings_.mass_fraction) fraction /= sum;
  }

  void read_division(ParcelsBy by, std::string_view key, std::string_view of) {
    if (settings_.number > 0.0)
      fault("{}: the mass is divided already. Leave out one of the two ways.", key);
    settings_.by = by;
    settings_.number = number(key, 1e-6, 1e15, of);
  }

  void check_place() {
    const InjectionSettings& s = settings_;
    if (named("face")) {
      for (const char* key : {"at", "nozzle_radius", "direction", "half_angle", "mass_flow"})
        if (named(key))
          fault("{}: belongs to a nozzle; a face feeds 'fraction' at 'speed' along its normal.",
                key);
      if (!named("fraction"))
        fault("fraction is missing: volume fraction of the particles that the face feeds.");
    } else {
      for (const char* key : {"rectangle", "fraction"})
        if (named(key)) fault("{}: belongs to a face. Name it: 'face x_lo'.", key);
      for (const char* key : {"at", "direction", "mass_flow"})
        if (!named(key)) fault("{} is missing: a nozzle has at, direction and mass_flow.", key);
    }
    if (!named("speed")) fault("speed is missing: of the parcels that enter, m/s.");
    if (!(s.from < s.to)) fault("to {}: must be after from {}.", s.to, s.from);
  }

  void check_matter() {
    const InjectionSettings& s = settings_;
    if (named("solid") == named("liquid"))
      fault("{}: write 'solid RHO' or 'liquid RHO NAME X ...'.",
            named("solid") ? "solid and liquid are both given" : "what enters is not said");
    if (!named("size")) {
      fault("size is missing: radii of the particles, for instance 'size constant 5e-5'.");
    } else if (s.liquid && faultless() && s.size.quantile(1e-12) <= 10.0 * s.core_radius) {
      fault("core {} {}: droplets down to {:.3g} m are hardly larger. Make the core smaller.",
            s.core_radius, s.core_density, s.size.quantile(1e-12));
    }
    if (named("core") && !named("liquid")) fault("core: belongs to a liquid.");
  }

  void check_division() {
    if (settings_.number <= 0.0 && faultless())
      fault(
          "how the mass is divided is missing: write 'particles N' (a parcel), "
          "'parcels_per_second N' or 'parcels_per_step N'.");
  }

  const std::vector<std::string>& species_;
  int types_;
  InjectionSettings settings_;
};

}  // namespace

InjectionSettings parse_injection(const std::vector<std::string>& words,
                                  const std::vector<std::string>& species, int types) {
  return Reader(words, species, types).read();
}

std::string feed_fault(const ParcelSettings& parcels, const InjectionSettings& injection) {
  if (!injection.of_face() || injection.liquid || injection.fraction <= parcels.close_packing)
    return {};
  return fmt::format(
      "fraction {} of the feed is above close_packing {}: solids cannot enter that dense. Lower "
      "the fraction to {} or less, or raise close_packing (random packing of spheres: 0.64 at "
      "most).",
      injection.fraction, parcels.close_packing, parcels.close_packing);
}

}  // namespace gasgrain
