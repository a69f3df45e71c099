// The team of threads: every chunk runs once, on any thread, and all threads see what was written before.
#include <gtest/gtest.h>

#include <vector>

#include "core/parallel.h"

namespace wythe::parallel_test {
namespace {

TEST(Workers, every_chunk_is_done_once_in_every_round) {
  for (const int threads : {1, 2, 3, 8}) {
    Workers workers(threads);
    for (const int chunks : {0, 1, 2, 7, 64}) {
      std::vector<int> done(static_cast<std::size_t>(chunks), 0);
      for (int round = 1; round <= 300; ++round) {
        workers.for_each_chunk(chunks, [&](int chunk) { ++done[chunk]; });
        for (const int times : done) ASSERT_EQ(times, round) << threads << " threads";
      }
    }
  }
}

TEST(Workers, a_round_sees_what_the_one_before_has_written) {
  Workers workers(4);
  std::vector<long> number(32, 1);
  for (int round = 0; round < 200; ++round) {
    const std::vector<long> before = number;
    workers.for_each_chunk(32, [&](int chunk) {
      const auto k = static_cast<std::size_t>(chunk);
      number[k] = (before[(k + 1) % 32] + before[(k + 31) % 32]) % 1000003;
    });
  }
  std::vector<long> alone(32, 1);
  for (int round = 0; round < 200; ++round) {
    const std::vector<long> before = alone;
    for (std::size_t k = 0; k < 32; ++k)
      alone[k] = (before[(k + 1) % 32] + before[(k + 31) % 32]) % 1000003;
  }
  EXPECT_EQ(number, alone);
}

TEST(Workers, a_team_that_is_never_asked_ends) {
  for (int k = 0; k < 20; ++k) Workers workers(3);
}

}  // namespace
}  // namespace wythe::parallel_test
