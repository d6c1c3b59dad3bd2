// A fault that one rank finds, or several, stops all with the same words.
#include <gtest/gtest.h>

#include <string>

#include "coupling/run_watch.h"

namespace gasgrain {
namespace {

TEST(run_watch, the_lowest_rank_that_found_a_fault_tells_all) {
  const Communicator world(MPI_COMM_WORLD);
  ASSERT_EQ(world.size(), 4);
  share_fault(world, "");
  for (int first = 0; first < 4; ++first) {
    const bool mine = world.rank() >= first && world.rank() % 2 == first % 2;
    std::string told;
    try {
      share_fault(world, mine ? std::string(10 + 5 * world.rank(), 'a' + world.rank()) : "");
    } catch (const RunFault& fault) {
      told = fault.what();
    }
    EXPECT_EQ(told, std::string(10 + 5 * first, static_cast<char>('a' + first)));
  }
}

}  // namespace
}  // namespace gasgrain
