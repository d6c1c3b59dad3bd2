#include "coupling/audit.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "coupling/base/listed.h"
#include "coupling/exchange/effect_sizes/sizes.h"

namespace gasgrain {
namespace {

// The gas about a grain, from the cells' velocities.
struct Surroundings {
  Eigen::Matrix3d gradient = Eigen::Matrix3d::Zero();  // d u_i / d x_j [1/s]
  Vec3 laplacian = Vec3::Zero();                       // [1/(m s)]

  [[nodiscard]] Vec3 vorticity() const {
    return {gradient(2, 1) - gradient(1, 2), gradient(0, 2) - gradient(2, 0),
            gradient(1, 0) - gradient(0, 1)};
  }
};

// Differences between the cell's neighbours, one-sided at the end of the tile.
Surroundings surroundings(const VectorField& u, const Int3& cell, const Vec3& h) {
  Surroundings about;
  const IndexBox& box = u[0].box();
  const std::ptrdiff_t here = u[0].offset(cell[0], cell[1], cell[2]);
  for (int d = 0; d < 3; ++d) {
    const std::ptrdiff_t step = u[0].stride(d);
    const std::ptrdiff_t below = here - (cell[d] > box.lo[d] ? step : 0);
    const std::ptrdiff_t above = here + (cell[d] + 1 < box.hi[d] ? step : 0);
    if (above == below) continue;
    const double distance = static_cast<double>((above - below) / step) * h[d];
    const bool both_sides = above - below == 2 * step;
    for (int i = 0; i < 3; ++i) {
      const double* value = u[i].data();
      about.gradient(i, d) = (value[above] - value[below]) / distance;
      if (both_sides)
        about.laplacian[i] += (value[above] - 2.0 * value[here] + value[below]) / (h[d] * h[d]);
    }
  }
  return about;
}

Vec3 at_cell(const VectorField& field, const Int3& cell) {
  return {field[0](cell[0], cell[1], cell[2]), field[1](cell[0], cell[1], cell[2]),
          field[2](cell[0], cell[1], cell[2])};
}

constexpr double atmosphere = 101325.0;  // [Pa]; the gas's own pressure is not lent

void raise(double& greatest, double value) {
  greatest = std::max(greatest, value);
}

}  // namespace

Audit::Audit(const Effects& effects) : effects_(effects) {
  for_each_audited_size([&](auto size) {
    seen_.push_back({std::string(size.name), 0.0, 0.0, 0.0});
  });
}

void Audit::take(const Scales& at) {
  std::size_t n = 0;
  const double reference = std::max(at.weight(), at.drag);
  for_each_audited_size([&](auto size) {
    const double force = size.force(at);
    Seen& seen = seen_[n++];
    seen.force += force;
    if (is_needed<decltype(size)>(at, force)) seen.needed += 1.0;
    if (force > seen.greatest * reference) seen.greatest = ratio(force, reference);
  });
  raise(extremes_.slip, at.slip);
  raise(extremes_.speed, at.speed);
  raise(extremes_.spin, at.spin);
  raise(extremes_.vorticity, at.vorticity);
  raise(extremes_.gas_acceleration, at.gas_acceleration);
  raise(extremes_.reynolds, at.reynolds());
  grains_ += 1.0;
  drag_ += at.drag;
  weight_ += at.weight();
}

void Audit::look(const ParticleView& particles, const ExchangeRecords& records,
                 const FieldStore& fields, const TileFrame& frame, const AuditSetting& setting) {
  ++couplings_;
  const RecordLayout& layout = records.layout();
  const Vec3 h = frame.grid.spacing();
  gas_known_ = fields.has(GasField::velocity);
  const bool eps_known = fields.has(GasField::void_fraction);
  Scales common;
  common.gravity = setting.gravity;
  common.gas_density = setting.gas.density;
  common.viscosity = setting.gas.viscosity;
  common.cell = std::cbrt(frame.grid.cell_volume());
  common.interval = setting.interval;
  common.depth = frame.grid.cells[1] == 1 ? h[1] : 0.0;
  common.gas_pressure = atmosphere;
  // Of trilinear weights: no method is narrower but at cells wider than the grain.
  common.bell = common.cell * std::sqrt(1.0 / 6.0 + 1.0 / 32.0 + 1.0 / 12.0);
  for (const Force& force : effects_.forces)
    if (const auto* lorentz = chosen_as<ForceLorentz>(force)) {
      common.charge = std::abs(lorentz->charge);
      common.electric = lorentz->electric.norm();
      common.magnetic = lorentz->magnetic.norm();
    }
  for (const GasField field : {GasField::vorticity, GasField::acceleration, GasField::viscous_force,
                               GasField::pressure_gradient})
    if (gas_known_ && !fields.has(field)) estimated_.add(field);
  for (std::size_t p = 0; p < particles.count; ++p) {
    Scales at = common;
    const double d = 2.0 * particles.radius[p];
    at.diameter = d;
    at.solid_density = particles.mass[p] / sphere_volume(particles.radius[p]);
    at.speed = particles.v(p).norm();
    if (particles.angular_velocity != nullptr)
      at.spin = Eigen::Map<const Vec3>(particles.angular_velocity + 3 * p).norm();
    raise(extremes_.diameter, d);
    raise(extremes_.largest_inverse, 1.0 / d);
    volume_ += particles.N(p) * d * d * d;
    surface_ += particles.N(p) * d * d;
    at.smallest_diameter = 1.0 / extremes_.largest_inverse;
    at.sauter_diameter = volume_ / surface_;
    if (gas_known_) {
      Int3 cell;
      for (int axis = 0; axis < 3; ++axis)
        cell[axis] = std::clamp(frame.cell(frame.in_cells(particles.x(p)[axis], axis), axis),
                                frame.tile.lo[axis], frame.tile.hi[axis] - 1);
      const VectorField& velocity = fields.vector(GasField::velocity);
      const Surroundings about = surroundings(velocity, cell, h);
      const Vec3 u = records.u(p);
      const Vec3 slip = u - particles.v(p);
      at.slip = slip.norm();
      at.drag = records.K(p) * at.slip;
      at.gas_speed = u.norm();
      at.vorticity =
          layout.vorticity >= 0 ? records.at(p, layout.vorticity).norm() : about.vorticity().norm();
      at.gas_acceleration = layout.acceleration >= 0 ? records.at(p, layout.acceleration).norm()
                                                     : (about.gradient * u).norm();
      at.viscous_force = fields.has(GasField::viscous_force)
                             ? at_cell(fields.vector(GasField::viscous_force), cell).norm()
                             : setting.gas.viscosity * about.laplacian.norm();
      if (eps_known)
        at.void_fraction = fields.scalar(GasField::void_fraction)(cell[0], cell[1], cell[2]);
      at.void_fraction = std::clamp(at.void_fraction, least_drag_void_fraction, 1.0);
      at.pressure_gradient = fields.has(GasField::pressure_gradient)
                                 ? at_cell(fields.vector(GasField::pressure_gradient), cell).norm()
                                 : at.solids() / at.void_fraction * at.drag / at.volume() +
                                       at.gas_density * (at.gravity + at.gas_acceleration);
      // The length over which the gas varies by itself, as far as the grid shows it.
      at.gas_length = std::max(common.cell, ratio(at.gas_speed, about.gradient.norm()));
      at.grain_acceleration = ratio(at.drag, at.mass()) + at.gravity;
      at.speed_scatter = layout.mean_velocity >= 0
                             ? (particles.v(p) - records.at(p, layout.mean_velocity)).norm()
                             : 0.0;
    }
    take(at);
  }
}

Audit Audit::whole(const Communicator& ranks) const {
  Audit all = *this;
  std::vector<double> sums{all.grains_, all.drag_, all.weight_};
  for (const Seen& seen : all.seen_) sums.insert(sums.end(), {seen.force, seen.needed});
  ranks.sum_in_place(sums);
  all.grains_ = sums[0];
  all.drag_ = sums[1];
  all.weight_ = sums[2];
  std::size_t n = 3;
  for (Seen& seen : all.seen_) {
    seen.force = sums[n++];
    seen.needed = sums[n++];
    seen.greatest = ranks.max(seen.greatest);
  }
  Extremes& most = all.extremes_;
  for (double* value :
       {&most.slip, &most.speed, &most.spin, &most.vorticity, &most.gas_acceleration,
        &most.reynolds, &most.diameter, &most.largest_inverse})
    *value = ranks.max(*value);
  return all;
}

}  // namespace gasgrain
