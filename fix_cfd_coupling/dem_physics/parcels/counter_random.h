// Random numbers without a state: a hash of (seed, step, number of the parcel, which draw). A
// parcel draws the same numbers on whatever rank it is, and after a restart.
// The mixing function is the finaliser of SplitMix64 (Steele, Lea and Flood, OOPSLA 2014, 453).
#pragma once

#include <cmath>
#include <cstdint>

namespace gasgrain {

inline std::uint64_t mix_bits(std::uint64_t z) {
  z += 0x9e3779b97f4a7c15ULL;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
  return z ^ (z >> 31);
}

class CounterRandom {
 public:
  CounterRandom(std::uint64_t seed, std::uint64_t step, std::uint64_t number)
      : key_(mix_bits(mix_bits(mix_bits(seed) + step) + number)) {}

  // Even from above 0 to below 1.
  double uniform() { return (static_cast<double>(mix_bits(key_ + draw_++) >> 12) + 0.5) * 0x1p-52; }
  // Of mean 0 and variance 1 (Box and Muller).
  double normal() {
    const double r = std::sqrt(-2.0 * std::log(uniform()));
    return r * std::cos(2.0 * M_PI * uniform());
  }

 private:
  std::uint64_t key_;
  std::uint64_t draw_ = 0;
};

}  // namespace gasgrain
