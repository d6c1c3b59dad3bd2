// The standard k-epsilon model, averaged over a cell with its void fraction eps:
//
//   d(eps rho k)/dt + div(F k) = div(eps (mu + mu_t/sigma_k) grad k) + eps (G - rho e)
//   d(eps rho e)/dt + div(F e) = div(eps (mu + mu_t/sigma_e) grad e)
//                                + eps (C_1 G - C_2 rho e) e/k
//   mu_t = C_mu rho k^2 / e,  G = mu_t |S|^2,  F = eps rho u
//
// Source: Launder and Spalding (1974), see launder_spalding.h; |S| in strain_rate.h.
//
// A step takes rate = e/k, mu_t, and G from its beginning, and the sinks as rho rate k and C_2 rho
// rate e of its end (implicit Euler): k and e stay positive at any step without a clamp. In a
// wall's cell k takes the mean production tau_w u / y and the mean dissipation of the wall law, and
// e is given by it; a cell that touches several walls takes the mean over them.
//
// Deviations: G leaves off -2/3 rho k div u, and momentum -2/3 grad(eps rho k), whose part that is
// no gradient is -2/3 rho k grad eps: p stands for p + 2/3 rho k. Turbulence that grains make or
// damp is not modelled. mu_t is cut at 1e5 mu, as is usual, and k and e at values far below any
// flow's; both are counted.
#pragma once

#include "gas_solver/grid/gas_state.h"
#include "gas_solver/operators/quantity.h"
#include "gas_solver/scalars/scalar_equation.h"
#include "gas_solver/turbulence/inflow_turbulence.h"
#include "gas_solver/turbulence/turbulence_report.h"
#include "gas_solver/turbulence/wall_sides.h"

namespace gasgrain {

class KEpsilon {
 public:
  static constexpr bool has_wall_law = true;

  KEpsilon(const Domain& domain, const GasInput& input, Halo& halo);

  // Advances k and e by a step with the velocity at its beginning (layers filled) and the last mass
  // fluxes. Collective.
  TurbulenceReport update(const GasState& state, double step,
                          const std::vector<InflowFace>& inflow);
  [[nodiscard]] const Array3<double>& viscosity() const { return viscosity_; }
  [[nodiscard]] const WallSides& walls() const { return walls_; }

  [[nodiscard]] const Array3<double>& k() const { return k_; }
  [[nodiscard]] const Array3<double>& epsilon() const { return e_; }
  // Of all cells. Collective.
  void set_uniform(const TurbulentValues& values);

  template <class File>
  void exchange_with(File& file) {
    constexpr int of_cells = -1;
    file.field("turbulence_k", of_cells, k_);
    file.field("turbulence_epsilon", of_cells, e_);
  }
  // After k and e were read. Collective.
  void restore(const GasState& state);

 private:
  struct WallCell {
    std::ptrdiff_t cell;
    double per_distance;  // mean over its walls [1/m]
  };
  struct Contact {  // of a cell with one of its walls
    std::ptrdiff_t cell;
    std::size_t wall;
    std::ptrdiff_t place;  // in the wall's layer
    double share;          // of the means over the cell's walls
  };
  void find_walls();
  void set_rates(const GasState& state);
  void set_rates_at_walls(const GasState& state);
  void set_conductance(const GasState& state, double sigma);
  [[nodiscard]] double density(std::ptrdiff_t cell) const {
    return std::visit([&](const auto& rho) { return rho(cell); }, density_);
  }
  void close(TurbulenceReport& report);
  // mu_t and the wall law's coefficients, from k, e and the density.
  void set_viscosity();
  [[nodiscard]] double greatest_viscosity() const;  // of eddies [Pa s]

  const Domain& domain_;
  Halo& halo_;
  double constant_density_;
  Quantity density_ = ConstantQuantity{0};  // the same, or the state's
  double molecular_;                        // [Pa s]
  InflowTurbulence inflow_;
  WallSides walls_;
  ScalarEquation equation_;
  ScalarTerms terms_;
  Array3<double> k_;                  // [m2/s2]
  Array3<double> e_;                  // [m2/s3]
  Array3<double> viscosity_;          // mu + mu_t [Pa s]
  Array3<double> production_;         // G [W/m3]
  Array3<double> rate_;               // of dissipation, e/k or the wall's mean [1/s]
  std::vector<WallCell> wall_cells_;  // none without viscosity
  std::vector<Contact> contacts_;
};

}  // namespace gasgrain
