// Looks for grains that tell of a run gone wrong, and lets one rank's find stop all of them.
//
// Two passes over a rank's own grains, each reading every number once:
//   look_at_state     at a coupling: is every position, velocity and force a number?
//   look_for_leavers  before the host hands grains to their ranks: which has no rank to go to? It
//                     is beyond a side of the box that is not periodic, or has crossed a whole
//                     sub-domain since the last time; the host drops either without a word.
// Neither communicates. share_fault() does: one number, the same on all ranks.
#pragma once

#include <string>

#include "coupling/base/communicator.h"
#include "coupling/base/error.h"
#include "coupling/exchange/particle_view.h"

namespace gasgrain {

// A run that cannot go on, found while it ran: the state is worth an autopsy. The same text on all
// ranks.
class RunFault : public Error {
 public:
  using Error::Error;
};

// When: for messages.
struct Moment {
  long step = 0;      // DEM step
  double time = 0.0;  // of the gas [s]; negative before it starts
};

// The host's numbers of grains and its forces [N], count x 3, beside a ParticleView.
struct HostGrains {
  const int* id = nullptr;
  const double* force = nullptr;
};

// 'grain 17 at x = 0.01, y = 0.02, z = 0.03 m'
std::string grain_at(const ParticleView& particles, const HostGrains& host, std::size_t p);
// 'at step 1200, t = 0.024 s'
std::string at(const Moment& moment);

// The first grain that is not finite, in words; empty: all are.
std::string look_at_state(const ParticleView& particles, const HostGrains& host);

struct HostBox {
  Vec3 lo = Vec3::Zero();  // [m]
  Vec3 hi = Vec3::Zero();
  std::array<bool, 3> periodic{};
  Vec3 own_lo = Vec3::Zero();  // this rank's part
  Vec3 own_hi = Vec3::Zero();
};

struct Leavers {
  std::string not_finite;  // the first grain whose position is no number
  long outside = 0;        // grains beyond a side
  std::string first;       // of them, in words, with the side
  std::string jumped;      // the first that crossed more than a sub-domain
};
Leavers look_for_leavers(const ParticleView& particles, const HostGrains& host, const HostBox& box);

// Where one rank or several have a fault (a text that is not empty), throws RunFault on all, with
// that of the lowest. Collective.
void share_fault(const Communicator& local, const std::string& fault);

}  // namespace gasgrain
