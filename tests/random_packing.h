// Equal spheres in a random packing without walls, for tests and benchmarks: spheres at random
// points of a periodic box are pushed apart until none overlap. Lengths are in diameters.
#pragma once

#include <fmt/format.h>

#include "tests/exchange_cloud.h"

namespace gasgrain {

// Indices of the points near each point, by a grid of buckets a little wider than the range.
class PackingNeighbours {
 public:
  PackingNeighbours(const std::vector<Vec3>& points, double side)
      : along_(std::max(3, static_cast<int>(side / 1.1))),
        side_(side),
        bucket_(static_cast<std::size_t>(along_) * along_ * along_) {
    for (std::size_t p = 0; p < points.size(); ++p) bucket_[index(place(points[p]))].push_back(p);
  }
  template <class F>
  void for_each(const Vec3& x, F&& f) const {
    const Int3 at = place(x);
    for (int k = -1; k <= 1; ++k)
      for (int j = -1; j <= 1; ++j)
        for (int i = -1; i <= 1; ++i)
          for (const std::size_t p : bucket_[index({at[0] + i, at[1] + j, at[2] + k})]) f(p);
  }

 private:
  [[nodiscard]] Int3 place(const Vec3& x) const {
    Int3 at{};
    for (int d = 0; d < 3; ++d) at[d] = static_cast<int>(std::floor(x[d] * along_ / side_));
    return at;
  }
  [[nodiscard]] std::size_t index(const Int3& at) const {
    std::size_t n = 0;
    for (const int a : at) n = n * along_ + (a + along_) % along_;
    return n;
  }
  int along_;
  double side_;
  std::vector<std::vector<std::size_t>> bucket_;
};

inline Vec3 wrapped_into(Vec3 x, double side) {
  for (int d = 0; d < 3; ++d) x[d] -= side * std::floor(x[d] / side);
  return x;
}

// Spheres of diameter 1. They are pushed apart as if they were a little wider, which ends sooner.
inline std::vector<Vec3> random_packing(double phi, double side, Random& random) {
  constexpr double wider = 1.002;
  constexpr int most_rounds = 20000;
  std::vector<Vec3> points(std::lround(phi * std::pow(side, 3) / sphere_volume(0.5)));
  for (Vec3& x : points) x = random.vector(Vec3::Zero(), Vec3::Constant(side));
  std::vector<Vec3> push(points.size());
  for (int round = 0; round < most_rounds; ++round) {
    const PackingNeighbours neighbours(points, side);
    double least = wider;
    for (std::size_t p = 0; p < points.size(); ++p) {
      push[p].setZero();
      neighbours.for_each(points[p], [&](std::size_t q) {
        if (p == q) return;
        Vec3 apart = points[p] - points[q];
        for (int d = 0; d < 3; ++d) apart[d] -= side * std::round(apart[d] / side);
        const double distance = apart.norm();
        if (distance >= wider) return;
        least = std::min(least, distance);
        push[p] += 0.5 * (wider - distance) / std::max(distance, 1e-9) * apart;
      });
    }
    if (least >= 1.0) {
      return points;
    }
    for (std::size_t p = 0; p < points.size(); ++p)
      points[p] = wrapped_into(points[p] + push[p], side);
  }
  fail("no packing of a solid share of {} was found in {} rounds: choose less than 0.62", phi,
       most_rounds);
}

}  // namespace gasgrain
