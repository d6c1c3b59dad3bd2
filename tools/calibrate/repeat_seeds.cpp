#include "tools/calibrate/repeat_seeds.h"

namespace gasgrain {

namespace {

bool is_prime(long number) {
  for (long divisor = 2; divisor * divisor <= number; ++divisor)
    if (number % divisor == 0) return false;
  return number > 1;
}

}  // namespace

std::vector<long> repeat_seeds(long first, int count) {
  std::vector<long> seeds{first};
  while (static_cast<int>(seeds.size()) < count) {
    // Neighbours make like numbers at first in a congruential generator.
    constexpr long apart = 104729;
    long next = seeds.back() + apart;
    while (!is_prime(next)) ++next;
    seeds.push_back(next);
  }
  return seeds;
}

}  // namespace gasgrain
