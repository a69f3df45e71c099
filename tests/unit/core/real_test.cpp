// The scalar types: exp and sine without libm, Dual, and the tangent of the joint law.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

#include "contact/law.h"
#include "contact/parameters.h"
#include "core/dual.h"
#include "core/real.h"
#include "scenes/scenes.h"

namespace wythe::real_test {
namespace {

TEST(Real, exp_of_minus_agrees_with_the_library) {
  for (int k = 0; k < 45000; ++k) {
    const double x = 1e-3 * k;
    // Taylor rest below 1e-16 and eight squarings of a rounding each: 2^8 x 2^-53 = 3e-14
    EXPECT_NEAR(exp_of_minus(x) / std::exp(-x), 1.0, 1e-13) << x;
  }
  EXPECT_EQ(exp_of_minus(0.0), 1.0);
  EXPECT_EQ(exp_of_minus(46.0), 0.0);
  EXPECT_EQ(exp_of_minus(1e300), 0.0);
}

TEST(Real, exp_of_minus_never_rises) {
  double last = 1;
  for (int k = 1; k < 100000; ++k) {
    const double now = exp_of_minus(1e-4 * k);
    EXPECT_LE(now, last);
    last = now;
  }
}

TEST(Real, sin_cos_agree_with_the_library) {
  for (int k = -31415; k <= 31415; ++k) {
    const double angle = 1e-4 * k;
    const SinCos<double> r = sin_cos(angle);
    // each of the two doublings about doubles the rounding of 1e-16; the step needs half angles
    const double size = std::fabs(angle);
    const double tolerance = size < 1 ? 3e-16 : size < 1.5708 ? 6e-16 : 1.5e-15;
    EXPECT_NEAR(r.sin, std::sin(angle), tolerance) << angle;
    EXPECT_NEAR(r.cos, std::cos(angle), tolerance) << angle;
  }
}

// Blocks that roll turn many times; a series without the whole turns taken off would change their shape.
TEST(Real, sin_cos_of_many_turns_agree_with_the_library) {
  for (double angle = -6300; angle < 6300; angle += 0.37) {
    const SinCos<double> r = sin_cos(angle);
    EXPECT_NEAR(r.sin, std::sin(angle), 1e-13) << angle;
    EXPECT_NEAR(r.cos, std::cos(angle), 1e-13) << angle;
    EXPECT_EQ(sin_cos(-angle).sin, -r.sin) << angle;
    EXPECT_EQ(sin_cos(-angle).cos, r.cos) << angle;
  }
}

TEST(Real, sin_cos_of_small_angles_keep_relative_accuracy) {
  for (const double angle : {1e-12, 1e-9, 1e-6, 1e-4, 0.01, 0.124, 0.126}) {
    EXPECT_NEAR(sin_cos(angle).sin / std::sin(angle), 1.0, 1e-15) << angle;
    EXPECT_EQ(sin_cos(-angle).sin, -sin_cos(angle).sin) << angle;  // mirror images stay mirrored
    EXPECT_EQ(sin_cos(-angle).cos, sin_cos(angle).cos) << angle;
  }
  EXPECT_EQ(sin_cos(0.0).sin, 0.0);
  EXPECT_EQ(sin_cos(0.0).cos, 1.0);
}

TEST(Real, sign_of_zero_is_zero) {
  EXPECT_EQ(sign(0.0), 0.0);
  EXPECT_EQ(sign(-0.0), 0.0);
  EXPECT_EQ(sign(2.0), 1.0);
  EXPECT_EQ(sign(-2.0), -1.0);
}

TEST(Dual, carries_the_chain_rule) {
  const Dual<2> x(3.0, 0), y(2.0, 1);
  const Dual<2> f = x * y / (x + y) - y;
  EXPECT_DOUBLE_EQ(f.value, 6.0 / 5 - 2);
  EXPECT_DOUBLE_EQ(f.partial[0], 4.0 / 25);        // y^2/(x + y)^2
  EXPECT_DOUBLE_EQ(f.partial[1], 9.0 / 25 - 1.0);  // x^2/(x + y)^2 - 1
  EXPECT_EQ(magnitude(-x).partial[0], 1.0);
  EXPECT_EQ(minimum(x, y).partial[1], 1.0);
}

// --- tangent of the law: Dual against central differences ----------------------------------------------

using D = Dual<2>;

contact::LawConstants<D> dual_of(const contact::LawConstants<double>& m) {
  contact::LawConstants<D> dual;
  for (std::size_t k = 0; k < contact::kConstants<double>.size(); ++k)
    dual.*contact::kConstants<D>[k] = m.*contact::kConstants<double>[k];
  dual.choice = m.choice;
  return dual;
}

contact::History<D> dual_of(const contact::History<double>& h) {
  contact::History<D> dual;
  for (std::size_t k = 0; k < contact::kHistory<double>.size(); ++k)
    dual.*contact::kHistory<D>[k] = h.*contact::kHistory<double>[k];
  return dual;
}

struct Stress {
  double sigma, tau;
};

template <class V>
Stress stress_at(const contact::LawConstants<double>& m, contact::History<double> h, double w,
                 double s) {
  const auto a = contact::update<V>(m, w, s, h);
  return {a.sigma, a.tau};
}

struct Tally {
  int compared = 0, skipped = 0;
};

// One partial of sigma or tau. A kink within h shows as a difference of the two one-sided slopes;
// there the tangent is one of them and nothing is compared.
void compare(double minus, double middle, double plus, double h, double partial, double stiffness,
             Tally& tally) {
  const double left = (middle - minus) / h, right = (plus - middle) / h;
  if (std::fabs(left - right) > 1e-3 * stiffness) {
    ++tally.skipped;
    return;
  }
  ++tally.compared;
  // one-sided slopes within 1e-3: curvature leaves the central difference right to h^2
  EXPECT_NEAR(partial, 0.5 * (left + right), 1e-3 * stiffness);
}

template <class V>
Tally compare_tangents(const JointMaterial& material) {
  const auto m = contact::constants_of(material);
  const auto dual_m = dual_of(m);
  std::mt19937 random(7);
  std::uniform_real_distribution<double> opening(-3e-4, 8e-5), slip(-8e-4, 8e-4);
  Tally tally;
  for (int walk = 0; walk < 100; ++walk) {
    contact::History<double> h{};
    for (int k = 0; k < 20; ++k) {
      const double w = opening(random), s = slip(random);
      contact::History<D> dual_h = dual_of(h);
      const auto dual = contact::update<V>(dual_m, D(w, 0), D(s, 1), dual_h);
      const double step = 1e-10;  // [m]; rounding of stresses 1e-9 Pa gives 10 Pa/m of 1e10
      const Stress at = stress_at<V>(m, h, w, s);
      EXPECT_NEAR(dual.sigma.value, at.sigma, 1e-6 * std::fabs(at.sigma));
      EXPECT_NEAR(dual.tau.value, at.tau, 1e-6 * std::fabs(at.tau));
      const Stress w0 = stress_at<V>(m, h, w - step, s), w1 = stress_at<V>(m, h, w + step, s);
      const Stress s0 = stress_at<V>(m, h, w, s - step), s1 = stress_at<V>(m, h, w, s + step);
      compare(w0.sigma, at.sigma, w1.sigma, step, dual.sigma.partial[0], m.kn, tally);
      compare(w0.tau, at.tau, w1.tau, step, dual.tau.partial[0], m.kn, tally);
      compare(s0.sigma, at.sigma, s1.sigma, step, dual.sigma.partial[1], m.ks, tally);
      compare(s0.tau, at.tau, s1.tau, step, dual.tau.partial[1], m.ks, tally);
      static_cast<void>(contact::update<V>(m, w, s, h));
    }
  }
  return tally;
}

TEST(LawTangent, dual_numbers_agree_with_central_differences_in_every_variant) {
  for (const Softening softening : {Softening::kBilinear, Softening::kExponential,
                                    Softening::kPolynomial, Softening::kPetersson})
    for (const Coupling coupling : {Coupling::kUnion, Coupling::kMaximum, Coupling::kStiffness})
      for (const int more : {0, 1, 2, 3, 4, 5, 6, 7}) {
        JointMaterial material = more % 4 < 2 ? scenes::paper_joint() : scenes::capped_joint();
        if (more >= 4) material.mode_2_energy_per_pressure = 0.2e-3;
        material.softening = softening;
        material.coupling = coupling;
        material.unloading = more % 2 == 0 ? Unloading::kSecant : Unloading::kElastic;
        SCOPED_TRACE(testing::Message()
                     << static_cast<int>(softening) << static_cast<int>(coupling) << more);
        const Tally tally = contact::with_variant(contact::choice_of(material), [&](auto variant) {
          return compare_tangents<decltype(variant)>(material);
        });
        EXPECT_LT(tally.skipped, 80) << "of " << tally.compared + tally.skipped;  // 1 %
      }
}

}  // namespace
}  // namespace wythe::real_test
