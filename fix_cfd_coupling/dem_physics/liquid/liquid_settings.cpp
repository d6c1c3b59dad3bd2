#include "fix_cfd_coupling/dem_physics/liquid/liquid_settings.h"

#include <cmath>
#include <cstdlib>
#include <functional>
#include <map>

#include "coupling/base/choice_list.h"
#include "coupling/base/error.h"
#include "fix_cfd_coupling/dem_physics/bridge/bridge_faults.h"

namespace gasgrain::liquid {

namespace {

std::optional<double> as_number(const std::string& word) {
  char* end = nullptr;
  const double value = std::strtod(word.c_str(), &end);
  if (word.empty() || *end != '\0') return std::nullopt;
  return value;
}

class Reader {
 public:
  Reader(const std::vector<std::string>& words, int types) : words_(words), types_(types) {}

  LiquidSettings read() {
    const std::map<std::string, std::function<void()>> keywords = this->keywords();
    std::vector<std::string> names;
    for (const auto& [name, action] : keywords) names.push_back(name);
    while (at_ < words_.size()) {
      const std::string word = words_[at_++];
      if (const auto found = keywords.find(word); found != keywords.end())
        found->second();
      else
        fault("\"{}\" is no keyword.{}", word, suggestion(word, names));
    }
    check_whole();
    if (faults_.empty()) {
      tabulate_angles();
      return settings_;
    }
    std::string text = "fix liquid cannot be used:";
    for (const std::string& one : faults_) text += "\n  " + one;
    throw Error(text);
  }

 private:
  template <class... Args>
  void fault(fmt::format_string<Args...> text, Args&&... args) {
    faults_.push_back(fmt::format(text, std::forward<Args>(args)...));
  }

  std::map<std::string, std::function<void()>> keywords() {
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

  std::optional<std::string> word(std::string_view key, std::string_view what) {
    if (at_ < words_.size()) return words_[at_++];
    fault("{}: its value is missing: {}.", key, what);
    return std::nullopt;
  }

  double number(std::string_view key, double low, double high, std::string_view what) {
    const auto text = word(key, what);
    if (!text) return 0.0;
    const auto value = as_number(*text);
    if (!value) {
      fault("{} {}: must be a number ({}).", key, *text, what);
      return 0.0;
    }
    if (!(*value >= low && *value <= high))
      fault("{} {}: must be from {} to {} ({}).", key, *text, low, high, what);
    return *value;
  }

  double volume(std::string_view key) {
    return number(key, 0.0, 1.0, "liquid of a grain in m3, 1e-12 is a cube of 0.1 mm");
  }

  int whole(std::string_view key, int least, std::string_view what) {
    const double value = number(key, least, 1e9, what);
    if (value != std::floor(value)) fault("{} {}: must be a whole number.", key, value);
    return static_cast<int>(value);
  }

  template <class List>
  List choice(std::string_view key, const List& before) {
    const auto names = choice_names<List>();
    const auto name = word(key, fmt::format("one of {}", fmt::join(names, ", ")));
    if (!name) return before;
    if (const auto found = choice_named<List>(*name)) return *found;
    fault("{} \"{}\" is unknown.{}", key, *name, suggestion(*name, names));
    return before;
  }

  void read_angles() {
    std::vector<double>& angles = settings_.contact_angles;
    angles.clear();
    for (; at_ < words_.size(); ++at_) {
      const auto value = as_number(words_[at_]);
      if (!value) break;
      angles.push_back(*value);
      if (std::string text = bridge::contact_angle_fault(*value); !text.empty())
        faults_.push_back(std::move(text));
    }
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
    if (at_ < words_.size() && as_number(words_[at_])) wall.film = volume("wall " + *id);
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
        faults_.push_back(std::move(text));
  }

  [[nodiscard]] bool named(std::string_view key) const {
    for (const std::string& one : words_)
      if (one == key) return true;
    return false;
  }

  const std::vector<std::string>& words_;
  int types_;
  std::size_t at_ = 0;
  bool separation_given_ = false;
  LiquidSettings settings_;
  std::vector<std::string> faults_;
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
