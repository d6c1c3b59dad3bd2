// Parcels, grids and sums over ranks for the tests of parcels.
#pragma once

#include <vector>

#include "fix_cfd_coupling/dem_physics/cell_sums.h"
#include "fix_cfd_coupling/dem_physics/parcels/counter_random.h"
#include "fix_cfd_coupling/dem_physics/parcels/parcel_motion.h"
#include "fix_cfd_coupling/dem_physics/parcels/particle_stress.h"

namespace gasgrain {

// Arrays of parcels as a host holds them.
struct Parcels {
  std::vector<double> x, v, radius, mass, solid_volume, particles;
  std::vector<int> number;

  // A parcel of solid particles.
  void add(const Vec3& position, const Vec3& velocity, double r, double density, double n) {
    for (int d = 0; d < 3; ++d) {
      x.push_back(position[d]);
      v.push_back(velocity[d]);
    }
    const double volume = 4.0 / 3.0 * M_PI * r * r * r;
    radius.push_back(r);
    solid_volume.push_back(volume);
    mass.push_back(density * volume);
    particles.push_back(n);
    number.push_back(static_cast<int>(number.size()) + 1);
  }
  [[nodiscard]] std::size_t count() const { return radius.size(); }
  ParcelView view() {
    return {count(),          x.data(),     v.data(),
            radius.data(),    mass.data(),  solid_volume.data(),
            particles.data(), number.data()};
  }
  [[nodiscard]] Vec3 momentum() const {
    Vec3 sum = Vec3::Zero();
    for (std::size_t p = 0; p < count(); ++p)
      sum += particles[p] * mass[p] * Vec3(v[3 * p], v[3 * p + 1], v[3 * p + 2]);
    return sum;
  }
  [[nodiscard]] double kinetic_energy() const {
    double sum = 0.0;
    for (std::size_t n = 0; n < v.size(); ++n)
      sum += 0.5 * particles[n / 3] * mass[n / 3] * v[n] * v[n];
    return sum;
  }
  [[nodiscard]] double total_mass() const {
    double sum = 0.0;
    for (std::size_t p = 0; p < count(); ++p) sum += particles[p] * mass[p];
    return sum;
  }
};

// A box of cubic cells of the size h.
inline BoxGrid box_of(const Int3& cells, double h) {
  BoxGrid grid;
  grid.lo = Vec3::Zero();
  grid.hi = h * Vec3(cells[0], cells[1], cells[2]);
  grid.cells = cells;
  return grid;
}

inline Walls all_walls() {
  Walls walls;
  walls.side = {{{true, true}, {true, true}, {true, true}}};
  return walls;
}

// One rank: cells of a periodic axis that the tile holds twice are added up.
inline SumOverRanks sum_of_one_rank(const TileFrame& frame) {
  return [frame](const std::vector<Array3<double>*>& fields) {
    const auto wrapped = [&](int i, int d) {
      const int n = frame.grid.cells[d];
      return frame.grid.periodic[d] ? ((i % n) + n) % n : i;
    };
    for (Array3<double>* field : fields) {
      Array3<double> box(frame.grid.all(), 0.0);
      for_each_cell(field->box(), [&](int i, int j, int k) {
        box(wrapped(i, 0), wrapped(j, 1), wrapped(k, 2)) += (*field)(i, j, k);
      });
      for_each_cell(field->box(), [&](int i, int j, int k) {
        (*field)(i, j, k) = box(wrapped(i, 0), wrapped(j, 1), wrapped(k, 2));
      });
    }
  };
}

inline double total_of_one_rank(double value) {
  return value;
}

// The whole box on one rank, with two layers of cells beyond its periodic sides.
inline TileFrame whole_box(const BoxGrid& grid) {
  TileFrame frame{grid, grid.all()};
  for (int d = 0; d < 3; ++d)
    if (grid.periodic[d]) {
      frame.tile.lo[d] -= 2;
      frame.tile.hi[d] += 2;
    }
  return frame;
}

// `a_cell` parcels in each cell of a part of the box, evenly with a random offset within their own
// part of the cell; theta the solid volume fraction.
inline void fill(Parcels& parcels, const BoxGrid& grid, const IndexBox& part, int along,
                 double theta, double radius, double density, const Vec3& velocity,
                 double offset = 1.0) {
  const Vec3 h = grid.spacing() / along;
  const double volume = 4.0 / 3.0 * M_PI * radius * radius * radius;
  const double n = theta * h.prod() / volume;
  CounterRandom random(7, 0, 0);
  for_each_cell({{part.lo[0] * along, part.lo[1] * along, part.lo[2] * along},
                 {part.hi[0] * along, part.hi[1] * along, part.hi[2] * along}},
                [&](int i, int j, int k) {
                  Vec3 x;
                  const Int3 cell{i, j, k};
                  for (int d = 0; d < 3; ++d)
                    x[d] = grid.lo[d] + h[d] * (cell[d] + 0.5 + offset * (random.uniform() - 0.5));
                  parcels.add(x, velocity, radius, density, n);
                });
}

// A step of parcels under gravity, without a gas.
struct Bed {
  BoxGrid grid;
  ParcelSettings settings;
  Parcels parcels;
  Vec3 gravity{0.0, 0.0, -9.81};
  StressReport stress_report;
  MotionReport motion_report;

  Bed(const BoxGrid& g, const ParcelSettings& s)
      : grid(g), settings(s), stress(s), motion(s.close_packing) {}

  ParticleStress stress;
  ParcelMotion motion;

  void step(double dt) {
    const TileFrame frame = whole_box(grid);
    const SumOverRanks sum = sum_of_one_rank(frame);
    std::vector<double> force(3 * parcels.count());
    for (std::size_t n = 0; n < force.size(); ++n) force[n] = parcels.mass[n / 3] * gravity[n % 3];
    stress_report = stress.add_forces(parcels.view(), frame, dt, force.data(), sum);
    for (std::size_t n = 0; n < force.size(); ++n)
      parcels.v[n] += dt * force[n] / parcels.mass[n / 3];
    motion_report = motion.move(parcels.view(), frame, dt, settings.walls, sum, total_of_one_rank);
    for (std::size_t n = 0; n < parcels.x.size(); ++n) {
      const int d = static_cast<int>(n % 3);
      if (!grid.periodic[d]) continue;
      const double length = grid.hi[d] - grid.lo[d];
      parcels.x[n] -= length * std::floor((parcels.x[n] - grid.lo[d]) / length);
    }
  }
};

}  // namespace gasgrain
