// Inflow through patches of the sides, which may be smaller than a face.
//
// A patch is clear of grains (its void fraction is 1): it lets the mass flux rho f U through a face
// of which it covers the fraction f at the velocity U, and this mass carries the TRUE velocity U,
// not f U. A nozzle smaller than a cell hence brings its mass flow m and its momentum m U both in
// full; a face that only knew f U would bring f m U and lose most of a thin jet's momentum.
//
// The fractions are exact areas, scaled so that they sum to the patch's area: the mass flow is the
// one asked for. A patch may start with a ramp, linear in time from 0, or follow a
// table in time.
#pragma once

#include <vector>

#include "coupling/base/array3.h"
#include "gas_solver/boundary/inflow_shape.h"
#include "gas_solver/grid/domain.h"

namespace gasgrain {

struct InflowPatch {
  int side = 0;
  Outline outline;
  double velocity = 0;  // true velocity into the domain [m/s]
  double ramp = 0;      // time until it is reached [s]
  // Or, instead of the velocity, the mass flow of the whole patch [kg/s]; 0: by velocity.
  double mass_flow = 0;
  // Or, instead of the ramp, a table of factors in time, linear between its lines and constant
  // beyond them; empty: none.
  std::vector<double> table_times;    // [s]
  std::vector<double> table_factors;  // of velocity or mass_flow

  // What ramp or table make of the strength at a time.
  [[nodiscard]] double factor(double time) const;
  // Before the factor, of gas of a density [kg/m3]: [m/s].
  [[nodiscard]] double full_velocity(double density) const {
    return mass_flow > 0 ? mass_flow / (density * outline.area()) : velocity;
  }
};

// What the patches bring through one face.
struct InflowFace {
  int side = 0;
  Int3 face{0, 0, 0};
  // Positive INTO the domain.
  double volume_flux = 0;    // sum of f U [m/s]
  double mass_flux = 0;      // sum of rho f U [kg/(m2 s)]
  double momentum_flux = 0;  // sum of rho f U^2 [Pa]
};

class Inflow {
 public:
  Inflow(const Domain& domain, std::vector<InflowPatch> patches, double constant_density);

  // The faces of this rank at a time; the same faces in the same order always. The gas of a patch
  // has the density of the cell it enters: `density`, or where that is empty the constant one.
  const std::vector<InflowFace>& at(double time, const Array3<double>& density);
  // The greatest Courant number per time, f U / h, of the faces of the last at() [1/s].
  [[nodiscard]] double courant_rate() const;

 private:
  struct Part {  // of a patch
    std::size_t face;
    std::size_t patch;
    double fraction;
  };
  const Domain& domain_;
  std::vector<InflowPatch> patches_;
  double constant_density_;
  std::vector<Part> parts_;
  std::vector<InflowFace> faces_;
};

// The outline of a whole side, and of a face of it.
Rectangle side_rectangle(const BoxGrid& grid, int side);
Rectangle face_rectangle(const BoxGrid& grid, int side, const Int3& face);

}  // namespace gasgrain
