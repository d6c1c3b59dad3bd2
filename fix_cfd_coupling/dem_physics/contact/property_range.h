// The properties of a contact model, read from the script and held to their range: each value that
// is outside is told with its types, all of a property at once.
#pragma once

#include <limits>
#include <string>

#include "fix_cfd_coupling/dem_physics/contact/contact_host.h"

namespace gasgrain::contact {

struct PropertyRange {
  const char* name;
  const char* unit;
  double low = 0.0;
  double high = std::numeric_limits<double>::infinity();
  bool above_low = false;  // low itself is outside

  [[nodiscard]] bool holds(double value) const {
    return (above_low ? value > low : value >= low) && value <= high;
  }
  [[nodiscard]] std::string text() const {
    std::string range = fmt::format("{} {}", above_low ? "above" : "from", low);
    if (high < std::numeric_limits<double>::infinity()) range += fmt::format(" to {}", high);
    return *unit != '\0' ? range + " " + unit : range;
  }
};

inline PairTable<double> pairs_in(const ContactHost& host, const PropertyRange& range) {
  const PairTable<double> values = host.need_pairs(range.name, range.unit);
  std::string faults;
  for (int i = 1; i <= host.types(); ++i)
    for (int j = i; j <= host.types(); ++j)
      if (!range.holds(values(i, j)))
        faults += fmt::format("\nproperty {} of types {} and {} is {}; allowed: {}.", range.name, i,
                              j, values(i, j), range.text());
  if (!faults.empty()) host.refuse(faults);
  return values;
}

inline std::vector<double> per_type_in(const ContactHost& host, const PropertyRange& range) {
  const std::vector<double> values = host.need_per_type(range.name, range.unit);
  std::string faults;
  for (int i = 1; i <= host.types(); ++i)
    if (!range.holds(values[i]))
      faults += fmt::format("\nproperty {} of type {} is {}; allowed: {}.", range.name, i,
                            values[i], range.text());
  if (!faults.empty()) host.refuse(faults);
  return values;
}

inline double scalar_in(const ContactHost& host, const PropertyRange& range) {
  const double value = host.need_scalar(range.name, range.unit);
  if (!range.holds(value))
    host.refuse(fmt::format("property {} is {}; allowed: {}.", range.name, value, range.text()));
  return value;
}

// A table of what `make(i, j)` gives for each pair of types.
template <class Make>
auto table_of(int types, Make make) {
  PairTable<decltype(make(1, 1))> table(types);
  for (int i = 1; i <= types; ++i)
    for (int j = 1; j <= types; ++j) table(i, j) = make(i, j);
  return table;
}

// In the names of LIGGGHTS.
namespace properties {

constexpr double no_end = std::numeric_limits<double>::infinity();
inline constexpr PropertyRange youngs_modulus{"youngsModulus", "Pa", 0.0, no_end, true};
inline constexpr PropertyRange poissons_ratio{"poissonsRatio", "", 0.0, 0.5};
inline constexpr PropertyRange restitution{"coefficientRestitution", "", 0.0, 1.0, true};
inline constexpr PropertyRange friction{"coefficientFriction", ""};
inline constexpr PropertyRange rolling_friction{"coefficientRollingFriction", ""};
inline constexpr PropertyRange rolling_damping{"coefficientRollingViscousDamping", ""};
inline constexpr PropertyRange speed{"characteristicVelocity", "m/s", 0.0, no_end, true};
inline constexpr PropertyRange viscosity{"FluidViscosity", "Pa s", 0.0, no_end, true};
inline constexpr PropertyRange critical_stokes{"CriticalStokes", "", 0.0, no_end, true};
inline constexpr PropertyRange greatest_restitution{"MaximumRestitution", "", 0.0, 1.0, true};

}  // namespace properties

}  // namespace gasgrain::contact
