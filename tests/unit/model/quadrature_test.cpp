// Quadratures of a face: their exact degree, their symmetry, and the key that selects them.
#include "model/quadrature.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "scenes/scenes.h"
#include "wythe/parts/reading.h"

namespace wythe::quadrature_test {
namespace {

double integral(const FaceQuadrature& rule, int power) {
  double sum = 0;
  for (std::size_t k = 0; k < rule.xi.size(); ++k)
    sum += rule.weight[k] * std::pow(rule.xi[k], power);
  return sum;
}
// Mean of xi^power over the face.
double exact(int power) { return power % 2 == 1 ? 0 : 1.0 / (power + 1); }

void expect_exact_to(PointRule kind, int n, int degree) {
  const FaceQuadrature rule = face_points(kind, n);
  ASSERT_EQ(rule.xi.size(), static_cast<std::size_t>(n));
  for (int power = 0; power <= degree; ++power)
    EXPECT_NEAR(integral(rule, power), exact(power), 4e-15) << n << " points, power " << power;
  const int next = degree + 1;  // every degree here is odd
  EXPECT_GT(std::fabs(integral(rule, next) - exact(next)), 1e-12) << n << " points";
}

TEST(PointRule, each_is_exact_to_its_degree_and_no_further) {
  for (int n = 2; n <= 16; ++n) {
    expect_exact_to(PointRule::kTrapezoid, n, 1);
    if (n <= 10) expect_exact_to(PointRule::kLobatto, n, 2 * n - 3);
    if (n <= 9) expect_exact_to(PointRule::kGauss, n, 2 * n - 1);
  }
}

TEST(PointRule, published_values) {
  const FaceQuadrature lobatto = face_points(PointRule::kLobatto, 3);
  EXPECT_DOUBLE_EQ(lobatto.weight[0], 1.0 / 6);
  EXPECT_DOUBLE_EQ(lobatto.weight[1], 2.0 / 3);
  EXPECT_EQ(lobatto.xi[1], 0);
  const FaceQuadrature four = face_points(PointRule::kLobatto, 4);
  EXPECT_DOUBLE_EQ(four.xi[2], 1 / std::sqrt(5.0));
  EXPECT_DOUBLE_EQ(four.weight[2], 5.0 / 12);
  const FaceQuadrature gauss = face_points(PointRule::kGauss, 3);
  EXPECT_DOUBLE_EQ(gauss.xi[2], std::sqrt(0.6));
  EXPECT_NEAR(gauss.weight[0], 5.0 / 18, 1e-15);
}

TEST(PointRule, halves_of_a_face_are_alike_bit_for_bit) {
  for (const Word<PointRule>& word : kPointRuleWords)
    for (int n = 2; n <= 16; ++n) {
      const FaceQuadrature rule = face_points(word.value, n);
      for (std::size_t k = 0; k < rule.xi.size(); ++k) {
        const std::size_t other = rule.xi.size() - 1 - k;
        EXPECT_EQ(rule.xi[k] + 0.0, -rule.xi[other] + 0.0) << word.word << n;
        EXPECT_EQ(rule.weight[k], rule.weight[other]) << word.word << n;
        EXPECT_GT(rule.weight[k], 0) << word.word << n;
        if (k > 0) {
          EXPECT_GT(rule.xi[k], rule.xi[k - 1]) << word.word << n;
        }
      }
    }
}

TEST(PointRule, a_number_alone_means_what_it_always_meant) {
  const auto meant = [](PointRule rule, int points) {
    SolveSpec solve;
    solve.point_rule = rule;
    solve.points_per_face = points;
    const QuadratureChoice choice = quadrature_choice(solve);
    return std::string(word_of(kPointRuleWords, choice.rule)) + " " + std::to_string(choice.points);
  };
  EXPECT_EQ(meant(PointRule::kDefault, 0), "lobatto 3");
  EXPECT_EQ(meant(PointRule::kDefault, 2), "corners 2");
  EXPECT_EQ(meant(PointRule::kDefault, 3), "trapezoid 3");
  EXPECT_EQ(meant(PointRule::kCorners, 0), "corners 2");
  EXPECT_EQ(meant(PointRule::kLobatto, 0), "lobatto 3");
  EXPECT_EQ(meant(PointRule::kGauss, 2), "gauss 2");
}

std::string refusal(PointRule rule, int points) {
  SolveSpec solve;
  solve.point_rule = rule;
  solve.points_per_face = points;
  FaultList faults;
  check_points(solve, faults);
  try {
    faults.throw_if_any();
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(PointRule, a_number_the_rule_does_not_have_is_refused_with_the_cure) {
  EXPECT_NE(refusal(PointRule::kCorners, 3).find("a face has two ends"), std::string::npos);
  EXPECT_NE(refusal(PointRule::kGauss, 1).find("between 2 and 16"), std::string::npos);
  EXPECT_NE(refusal(PointRule::kLobatto, 17).find("between 2 and 16"), std::string::npos);
  EXPECT_EQ(refusal(PointRule::kLobatto, 2), "");
}

// The stiffness of a face against turning: k A L^2/12 of a continuous joint, three times that of corners.
TEST(PointRule, the_elastic_stiffness_in_rotation_is_that_of_a_continuous_joint) {
  EXPECT_NEAR(integral(face_points(PointRule::kCorners, 2), 2), 3 * exact(2), 1e-15);
  for (const int n : {3, 4, 5})
    EXPECT_NEAR(integral(face_points(PointRule::kLobatto, n), 2), exact(2), 1e-15);
  for (const int n : {2, 3})
    EXPECT_NEAR(integral(face_points(PointRule::kGauss, n), 2), exact(2), 1e-15);
}

// A joint reads its widest opening at its ends, also where no point stands there.
TEST(PointRule, the_opening_of_a_joint_is_that_of_its_wider_end) {
  double wanted = 0;
  for (const PointRule rule : {PointRule::kCorners, PointRule::kLobatto, PointRule::kGauss}) {
    ModelSpec spec = scenes::small_wall();
    spec.solve.point_rule = rule;
    const Model model = compile(spec);
    State state = initial_state(model);
    state.theta[5] = 1e-3;
    double widest = 0;
    for (const JointReading& joint : read_wall(model, state).joints)
      widest = std::fmax(widest, joint.opening);
    if (rule == PointRule::kCorners) wanted = widest;
    EXPECT_NEAR(widest, wanted, 1e-9 * wanted);
    EXPECT_GT(wanted, 1e-5);
  }
}

}  // namespace
}  // namespace wythe::quadrature_test
