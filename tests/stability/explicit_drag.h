// The naive way to couple drag, as a negative control: both sides feel K (u - v) of the beginning
// of the step. Void fraction, weights, drag law and gas are the product's; only that drag is
// implicit nowhere. It is stable while K T (1 / m + 1 / m_gas) is below 2.
#pragma once

#include "tests/stability/coupled_bed.h"

namespace gasgrain::stability {

class ExplicitBed {
 public:
  ExplicitBed(const GasInput& input, const std::string& effects, double step, Cloud grains)
      : cloud(std::move(grains)),
        effects_(parse_effects(words_of(effects), "test")),
        properties_{input.density, input.viscosity},
        step_(step),
        gas_(input, self()),
        records_(effects_.layout(false)) {
    records_.resize(cloud.radius.size());
  }

  Cloud cloud;

  // Grains within the box, which do not come near a periodic side.
  void advance() {
    const IndexBox& own = gas_.own();
    const double cell = gas_.grid().cell_volume();
    weights_.find(cloud.view(), effects_.method, whole_frame(gas_.grid(), effects_.method));
    FieldStore tile(effects_.lent().united(effects_.taken()), weights_.tile());
    deposit_solid_volume(cloud.view(), weights_, tile.scalar(GasField::solid_volume));
    const Array3<double> solids = wrapped(tile.scalar(GasField::solid_volume), gas_.grid());
    Array3<double> eps(own);
    for (std::size_t n = 0; n < eps.size(); ++n) eps[n] = 1.0 - solids[n] / cell;
    gas_.set_void_fraction(eps);
    unwrap(eps, tile.scalar(GasField::void_fraction));
    const CellVector u = gas_.cell_velocity();
    for (int d = 0; d < 3; ++d) unwrap(u[d], tile.vector(GasField::velocity)[d]);
    refresh_drag(cloud.view(), weights_, effects_, properties_, tile, records_);
    VectorField on_gas = make_vector_field(weights_.tile());
    weights_.deposit(
        [&](std::size_t p) -> Vec3 {
          return records_.K(p) / cell * (cloud.view().v(p) - records_.u(p));
        },
        on_gas);
    CellVector source;
    for (int d = 0; d < 3; ++d) source[d] = wrapped(on_gas[d], gas_.grid());
    gas_.set_drag(Array3<double>(own), source);
    gas_.advance(step_);
    for (std::size_t p = 0; p < cloud.radius.size(); ++p)
      for (int d = 0; d < 3; ++d) {
        double& v = cloud.velocity[3 * p + d];
        v += step_ * records_.K(p) / cloud.mass[p] * (records_.u(p)[d] - v);
      }
  }

  [[nodiscard]] const GasSolver& gas() const { return gas_; }
  [[nodiscard]] double fastest_grain() const {
    double speed = 0;
    for (std::size_t p = 0; p < cloud.radius.size(); ++p)
      speed = std::max(speed, cloud.view().v(p).norm());
    return speed;
  }

 private:
  void unwrap(const Array3<double>& own, Array3<double>& tile) const {
    const Int3& n = gas_.grid().cells;
    for_each_cell(tile.box(), [&](int i, int j, int k) {
      tile(i, j, k) =
          own(((i % n[0]) + n[0]) % n[0], ((j % n[1]) + n[1]) % n[1], ((k % n[2]) + n[2]) % n[2]);
    });
  }

  Effects effects_;
  GasProperties properties_;
  double step_;
  GasSolver gas_;
  ParticleWeights weights_;
  ExchangeRecords records_;
};

}  // namespace gasgrain::stability
