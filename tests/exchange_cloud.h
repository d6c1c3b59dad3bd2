// Particles and fields for the tests of coupling/exchange.
#pragma once

#include <random>
#include <vector>

#include "coupling/exchange/particle_exchange.h"

namespace gasgrain {

// Owns the arrays that a host would own.
struct Cloud {
  std::vector<double> position;
  std::vector<double> velocity;
  std::vector<double> radius;
  std::vector<double> mass;
  std::vector<double> parcel_size;  // empty: particles

  void add(const Vec3& x, const Vec3& v, double r, double m = 1e-6) {
    position.insert(position.end(), x.data(), x.data() + 3);
    velocity.insert(velocity.end(), v.data(), v.data() + 3);
    radius.push_back(r);
    mass.push_back(m);
    if (!parcel_size.empty()) parcel_size.push_back(1.0);
  }
  void remove_last() {
    position.resize(position.size() - 3);
    velocity.resize(velocity.size() - 3);
    radius.pop_back();
    mass.pop_back();
    if (!parcel_size.empty()) parcel_size.pop_back();
  }
  [[nodiscard]] ParticleView view() const {
    return {radius.size(),
            position.data(),
            velocity.data(),
            nullptr,
            radius.data(),
            mass.data(),
            parcel_size.empty() ? nullptr : parcel_size.data()};
  }
};

class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}
  double between(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine_);
  }
  Vec3 vector(const Vec3& low, const Vec3& high) {
    return {between(low[0], high[0]), between(low[1], high[1]), between(low[2], high[2])};
  }
  Vec3 vector(double size) { return vector(Vec3::Constant(-size), Vec3::Constant(size)); }
  void fill(Array3<double>& field, double low, double high) {
    for (double& value : field) value = between(low, high);
  }

 private:
  std::mt19937_64 engine_;
};

// A box of unequal cells of a few particle diameters.
inline BoxGrid uneven_box(std::array<bool, 3> periodic) {
  BoxGrid grid;
  grid.lo = {-0.01, 0.002, 0.0};
  grid.hi = {0.014, 0.012, 0.036};
  grid.cells = {6, 3, 8};
  grid.periodic = periodic;
  return grid;
}

inline constexpr double cloud_radius = 0.6e-3;

inline Cloud random_cloud(const BoxGrid& grid, std::size_t count, Random& random,
                          double greatest_radius = cloud_radius) {
  Cloud cloud;
  for (std::size_t p = 0; p < count; ++p)
    cloud.add(random.vector(grid.lo, grid.hi), random.vector(2.0),
              random.between(0.5, 1.0) * greatest_radius);
  return cloud;
}

// The grid's own cells along walls; grown by the stencil along periodic axes.
inline TileFrame whole_frame(const BoxGrid& grid, const VoidFractionMethod& method,
                             double radius = cloud_radius) {
  const Int3 reach = stencil_reach(method, radius, grid);
  TileFrame frame{grid, grid.all()};
  for (int d = 0; d < 3; ++d)
    if (grid.periodic[d]) {
      // One cell more: a particle on the upper end of the box is in the next cell.
      frame.tile.lo[d] -= reach[d] + 1;
      frame.tile.hi[d] += reach[d] + 1;
    }
  return frame;
}

// A field over a tile with unwrapped indices, added up over the cells of the box.
inline Array3<double> wrapped(const Array3<double>& field, const BoxGrid& grid) {
  Array3<double> sum(grid.all());
  for_each_cell(field.box(), [&](int i, int j, int k) {
    Int3 cell{i, j, k};
    for (int d = 0; d < 3; ++d)
      cell[d] = ((cell[d] % grid.cells[d]) + grid.cells[d]) % grid.cells[d];
    sum(cell[0], cell[1], cell[2]) += field(i, j, k);
  });
  return sum;
}

}  // namespace gasgrain
