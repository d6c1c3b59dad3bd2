// The weights between the particles of a rank and the cells of its tile, found once a coupled step.
//
// Everything that goes from particles to cells (deposit) and from cells to particles (sample) uses
// this one list, so that the two are exact adjoints of each other:
//   sum_cells field * deposit(q) = sum_particles q * sample(field).
// With it, what the particles take out of the gas is what the gas gives.
//
// Where the method spreads points over cells (methods.h) the list is between particles and points,
// and the spread and its adjoint stand between points and cells.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "coupling/base/array3.h"
#include "coupling/base/error.h"
#include "coupling/exchange/particle_view.h"
#include "coupling/exchange/self_disturbance.h"
#include "coupling/exchange/void_fraction/methods.h"

namespace gasgrain {

// One Array3 a component.
using VectorField = std::array<Array3<double>, 3>;

inline VectorField make_vector_field(const IndexBox& box) {
  return {Array3<double>(box), Array3<double>(box), Array3<double>(box)};
}

class ParticleWeights {
 public:
  // Replaces the list. Throws Error naming the particle when one touches a cell outside of the tile
  // or its position is not a number.
  void find(const ParticleView& particles, const VoidFractionMethod& method,
            const TileFrame& frame);

  [[nodiscard]] std::size_t particles() const { return first_.empty() ? 0 : first_.size() - 1; }
  // Pairs of a particle and a cell, or a point where the method spreads points.
  [[nodiscard]] std::size_t entries() const { return cell_.size(); }
  [[nodiscard]] const IndexBox& tile() const { return tile_; }
  // Particles whose centre was beyond a wall of the box: the host's walls leak or are elsewhere.
  [[nodiscard]] std::size_t beyond_walls() const { return beyond_walls_; }

  [[nodiscard]] double cell_volume() const { return h_.prod(); }  // [m3]
  // Where a particle's weights lie, and how far apart.
  [[nodiscard]] Footprint footprint(std::size_t p) const;

  // Adds value(p), a double, of every particle to the field.
  template <class F>
  void deposit(F&& value, Array3<double>& field) const {
    check(field);
    if (!spread_) return add_entries(value, field.data());
    Array3<double> points(points_);
    add_entries(value, points.data());
    spread_->add(points, field);
  }

  // Adds value(p), a Vec3, of every particle to the field.
  template <class F>
  void deposit(F&& value, VectorField& field) const {
    for (const auto& component : field) check(component);
    if (!spread_) return add_vector_entries(value, data_of(field));
    VectorField points = make_vector_field(points_);
    add_vector_entries(value, data_of(points));
    for (int d = 0; d < 3; ++d) spread_->add(points[d], field[d]);
  }

  // Calls put(p, value) with the field's weighted mean, a double, at every particle.
  template <class F>
  void sample(const Array3<double>& field, F&& put) const {
    check(field);
    if (!spread_) return sum_entries(field.data(), put);
    Array3<double> points(points_);
    spread_->gather(field, points);
    sum_entries(points.data(), put);
  }

  // Calls put(p, value) with the field's weighted mean, a Vec3, at every particle.
  template <class F>
  void sample(const VectorField& field, F&& put) const {
    for (const auto& component : field) check(component);
    if (!spread_) return sum_vector_entries(data_of(field), put);
    VectorField points = make_vector_field(points_);
    for (int d = 0; d < 3; ++d) spread_->gather(field[d], points[d]);
    sum_vector_entries(data_of(std::as_const(points)), put);
  }

 private:
  template <class Method, class F>
  void list(const ParticleView& particles, const Method& method, const IndexBox& box,
            const TileFrame& frame, F&& seen);
  template <class Method>
  void make_spread(const ParticleView& particles, const Method& method, const TileFrame& frame);

  static std::array<double*, 3> data_of(VectorField& field) {
    return {field[0].data(), field[1].data(), field[2].data()};
  }
  static std::array<const double*, 3> data_of(const VectorField& field) {
    return {field[0].data(), field[1].data(), field[2].data()};
  }

  template <class F>
  void add_entries(F&& value, double* out) const {
    for (std::size_t p = 0; p + 1 < first_.size(); ++p) {
      const double q = value(p);
      for (std::size_t n = first_[p]; n < first_[p + 1]; ++n) out[cell_[n]] += weight_[n] * q;
    }
  }
  template <class F>
  void add_vector_entries(F&& value, const std::array<double*, 3>& out) const {
    for (std::size_t p = 0; p + 1 < first_.size(); ++p) {
      const Vec3 q = value(p);
      for (std::size_t n = first_[p]; n < first_[p + 1]; ++n)
        for (int d = 0; d < 3; ++d) out[d][cell_[n]] += weight_[n] * q[d];
    }
  }
  template <class F>
  void sum_entries(const double* in, F&& put) const {
    for (std::size_t p = 0; p + 1 < first_.size(); ++p) {
      double sum = 0.0;
      for (std::size_t n = first_[p]; n < first_[p + 1]; ++n) sum += weight_[n] * in[cell_[n]];
      put(p, sum);
    }
  }
  template <class F>
  void sum_vector_entries(const std::array<const double*, 3>& in, F&& put) const {
    for (std::size_t p = 0; p + 1 < first_.size(); ++p) {
      Vec3 sum = Vec3::Zero();
      for (std::size_t n = first_[p]; n < first_[p + 1]; ++n)
        for (int d = 0; d < 3; ++d) sum[d] += weight_[n] * in[d][cell_[n]];
      put(p, sum);
    }
  }

  void check(const Array3<double>& field) const {
    if (field.box() != tile_)
      fail(
          "a field of {} cells was given to weights of a tile of {} cells: both must have the "
          "same box",
          field.size(), tile_.size());
  }

  IndexBox tile_;
  std::vector<std::size_t>
      first_;  // where the entries of a particle begin; one more than particles
  std::vector<std::uint32_t> cell_;  // offset into an Array3 over the tile, or over points_
  std::vector<double> weight_;
  std::size_t beyond_walls_ = 0;
  std::optional<SeparableSpread> spread_;
  // Of each point along each axis: mean and variance of the cells' centres, in cells.
  std::array<std::vector<double>, 3> centre_, variance_;
  Vec3 h_ = Vec3::Ones();  // [m]
  IndexBox points_;        // where there is a spread
};

}  // namespace gasgrain
