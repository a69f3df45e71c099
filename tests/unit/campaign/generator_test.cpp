// Streams of random numbers equal those of OpenTURNS 1.20, with which the published samples were drawn.
#include "campaign/draws/generator.h"

#include <gtest/gtest.h>

#include "campaign/draws/sampling.h"

namespace wythe {
namespace {

TEST(Generator, gives_the_numbers_that_openturns_gave) {
  Generator generator(12345);
  for (const double known : {0.45516877904350905, 0.65316585136433369, 0.17618172678628552,
                             0.029055985342306245, 0.32360217517874079})
    EXPECT_EQ(generator.uniform(), known);
  for (int k = 5; k < 999; ++k) generator.uniform();  // beyond a refill of the state
  EXPECT_EQ(generator.uniform(), 0.19317561516053594);
  Generator whole(777);
  for (const std::uint64_t known : {2U, 1U, 0U, 0U, 4U, 3U, 5U, 6U})
    EXPECT_EQ(whole.below(7), known);
}

TEST(Generator, fills_the_unit_interval_evenly) {
  Generator generator(1);
  std::array<int, 16> count{};
  double sum = 0;
  constexpr int kDrawn = 160'000;
  for (int k = 0; k < kDrawn; ++k) {
    const double u = generator.uniform();
    ASSERT_TRUE(u >= 0 && u < 1);
    ++count[static_cast<std::size_t>(16 * u)];
    sum += u;
  }
  EXPECT_NEAR(sum / kDrawn, 0.5, 4 * 0.29 / 400);               // four standard errors
  for (const int here : count) EXPECT_NEAR(here, 10'000, 400);  // the same of each sixteenth
}

TEST(Generator, streams_of_two_names_or_seeds_differ) {
  const std::vector<double> a = normal_numbers(1, "a", 8);
  EXPECT_NE(a, normal_numbers(1, "b", 8));
  EXPECT_NE(a, normal_numbers(2, "a", 8));
  EXPECT_EQ(a, normal_numbers(1, "a", 8));
}

}  // namespace
}  // namespace wythe
