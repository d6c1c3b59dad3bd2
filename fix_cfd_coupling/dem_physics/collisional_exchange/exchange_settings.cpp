#include "fix_cfd_coupling/dem_physics/collisional_exchange/exchange_settings.h"

#include <limits>

#include "coupling/base/word_reader.h"

namespace gasgrain {

namespace {

constexpr double hottest = 1e4;  // [K]

class Reader : WordReader {
 public:
  explicit Reader(const std::vector<std::string>& words) : WordReader(words) {}

  ExchangeSettings read() {
    read_keywords(keywords());
    check_whole();
    throw_faults("the collisional exchange");
    return settings_;
  }

 private:
  Keywords keywords() {
    ExchangeSettings& s = settings_;
    return {
        {"close_packing",
         [&] {
           s.close_packing =
               number("close_packing", 0.05, 0.999, "solid volume fraction, spheres 0.58 to 0.64");
         }},
        {"k_solid", [&] { s.k_solid = rate("k_solid"); }},
        {"k_liquid", [&] { s.k_liquid = rate("k_liquid"); }},
        {"time_scale_ratio",
         [&] {
           s.time_scale_ratio =
               number("time_scale_ratio", 1.0, 1e6, "time scale of films over that of velocities");
         }},
        {"agglomeration", [&] { read_agglomeration(); }},
        {"species", [&] { read_species(); }},
        {"film_temperature",
         [&] {
           s.film_temperature = number("film_temperature", least_above_0, hottest, "K, at first");
         }},
        {"momentum", [&] { read_momentum(); }},
        {"cells", [&] { read_cells(); }},
        {"every", [&] { s.every = whole("every", 1, "steps"); }},
    };
  }

  double rate(std::string_view key) {
    return number(key, 0.0, 1e3, "1 / collisions to equilibrium of the velocities");
  }

  void read_agglomeration() {
    const auto text = word("agglomeration", "mean or variance");
    if (!text) return;
    if (*text == "mean")
      settings_.agglomeration = Agglomeration::mean;
    else if (*text == "variance")
      settings_.agglomeration = Agglomeration::variance;
    else
      fault("agglomeration \"{}\" is unknown.{}", *text, suggestion(*text, {"mean", "variance"}));
  }

  void read_momentum() {
    const auto text = word("momentum", "on or off");
    if (!text) return;
    settings_.momentum = *text != "off";
    if (*text != "on" && *text != "off") fault("momentum {}: must be 'on' or 'off'.", *text);
  }

  void read_cells() {
    Int3 cells{1, 1, 1};
    for (int& n : cells) n = whole("cells", 1, "three numbers of cells, along x, y and z");
    settings_.cells = cells;
  }

  void read_species() {
    const auto name = word("species", "its name");
    if (!name) return;
    if (*name == "density" || as_number(*name)) {
      fault("species {}: its name comes first, for instance 'species water density 998'.", *name);
      if (*name == "density") number("density", 0.0, std::numeric_limits<double>::max(), "kg/m3");
      return;
    }
    LiquidSpecies liquid;
    liquid.name = *name;
    const std::string what = "species " + *name;
    if (take("density"))
      liquid.density = number(what + " density", 1.0, 3e4, "kg/m3, water 998");
    else
      fault("{}: has no density. Write 'species {} density 998' (kg/m3).", what, *name);
    if (take("heat")) read_heat(what, liquid.enthalpy);
    for (const LiquidSpecies& other : settings_.species)
      if (other.name == liquid.name) fault("{}: is named twice. Leave out one of the two.", what);
    settings_.species.push_back(liquid);
  }

  void read_heat(const std::string& what, SpeciesEnthalpy& h) {
    h.coefficients = numbers();
    if (h.coefficients.empty())
      fault("{} heat: give C0 C1 ... of c_p = C0 + C1 T + ..., J/(kg K); water 'heat 4180'.", what);
    if (!take("range")) {
      fault("{} heat: has no range. Write 'range 273 373' (K) after the coefficients.", what);
      return;
    }
    h.low = number(what + " range", least_above_0, hottest, "K, the lower end");
    h.high = number(what + " range", least_above_0, hottest, "K, the upper end");
    if (!(h.low < h.high)) {
      fault("{} range {} {}: the lower end comes first, the upper one is above it.", what, h.low,
            h.high);
    } else if (const auto T = temperature_without_heat(h)) {
      fault(
          "{} heat: c_p is {:.4g} J/(kg K) at {:.6g} K, must be above 0 over its whole range {} to "
          "{} K. Narrow the range or correct the coefficients.",
          what, h.specific_heat(*T), *T, h.low, h.high);
    }
  }

  // A temperature of the range where c_p is not above 0, of many that are tried.
  static std::optional<double> temperature_without_heat(const SpeciesEnthalpy& h) {
    constexpr int tries = 2000;
    for (int n = 0; n <= tries; ++n) {
      const double T = h.low + (h.high - h.low) * n / tries;
      if (!(h.specific_heat(T) > 0.0)) return T;
    }
    return std::nullopt;
  }

  void check_whole() {
    const ExchangeSettings& s = settings_;
    if (s.film_temperature && s.species.empty())
      fault("film_temperature: there are no films. Name their liquids with 'species'.");
    for (const LiquidSpecies& one : s.species) {
      const SpeciesEnthalpy& h = one.enthalpy;
      if (named("film_temperature") && h.coefficients.empty())
        fault(
            "species {}: has no enthalpy, which film_temperature needs. Write 'heat C0 range TLO "
            "THI' after its density (c_p in J/(kg K) over a range in K), or leave out "
            "film_temperature.",
            one.name);
      else if (!named("film_temperature") && !h.coefficients.empty())
        fault(
            "species {} heat: is of no use without film_temperature. Add 'film_temperature T' (K, "
            "at first), or leave out the heat.",
            one.name);
      else if (s.film_temperature && h.low < h.high && !h.within_range(*s.film_temperature))
        fault("film_temperature {}: is out of the range of species {}, {} to {} K.",
              *s.film_temperature, one.name, h.low, h.high);
    }
  }

  static constexpr double least_above_0 = 1e-3;  // [K]
  ExchangeSettings settings_;
};

}  // namespace

ExchangeSettings parse_exchange(const std::vector<std::string>& words) {
  return Reader(words).read();
}

}  // namespace gasgrain
