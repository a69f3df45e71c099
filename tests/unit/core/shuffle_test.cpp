// Rearrangements of packs against plain loops, for every width on any processor.
#pragma GCC diagnostic ignored "-Wpsabi"  // wide vectors are passed to inlined functions only
#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <numeric>

#include "dynamics/passes/shuffle.h"

namespace wythe::dynamics::shuffle_test {
namespace {

typedef double Two __attribute__((vector_size(16)));
typedef double Four __attribute__((vector_size(32)));
typedef double Eight __attribute__((vector_size(64)));

template <class V>
class Shuffle : public testing::Test {};
using Widths = testing::Types<Two, Four, Eight>;
TYPED_TEST_SUITE(Shuffle, Widths);

TYPED_TEST(Shuffle, scattered_rows_become_columns_and_go_back) {
  using V = TypeParam;
  constexpr int width = shuffle::width_of<V>;
  std::array<double, 4 * 32> rows;
  std::iota(rows.begin(), rows.end(), 1.0);
  std::array<std::int32_t, width> id;
  for (std::size_t k = 0; k < width; ++k) id[k] = static_cast<std::int32_t>((7 * k + 3) % 32);
  V column[4];
  shuffle::load_rows(rows.data(), id.data(), column);
  shuffle::transpose(column);
  for (std::size_t c = 0; c < 4; ++c) {
    std::array<double, width> lane;
    shuffle::store(column[c], lane.data());
    for (std::size_t k = 0; k < width; ++k)
      EXPECT_EQ(lane[k], rows[4 * static_cast<std::size_t>(id[k]) + c]);
  }
  shuffle::transpose(column);
  std::array<double, 4 * width> back;
  shuffle::store_rows(column, back.data());
  for (std::size_t k = 0; k < width; ++k)
    for (std::size_t c = 0; c < 4; ++c)
      EXPECT_EQ(back[4 * k + c], rows[4 * static_cast<std::size_t>(id[k]) + c]);
}

}  // namespace
}  // namespace wythe::dynamics::shuffle_test
