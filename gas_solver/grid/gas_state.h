// The fields the gas solver advances. All lie over Domain::box(); SI units.
#pragma once

#include <array>

#include "gas_solver/grid/domain.h"

namespace gasgrain {

using CellVector = std::array<Array3<double>, 3>;

struct GasState {
  explicit GasState(const IndexBox& box)
      : void_fraction(box, 1.0),
        void_fraction_before(box, 1.0),
        drag_coefficient(box),
        pressure(box) {
    for (int d = 0; d < 3; ++d) drag_source[d] = velocity[d] = mass_flux[d] = Array3<double>(box);
  }

  // Cells.
  Array3<double> void_fraction;               // eps at the end of the step of time
  Array3<double> void_fraction_before;        // eps at its beginning
  Array3<double> drag_coefficient;            // K [kg/(m3 s)]
  std::array<Array3<double>, 3> drag_source;  // S [N/m3]
  Array3<double>
      pressure;  // p minus the hydrostatic pressure of gas at rest [Pa], see hydrostatic.h
  // Faces.
  std::array<Array3<double>, 3> velocity;   // u, interstitial [m/s]
  std::array<Array3<double>, 3> mass_flux;  // eps rho u [kg/(m2 s)]
};

// Value at the face between the cell at `o` and the one before it, `s` offsets away.
inline double face_mean(const Array3<double>& cells, std::ptrdiff_t o, std::ptrdiff_t s) {
  return 0.5 * (cells[o - s] + cells[o]);
}

}  // namespace gasgrain
