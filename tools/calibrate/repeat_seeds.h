// Seeds of repeats: runs that differ by nothing else.
#pragma once

#include <vector>

namespace gasgrain {

// `first`, then primes far from each other: LIGGGHTS takes as a seed only a prime above 10000.
std::vector<long> repeat_seeds(long first, int count);

}  // namespace gasgrain
