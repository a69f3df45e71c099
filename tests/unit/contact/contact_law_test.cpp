// The joint law: areas, damage, strengths, unloading, coupling, dry joints and refused materials.
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

namespace wythe::contact_law_test {
namespace {

using scenes::degrees;

constexpr Softening kSoftenings[] = {Softening::kBilinear, Softening::kExponential,
                                     Softening::kPolynomial, Softening::kPetersson};
static_assert(std::size(kSoftenings) == std::size(kSofteningWords));
constexpr Coupling kCouplings[] = {Coupling::kUnion, Coupling::kMaximum, Coupling::kStiffness};
constexpr Unloading kUnloadings[] = {Unloading::kSecant, Unloading::kElastic};

template <class Check>
void for_every_variant(const Check& check) {
  for (const Softening softening : kSoftenings)
    for (const Coupling coupling : kCouplings)
      for (const Unloading unloading : kUnloadings) {
        JointMaterial m = scenes::paper_joint();
        m.softening = softening;
        m.coupling = coupling;
        m.unloading = unloading;
        SCOPED_TRACE(testing::Message()
                     << "softening " << static_cast<int>(softening) << " coupling "
                     << static_cast<int>(coupling) << " unloading " << static_cast<int>(unloading));
        check(m);
      }
}

JointMaterial any_variant(int index) {
  JointMaterial m = scenes::paper_joint();
  m.softening = kSoftenings[index % 4];
  m.coupling = kCouplings[(index / 4) % 3];
  m.unloading = kUnloadings[(index / 12) % 2];
  return m;
}
// The same, half of them with a GII that grows with pressure.
JointMaterial any_rising(int index) {
  JointMaterial m = any_variant(index);
  if (*rc::gen::arbitrary<bool>()) m.mode_2_energy_per_pressure = 0.2e-3;
  return m;
}

// The same with all that goes with a cap; without what moves a joint sideways where `lifts` is false.
JointMaterial any_capped(int index, bool lifts = true) {
  const JointMaterial variant = any_variant(index);
  JointMaterial m = scenes::capped_joint();
  m.softening = variant.softening;
  m.coupling = variant.coupling;
  m.unloading = variant.unloading;
  if (!lifts) m.dilatancy_angle = m.dilatancy_slip = m.dilatancy_pressure = kUnset;
  return m;
}

// Random cuts of the way from `from` to `to`: what the law dissipates must not depend on them.
std::vector<ContactPathRow> cut(ContactPathRow from, ContactPathRow to, std::vector<int> permille) {
  permille.push_back(1000);
  std::sort(permille.begin(), permille.end());
  std::vector<ContactPathRow> path;
  for (const int p : permille)
    path.push_back({from.opening + (to.opening - from.opening) * p / 1000,
                    from.slip + (to.slip - from.slip) * p / 1000});
  return path;
}

std::vector<int> random_cuts() {
  return *rc::gen::container<std::vector<int>>(rc::gen::inRange(1, 1000));
}

// --- areas: GI, GII, Gc within 0.1 % for any subdivision (drive_contact resolves each branch by
// 500 substeps; curved branches leave the trapezoidal rest of that, below 1e-5, and the exponential
// its tail exp(-x)) -----------------------------------------------------------------------------------

TEST(ContactLaw, opening_dissipates_the_mode_1_energy_however_it_is_cut) {
  EXPECT_TRUE(rc::check([] {
    const JointMaterial m = any_variant(*rc::gen::inRange(0, 24));
    const double apart = 15 * m.mode_1_energy / m.tensile_strength;  // tail exp(-15) = 3e-7
    const auto answers = drive_contact(m, cut({0, 0}, {apart, 0}, random_cuts()));
    RC_ASSERT(std::fabs(answers.back().dissipated / m.mode_1_energy - 1) < 1e-3);
    RC_ASSERT(answers.back().damage_tension > 0.999999);
  }));
}

TEST(ContactLaw, slipping_dissipates_the_mode_2_energy_above_the_residual_however_it_is_cut) {
  EXPECT_TRUE(rc::check([] {
    JointMaterial m = any_variant(*rc::gen::inRange(0, 24));
    const double compression = *rc::gen::inRange(0, 1000) * 1e3;  // [Pa]
    double energy = m.mode_2_energy;
    if (*rc::gen::arbitrary<bool>()) {
      m.mode_2_energy_per_pressure = *rc::gen::inRange(0, 500) * 1e-6;
      energy += m.mode_2_energy_per_pressure * compression;
    }
    const double w = -compression / m.normal_stiffness;
    const double drop = m.cohesion + compression * (std::tan(m.friction_angle) -
                                                    std::tan(m.residual_friction_angle));
    const double last = 15 * energy / drop;
    auto path = cut({w, 0}, {w, last}, random_cuts());
    path.insert(path.begin(), {w, 0});
    const auto answers = drive_contact(m, path);
    const double plastic = last - answers.back().shear_stress / m.shear_stiffness;
    const double friction = compression * std::tan(m.residual_friction_angle) * plastic;
    RC_ASSERT(std::fabs((answers.back().dissipated - friction) / energy - 1) < 1e-3);
  }));
}

TEST(ContactLaw, crushing_dissipates_the_compressive_energy_however_it_is_cut) {
  EXPECT_TRUE(rc::check([] {
    const int index = *rc::gen::inRange(0, 24);
    const JointMaterial m = *rc::gen::arbitrary<bool>() ? any_capped(index) : any_variant(index);
    const double closure = 2.2 * m.compressive_energy / m.compressive_strength;
    const auto answers = drive_contact(m, cut({0, 0}, {-closure, 0}, random_cuts()));
    RC_ASSERT(std::fabs(answers.back().dissipated / m.compressive_energy - 1) < 1e-3);
    RC_ASSERT(answers.back().crushing == 1.0);
    RC_ASSERT(answers.back().normal_stress == 0.0);
  }));
}

TEST(ContactLaw, energies_do_not_grow_with_the_length_of_a_row) {
  for_every_variant([](const JointMaterial& m) {
    for (const double far : {0.03, 1.0, 1e3}) {  // up to a kilometre in one row [m]
      EXPECT_NEAR(drive_contact(m, {{far, 0}}).back().dissipated / m.mode_1_energy, 1, 1e-3);
      EXPECT_NEAR(drive_contact(m, {{-far - 0.01, 0}}).back().dissipated / m.compressive_energy, 1,
                  1e-3);
      const double pressed = -0.5e6 / m.normal_stiffness;
      const auto slid = drive_contact(m, {{pressed, 0}, {pressed, far}});
      const double plastic = far - slid.back().shear_stress / m.shear_stiffness;
      const double friction = 0.5e6 * std::tan(m.residual_friction_angle) * plastic;
      EXPECT_NEAR(slid.back().dissipated / (friction + m.mode_2_energy), 1, 1e-3) << far;
      EXPECT_NEAR(slid.back().shear_stress, 0.5e6 * std::tan(m.residual_friction_angle), 1e3);
    }
    // back from a kilometre apart until it is crushed: nothing on the way is stepped over
    const auto back = drive_contact(m, {{1e3, 0}, {-0.01, 0}});
    EXPECT_NEAR(back.back().dissipated / (m.mode_1_energy + m.compressive_energy), 1, 1e-3);
  });
}

TEST(ContactLaw, a_long_oblique_row_is_what_its_short_pieces_are) {
  for_every_variant([](JointMaterial m) {
    m.compressive_strength = kUnlimited;
    const ContactPathRow far{-1e-4, 0.3};
    std::vector<ContactPathRow> pieces;
    for (int k = 1; k <= 3000; ++k)
      pieces.push_back({k / 3000.0 * far.opening, k / 3000.0 * far.slip});
    const ContactAnswer whole = drive_contact(m, {far}).back();
    const ContactAnswer cut = drive_contact(m, pieces).back();
    EXPECT_NEAR(whole.dissipated / cut.dissipated, 1, 1e-3);
    EXPECT_NEAR(whole.shear_stress / cut.shear_stress, 1, 1e-6);
  });
}

TEST(ContactLaw, softening_shapes_have_unit_area_and_start_at_one) {
  const auto check = [](Softening k) {
    double area = 0;
    const double h = 1e-4;
    for (double x = 0.5 * h; x < 40; x += h) area += h * contact::soften(k, x).left;
    EXPECT_NEAR(area, 1, 1e-6);
    EXPECT_EQ(contact::soften(k, 0.0).left, 1.0);
    double steepest = 0;
    for (double x = 0; x < 4; x += 0.01)
      steepest = std::max(steepest, -contact::soften(k, x).slope);
    EXPECT_NEAR(steepest, contact::steepest_slope(k), 1e-12);
  };
  for (const Softening softening : kSoftenings) check(softening);
}

// --- random paths: what may never happen --------------------------------------------------------------

struct Walk {
  JointMaterial m;
  std::vector<ContactPathRow> path;
  std::vector<ContactAnswer> answers;
};

Walk random_walk() {
  Walk walk;
  walk.m = any_rising(*rc::gen::inRange(0, 24));
  const auto targets =
      *rc::gen::resize(25, rc::gen::container<std::vector<std::pair<int, int>>>(
                               rc::gen::pair(rc::gen::resize(100, rc::gen::inRange(-40, 61)),
                                             rc::gen::resize(100, rc::gen::inRange(-300, 301)))));
  ContactPathRow from;
  for (const auto& [opening, slip] : targets) {
    const ContactPathRow to{1e-6 * opening, 2e-6 * slip};
    for (int k = 1; k <= 20; ++k)
      walk.path.push_back({from.opening + (to.opening - from.opening) * k / 20,
                           from.slip + (to.slip - from.slip) * k / 20});
    from = to;
  }
  walk.answers = drive_contact(walk.m, walk.path);
  return walk;
}

TEST(ContactLaw, damage_never_decreases_and_dissipation_never_falls) {
  EXPECT_TRUE(rc::check([] {
    const Walk walk = random_walk();
    ContactAnswer last;
    for (const ContactAnswer& now : walk.answers) {
      RC_ASSERT(now.damage_tension >= last.damage_tension);
      RC_ASSERT(now.damage_shear >= last.damage_shear);
      RC_ASSERT(now.damage >= last.damage);
      RC_ASSERT(now.crushing >= last.crushing);
      RC_ASSERT(now.dissipated >= last.dissipated - 1e-9 * walk.m.mode_1_energy);  // round-off
      RC_ASSERT(now.damage <= 1.0);
      last = now;
    }
  }));
}

TEST(ContactLaw, stress_stays_within_the_strength_that_is_left) {
  EXPECT_TRUE(rc::check([] {
    const Walk walk = random_walk();
    const JointMaterial& m = walk.m;
    for (std::size_t k = 0; k < walk.answers.size(); ++k) {
      const ContactAnswer& a = walk.answers[k];
      const double left = 1 - a.damage;
      RC_ASSERT(a.normal_stress <= left * m.tensile_strength * (1 + 1e-9) + 1e-6);
      RC_ASSERT(a.normal_stress >= -m.compressive_strength * (1 - a.crushing) * (1 + 1e-9));
      if (m.coupling == Coupling::kStiffness) continue;  // weaker still: the test below
      // The shear return feels the normal stress with the damage before this substep; under tension
      // that is tan(phi) ft (1 - d) times the damage of one substep, 1/250 at most.
      const double spare = std::tan(m.friction_angle) * m.tensile_strength / 250;
      const double t_res = std::tan(m.residual_friction_angle), t_0 = std::tan(m.friction_angle);
      const double sn = -a.normal_stress;
      const double limit = left * m.cohesion + sn * (t_res + left * (t_0 - t_res));
      RC_ASSERT(std::fabs(a.shear_stress) <= std::max(0.0, limit) + spare);
    }
  }));
}

// Work done by the stresses = elastic energy held + dissipated: no energy from nowhere on any path.
template <class V>
void check_balance(const JointMaterial& material, const std::vector<ContactPathRow>& path) {
  const auto m = contact::constants_of(material);
  contact::History<double> h{};
  contact::LawUpdate<double> before{};
  ContactPathRow from;
  double work = 0, dissipated = 0, stored = 0, handled = 0;
  for (const ContactPathRow& to : path) {
    constexpr int kPieces = 400;
    double w0 = from.opening, s0 = from.slip;
    for (int k = 1; k <= kPieces; ++k) {
      const double w = from.opening + (to.opening - from.opening) * k / kPieces;
      const double s = from.slip + (to.slip - from.slip) * k / kPieces;
      const auto now = contact::update<V>(m, w, s, h);
      const double normal = 0.5 * (before.sigma + now.sigma) * (w - w0);
      const double shear = 0.5 * (before.tau + now.tau) * (s - s0);
      work += normal + shear;
      handled += std::fabs(normal) + std::fabs(shear);
      dissipated += now.friction + now.fracture + now.crushing;
      w0 = w;
      s0 = s;
      before = now;
    }
    const bool secant = m.choice.unloading == Unloading::kSecant && before.sigma > 0;
    stored = (secant ? 0.5 * before.sigma * (w0 + h.crush)
                     : 0.5 * before.sigma * before.sigma * m.inv_kn) +
             0.5 * before.tau * before.tau * m.inv_ks;
    from = to;
  }
  // Corners of the branches within a piece leave half a piece's error each.
  RC_ASSERT(std::fabs(work - stored - dissipated) <= 2e-3 * handled + 1e-3);
}

TEST(ContactLaw, work_is_stored_or_dissipated_on_any_path) {
  EXPECT_TRUE(rc::check([] {
    const int index = *rc::gen::inRange(0, 24);
    const JointMaterial m = *rc::gen::arbitrary<bool>() ? any_capped(index) : any_rising(index);
    const auto targets = *rc::gen::container<std::vector<std::pair<int, int>>>(
        rc::gen::pair(rc::gen::inRange(-40, 61), rc::gen::inRange(-100, 101)));
    std::vector<ContactPathRow> path;
    for (const auto& [opening, slip] : targets) path.push_back({1e-6 * opening, 1e-6 * slip});
    contact::with_variant(contact::choice_of(m),
                          [&](auto variant) { check_balance<decltype(variant)>(m, path); });
  }));
}

// --- single claims ------------------------------------------------------------------------------------

TEST(ContactLaw, broken_joint_is_never_tensile_again_and_carries_compression_with_kn) {
  for_every_variant([](const JointMaterial& m) {
    // to 25 GI/ft: the exponential tail is exp(-25)
    const double apart = 25 * m.mode_1_energy / m.tensile_strength;
    const auto a = drive_contact(
        m, {{apart, 0}, {0.5 * apart, 0}, {1e-6, 0}, {0, 0}, {-1e-5, 0}, {-2e-5, 0}, {1e-6, 0}});
    for (const ContactAnswer& row : a) EXPECT_LE(row.normal_stress, 1e-9 * m.tensile_strength);
    EXPECT_NEAR(a[4].normal_stress, -1e-5 * m.normal_stiffness, 1e-3);
    EXPECT_NEAR(a[5].normal_stress, -2e-5 * m.normal_stiffness, 1e-3);
  });
}

TEST(ContactLaw, reclosed_joint_slides_with_the_residual_friction) {
  for_every_variant([](const JointMaterial& m) {
    const double apart = 25 * m.mode_1_energy / m.tensile_strength;
    const double w = -0.4e6 / m.normal_stiffness;
    const auto a = drive_contact(m, {{apart, 0}, {w, 0}, {w, 1e-3}});
    EXPECT_NEAR(a[2].shear_stress, 0.4e6 * std::tan(m.residual_friction_angle), 1.0);
  });
}

TEST(ContactLaw, half_broken_joint_slides_with_friction_between_peak_and_residual) {
  JointMaterial m = scenes::paper_joint();
  // half the strength lost in tension: kappa half way between w0 and wu
  const double w0 = m.tensile_strength / m.normal_stiffness;
  const double wu = 2 * m.mode_1_energy / m.tensile_strength;
  const double w = -0.4e6 / m.normal_stiffness;
  std::vector<ContactPathRow> path{{0.5 * (w0 + wu), 0}, {w, 0}};
  for (int k = 1; k <= 1000; ++k) path.push_back({w, 1e-7 * k});
  double peak = 0;
  for (const auto& a : drive_contact(m, path)) peak = std::max(peak, std::fabs(a.shear_stress));
  const double t0 = m.cohesion + 0.4e6 * std::tan(m.friction_angle);
  const double tr = 0.4e6 * std::tan(m.residual_friction_angle);
  EXPECT_NEAR(peak, tr + 0.5 * (t0 - tr), 2e-3 * t0);  // one row of slip past the peak
}

TEST(ContactLaw, slip_adds_up_over_reversals) {
  const JointMaterial m = scenes::paper_joint();
  const double w = -0.3e6 / m.normal_stiffness;
  const double s = 2e-4;
  const auto once = drive_contact(m, {{w, 0}, {w, s}});
  const auto twice = drive_contact(m, {{w, 0}, {w, s}, {w, -s}});
  // plastic slip: forth p1, back p1 to 0 and on to s - |tau|/ks on the other side
  const double p1 = s - once.back().shear_stress / m.shear_stiffness;
  const double p2 = s + twice.back().shear_stress / m.shear_stiffness;
  EXPECT_LT(twice.back().shear_stress, 0);
  EXPECT_NEAR(twice.back().damage_shear / once.back().damage_shear, (2 * p1 + p2) / p1, 1e-9);
}

TEST(ContactLaw, fully_slipped_joint_has_the_residual_in_both_directions) {
  const JointMaterial m = scenes::paper_joint();
  const double w = -0.3e6 / m.normal_stiffness,
               residual = 0.3e6 * std::tan(m.residual_friction_angle);
  const auto a = drive_contact(m, {{w, 0}, {w, 5e-3}, {w, 0}, {w, 5e-3}});
  EXPECT_NEAR(a[1].shear_stress, residual, 1e-6 * residual);
  EXPECT_NEAR(a[2].shear_stress, -residual, 1e-6 * residual);
  EXPECT_NEAR(a[3].shear_stress, residual, 1e-6 * residual);
}

TEST(ContactLaw, dry_joint_has_no_tension_and_coulomb_friction) {
  const JointMaterial m = scenes::dry_joint(20e9, 8e9, std::atan(0.6));
  const auto a = drive_contact(m, {{1e-5, 0}, {1e-5, 1e-4}, {-1e-5, 1e-4}, {-1e-5, 1e-2}});
  EXPECT_EQ(a[0].normal_stress, 0);
  EXPECT_EQ(a[1].shear_stress, 0);
  EXPECT_EQ(a[0].damage_tension, 1);
  EXPECT_EQ(a[0].dissipated, 0);
  EXPECT_EQ(a[3].damage_shear, 0);
  EXPECT_NEAR(a[3].normal_stress, -2e5, 1e-6);
  EXPECT_NEAR(a[3].shear_stress, 1.2e5, 1e-3);
}

TEST(ContactLaw, secant_unloading_goes_to_the_origin) {
  const JointMaterial m = scenes::paper_joint();
  const double open = 3e-5;
  const auto a = drive_contact(m, {{open, 0}, {0.5 * open, 0}, {0, 0}, {open, 0}});
  EXPECT_GT(a[0].normal_stress, 0);
  EXPECT_NEAR(a[1].normal_stress, 0.5 * a[0].normal_stress, 1e-6 * a[0].normal_stress);
  EXPECT_NEAR(a[2].normal_stress, 0, 1e-6);
  EXPECT_NEAR(a[3].normal_stress, a[0].normal_stress, 1e-6 * a[0].normal_stress);
}

TEST(ContactLaw, elastic_unloading_goes_to_a_set_and_presses_only_when_closed) {
  JointMaterial m = scenes::paper_joint();
  m.unloading = Unloading::kElastic;
  const double open = 3e-5, back = 2e-6;
  const auto a = drive_contact(m, {{open, 0}, {open - back, 0}, {1e-5, 0}, {-1e-6, 0}});
  EXPECT_NEAR(a[1].normal_stress, a[0].normal_stress - m.normal_stiffness * back, 1e-3);
  EXPECT_EQ(a[2].normal_stress, 0);
  EXPECT_NEAR(a[3].normal_stress, -1e-6 * m.normal_stiffness, 1e-6);
}

// Half broken in tension, then slipped under compression: damage by the three rules.
ContactAnswer half_and_slipped(Coupling coupling) {
  JointMaterial m = scenes::paper_joint();
  m.coupling = coupling;
  const double w0 = m.tensile_strength / m.normal_stiffness;
  const double wu = 2 * m.mode_1_energy / m.tensile_strength;
  const double w = -0.3e6 / m.normal_stiffness;
  return drive_contact(m, {{0.5 * (w0 + wu), 0}, {w, 0}, {w, 4e-4}}).back();
}

TEST(ContactLaw, coupling_by_union_maximum_and_stiffness) {
  const ContactAnswer u = half_and_slipped(Coupling::kUnion);
  EXPECT_NEAR(u.damage_tension, 0.5, 1e-12);
  EXPECT_NEAR(u.damage, 0.5 + u.damage_shear - 0.5 * u.damage_shear, 1e-12);
  const ContactAnswer m = half_and_slipped(Coupling::kMaximum);
  EXPECT_NEAR(m.damage, std::max(0.5, m.damage_shear), 1e-12);
  // stiffness: 1 - secant/kn with the secant 0.5 ft over the opening, far above 0.5
  const JointMaterial p = scenes::paper_joint();
  const double kappa =
      0.5 * (p.tensile_strength / p.normal_stiffness + 2 * p.mode_1_energy / p.tensile_strength);
  const double lost = 1 - 0.5 * p.tensile_strength / kappa / p.normal_stiffness;
  const double t0 = p.cohesion + 0.3e6 * std::tan(p.friction_angle);
  const double tr = 0.3e6 * std::tan(p.residual_friction_angle);
  const ContactAnswer s = half_and_slipped(Coupling::kStiffness);
  EXPECT_GT(lost, s.damage_shear);
  EXPECT_NEAR(s.shear_stress, tr + (1 - lost) * (t0 - tr), 1e-6 * t0);
}

// --- what is refused ----------------------------------------------------------------------------------

const MaterialFault* fault_of(const std::vector<MaterialFault>& faults, const std::string& key) {
  const auto found = std::find_if(faults.begin(), faults.end(),
                                  [&](const MaterialFault& f) { return f.key == key; });
  return found == faults.end() ? nullptr : &*found;
}

TEST(ContactLaw, paper_materials_pass_the_check) {
  EXPECT_TRUE(check_joint_material(scenes::paper_joint()).empty());
  EXPECT_TRUE(check_joint_material(scenes::paper_unit()).empty());
  EXPECT_TRUE(check_joint_material(scenes::dry_joint(1e9, 1e9, 0.5)).empty());
  for_every_variant([](const JointMaterial& m) { EXPECT_TRUE(check_joint_material(m).empty()); });
}

TEST(ContactLaw, snap_back_is_refused_with_its_numbers) {
  JointMaterial m = scenes::paper_joint();
  m.mode_1_energy = 0.5;  // below ft^2/(2 kn) = 0.5625 N/m
  const auto faults = check_joint_material(m);
  const MaterialFault* fault = fault_of(faults, "mode_1_energy");
  ASSERT_NE(fault, nullptr);
  EXPECT_EQ(fault->value, "0.5 N/m");
  for (const char* part : {"snap-back", "0.15 MPa", "20 GPa/m"})
    EXPECT_NE(fault->problem.find(part), std::string::npos) << fault->problem;
  EXPECT_NE(fault->cure.find("0.5625 N/m"), std::string::npos) << fault->cure;

  m = scenes::paper_joint();
  m.mode_2_energy = 0.1;
  const auto shear = check_joint_material(m);
  EXPECT_NE(fault_of(shear, "mode_2_energy"), nullptr);
  m = scenes::paper_joint();
  m.compressive_energy = 100;  // below fc^2/(2 kn) = 392 N/m
  const auto crush = check_joint_material(m);
  EXPECT_NE(fault_of(crush, "compressive_energy"), nullptr);
}

TEST(ContactLaw, snap_back_bound_is_the_edge_of_what_can_be_followed) {
  // Just above the bound the falling branch is nearly upright but single valued: the law follows it.
  for (const Softening softening : kSoftenings) {
    JointMaterial m = scenes::paper_joint();
    m.softening = softening;
    const double least = contact::steepest_slope(softening) * m.tensile_strength *
                         m.tensile_strength / m.normal_stiffness;
    m.mode_1_energy = 0.999 * least;
    EXPECT_FALSE(check_joint_material(m).empty());
    m.mode_1_energy = 1.05 * least;
    EXPECT_TRUE(check_joint_material(m).empty());
    const auto a = drive_contact(m, {{15 * m.mode_1_energy / m.tensile_strength, 0}});
    EXPECT_NEAR(a.back().dissipated, m.mode_1_energy,
                2e-2 * m.mode_1_energy);  // one substep's jump
  }
}

TEST(ContactLaw, missing_and_inadmissible_parameters_are_all_named) {
  JointMaterial m;
  EXPECT_EQ(check_joint_material(m).size(), 8U);
  m = scenes::paper_joint();
  m.mode_1_energy = kUnset;
  EXPECT_NE(fault_of(check_joint_material(m), "mode_1_energy"), nullptr);
  m = scenes::paper_joint();
  m.residual_friction_angle = degrees(20);
  EXPECT_NE(fault_of(check_joint_material(m), "residual_friction_angle"), nullptr);
  m = scenes::paper_joint();
  m.residual_cohesion = 1e6;
  EXPECT_NE(fault_of(check_joint_material(m), "residual_cohesion"), nullptr);
  m = scenes::paper_joint();
  m.normal_stiffness = -1;
  m.friction_angle = degrees(95);
  const auto faults = check_joint_material(m);
  EXPECT_NE(fault_of(faults, "normal_stiffness"), nullptr);
  EXPECT_NE(fault_of(faults, "friction_angle"), nullptr);
}

}  // namespace
}  // namespace wythe::contact_law_test
