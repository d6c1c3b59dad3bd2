// Implicit transport of a scalar phi that the gas carries, in cells, per volume of a cell:
//
//   m (phi - phi_n)/dt + sum over the six sides of F_in (phi - phi_up) / h
//     = div(Gamma grad phi) + source - sink phi
//
// m = eps rho is the mass that carries phi, F_in >= 0 the mass flux that enters through a side and
// phi_up what it brings; Gamma of a face is the mean of its two cells. The form is that of momentum
// (momentum/assembly.h): the conservative one less phi [dm/dt + div F], the same while the fluxes
// obey continuity, and a uniform phi is its solution whatever eps does.
//
// phi_up is first-order upwind and implicit; "limited" adds van Leer's correction from phi_n. All
// coefficients are positive for any step. A correction that takes away could still overdraw a cell
// at a high Courant number: for a scalar that must stay positive the loss is taken as loss phi /
// phi_n (Patankar 1980, section 7.2-2), which is the same once the field is steady.
//
// The system is solved by Gauss-Seidel sweeps forth and back, as in momentum/predictor.h.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "gas_solver/boundary/inflow.h"
#include "gas_solver/boundary/kinds.h"
#include "gas_solver/grid/halo.h"

namespace gasgrain {

// One equation: phi = inverse_diagonal * (source + sum of coefficient * phi of the neighbour).
struct alignas(64) ScalarRow {
  std::array<double, 6> coefficient;  // x lo, x hi, y lo, ... (the numbering of sides)
  double source;
  double inverse_diagonal;
};

// Fields over Domain::box(). The layers around the own cells matter for `conductance` alone.
struct ScalarTerms {
  explicit ScalarTerms(const IndexBox& box) : mass(box), conductance(box), source(box), sink(box) {}
  Array3<double> mass;         // m [kg/m3]
  Array3<double> conductance;  // Gamma, eps included [kg/(m s)]
  Array3<double> source;       // >= 0 where phi must stay positive [kg/(m3 s) phi]
  Array3<double> sink;         // >= 0 [kg/(m3 s)]
};

// What the sides do. Without a value of its own a side lets nothing through by conduction.
struct ScalarBoundary {
  const std::vector<InflowFace>* inflow = nullptr;    // faces of inflow, with
  const std::vector<double>* inflow_value = nullptr;  // what the gas brings through each of them
  double outside = 0;                                 // what comes back through an outlet
  std::array<std::optional<double>, side_count> side_value;
};

struct ScalarChoices {
  bool limited = true;
  bool positive = false;
  double tolerance = 1e-6;
};

struct ScalarReport {
  int sweeps = 0;  // pairs
  bool converged = false;
};

class ScalarEquation {
 public:
  ScalarEquation(const Domain& domain, Halo& halo, const ScalarChoices& choices);

  // `before` is phi at the step's beginning, its layers filled.
  void assemble(const ScalarTerms& terms, const std::array<Array3<double>, 3>& mass_flux,
                double step, const Array3<double>& before, const ScalarBoundary& boundary);
  // Gives the value of an own cell, after assemble().
  void fix(std::ptrdiff_t cell, double value);
  // Starts from what phi holds and fills its layers. A sweep's greatest change ends the sweeps:
  // relative to the cell's own value where phi is positive, else to the greatest |phi|. Collective.
  ScalarReport solve(Array3<double>& phi);

 private:
  void limited_gain(const std::array<Array3<double>, 3>& mass_flux, const Array3<double>& phi);
  void close_sides(const ScalarTerms& terms, const std::array<Array3<double>, 3>& mass_flux,
                   const ScalarBoundary& boundary);
  struct Change {
    double greatest = 0;  // |change| of a cell
    double scale = 0;     // greatest |phi|
    double excess = -1;   // greatest of |change| - tolerance |phi| of a cell
  };
  Change sweep(Array3<double>& phi, bool forth) const;

  const Domain& domain_;
  Halo& halo_;
  ScalarChoices choices_;
  Vec3 spacing_;
  std::vector<int> axes_;  // those along which neighbours differ
  Array3<ScalarRow> rows_;
  Array3<double> addition_;  // of the limiter to a flux, per h
  Array3<double> gain_;      // of a cell by these
};

}  // namespace gasgrain
