// A mode II energy that grows with the pressure, GII = a + b sn (docs/theory/joint_law.md, 3.11a): stresses
// and areas in closed form for every shape, a varying pressure, snap-back, and b = 0 as the law without it.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "contact/law.h"
#include "contact/parameters.h"
#include "scenes/scenes.h"
#include "wythe/parts/contact_law.h"

namespace wythe::rising_energy_test {
namespace {

constexpr Softening kSoftenings[] = {Softening::kBilinear, Softening::kExponential,
                                     Softening::kPolynomial, Softening::kPetersson};
static_assert(std::size(kSoftenings) == std::size(kSofteningWords));
constexpr double kPressures[] = {0, 0.2e6, 0.7e6, 2e6};  // [Pa]
constexpr double kB = 0.13e-3;                           // [m]

JointMaterial rising(Softening softening, double b = kB) {
  JointMaterial m = scenes::paper_joint();
  m.softening = softening;
  m.mode_2_energy_per_pressure = b;
  return m;
}

contact::LawUpdate<double> update(const contact::LawConstants<double>& m, double w, double s,
                                  contact::History<double>& h) {
  return contact::with_variant(
      m.choice, [&](auto variant) { return contact::update<decltype(variant)>(m, w, s, h); });
}

// The numbers of (3.10) for a joint under constant pressure.
struct Under {
  double pressure, residual, drop, energy;
  Under(const JointMaterial& m, double sn)
      : pressure(sn),
        residual(m.residual_cohesion + sn * std::tan(m.residual_friction_angle)),
        drop(m.cohesion + sn * std::tan(m.friction_angle) - residual),
        energy(m.mode_2_energy + m.mode_2_energy_per_pressure * sn) {}
  [[nodiscard]] double yield(Softening softening, double slip) const {
    return residual + drop * contact::soften(softening, slip * drop / energy).left;
  }
};

// Work above the residual over `n` equal plastic slips up to x = `end` of (3.4), each stress held against (3.10). The slip
// that is asked for ends where the plastic slip is the one wanted.
double work_above_residual(const JointMaterial& m, double sn, int n, double end) {
  const auto law = contact::constants_of(m);
  const Under under(m, sn);
  contact::History<double> h{};
  double work = 0;
  for (int k = 0; k <= n; ++k) {
    const double plastic = end * under.energy / under.drop * k / n;
    const double tau = under.yield(m.softening, plastic);
    const auto now = update(law, -sn / m.normal_stiffness, plastic + tau / m.shear_stiffness, h);
    EXPECT_NEAR(now.tau, tau, 1e-12 * under.yield(m.softening, 0)) << "slip " << plastic;
    EXPECT_NEAR(h.slip, plastic, 1e-12 * end * under.energy / under.drop);
    work += now.friction + now.fracture;
  }
  return work - under.residual * h.slip;
}

// Trapezoids are exact on straight pieces (bilinear, petersson with its knee between two of 36 slips); of a parabola they
// miss by a share of h^2, which two cuts take out; of exp(-x) they give (h/2) coth(h/2). What is left is rounding,
// and of exp(-x) its polynomial's 1e-13 over 300 slips.
TEST(RisingEnergy, work_above_the_residual_is_a_plus_b_sn_for_every_shape) {
  for (const double sn : kPressures) {
    const Under under(rising(Softening::kBilinear), sn);
    EXPECT_DOUBLE_EQ(under.energy, 125 + kB * sn);
    const auto share = [&](Softening softening, int n, double end) {
      return work_above_residual(rising(softening), sn, n, end) / under.energy;
    };
    EXPECT_NEAR(share(Softening::kBilinear, 7, 2), 1, 1e-12);
    EXPECT_NEAR(share(Softening::kPetersson, 36, 3.6), 1, 1e-12);
    const double coarse = share(Softening::kPolynomial, 30, 3);
    const double fine = share(Softening::kPolynomial, 60, 3);
    EXPECT_NEAR((4 * fine - coarse) / 3, 1, 1e-12);
    const double half = 0.5 * 45 / 300;  // exp(-x) ends at 45
    EXPECT_NEAR(share(Softening::kExponential, 300, 45) * std::tanh(half) / half, 1, 1e-11);
  }
}

// On the falling branch, whatever cuts a slip into steps.
TEST(RisingEnergy, work_does_not_depend_on_the_step) {
  EXPECT_TRUE(rc::check([] {
    const JointMaterial m = rising(Softening::kBilinear, *rc::gen::inRange(0, 500) * 1e-6);
    const double sn = *rc::gen::inRange(0, 2000) * 1e3, w = -sn / m.normal_stiffness;
    const auto law = contact::constants_of(m);
    const Under under(m, sn);
    const double peak = under.yield(m.softening, 0) / m.shear_stiffness;
    const double last = 1.9 * under.energy / under.drop;
    auto cuts = *rc::gen::container<std::vector<int>>(rc::gen::inRange(1, 1000));
    std::sort(cuts.begin(), cuts.end());
    cuts.push_back(1000);
    const auto work_of = [&](const std::vector<int>& permille) {
      contact::History<double> h{};
      static_cast<void>(update(law, w, peak, h));
      double work = 0;
      for (const int p : permille) {
        const auto now = update(law, w, peak + (last - peak) * p / 1000, h);
        work += now.friction + now.fracture;
      }
      return work;
    };
    const double whole = work_of({1000});
    RC_ASSERT(std::fabs(work_of(cuts) - whole) <= 1e-11 * whole);
  }));
}

// A slip of half of what uses up GII under 0.5 MPa. As b/a is above the drop of friction over that of cohesion, the same
// slip is a larger share of GII under less pressure: the joint wears as it is relieved, and nothing heals.
TEST(RisingEnergy, damage_follows_the_pressure_down_and_never_back) {
  const JointMaterial m = rising(Softening::kBilinear);
  const auto law = contact::constants_of(m);
  const Under high(m, 0.5e6), low(m, 0.1e6);
  ASSERT_GT(high.energy / high.drop, low.energy / low.drop);
  const double plastic = high.energy / high.drop;
  const double s = plastic + high.yield(m.softening, plastic) / m.shear_stiffness;
  contact::History<double> h{};
  static_cast<void>(update(law, -0.5e6 / m.normal_stiffness, s, h));
  EXPECT_NEAR(h.shear_damage, 0.5, 1e-12);
  // at the slip where it carries nothing, so that it doesn't slide
  static_cast<void>(update(law, -0.1e6 / m.normal_stiffness, h.plastic_slip, h));
  const double worn = 0.5 * plastic * low.drop / low.energy;
  EXPECT_GT(worn, 0.5);
  EXPECT_NEAR(h.shear_damage, worn, 1e-12);
  static_cast<void>(update(law, -0.5e6 / m.normal_stiffness, h.plastic_slip, h));
  EXPECT_NEAR(h.shear_damage, worn, 1e-12);
  EXPECT_NEAR(h.slip, plastic, 1e-15);
}

// Drawn to half of what bears it, and pressed by nothing: GII is a.
TEST(RisingEnergy, a_joint_that_is_not_pressed_has_the_bits_of_one_without) {
  for (const Softening softening : kSoftenings)
    for (const double share : {0.0, 0.5}) {
      const JointMaterial m = rising(softening), none = rising(softening, 0);
      const auto law = contact::constants_of(m), same = contact::constants_of(none);
      const double w = share * m.tensile_strength / m.normal_stiffness;
      contact::History<double> h{}, g{};
      for (int k = 1; k <= 100; ++k) {
        const double tau = update(law, w, 3e-5 * k, h).tau;
        EXPECT_EQ(tau, update(same, w, 3e-5 * k, g).tau) << share << " at " << k;
      }
      EXPECT_GT(h.shear_damage, 0.8);
      EXPECT_EQ(h.shear_damage, g.shear_damage);
    }
}

TEST(RisingEnergy, damage_never_falls_on_any_path) {
  EXPECT_TRUE(rc::check([] {
    const JointMaterial m = rising(kSoftenings[*rc::gen::inRange(0, 4)]);
    const auto law = contact::constants_of(m);
    contact::History<double> h{};
    double last = 0;
    for (const auto& [pressed, slip] : *rc::gen::container<std::vector<std::pair<int, int>>>(
             rc::gen::pair(rc::gen::inRange(-100, 20), rc::gen::inRange(-300, 301)))) {
      const auto now = update(law, 1e-6 * pressed, 2e-6 * slip, h);
      RC_ASSERT(now.damage >= last - 1e-15);
      RC_ASSERT(now.damage <= 1);
      RC_ASSERT(now.friction + now.fracture >= -1e-12);
      last = now.damage;
    }
  }));
}

TEST(RisingEnergy, none_stated_as_zero_has_the_bits_of_none) {
  EXPECT_TRUE(rc::check([] {
    JointMaterial m = *rc::gen::arbitrary<bool>() ? scenes::capped_joint() : scenes::paper_joint();
    m.softening = kSoftenings[*rc::gen::inRange(0, 4)];
    JointMaterial zero = m;
    zero.mode_2_energy_per_pressure = 0;
    const auto law = contact::constants_of(m), same = contact::constants_of(zero);
    RC_ASSERT(!law.choice.rising && same.choice.rising);
    contact::History<double> h{}, g{};
    for (const auto& [opening, slip] : *rc::gen::container<std::vector<std::pair<int, int>>>(
             rc::gen::pair(rc::gen::inRange(-100, 60), rc::gen::inRange(-300, 301)))) {
      const auto one = update(law, 1e-6 * opening, 2e-6 * slip, h);
      const auto other = update(same, 1e-6 * opening, 2e-6 * slip, g);
      const auto bits = [](double x) { return std::bit_cast<std::uint64_t>(x); };
      RC_ASSERT(bits(one.sigma) == bits(other.sigma) && bits(one.tau) == bits(other.tau));
      RC_ASSERT(bits(one.fracture) == bits(other.fracture));
      for (const auto number : contact::kHistory<double>)
        RC_ASSERT(bits(h.*number) == bits(g.*number));
    }
  }));
}

const MaterialFault* fault_of(const std::vector<MaterialFault>& faults, const std::string& key) {
  const auto found = std::find_if(faults.begin(), faults.end(),
                                  [&](const MaterialFault& f) { return f.key == key; });
  return found == faults.end() ? nullptr : &*found;
}

// a + b sn - G (t0 - tr)^2/ks is concave in sn: both ends above 0, all between.
TEST(RisingEnergy, snap_back_is_refused_at_the_worse_end_of_the_pressures) {
  for (const Softening softening : kSoftenings) {
    JointMaterial m = rising(softening);
    m.friction_angle = scenes::degrees(45);
    m.residual_friction_angle = scenes::degrees(30);
    const double steepest = contact::steepest_slope(softening), fc = m.compressive_strength;
    const auto least = [&](double sn) {
      return steepest * std::pow(Under(m, sn).drop, 2) / m.shear_stiffness;
    };
    // without b the end at fc decides; b may give all that it asks for, and the other end remains
    for (const double given : {0.0, 0.5, 1.0, 3.0}) {
      m.mode_2_energy_per_pressure = given * (least(fc) - least(0)) / fc;
      const double bound = std::max(least(0), least(fc) - m.mode_2_energy_per_pressure * fc);
      m.mode_2_energy = (1 - 1e-9) * bound;
      EXPECT_NE(fault_of(check_joint_material(m), "mode_2_energy"), nullptr) << given;
      m.mode_2_energy = (1 + 1e-9) * bound;
      EXPECT_TRUE(check_joint_material(m).empty()) << given;
      for (double sn = 0; sn <= fc; sn += fc / 50)
        EXPECT_GT(Under(m, sn).energy, least(sn) * (1 - 1e-12)) << given << " at " << sn;
    }
  }
}

TEST(RisingEnergy, a_fault_says_how_much_the_pressure_gives) {
  JointMaterial m = rising(Softening::kBilinear, 1e-6);
  m.friction_angle = scenes::degrees(60);
  m.mode_2_energy = 20;
  const auto faults = check_joint_material(m);
  const MaterialFault* fault = fault_of(faults, "mode_2_energy");
  ASSERT_NE(fault, nullptr);
  EXPECT_NE(fault->problem.find("3.96 N/m more by mode_2_energy_per_pressure"), std::string::npos)
      << fault->problem;
  for (const double bad : {-1e-4, kUnlimited}) {
    m = rising(Softening::kBilinear, bad);
    EXPECT_NE(fault_of(check_joint_material(m), "mode_2_energy_per_pressure"), nullptr);
  }
}

}  // namespace
}  // namespace wythe::rising_energy_test
