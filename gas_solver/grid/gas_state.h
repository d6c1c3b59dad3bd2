// The fields the gas solver advances. All lie over Domain::box(); SI units.
//
// Fields that only some choices of gas.toml need are empty without them: they cost nothing then.
#pragma once

#include <array>

#include "gas_solver/grid/domain.h"

namespace gasgrain {

using CellVector = std::array<Array3<double>, 3>;

inline CellVector make_vector(const IndexBox& box) {
  return {Array3<double>(box), Array3<double>(box), Array3<double>(box)};
}

struct GasState {
  explicit GasState(const IndexBox& box)
      : void_fraction(box, 1.0),
        void_fraction_before(box, 1.0),
        drag_coefficient(box),
        drag_source(make_vector(box)),
        pressure(box),
        velocity(make_vector(box)),
        mass_flux(make_vector(box)) {}

  // Cells.
  Array3<double> void_fraction;         // eps at the end of the step of time
  Array3<double> void_fraction_before;  // eps at its beginning
  Array3<double> void_fraction_middle;  // their mean; Crank-Nicolson
  Array3<double> drag_coefficient;      // K [kg/(m3 s)]
  CellVector drag_source;               // S [N/m3]
  Array3<double> mass_source;           // S_m [kg/(m3 s)]; where a scene has sources of gas
  Array3<double> pressure;              // p less that of gas at rest [Pa], see hydrostatic.h
  Array3<double> density;               // rho [kg/m3]; ideal gas
  Array3<double> density_before;        // at the step's beginning
  // Faces.
  CellVector velocity;          // u, interstitial [m/s]
  CellVector mass_flux;         // eps rho u [kg/(m2 s)]
  CellVector mass_flux_before;  // at the step's beginning; Crank-Nicolson
  CellVector mass_flux_middle;  // at its middle; Crank-Nicolson

  // What the momentum balance of a step takes as its void fraction and its convecting fluxes.
  [[nodiscard]] const Array3<double>& momentum_void_fraction() const {
    return void_fraction_middle.size() > 0 ? void_fraction_middle : void_fraction;
  }
  [[nodiscard]] const CellVector& convecting_flux() const {
    return mass_flux_middle[0].size() > 0 ? mass_flux_middle : mass_flux;
  }
};

// Value at the face between the cell at `o` and the one before it, `s` offsets away.
inline double face_mean(const Array3<double>& cells, std::ptrdiff_t o, std::ptrdiff_t s) {
  return 0.5 * (cells[o - s] + cells[o]);
}

}  // namespace gasgrain
