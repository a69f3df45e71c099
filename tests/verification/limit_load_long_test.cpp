// Limit analysis of a facade of thousands of blocks. LimitLoad.both_bounds_of_the_tuff_wall_meet is its short form with 825 blocks.
#include <gtest/gtest.h>

#include "scenes/places.h"
#include "verification/record.h"
#include "wythe/parts/io.h"
#include "wythe/parts/limit.h"

namespace wythe::verification::limit_load_long_test {
namespace {

// Two storeys, six windows and a door. The figure is that of another program, Clp's interior point, on
// the static programme alone.
TEST(LargeLimitLoad, facade_of_4660_blocks) {
  const Model model = compile(read_model(source_dir() + "/tests/verification/facade.toml"));
  ASSERT_EQ(model.n_block, 4660);
  const LimitResult answer = limit_load(model, {});
  EXPECT_NEAR(answer.kinematic / answer.load, 1, 1e-6) << "both theorems";
  EXPECT_LT(answer.accuracy, 1e-7);
  verify({"LP-5", "facade of 4 660 blocks, dry", "kN", 39.545685, 2e-6, "six digits of Clp's"},
         1e-3 * answer.load);
}

}  // namespace
}  // namespace wythe::verification::limit_load_long_test
