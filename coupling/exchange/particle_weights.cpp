#include "coupling/exchange/particle_weights.h"
#include "coupling/base/listed.h"

#include <algorithm>
#include <numeric>

namespace gasgrain {
namespace {

[[noreturn]] void fail_outside(std::size_t p, const Vec3& x, double radius, const IndexBox& tile) {
  fail(
      "particle {} of this rank, at ({:g}, {:g}, {:g}) m with radius {:g} m, touches cells outside "
      "of the rank's tile of cells ({}, {}, {}) to ({}, {}, {}). Either it has left the rank's "
      "sub-domain, and the neighbour lists must be rebuilt more often, or it is greater than the "
      "radius the tile was made for.",
      p, x[0], x[1], x[2], radius, tile.lo[0], tile.lo[1], tile.lo[2], tile.hi[0], tile.hi[1],
      tile.hi[2]);
}

// Along a periodic axis the centre must be within the tile; this also finds what is not a number,
// before it is made a cell index. Along the other axes any number will do: it is folded.
[[gnu::always_inline]] inline bool usable(const Vec3& x, const TileFrame& frame) {
  for (int d = 0; d < 3; ++d) {
    const double s = frame.in_cells(x[d], d);
    const bool good =
        frame.grid.periodic[d] ? s >= frame.tile.lo[d] && s <= frame.tile.hi[d] : std::isfinite(s);
    if (!good) return false;
  }
  return true;
}

}  // namespace

void ParticleWeights::find(const ParticleView& particles, const VoidFractionMethod& method,
                           const TileFrame& frame) {
  tile_ = frame.tile;
  h_ = frame.grid.spacing();
  first_.resize(particles.count + 1);
  cell_.clear();
  weight_.clear();
  beyond_walls_ = 0;
  spread_.reset();
  visit_apart(
      [&](const auto& chosen) {
        using Method = std::decay_t<decltype(chosen)>;
        if constexpr (Spreads<Method>::value) {
          Method sized = chosen;
          if (sized.diameter <= 0.0 && particles.count > 0)
            sized.diameter =
                2.0 * *std::max_element(particles.radius, particles.radius + particles.count);
          make_spread(particles, sized, frame);
        } else {
          list(particles, chosen, tile_, frame, [](int, int, int) {});
          for (int d = 0; d < 3; ++d) {
            centre_[d].resize(tile_.extent(d));
            std::iota(centre_[d].begin(), centre_[d].end(), tile_.lo[d] + 0.5);
            variance_[d].assign(tile_.extent(d), 0.0);
          }
        }
      },
      method);
}

// Lists the particles' entries in a box of cells or points, each of which is shown to `seen`.
template <class Method, class F>
void ParticleWeights::list(const ParticleView& particles, const Method& method, const IndexBox& box,
                           const TileFrame& frame, F&& seen) {
  const std::ptrdiff_t stride_y = box.extent(0);
  const std::ptrdiff_t stride_z = stride_y * box.extent(1);
  for (std::size_t p = 0; p < particles.count; ++p) {
    const Vec3 x = particles.x(p);
    const double radius = particles.radius[p];
    if (!usable(x, frame)) fail_outside(p, x, radius, tile_);
    if (frame.beyond_walls(x)) ++beyond_walls_;
    first_[p] = cell_.size();
    method.for_each_weight(frame, x, radius, [&](int i, int j, int k, double w) {
      if (!box.contains(i, j, k)) fail_outside(p, x, radius, tile_);
      seen(i, j, k);
      cell_.push_back(static_cast<std::uint32_t>((i - box.lo[0]) + stride_y * (j - box.lo[1]) +
                                                 stride_z * (k - box.lo[2])));
      weight_.push_back(w);
    });
  }
  first_[particles.count] = cell_.size();
}

// Only the points that particles touch are spread: in a bed with much empty space above it that is
// what most of the time is saved by.
template <class Method>
void ParticleWeights::make_spread(const ParticleView& particles, const Method& method,
                                  const TileFrame& frame) {
  const double radius = 0.5 * method.diameter;
  std::array<IndexRange, 3> touched;
  for (int d = 0; d < 3; ++d) {
    const IndexRange points =
        method.points(frame.grid, d, radius, IndexRange{tile_.lo[d], tile_.hi[d]});
    points_.lo[d] = points.lo;
    points_.hi[d] = points.hi;
    touched[d] = {points.hi, points.lo};
  }
  list(particles, method, points_, frame, [&](int i, int j, int k) {
    const Int3 point{i, j, k};
    for (int d = 0; d < 3; ++d) {
      touched[d].lo = std::min(touched[d].lo, point[d]);
      touched[d].hi = std::max(touched[d].hi, point[d] + 1);
    }
  });
  if (particles.count == 0) {
    spread_.emplace();
    return;
  }
  std::array<AxisSpread, 3> axes;
  for (int d = 0; d < 3; ++d) {
    axes[d] = method.spread(frame.grid, d, radius, touched[d]);
    if (axes[d].outer.lo >= tile_.lo[d] && axes[d].outer.hi <= tile_.hi[d]) continue;
    for (std::size_t p = 0; p < particles.count; ++p)
      method.for_each_weight(frame, particles.x(p), radius, [&](int i, int j, int k, double /*w*/) {
        const int point = Int3{i, j, k}[d];
        const IndexRange cells =
            method.spread(frame.grid, d, radius, IndexRange{point, point + 1}).outer;
        if (cells.lo < tile_.lo[d] || cells.hi > tile_.hi[d])
          fail_outside(p, particles.x(p), particles.radius[p], tile_);
      });
  }
  spread_.emplace(axes);
  for (int d = 0; d < 3; ++d) {
    centre_[d].assign(points_.extent(d), 0.0);
    variance_[d].assign(points_.extent(d), 0.0);
    for (int point = touched[d].lo; point < touched[d].hi; ++point) {
      double mean = 0.0;
      double square = 0.0;
      for (int cell = axes[d].outer.lo; cell < axes[d].outer.hi; ++cell) {
        const double w = axes[d].share(cell - axes[d].outer.lo, point - touched[d].lo);
        mean += w * (cell + 0.5);
        square += w * (cell + 0.5) * (cell + 0.5);
      }
      centre_[d][point - points_.lo[d]] = mean;
      variance_[d][point - points_.lo[d]] = square - mean * mean;
    }
  }
}

Footprint ParticleWeights::footprint(std::size_t p) const {
  const IndexBox& box = spread_ ? points_ : tile_;
  const auto nx = static_cast<std::uint32_t>(box.extent(0));
  const auto ny = static_cast<std::uint32_t>(box.extent(1));
  Vec3 mean = Vec3::Zero();
  Vec3 square = Vec3::Zero();
  Vec3 within = Vec3::Zero();
  for (std::size_t n = first_[p]; n < first_[p + 1]; ++n) {
    const std::array<std::uint32_t, 3> at{cell_[n] % nx, cell_[n] / nx % ny, cell_[n] / nx / ny};
    for (int d = 0; d < 3; ++d) {
      const double x = centre_[d][at[d]];
      mean[d] += weight_[n] * x;
      square[d] += weight_[n] * x * x;
      within[d] += weight_[n] * variance_[d][at[d]];
    }
  }
  const Vec3 between = (square - mean.cwiseProduct(mean)).cwiseMax(0.0);
  return {(between + within).cwiseProduct(h_).cwiseProduct(h_), h_};
}

}  // namespace gasgrain
