#include "coupling/exchange/particle_weights.h"

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
bool usable(const Vec3& x, const TileFrame& frame) {
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
  first_.resize(particles.count + 1);
  cell_.clear();
  weight_.clear();
  beyond_walls_ = 0;

  const std::ptrdiff_t stride_y = tile_.extent(0);
  const std::ptrdiff_t stride_z = stride_y * tile_.extent(1);
  std::visit(
      [&](const auto& chosen) {
        for (std::size_t p = 0; p < particles.count; ++p) {
          const Vec3 x = particles.x(p);
          const double radius = particles.radius[p];
          if (!usable(x, frame)) fail_outside(p, x, radius, tile_);
          if (frame.beyond_walls(x)) ++beyond_walls_;
          first_[p] = cell_.size();
          chosen.for_each_weight(frame, x, radius, [&](int i, int j, int k, double w) {
            if (!tile_.contains(i, j, k)) fail_outside(p, x, radius, tile_);
            cell_.push_back(static_cast<std::uint32_t>(
                (i - tile_.lo[0]) + stride_y * (j - tile_.lo[1]) + stride_z * (k - tile_.lo[2])));
            weight_.push_back(w);
          });
        }
      },
      method);
  first_[particles.count] = cell_.size();
}

}  // namespace gasgrain
