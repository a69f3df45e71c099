// Crushing under normal and shear stress together, hardening and dilatancy: strengths, areas and
// energies in closed form (docs/theory/joint_law.md), refusals, and no recovery of strength.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "contact/law.h"
#include "contact/parameters.h"
#include "scenes/scenes.h"
#include "wythe/parts/contact_law.h"

namespace wythe::compression_cap_test {
namespace {

using contact::History;

constexpr double kCss = 9;

// Friction that never slides, so that the cap alone acts in compression.
JointMaterial cap_alone() {
  JointMaterial m = scenes::paper_joint();
  m.compression_cap = kCss;
  m.cohesion = m.residual_cohesion = 0.3 * m.compressive_strength;
  m.friction_angle = m.residual_friction_angle = scenes::degrees(80);
  return m;
}

JointMaterial with_hardening(JointMaterial m) {
  m.hardening_displacement = 0.3e-3;
  return m;
}

contact::LawUpdate<double> step(const contact::LawConstants<double>& m, double w, double s,
                                History<double>& h) {
  return contact::with_variant(
      m.choice, [&](auto variant) { return contact::update<decltype(variant)>(m, w, s, h); });
}

// F(q): fc/3 to fc along a parabola, then straight to 0 so that the whole area is Gc.
double strength_after(const JointMaterial& m, double q) {
  const double fc = m.compressive_strength;
  const double harden = m.hardening_displacement > 0 ? m.hardening_displacement : 0.0;
  if (q < harden) return fc / 3 + 2 * fc / 3 * (2 * q / harden - q * q / harden / harden);
  const double area = harden * fc * 7 / 9, fall = 2 * (m.compressive_energy - area) / fc;
  return fc * std::max(0.0, 1 - (q - harden) / fall);
}

TEST(CompressionCap, pressed_alone_it_is_the_law_without_a_cap) {
  JointMaterial plain = scenes::paper_joint(), capped = plain;
  capped.compression_cap = kCss;
  std::vector<ContactPathRow> path;
  for (const double w : {-1e-4, -3e-4, -1e-3, -8e-4, -2e-3, -7e-3, 1e-5, -9e-3})
    path.push_back({w, 0});
  const auto a = drive_contact(plain, path), b = drive_contact(capped, path);
  for (std::size_t k = 0; k < path.size(); ++k) {
    EXPECT_NEAR(a[k].normal_stress, b[k].normal_stress, 1e-7 * plain.compressive_strength) << k;
    EXPECT_NEAR(a[k].dissipated, b[k].dissipated, 1e-6 * plain.compressive_energy) << k;
    EXPECT_NEAR(a[k].crushing, b[k].crushing, 1e-9) << k;
  }
}

TEST(CompressionCap, first_crushing_lies_on_the_ellipse) {
  const JointMaterial m = cap_alone();
  const double fc = m.compressive_strength;
  for (const double share : {0.05, 0.2, 0.5, 0.8, 0.99}) {
    const double w = -share * fc / m.normal_stiffness;
    const double most = fc * std::sqrt((1 - share * share) / kCss);
    const double slip = most / m.shear_stiffness;
    const auto below = drive_contact(m, {{w, 0}, {w, 0.999 * slip}});
    EXPECT_EQ(below.back().crushing, 0) << share;
    EXPECT_NEAR(below.back().shear_stress, 0.999 * most, 1e-6 * fc);
    const auto above = drive_contact(m, {{w, 0}, {w, 1.05 * slip}});
    EXPECT_GT(above.back().crushing, 0) << share;
    const double sigma = above.back().normal_stress, tau = above.back().shear_stress;
    EXPECT_LT(sigma * sigma + kCss * tau * tau, fc * fc);
  }
}

// On every way from rest to nothing left the cap takes Gc, however pressure and shear share it.
TEST(CompressionCap, crushing_takes_the_compressive_energy_in_every_direction_and_cut) {
  EXPECT_TRUE(rc::check([] {
    const JointMaterial m = *rc::gen::arbitrary<bool>() ? with_hardening(cap_alone()) : cap_alone();
    const double angle = *rc::gen::inRange(0, 80) * scenes::degrees(1);
    const int steps = *rc::gen::inRange(2000, 8000);
    const double far = 20 * m.compressive_energy / m.compressive_strength;
    const auto law = contact::constants_of(m);
    History<double> h{};
    contact::LawUpdate<double> before{}, now{};
    double work = 0, crushed = 0, w0 = 0, s0 = 0;
    for (int k = 1; k <= steps; ++k) {
      const double w = -far * std::cos(angle) * k / steps, s = far * std::sin(angle) * k / steps;
      now = step(law, w, s, h);
      work += 0.5 * (before.sigma + now.sigma) * (w - w0) + 0.5 * (before.tau + now.tau) * (s - s0);
      crushed += now.crushing;
      before = now;
      w0 = w;
      s0 = s;
    }
    RC_ASSERT(now.sigma == 0.0);
    RC_ASSERT(now.tau == 0.0);
    RC_ASSERT(std::fabs(crushed / m.compressive_energy - 1) < 1e-9);
    RC_ASSERT(std::fabs(work / m.compressive_energy - 1) <
              0.01);  // of steps that jump over the peak
  }));
}

TEST(CompressionCap, stress_stays_on_the_cap_and_what_is_crushed_never_comes_back) {
  EXPECT_TRUE(rc::check([] {
    const JointMaterial m = *rc::gen::arbitrary<bool>() ? with_hardening(cap_alone()) : cap_alone();
    const auto law = contact::constants_of(m);
    History<double> h{};
    double q = 0;
    const auto targets = *rc::gen::container<std::vector<std::pair<int, int>>>(
        rc::gen::pair(rc::gen::inRange(-200, 20), rc::gen::inRange(-200, 200)));
    double w0 = 0, s0 = 0;
    for (const auto& [opening, slip] : targets)
      for (int k = 1; k <= 50; ++k) {
        const double w = w0 + (1e-5 * opening - w0) * k / 50, s = s0 + (1e-5 * slip - s0) * k / 50;
        const auto now = step(law, w, s, h);
        const double pressed = std::min(now.sigma, 0.0), strength = strength_after(m, h.crush_path);
        RC_ASSERT(std::hypot(pressed, std::sqrt(kCss) * now.tau) <=
                  strength + 1e-6 * m.compressive_strength);
        RC_ASSERT(h.crush_path >= q);
        RC_ASSERT(now.crushing >= 0);
        q = h.crush_path;
        if (k == 50) w0 = w, s0 = s;
      }
  }));
}

// The corner: of friction c + sn tan phi and the cap the smaller holds.
TEST(CompressionCap, shear_is_held_by_friction_or_cap_whichever_is_smaller) {
  JointMaterial m = scenes::paper_joint();
  m.compression_cap = kCss;
  m.friction_angle = m.residual_friction_angle = scenes::degrees(35);
  m.residual_cohesion = m.cohesion;  // no softening in shear
  const double fc = m.compressive_strength, tan = std::tan(m.friction_angle);
  for (const double share : {0.05, 0.2, 0.35, 0.5, 0.7, 0.9}) {
    const double w = -share * fc / m.normal_stiffness;
    const double friction = m.cohesion + share * fc * tan;
    const double cap = fc * std::sqrt((1 - share * share) / kCss);
    // slip until just beyond the smaller of the two
    const double most = std::min(friction, cap);
    const auto at = drive_contact(m, {{w, 0}, {w, 1.0001 * most / m.shear_stiffness}}).back();
    EXPECT_NEAR(at.shear_stress, most, 2e-4 * most) << share;
    EXPECT_EQ(at.crushing > 0, cap < friction) << share;
    // far along: the cap has softened, or friction holds with nothing crushed
    const auto far = drive_contact(m, {{w, 0}, {w, 2e-3}}).back();
    if (friction < 0.99 * cap) {
      EXPECT_NEAR(far.shear_stress, friction, 1e-6 * fc) << share;
      EXPECT_EQ(far.crushing, 0) << share;
    } else {
      EXPECT_GT(far.crushing, 0.005) << share;
    }
  }
}

TEST(CompressionCap, hardening_rises_from_a_third_and_keeps_the_area) {
  const JointMaterial m = with_hardening(scenes::paper_joint());
  const auto law = contact::constants_of(m);
  for (const double q : {0.0, 1e-5, 1e-4, 2.9e-4, 3e-4, 3.1e-4, 1e-3, 6e-3, 7e-3})
    EXPECT_NEAR(contact::crush_strength(law, q).left, strength_after(m, q),
                1e-9 * m.compressive_strength)
        << q;
  // work by the closed form against the area under F
  double area = 0;
  constexpr int kSteps = 20000;
  for (int k = 0; k < kSteps; ++k)
    area += strength_after(m, law.p_full * (k + 0.5) / kSteps) * law.p_full / kSteps;
  EXPECT_NEAR(contact::crush_work(law, law.p_full), m.compressive_energy,
              1e-9 * m.compressive_energy);
  EXPECT_NEAR(area, m.compressive_energy, 1e-5 * m.compressive_energy);
  const auto pressed = drive_contact(m, {{-0.02, 0}}).back();
  EXPECT_NEAR(pressed.dissipated, m.compressive_energy, 1e-3 * m.compressive_energy);
  EXPECT_EQ(pressed.crushing, 1);
}

TEST(CompressionCap, dilatancy_lifts_with_slip_and_fades) {
  JointMaterial m = scenes::paper_joint();
  m.compressive_strength = kUnlimited;
  m.dilatancy_angle = scenes::degrees(10);
  const double tan = std::tan(m.dilatancy_angle), press = -1e-6;
  const auto rise = [&](double slip) {  // of the stress, where the joint can't open
    const auto a = drive_contact(m, {{press, 0}, {press, slip}});
    return -(a.back().normal_stress - a.front().normal_stress) / m.normal_stiffness;
  };
  // plastic slip s: tan psi s
  const auto plastic = [&](double slip) {
    const auto a = drive_contact(m, {{press, 0}, {press, slip}});
    return slip - a.back().shear_stress / m.shear_stiffness;
  };
  EXPECT_NEAR(rise(2e-4), tan * plastic(2e-4), 1e-3 * tan * 2e-4);
  m.dilatancy_slip = 1e-4;  // fades on a straight line: tan psi s0/2 in all
  EXPECT_NEAR(rise(5e-4), 0.5 * tan * m.dilatancy_slip, 1e-3 * tan * 1e-4);
  m.dilatancy_slip = kUnset;
  m.dilatancy_pressure = 50e3;  // as the stress rises, d sigma/ds = kn tan psi (1 - sigma/su)
  EXPECT_LT(rise(5e-4) - press, 1.001 * m.dilatancy_pressure / m.normal_stiffness);
  EXPECT_GT(rise(5e-4) - press, 0.9 * m.dilatancy_pressure / m.normal_stiffness);
}

const MaterialFault* fault_of(const std::vector<MaterialFault>& faults, const std::string& key) {
  const auto at = std::find_if(faults.begin(), faults.end(),
                               [&](const MaterialFault& f) { return f.key == key; });
  return at == faults.end() ? nullptr : &*at;
}

void expect_fault(const JointMaterial& m, const std::string& key, const std::string& part) {
  const auto faults = check_joint_material(m);
  const MaterialFault* fault = fault_of(faults, key);
  ASSERT_NE(fault, nullptr) << key;
  EXPECT_EQ(fault->value.empty(), fault->problem.starts_with("is missing"));
  EXPECT_NE(fault->problem.find(part), std::string::npos) << fault->problem;
  EXPECT_FALSE(fault->cure.empty());
}

TEST(CompressionCap, what_makes_no_sense_is_refused_with_its_numbers) {
  EXPECT_TRUE(check_joint_material(scenes::capped_joint()).empty());
  JointMaterial m = scenes::capped_joint();
  m.compression_cap = 0;
  expect_fault(m, "compression_cap", "must be more than 0");
  m.compression_cap = 1000;  // 3.96/sqrt(1000) = 0.125 MPa, below the cohesion of 0.15
  expect_fault(m, "compression_cap", "cap and friction never meet");
  m = scenes::capped_joint();
  m.compressive_strength = kUnlimited;
  expect_fault(m, "compression_cap", "unlimited");
  expect_fault(m, "hardening_displacement", "unlimited");
  m = scenes::capped_joint();
  m.hardening_displacement = 5e-3;  // 7/9 5 mm 3.96 MPa = 15 400 N/m
  expect_fault(m, "hardening_displacement", "15400 N/m");
  m = scenes::capped_joint();
  m.compressive_energy = 600;  // of which hardening takes 277; fc^2/(2 kn) is 392
  expect_fault(m, "compressive_energy", "snap-back");
  m = scenes::capped_joint();
  m.shear_stiffness = 0.02e9;  // Css ks = 0.18 GPa/m: fc^2/(2 Css ks) = 43 560 N/m
  expect_fault(m, "compressive_energy", "snap-back");
  m = scenes::capped_joint();
  m.dilatancy_angle = scenes::degrees(20);
  expect_fault(m, "dilatancy_angle", "make energy");
  m.dilatancy_angle = kUnset;
  expect_fault(m, "dilatancy_angle", "is missing");
}

}  // namespace
}  // namespace wythe::compression_cap_test
