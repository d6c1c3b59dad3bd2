// Inflow through patches of the sides, which may be smaller than a face.
//
// A patch is clear of grains (its void fraction is 1): it lets the mass flux rho f U through a face
// of which it covers the fraction f at the velocity U, and this mass carries the TRUE velocity U,
// not f U. A nozzle smaller than a cell hence brings its mass flow m and its momentum m U both in
// full; a face that only knew f U would bring f m U and lose most of a thin jet's momentum.
//
// The fractions are exact areas, scaled so that they sum to the patch's area: the mass flow is the
// one asked for. A patch may start with a ramp, linear in time from 0.
#pragma once

#include <vector>

#include "gas_solver/boundary/inflow_shape.h"
#include "gas_solver/grid/domain.h"

namespace gasgrain {

struct InflowPatch {
  int side = 0;
  Outline outline;
  double velocity = 0;  // true velocity into the domain [m/s]
  double ramp = 0;      // time until it is reached [s]
};

// What the patches bring through one face.
struct InflowFace {
  int side = 0;
  Int3 face{0, 0, 0};
  double volume_flux = 0;    // sum of f U, positive INTO the domain [m/s]
  double momentum_flux = 0;  // sum of f U |U| [m2/s2], positive into the domain
};

class Inflow {
 public:
  Inflow(const Domain& domain, std::vector<InflowPatch> patches);

  // The faces of this rank at a time; the same faces in the same order always.
  [[nodiscard]] const std::vector<InflowFace>& at(double time);
  // The greatest Courant number per time, f U / h, of this rank's faces [1/s].
  [[nodiscard]] double courant_rate(double time);

 private:
  struct Part {  // of a patch
    std::size_t face;
    std::size_t patch;
    double fraction;
  };
  const Domain& domain_;
  std::vector<InflowPatch> patches_;
  std::vector<Part> parts_;
  std::vector<InflowFace> faces_;
};

// The outline of a whole side, and of a face of it.
Rectangle side_rectangle(const BoxGrid& grid, int side);

}  // namespace gasgrain
