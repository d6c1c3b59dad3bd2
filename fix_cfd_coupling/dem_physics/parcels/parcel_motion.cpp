#include "fix_cfd_coupling/dem_physics/parcels/parcel_motion.h"

#include "fix_cfd_coupling/dem_physics/parcels/parcel_deposit.h"

namespace gasgrain {

namespace {

constexpr double not_marked = 2.0;
constexpr double least_core = 1e-9;  // of a particle, to take part in the packing
// Above what a cell held before by this share is no more than round-off.
constexpr double round_off = 1e-13;

double weight_at(const AxisWeights& axis, int cell) {
  for (int n = 0; n < axis.count; ++n)
    if (axis.cell[n] == cell) return axis.weight[n];
  return 0.0;
}

// Whether a parcel at x may have a share in a cell that is marked.
bool touches(const TileFrame& frame, const Vec3& x, const Array3<char>& touched) {
  Int3 below;
  for (int d = 0; d < 3; ++d) below[d] = frame.cell(std::floor(frame.in_cells(x[d], d) - 0.5), d);
  return touched(below[0], below[1], below[2]) != 0;
}

// Cuts a way that would end outside of the tile.
bool cut_at_tile(const TileFrame& frame, const Vec3& start, Vec3& way) {
  if (frame.beyond_walls(start + way)) return false;
  bool cut = false;
  for (int d = 0; d < 3; ++d) {
    const double s = frame.in_cells(start[d] + way[d], d);
    double kept = s;
    if (frame.cell(std::floor(s - 0.5), d) < frame.tile.lo[d]) kept = frame.tile.lo[d] + 0.5;
    if (frame.cell(std::floor(s - 0.5) + 1.0, d) >= frame.tile.hi[d])
      kept = frame.tile.hi[d] - 0.5 - 1e-9;
    if (kept == s) continue;
    way[d] = (kept - frame.in_cells(start[d], d)) * frame.grid.spacing()[d];
    cut = true;
  }
  return cut;
}

}  // namespace

void ParcelMotion::find_ways(const ParcelView& parcels, const TileFrame& frame, double dt,
                             const Walls& walls, MotionReport& report) {
  ways_.assign(parcels.count, {});
  const double per_volume = 1.0 / frame.grid.cell_volume();
  for (std::size_t p = 0; p < parcels.count; ++p) {
    Way& way = ways_[p];
    const FreeFlight flight =
        fly(parcels.x(p), parcels.v(p), parcels.radius[p], dt, frame.grid, walls);
    way.start = parcels.x(p);
    way.way = flight.position - way.start;
    way.velocity = flight.velocity;
    report.rebounds += static_cast<std::size_t>(flight.rebounds);
    report.wall_impulse += parcels.parcel_mass(p) * (parcels.v(p) - flight.velocity);
    if (frame.beyond_walls(way.start)) continue;
    if (cut_at_tile(frame, way.start, way.way)) ++report.cut_at_tile;
    if (parcels.solid_volume[p] > least_core * parcels.particle_volume(p))
      way.fraction = parcels.solids(p) * per_volume;
  }
}

void ParcelMotion::deposit_ways(const TileFrame& frame, const SumOverRanks& sum) {
  clear(before_, frame);
  clear(fraction_, frame);
  for (const Way& way : ways_) {
    if (way.fraction == 0.0) continue;
    deposit(stencil_within(frame, way.start), way.fraction, before_);
    if (!frame.beyond_walls(way.end()))
      deposit(trilinear_axes(frame, way.end()), way.fraction, fraction_);
  }
  sum({&before_, &fraction_});
}

double ParcelMotion::limit(std::size_t cell, double packings) const {
  return std::max(packings * close_packing_, before_[cell]);
}

bool ParcelMotion::any_above(double packings) const {
  for (std::size_t n = 0; n < fraction_.size(); ++n)
    if (fraction_[n] > (1.0 + round_off) * limit(n, packings)) return true;
  return false;
}

void ParcelMotion::mark_above(const TileFrame& frame, double packings) {
  clear(share_, frame);
  for (std::size_t n = 0; n < share_.size(); ++n)
    share_[n] = fraction_[n] > (1.0 + round_off) * limit(n, packings) ? 0.0 : not_marked;
  // Parcels are found by the lowest cell of their stencil.
  if (touched_.box() != frame.tile) touched_ = Array3<char>(frame.tile);
  touched_.fill(0);
  for_each_cell(frame.tile, [&](int i, int j, int k) {
    if (share_(i, j, k) == not_marked) return;
    const IndexBox below{{i - 1, j - 1, k - 1}, {i + 1, j + 1, k + 1}};
    for_each_cell(intersection(below, frame.tile),
                  [&](int l, int m, int n) { touched_(l, m, n) = 1; });
  });
}

void ParcelMotion::find_shares(const TileFrame& frame, const SumOverRanks& sum) {
  clear(inflow_, frame);
  clear(outflow_, frame);
  for (const Way& way : ways_) {
    if (way.fraction == 0.0) continue;
    const bool gone = frame.beyond_walls(way.end());
    if (!touches(frame, way.start, touched_) && (gone || !touches(frame, way.end(), touched_)))
      continue;
    const ParcelStencil before = trilinear_axes(frame, way.start);
    const ParcelStencil after = gone ? ParcelStencil{} : trilinear_axes(frame, way.end());
    for_each_product(after, [&](int i, int j, int k, double w) {
      if (w == 0.0 || share_(i, j, k) == not_marked) return;
      const double change = way.fraction * (w - weight_at(before[0], i) * weight_at(before[1], j) *
                                                    weight_at(before[2], k));
      (change > 0.0 ? inflow_ : outflow_)(i, j, k) += std::abs(change);
    });
    for_each_product(before, [&](int i, int j, int k, double w) {
      if (share_(i, j, k) == not_marked) return;
      if (weight_at(after[0], i) * weight_at(after[1], j) * weight_at(after[2], k) == 0.0)
        outflow_(i, j, k) += way.fraction * w;
    });
  }
  sum({&inflow_, &outflow_});
  for (std::size_t n = 0; n < share_.size(); ++n) {
    if (share_[n] == not_marked || inflow_[n] <= 0.0) continue;
    const double room = limit(n, soft_limit) - before_[n];
    share_[n] = std::clamp((room + outflow_[n]) / inflow_[n], 0.0, 1.0);
  }
}

void ParcelMotion::shorten_ways(const TileFrame& frame, const SumOverRanks& sum, bool hard) {
  clear(change_, frame);
  for (Way& way : ways_) {
    if (way.fraction == 0.0 || frame.beyond_walls(way.end())) continue;
    if (!touches(frame, way.end(), touched_)) continue;
    const ParcelStencil after = trilinear_axes(frame, way.end());
    const ParcelStencil before = trilinear_axes(frame, way.start);
    Vec3 shorter = Vec3::Ones();
    for_each_product(after, [&](int i, int j, int k, double w) {
      const double share = share_(i, j, k);
      if (share >= 1.0) return;
      const std::array<int, 3> cell{i, j, k};
      Vec3 held;
      for (int d = 0; d < 3; ++d) held[d] = weight_at(before[d], cell[d]);
      if (w <= held.prod()) return;
      for (int d = 0; d < 3; ++d)
        if (weight_at(after[d], cell[d]) > held[d]) shorter[d] = std::min(shorter[d], share);
    });
    if (shorter == Vec3::Ones()) continue;
    deposit(after, -way.fraction, change_);
    way.alpha = way.alpha.cwiseProduct(shorter);
    way.stopped = way.stopped || hard;
    deposit(trilinear_axes(frame, way.end()), way.fraction, change_);
  }
  sum({&change_});
  for (std::size_t n = 0; n < fraction_.size(); ++n) fraction_[n] += change_[n];
}

void ParcelMotion::hold_all(const TileFrame& frame) {
  for (Way& way : ways_) {
    if (way.fraction == 0.0) continue;
    way.alpha.setZero();
    way.stopped = true;
  }
  clear(fraction_, frame);
  for (std::size_t n = 0; n < fraction_.size(); ++n) fraction_[n] = before_[n];
}

void ParcelMotion::set_velocities(const ParcelView& parcels, const TileFrame& frame, double dt,
                                  const SumOverRanks& sum, MotionReport& report) {
  clear(mass_, frame);
  for (Array3<double>& field : momentum_) clear(field, frame);
  for (std::size_t p = 0; p < parcels.count; ++p) {
    const Way& way = ways_[p];
    if (frame.beyond_walls(way.end())) continue;
    const ParcelStencil stencil = trilinear_axes(frame, way.end());
    const double mass = parcels.parcel_mass(p);
    const Vec3 momentum = mass / dt * way.alpha.cwiseProduct(way.way);
    for_each_product(stencil, [&](int i, int j, int k, double w) {
      const std::ptrdiff_t n = mass_.offset(i, j, k);
      mass_[n] += w * mass;
      for (int d = 0; d < 3; ++d) momentum_[d][n] += w * momentum[d];
    });
  }
  sum({&mass_, &momentum_[0], &momentum_[1], &momentum_[2]});
  for (std::size_t p = 0; p < parcels.count; ++p) {
    Way& way = ways_[p];
    if (way.alpha == Vec3::Ones()) continue;
    ++report.limited;
    report.stopped += way.stopped;
    const ParcelStencil stencil = trilinear_axes(frame, way.end());
    const double mass_here = sample(stencil, mass_);
    for (int d = 0; d < 3; ++d) {
      const double v = way.velocity[d];
      const double mean = sample(stencil, momentum_[d]) / mass_here;
      const double carried = std::clamp(mean, std::min(v, 0.0), std::max(v, 0.0));
      way.velocity[d] = way.alpha[d] * v + (1.0 - way.alpha[d]) * carried;
      report.lost_momentum[d] += parcels.parcel_mass(p) * (v - way.velocity[d]);
    }
  }
}

MotionReport ParcelMotion::move(const ParcelView& parcels, const TileFrame& frame, double dt,
                                const Walls& walls, const SumOverRanks& sum,
                                const TotalOverRanks& total) {
  MotionReport report;
  find_ways(parcels, frame, dt, walls, report);
  deposit_ways(frame, sum);
  const auto anywhere = [&](double packings) {
    return total(any_above(packings) ? 1.0 : 0.0) > 0.0;
  };
  while (report.passes < soft_passes &&
         anywhere(report.passes < even_passes ? soft_limit : hard_limit)) {
    mark_above(frame, soft_limit);
    find_shares(frame, sum);
    shorten_ways(frame, sum, false);
    ++report.passes;
  }
  while (report.passes >= soft_passes && anywhere(hard_limit)) {
    if (report.passes == most_passes) {
      hold_all(frame);
      report.all_held = true;
      break;
    }
    mark_above(frame, hard_limit);
    shorten_ways(frame, sum, true);
    ++report.passes;
  }
  if (report.passes > 0) set_velocities(parcels, frame, dt, sum, report);

  for (std::size_t p = 0; p < parcels.count; ++p) {
    const Vec3 end = ways_[p].end();
    if (frame.beyond_walls(end)) ++report.outside;
    for (int d = 0; d < 3; ++d) {
      parcels.position[3 * p + d] = end[d];
      parcels.velocity[3 * p + d] = ways_[p].velocity[d];
    }
  }
  for (const double fraction : fraction_)
    report.greatest_fraction = std::max(report.greatest_fraction, fraction);
  return report;
}

}  // namespace gasgrain
