#include "coupling/run_watch.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>

namespace gasgrain {
namespace {

std::string numbers(const double* v) {
  return fmt::format("({:.4g}, {:.4g}, {:.4g})", v[0], v[1], v[2]);
}

bool finite(const double* v) {
  return std::isfinite(v[0] + v[1] + v[2]);
}

}  // namespace

std::string grain_at(const ParticleView& particles, const HostGrains& host, std::size_t p) {
  const double* x = particles.position + 3 * p;
  return fmt::format("grain {} at x = {:.6g}, y = {:.6g}, z = {:.6g} m", host.id[p], x[0], x[1],
                     x[2]);
}

std::string at(const Moment& moment) {
  return moment.time >= 0.0
             ? fmt::format("at step {}, t = {:.6g} s", moment.step, moment.time)
             : fmt::format("at step {}, {:.6g} s before the gas starts", moment.step, -moment.time);
}

std::string look_at_state(const ParticleView& particles, const HostGrains& host) {
  for (std::size_t p = 0; p < particles.count; ++p) {
    const double* x = particles.position + 3 * p;
    const double* v = particles.velocity + 3 * p;
    const double* f = host.force + 3 * p;
    // A sum of finite numbers of a bed is finite; one that is not makes the sum so.
    if (std::isfinite(x[0] + x[1] + x[2] + v[0] + v[1] + v[2] + f[0] + f[1] + f[2])) continue;
    const std::string grain = grain_at(particles, host, p);
    if (!finite(x)) return fmt::format("the position of {} is not a number", grain);
    if (!finite(v)) return fmt::format("the velocity of {} is not a number: {}", grain, numbers(v));
    return fmt::format("the force on {}, velocity {} m/s, is not a number: {}", grain, numbers(v),
                       numbers(f));
  }
  return "";
}

Leavers look_for_leavers(const ParticleView& particles, const HostGrains& host,
                         const HostBox& box) {
  Leavers found;
  const Vec3 own = box.own_hi - box.own_lo;
  for (std::size_t p = 0; p < particles.count; ++p) {
    const double* x = particles.position + 3 * p;
    if (!finite(x)) {
      if (found.not_finite.empty())
        found.not_finite =
            fmt::format("the position of {} is not a number", grain_at(particles, host, p));
      continue;
    }
    for (int d = 0; d < 3; ++d) {
      // The host's own comparison: the upper side is no part of the box.
      const bool below = x[d] < box.lo[d];
      if (!box.periodic[d] && (below || x[d] >= box.hi[d])) {
        ++found.outside;
        if (found.first.empty())
          found.first = fmt::format(
              "{}, velocity {} m/s, has left the box through {}_{}", grain_at(particles, host, p),
              numbers(particles.velocity + 3 * p), "xyz"[d], below ? "lo" : "hi");
        break;
      }
      if (found.jumped.empty() &&
          (x[d] < box.own_lo[d] - own[d] || x[d] >= box.own_hi[d] + own[d])) {
        found.jumped = fmt::format(
            "{}, velocity {} m/s, has crossed more than {:.3g} m in {} since the grains were last "
            "handed to their ranks",
            grain_at(particles, host, p), numbers(particles.velocity + 3 * p), own[d], "xyz"[d]);
        break;
      }
    }
  }
  return found;
}

void share_fault(const Communicator& local, const std::string& fault) {
  const double none = local.size();
  const double teller = local.min(fault.empty() ? none : local.rank());
  if (teller == none) return;
  const int root = static_cast<int>(teller);
  int length = static_cast<int>(fault.size());
  MPI_Bcast(&length, 1, MPI_INT, root, local.handle());
  std::string text = fault;
  text.resize(length);
  MPI_Bcast(text.data(), length, MPI_CHAR, root, local.handle());
  throw RunFault(text);
}

}  // namespace gasgrain
