#include "tools/advise_effects.h"

#include <algorithm>
#include <map>

#include "coupling/base/error.h"
#include "coupling/exchange/effect_sizes/sizes.h"

namespace gasgrain {
namespace {

std::string on_off(bool on) {
  return on ? "on" : "off";
}

template <class Chosen>
bool has_force(const Effects& effects) {
  return std::any_of(effects.forces.begin(), effects.forces.end(),
                     [](const Force& force) { return std::holds_alternative<Chosen>(force); });
}

std::string convection_name(const GasInput& gas) {
  return std::string(convection_names[static_cast<std::size_t>(gas.convection)]);
}

// Now and advised, one overload an effect; of a force by its size alone.
class Chooser {
 public:
  Chooser(const AdviseScene& scene, const Places& places, EffectRow& row)
      : scene_(scene), effects_(scene.couple.effects), places_(places), row_(row) {}

  template <class Chosen>
  void choose(SizeOf<Chosen>) {
    set(has_force<Chosen>(effects_), needed());
    if (std::is_same_v<Chosen, ForceBasset>) row_.note = "an upper bound above Re = 1";
  }
  void choose(SizeDrag) { set(effects_.drag.has_value(), true); }
  void choose(SizePolydisperse) { set(effects_.drag && effects_.polydisperse, needed()); }
  void choose(SizeSelfDisturbance) {
    set(!effects_.ignore_self_disturbance, true);
    row_.note = "the default; in a bed it is nothing and costs nothing";
  }
  void choose(SizeMomentumSharing) {
    row_.now = std::string(name_of(effects_.sharing));
    row_.advised = std::string(SharingScheme3::name);
    row_.note = "of what scheme_1 and scheme_2 get wrong";
  }
  void choose(SizeOverlapped) {
    const bool on = scene_.couple.mode == "overlapped";
    set(on, on && !needed());
    row_.note = "of its error; it saves waiting only";
  }
  void choose(SizeRotation) { of_contacts(scene_.rotates); }
  void choose(SizeTangentialHistory) { of_contacts(scene_.contacts.tangential == "history"); }
  void choose(SizeSmagorinsky) {
    const bool cross = resolved();
    set(turbulence() == TurbulenceModel::smagorinsky, turbulent() && cross);
    row_.note = cross ? "the grid has 10 cells or more across the flow: large eddies are resolved"
                      : "the grid has less than 10 cells across the flow: no large eddies on it";
  }
  void choose(SizeKEpsilon) {
    set(turbulence() == TurbulenceModel::k_epsilon, turbulent() && !resolved());
  }
  void choose(SizeIdealGas) { set(scene_.gas.law == GasLaw::ideal_gas, needed()); }
  void choose(SizeModelB) {
    row_.now = scene_.gas.model == GasModel::b ? "B" : "A";
    row_.advised = "A";
    row_.note = "of what B leaves out; A is the derived one";
  }
  void choose(SizeConvection) {
    row_.now = convection_name(scene_.gas);
    const bool first_order = scene_.gas.convection == Convection::upwind;
    row_.advised = first_order && needed() ? "tvd" : row_.now;
    row_.note = "of what upwind would add";
  }
  void choose(SizeDepthCorrection) { set(scene_.gas.plane_of_spheres > 0.0, needed()); }
  // Dry and uncharged grains want neither, and whether they are the script does not say.
  // Parcels touch nothing.
  void choose(SizeLiquidBridge) { of_cohesion("bridge", "; if the grains were wet", false); }
  void choose(SizeElectrostatics) {
    of_cohesion("electrostatic", "; at the greatest charge", false);
  }
  void choose(SizeVanDerWaals) { of_cohesion("van_der_waals", "", needed()); }
  void choose(SizeLubrication) {
    if (scene_.parcels) return without_contacts();
    row_.now = "absent";
    row_.advised = needed() ? "wanted" : "absent";
    row_.note = "not in this version";
    row_.price = "none: absent";
  }

 private:
  void without_contacts() {
    set(false, false);
    row_.note = "parcels have no contacts";
  }
  void of_cohesion(const std::string& model, const std::string& condition, bool wanted) {
    if (scene_.parcels) return without_contacts();
    const bool now = scene_.contacts.cohesion == model;
    set(now, now || wanted);
    row_.note = "cohesion " + model + condition;
  }
  void set(bool now, bool advised) {
    row_.now = on_off(now);
    row_.advised = on_off(advised);
  }
  // Of grains that do not move neither matters.
  void of_contacts(bool now) {
    if (scene_.parcels) return without_contacts();
    set(now, scene_.moves ? needed() : now);
  }
  [[nodiscard]] bool needed() const { return row_.needed; }
  [[nodiscard]] TurbulenceModel turbulence() const { return scene_.gas.turbulence.model; }
  // By the mean flow's stress, whichever model stands for it.
  [[nodiscard]] bool turbulent() const {
    return std::any_of(places_.list.begin(), places_.list.end(), [](const Place& place) {
      return share_of_motion(place.scales, SizeKEpsilon::force(place.scales)) >= needed_share;
    });
  }
  // Half widths of the narrowest flow that is turbulent.
  [[nodiscard]] bool resolved() const {
    constexpr double cells_across = 10.0;
    const Scales& last = places_.list.back().scales;
    return 2.0 * last.gas_length >= cells_across * last.cell;
  }

  const AdviseScene& scene_;
  const Effects& effects_;
  const Places& places_;
  EffectRow& row_;
};

}  // namespace

std::vector<EffectRow> effect_rows(const AdviseScene& scene, const Places& places) {
  std::vector<EffectRow> rows;
  for_each_size([&](auto size) {
    EffectRow row;
    row.name = size.name;
    row.number_name = size.number_name;
    row.threshold = size.threshold;
    for (const Place& place : places.list) {
      const double force = size.force(place.scales);
      row.sizes.push_back({ratio(force, place.scales.weight()), ratio(force, place.scales.drag)});
      const double share = share_of_motion(place.scales, force);
      if (row.sizes.size() == 1 || share > row.share) row.number = size.number(place.scales);
      row.share = std::max(row.share, share);
      row.needed = row.needed || is_needed<decltype(size)>(place.scales, force);
    }
    row.price = effect_price(row.name);
    Chooser(scene, places, row).choose(size);
    rows.push_back(std::move(row));
  });
  return rows;
}

std::string effect_price(const std::string& name) {
  // ns a grain and DEM step, and their share of the 356 ns of a DEM step of the spouted bed.
  static const std::map<std::string, std::string> prices{
      {"liquid bridges", "50 to 75 % of the grains' part"},
      {"van der Waals", "25 % of the grains' part"},
      {"drag", "10 ns (3 %)"},
      {"pressure_gradient", "0 ns"},
      {"viscous_stress", "2 ns, gas 13 %*"},
      {"virtual_mass", "16 ns (5 %), gas 13 %*"},
      {"basset", "52 ns (15 %), gas 13 %*"},
      {"saffman_mei", "44 ns (12 %), gas 13 %*"},
      {"magnus", "30 ns (8 %), gas 13 %*"},
      {"rotation_torque", "38 ns (11 %), gas 13 %*"},
      {"lorentz", "14 ns (4 %)"},
      {"turbulence smagorinsky", "gas 3 %"},
      {"turbulence k_epsilon", "gas 50 %"},
      {"law ideal_gas", "gas 0 %"},
      {"convection", "gas 30 % over upwind"},
      {"mode overlapped", "-1 % of the run"},
      {"momentum_sharing", "the default"},
      {"self_disturbance", "the default"},
      {"polydisperse", "2 fields a coupling"},
      {"tangential history", "gasgrain study contact-model"},
      {"model B", "0"},
      {"plane_of_spheres", "0"},
  };
  const auto found = prices.find(name);
  return found == prices.end() ? "not measured" : found->second;
}

}  // namespace gasgrain
