// What the host stores and migrates for each particle between couplings: a row of plain doubles,
// as long as the scene's effects ask for (RecordLayout). A row of zeros is that of a new particle:
// no force until the next coupling, nothing owed.
//
// Between two couplings a particle feels K (u - v) and the other forces with its own, current v. At
// a coupling the gas is charged with the drag it EXPECTS, K (u - v) over the interval with v as it
// then is; what the particle has really `taken` by the next coupling, of drag and of every other
// force that the gas answers for, differs from it by the carry
//   carry = taken - expected   [N s].
// The gas feels the force density -(K u - S). To lose the carry on top of what is expected of it
// over the next interval T, S must be smaller by carry / T:
//   S = K v - carry / T.
#pragma once

#include <algorithm>
#include <vector>

#include "coupling/base/vec3.h"

namespace gasgrain {

// Where a row keeps what only some effects need; absent: -1.
struct RecordLayout {
  int size = 13;
  int reaction = -1;          // the part of the steady force that the gas answers for [N]
  int vorticity = -1;         // of the gas at the particle [1/s]
  int acceleration = -1;      // of the gas at the particle [m/s2]
  int mean_coefficient = -1;  // K at the mean slip of the grains around [kg/s]
  int mean_velocity = -1;     // of the grains around [m/s]
  int position = -1;          // at the last coupling [m]
  int velocity = -1;          // at the last coupling [m/s]
  int history = -1;           // of the particle's acceleration, basset.h

  // Room for `count` doubles at the end of the row; returns where it begins.
  int add(int count) {
    const int begin = size;
    size += count;
    return begin;
  }
};

class ExchangeRecords {
 public:
  using Vector = Eigen::Map<Vec3>;
  using ConstVector = Eigen::Map<const Vec3>;

  explicit ExchangeRecords(const RecordLayout& layout = {}) : layout_(layout) {}

  [[nodiscard]] const RecordLayout& layout() const { return layout_; }
  [[nodiscard]] std::size_t size() const { return rows_.size() / stride(); }
  void resize(std::size_t count) { rows_.resize(count * stride(), 0.0); }
  void clear(std::size_t p) { std::fill_n(row(p), stride(), 0.0); }
  void copy(std::size_t from, std::size_t to) { std::copy_n(row(from), stride(), row(to)); }
  // The row of a particle, layout().size doubles.
  double* row(std::size_t p) { return rows_.data() + p * stride(); }
  [[nodiscard]] const double* row(std::size_t p) const { return rows_.data() + p * stride(); }

  // Drag coefficient [kg/s], F_drag = K (u - v).
  double& K(std::size_t p) { return row(p)[0]; }
  [[nodiscard]] double K(std::size_t p) const { return row(p)[0]; }
  // Gas velocity at the particle, interval mean [m/s].
  Vector u(std::size_t p) { return at(p, 1); }
  [[nodiscard]] ConstVector u(std::size_t p) const { return at(p, 1); }
  // Sum of the forces that hold for an interval [N].
  Vector steady_force(std::size_t p) { return at(p, 4); }
  [[nodiscard]] ConstVector steady_force(std::size_t p) const { return at(p, 4); }
  // Impulse taken since the last coupling, of all forces that the gas answers for [N s].
  Vector taken(std::size_t p) { return at(p, 7); }
  [[nodiscard]] ConstVector taken(std::size_t p) const { return at(p, 7); }
  // Impulse that the gas gave at the last coupling [N s].
  Vector expected(std::size_t p) { return at(p, 10); }
  [[nodiscard]] ConstVector expected(std::size_t p) const { return at(p, 10); }

  // A vector of the layout.
  Vector at(std::size_t p, int where) { return Vector(row(p) + where); }
  [[nodiscard]] ConstVector at(std::size_t p, int where) const {
    return ConstVector(row(p) + where);
  }

  // Impulse that the particle took and the gas has not yet given [N s].
  [[nodiscard]] Vec3 carry(std::size_t p) const { return taken(p) - expected(p); }

 private:
  [[nodiscard]] std::size_t stride() const { return static_cast<std::size_t>(layout_.size); }

  RecordLayout layout_;
  std::vector<double> rows_;
};

}  // namespace gasgrain
