#include "fix_cfd_coupling/dem_physics/parcels/parcel_settings.h"

#include "coupling/base/word_reader.h"

namespace gasgrain {

namespace {

const std::vector<std::string> sides{"x_lo", "x_hi", "y_lo", "y_hi", "z_lo", "z_hi"};

class Reader : WordReader {
 public:
  explicit Reader(const std::vector<std::string>& words) : WordReader(words) {}

  ParcelSettings read() {
    read_keywords(keywords());
    if (named("retention") && !named("walls"))
      fault(
          "retention without walls: no side of the box is a wall. Name them: 'walls x_lo x_hi ...' "
          "({}).",
          fmt::join(sides, " "));
    throw_faults("fix all parcels");
    return settings_;
  }

 private:
  Keywords keywords() {
    ParcelSettings& s = settings_;
    return {
        {"particles",
         [&] {
           s.particles = number("particles", 1e-6, 1e15, "particles a parcel; need not be whole");
         }},
        {"close_packing",
         [&] {
           s.close_packing = number("close_packing", 0.1, 0.9,
                                    "solid volume fraction; spheres: loose 0.56, dense 0.64");
         }},
        {"stress", [&] { read_stress(); }},
        {"restitution",
         [&] { s.restitution = number("restitution", 0.0, 1.0, "of the stress's limiter"); }},
        {"walls", [&] { read_walls(); }},
        {"retention",
         [&] {
           s.walls.retention_normal =
               number("retention", 0.0, 1.0, "share of the normal velocity kept at a wall");
           s.walls.retention_tangential =
               number("retention", 0.0, 1.0, "share of the tangential velocity kept at a wall");
         }},
        {"damping",
         [&] {
           s.damping = read_switch("damping");
           if (s.damping) s.damping_restitution = restitution("damping on");
         }},
        {"isotropy",
         [&] {
           s.isotropy = read_switch("isotropy");
           if (!s.isotropy) return;
           s.isotropy_restitution = restitution("isotropy on");
           s.isotropy_share =
               number("isotropy on", 1e-6, 1.0,
                      "greatest share of a cell's parcels redirected in a step, for instance 0.4");
         }},
        {"cells",
         [&] {
           s.cells = Int3{};
           for (int& n : *s.cells) n = whole("cells", 1, "cells of the parcels' own grid");
         }},
        {"seed",
         [&] { s.seed = static_cast<std::uint64_t>(whole("seed", 0, "of random numbers")); }},
    };
  }

  double restitution(std::string_view key) {
    return number(key, 0.0, 1.0, "restitution of the grains; 1: elastic");
  }

  bool read_switch(std::string_view key) {
    if (take("on")) return true;
    if (take("off")) return false;
    const auto text = word(key, "'on' with its numbers, or 'off'");
    if (text)
      fault("{} {}: must be 'on' with its numbers, or 'off'.{}", key, *text,
            suggestion(*text, {"on", "off"}));
    return false;
  }

  void read_stress() {
    ParcelSettings& s = settings_;
    if (take("off")) {
      s.stress = false;
      return;
    }
    s.stress_constant = number("stress", 1e-3, 1e6, "P_s in Pa, 100 is usual; or 'stress off'");
    s.stress_exponent = number("stress", 1.0, 5.0, "exponent beta, 2 to 5 are usual");
    s.stress_epsilon = number("stress", 1e-12, 1e-2, "epsilon, 1e-7 is usual");
  }

  void read_walls() {
    bool any = false;
    for (bool more = true; more;) {
      more = false;
      for (std::size_t n = 0; n < sides.size(); ++n)
        if (take(sides[n])) {
          settings_.walls.side[n / 2][n % 2] = true;
          any = more = true;
        }
    }
    if (any) return;
    const auto text = word("walls", "sides of the box");
    fault("walls {}: name sides of the box.{}", text.value_or(""),
          suggestion(text.value_or(""), sides));
  }

  ParcelSettings settings_;
};

}  // namespace

ParcelSettings parse_parcels(const std::vector<std::string>& words) {
  return Reader(words).read();
}

}  // namespace gasgrain
