// Contract: what a gas solver lends to the particles and what it takes back, cell by cell.
//
// Fields are named here once; a run moves, stores and computes only those in its FieldSet. Vectors
// take three components. Signs and units are those of the LIST below; all values are means of a
// cell.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace gasgrain {

// Lent by the gas: time means over a coupling interval of what acts on particles.
// Taken by the gas: volume densities of what the particles deposit.
enum class GasField : std::uint8_t {
  void_fraction,      // eps, the sum over all DEM ranks
  velocity,           // u, interstitial
  pressure_gradient,  // grad p
  vorticity,          // curl u
  acceleration,       // Du/Dt = du/dt + u . grad u, along the gas's own path
  viscous_force,      // div tau, with the molecular viscosity
  solids_velocity,    // mean over the solids, sum over all DEM ranks
  sauter_diameter,    // of the cell's grains: six times their volume over their surface
  solid_volume,       // volume of solids in the cell
  solid_flux,         // sum of volume times velocity of the solids in the cell
  solid_surface,      // surface of the solids in the cell
  drag_coefficient,   // sum of K of the particles in the cell, per volume
  drag_source,        // sum of K v, less what the ledger carries, per volume
};

struct GasFieldInfo {
  GasField field;
  std::string_view name;
  int components;
  std::string_view unit;
  bool lent;  // gas to particles (else particles to gas)
};

inline constexpr std::array<GasFieldInfo, 13> gas_field_list{{
    {GasField::void_fraction, "void_fraction", 1, "1", true},
    {GasField::velocity, "velocity", 3, "m/s", true},
    {GasField::pressure_gradient, "pressure_gradient", 3, "Pa/m", true},
    {GasField::vorticity, "vorticity", 3, "1/s", true},
    {GasField::acceleration, "acceleration", 3, "m/s2", true},
    {GasField::viscous_force, "viscous_force", 3, "N/m3", true},
    {GasField::solids_velocity, "solids_velocity", 3, "m/s", true},
    {GasField::sauter_diameter, "sauter_diameter", 1, "m", true},
    {GasField::solid_volume, "solid_volume", 1, "m3", false},
    {GasField::solid_flux, "solid_flux", 3, "m4/s", false},
    {GasField::solid_surface, "solid_surface", 1, "m2", false},
    {GasField::drag_coefficient, "drag_coefficient", 1, "kg/(m3 s)", false},
    {GasField::drag_source, "drag_source", 3, "N/m3", false},
}};

constexpr const GasFieldInfo& info(GasField field) {
  return gas_field_list[static_cast<std::size_t>(field)];
}

// A set of fields as a bit mask.
class FieldSet {
 public:
  constexpr FieldSet() = default;
  constexpr explicit FieldSet(std::uint32_t bits) : bits_(bits) {}
  constexpr FieldSet& add(GasField field) {
    bits_ |= 1U << static_cast<unsigned>(field);
    return *this;
  }
  [[nodiscard]] constexpr bool has(GasField field) const {
    return (bits_ >> static_cast<unsigned>(field) & 1U) != 0;
  }
  [[nodiscard]] constexpr std::uint32_t bits() const { return bits_; }
  [[nodiscard]] constexpr FieldSet united(FieldSet other) const {
    return FieldSet(bits_ | other.bits_);
  }
  [[nodiscard]] constexpr FieldSet common(FieldSet other) const {
    return FieldSet(bits_ & other.bits_);
  }
  [[nodiscard]] constexpr FieldSet without(FieldSet other) const {
    return FieldSet(bits_ & ~other.bits_);
  }

 private:
  std::uint32_t bits_ = 0;
};

// A coupling has two stages: first the solids are taken and what depends on them alone is lent,
// then everything else.
inline constexpr FieldSet lent_early = FieldSet()
                                           .add(GasField::void_fraction)
                                           .add(GasField::solids_velocity)
                                           .add(GasField::sauter_diameter);
inline constexpr FieldSet taken_early =
    FieldSet().add(GasField::solid_volume).add(GasField::solid_flux).add(GasField::solid_surface);

}  // namespace gasgrain
