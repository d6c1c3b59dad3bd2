// What is wrong with the numbers of a bridge, in words; empty when nothing is. The caller adds
// where the number was written.
#pragma once

#include <cmath>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "fix_cfd_coupling/dem_physics/bridge/liquid_bridge.h"

namespace gasgrain::bridge {

namespace detail {
inline std::string fault(std::string_view key, double value, std::string_view allowed) {
  std::ostringstream text;
  text << key << " = " << value << " is not allowed: " << allowed;
  return text.str();
}
}  // namespace detail

// Of one partner's contact angle, before the two are averaged.
inline std::string contact_angle_fault(double angle) {
  if (angle >= 0.0 && angle <= 0.5 * pi) return {};
  std::ostringstream allowed;
  allowed << "give radians from 0 (wetting) to 1.5708.";
  if (angle > 0.5 * pi && angle <= 90.0)
    allowed << " If it is in degrees, write " << angle * pi / 180.0 << ".";
  return detail::fault("contact_angle", angle, allowed.str());
}

inline std::vector<std::string> bridge_faults(const LiquidBridge& b) {
  std::vector<std::string> faults;
  const auto need = [&](bool good, std::string_view key, double value, std::string_view allowed) {
    if (!good) faults.push_back(detail::fault(key, value, allowed));
  };
  need(std::isfinite(b.radius) && b.radius > 0.0, "radius", b.radius,
       "give the grain's radius in m, above 0.");
  if (std::string text = contact_angle_fault(b.contact_angle); !text.empty())
    faults.push_back(std::move(text));
  need(std::isfinite(b.surface_tension) && b.surface_tension >= 0.0, "surface_tension",
       b.surface_tension, "give N/m, 0 or more (water at 20 C: 0.0728).");
  need(std::isfinite(b.volume) && b.volume >= 0.0, "volume", b.volume,
       "give the liquid in m3, 0 or more (0: dry).");
  return faults;
}

inline std::vector<std::string> viscous_faults(double viscosity, double minimum_separation) {
  std::vector<std::string> faults;
  if (!(std::isfinite(viscosity) && viscosity >= 0.0))
    faults.push_back(
        detail::fault("viscosity", viscosity, "give Pa s, 0 or more (water at 20 C: 0.001)."));
  if (!(std::isfinite(minimum_separation) && minimum_separation > 0.0))
    faults.push_back(detail::fault("minimum_separation", minimum_separation,
                                   "give m, above 0: the height of the grains' roughness; without "
                                   "it the viscous force at contact is infinite."));
  return faults;
}

}  // namespace gasgrain::bridge
