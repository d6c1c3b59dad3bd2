#include "fix_cfd_coupling/dem_physics/liquid/liquid_settings.h"

#include "coupling/base/word_reader.h"
#include "fix_cfd_coupling/dem_physics/bridge/bridge_faults.h"

namespace gasgrain::liquid {

namespace {

class Reader : WordReader {
 public:
  Reader(const std::vector<std::string>& words, int types) : WordReader(words), types_(types) {}

  LiquidSettings read() {
    read_keywords(keywords());
    check_whole();
    throw_faults("fix liquid");
    tabulate_angles();
    return settings_;
  }

 private:
  Keywords keywords() {
    LiquidSettings& s = settings_;
    return {
        {"content", [&] { s.content = number("content", 0.0, 1.0, "liquid over grain volume"); }},
        {"film", [&] { s.film = volume("film"); }},
        {"surface_tension",
         [&] { s.surface_tension = number("surface_tension", 0.0, 10.0, "N/m, water 0.0728"); }},
        {"contact_angle", [&] { read_angles(); }},
        {"law", [&] { s.law = choice<bridge::BridgeLaw>("law", s.law); }},
        {"division", [&] { s.division = choice<DivisionRule>("division", s.division); }},
        {"viscosity", [&] { s.viscosity = number("viscosity", 0.0, 1e4, "Pa s, water 0.001"); }},
        {"minimum_separation",
         [&] {
           s.minimum_separation = number("minimum_separation", 0.0, 1.0, "m, of the roughness");
           separation_given_ = true;
         }},
        {"formation", [&] { read_formation(); }},
        {"gives", [&] { read_share(); }},
        {"film_min", [&] { s.film_min = volume("film_min"); }},
        {"bridges_max",
         [&] { s.bridges_max = whole("bridges_max", 0, "bridges of a grain, 0: no limit"); }},
        {"wall", [&] { read_wall(); }},
        {"packing",
         [&] { s.packing_void_fraction = number("packing", 1e-3, 0.999, "void fraction"); }},
        {"reach", [&] { s.reach = number("reach", 0.0, 2.0, "in r_i + r_j"); }},
        {"every", [&] { s.every = whole("every", 1, "steps"); }},
        {"output", [&] { s.output = word("output", "a file name").value_or(""); }},
    };
  }

  double volume(std::string_view key) {
    return number(key, 0.0, 1.0, "liquid of a grain in m3, 1e-12 is a cube of 0.1 mm");
  }

  void read_angles() {
    std::vector<double>& angles = settings_.contact_angles;
    angles = numbers();
    for (const double angle : angles)
      if (std::string text = bridge::contact_angle_fault(angle); !text.empty())
        add_fault(std::move(text));
    if (angles.empty() || (angles.size() > 1 && static_cast<int>(angles.size()) != types_))
      fault("contact_angle: give one number for all grain types or one for each of the {}, not {}.",
            types_, angles.size());
  }

  void tabulate_angles() {
    settings_.types = types_;
    for (int i = 0; i < types_; ++i)
      for (int j = 0; j < types_; ++j)
        settings_.angles_between.push_back(
            bridge::contact_angle_of(settings_.contact_angle(i), settings_.contact_angle(j)));
  }

  void read_formation() {
    const auto text = word("formation", "films, touch, or a gap in m");
    if (!text) return;
    if (*text == "films") {
      settings_.formation = Formation::films;
    } else if (*text == "touch") {
      settings_.formation = Formation::touch;
    } else if (const auto gap = as_number(*text); gap && *gap >= 0.0) {
      settings_.formation = Formation::gap;
      settings_.formation_gap = *gap;
    } else {
      fault("formation {}: must be 'films', 'touch', or a gap in m, 0 or more.{}", *text,
            suggestion(*text, {"films", "touch"}));
    }
  }

  void read_share() {
    const auto text = word("gives", "shadow, or a share of the film");
    if (!text || *text == "shadow") return;
    const auto share = as_number(*text);
    if (share && *share > 0.0 && *share <= 1.0)
      settings_.given_share = *share;
    else
      fault("gives {}: must be 'shadow' or a share of the film above 0, at most 1.", *text);
  }

  void read_wall() {
    const auto id = word("wall", "ID of a fix wall/gran");
    const auto area = word("wall", "its area in m2, or 'mesh'");
    if (!id || !area) return;
    WallSetting wall{*id, std::nullopt, 0.0};
    if (*area != "mesh") {
      wall.area = as_number(*area);
      if (!wall.area || !(*wall.area > 0.0))
        fault("wall {} {}: after its ID give its area in m2, above 0, or 'mesh'.", *id, *area);
    }
    if (number_follows()) wall.film = volume("wall " + *id);
    for (const WallSetting& other : settings_.walls)
      if (other.id == wall.id) fault("wall {}: is named twice. Leave out one of the two.", *id);
    settings_.walls.push_back(wall);
  }

  void check_whole() {
    const LiquidSettings& s = settings_;
    if (s.content.has_value() == s.film.has_value())
      fault(
          "{}: write 'content X' (liquid over grain volume, for instance 0.01) or 'film V' "
          "(m3 a grain); 0 for dry grains.",
          s.content ? "content and film are both given" : "there is no liquid");
    if (s.surface_tension < 0.0 && !named("surface_tension"))
      fault("surface_tension is missing: give N/m, 0 or more (water at 20 C: 0.0728).");
    if (s.contact_angles.empty() && !named("contact_angle"))
      fault("contact_angle is missing: give radians from 0 (wetting) to 1.5708.");
    if (named("viscosity") != separation_given_)
      fault(
          "viscosity and minimum_separation belong together: the viscous force of a bridge goes "
          "as viscosity / gap, and ends at the height of the grains' roughness, "
          "minimum_separation [m].");
    else if (separation_given_)
      for (std::string& text : bridge::viscous_faults(s.viscosity, s.minimum_separation))
        add_fault(std::move(text));
  }

  int types_;
  bool separation_given_ = false;
  LiquidSettings settings_;
};

}  // namespace

double LiquidSettings::film_at_first(double radius) const {
  if (film) return *film;
  return content.value_or(0.0) * 4.0 / 3.0 * bridge::pi * radius * radius * radius;
}

LiquidSettings parse_liquid(const std::vector<std::string>& words, int types) {
  return Reader(words, types).read();
}

}  // namespace gasgrain::liquid
