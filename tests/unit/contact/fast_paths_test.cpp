// The fast paths of the joint pass against the full law. Elastic and undamaged points against update() on
// random histories of every variant, faces along the tangent against plain vectors (docs/theory/kinematics.md).
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <complex>
#include <cstdint>
#include <random>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "contact/fast_paths.h"
#include "contact/parameters.h"
#include "scenes/rig.h"
#include "scenes/scenes.h"

namespace wythe::fast_paths_test {
namespace {

// Repeatable numbers.
class Dice {
 public:
  double share() { return static_cast<double>(bits_() >> 11) * 0x1p-53; }  // [0, 1)
  double between(double low, double high) { return low + (high - low) * share(); }
  int below(int n) { return static_cast<int>(n * share()); }
  double either() { return below(2) == 0 ? -1 : 1; }

 private:
  std::mt19937_64 bits_{20240229};
};

// --- points at rest -------------------------------------------------------------------------------------

using History = contact::History<double>;

// States met: how many were closed, left alone by update(), found at rest; among these which histories;
// and what the others did.
struct Tally {
  int closed = 0, unchanged = 0, rest = 0;
  int crushed = 0, slid = 0, torn = 0, worn = 0, open = 0;
  int opens = 0, slides = 0, crushes = 0, presses = 0;
  int undamaged = 0, drawn = 0, widened = 0;
};

bool same_bits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}
bool same_bits(const History& a, const History& b) {
  return same_bits(a.kappa, b.kappa) && same_bits(a.crush, b.crush) &&
         same_bits(a.plastic_slip, b.plastic_slip) && same_bits(a.slip, b.slip) &&
         same_bits(a.shear_damage, b.shear_damage) && same_bits(a.tension_set, b.tension_set) &&
         same_bits(a.crush_path, b.crush_path);
}

// A point on a random path.
template <class V>
class Walker {
 public:
  Walker(const JointMaterial& material, Dice& dice, Tally& tally)
      : m_(contact::constants_of(material)), dice_(dice), tally_(tally) {}

  void walk() {
    for (int leg = 0; leg < 20; ++leg) {
      const double w0 = w_, s0 = s_, w1 = next_opening(), s1 = next_slip();
      const int steps = 1 + dice_.below(10);
      for (int k = 1; k <= steps; ++k) {
        step(w0 + (w1 - w0) * k / steps, s0 + (s1 - s0) * k / steps);
        ask(w_, s_, false);  // once more, on the yield stress but for rounding
        ask(eased(w_, -h_.crush, 1e-9), eased(s_, h_.plastic_slip, 2e-9));
        ask(-h_.crush, s_);  // where contact is just lost
        ask(next_opening(), h_.plastic_slip + dice_.between(-1, 1) * 2e-5);
        ask(-h_.crush - dice_.share() * 1e-4, next_slip());
      }
    }
  }

 private:
  // Seen from where contact is lost: pressed, crushed, cracking, wide open.
  double next_opening() {
    constexpr double kReach[] = {-1e-4, -1e-4, -2e-4, -8e-3, 2e-5, 4e-3};  // [m]
    return -h_.crush + dice_.share() * kReach[dice_.below(6)];
  }
  // Seen from where it is free of shear: elastic, softening, worn off.
  double next_slip() {
    constexpr double kReach[] = {2e-5, 2e-5, 5e-4, 0.1};  // [m]
    return h_.plastic_slip + dice_.between(-1, 1) * kReach[dice_.below(4)];
  }

  void step(double w, double s) {
    ask(w, s);
    w_ = w;
    s_ = s;
    History any = h_;
    const contact::LawUpdate<double> now = contact::update<V>(m_, w, s, h_);
    const contact::LawUpdate<double> same = contact::update<contact::AnyVariant>(m_, w, s, any);
    EXPECT_TRUE(same_bits(h_, any) && same_bits(now.sigma, same.sigma) &&
                same_bits(now.tau, same.tau) && same_bits(now.fracture, same.fracture));
  }

  static double eased(double from, double towards, double share) {
    return from + share * (towards - from);
  }

  void ask(double w, double s, bool counted = true) {
    const contact::ElasticStep<double> rest = contact::elastic_step<V, false>(m_, w, s, h_);
    History now = h_;
    const contact::LawUpdate<double> answer = contact::update<V>(m_, w, s, now);
    // the way of closed points: the same answer, or none
    const contact::ElasticStep<double> shut = contact::elastic_step<V, true>(m_, w, s, h_);
    EXPECT_EQ(shut.is_elastic, rest.is_elastic && w + h_.crush <= 0);
    if (shut.is_elastic) {
      EXPECT_TRUE(same_bits(shut.sigma, rest.sigma) && same_bits(shut.tau, rest.tau));
    }
    const bool closed = counted && w + h_.crush < 0;
    tally_.closed += closed;
    tally_.unchanged += closed && same_bits(h_, now);
    tally_.rest += closed && rest.is_elastic;
    if (!rest.is_elastic)
      check_busy(w, s, answer, now);
    else
      check_rest(rest, w, answer, now);
    if (contact::has_undamaged_path<V>(m_) && contact::is_undamaged<V>(m_, h_))
      check_whole(w, s, answer, now);
  }

  // Zeros may differ in their sign: a face adds its points to 0.
  void check_whole(double w, double s, const contact::LawUpdate<double>& answer,
                   const History& now) {
    const contact::UndamagedStress<double> undamaged = contact::undamaged_point(m_, w, s);
    const bool slides = now.slip > 0, crushes = now.crush > 0;
    EXPECT_TRUE(!undamaged.stays || contact::is_undamaged<V>(m_, now));
    EXPECT_TRUE(undamaged.stays || slides || crushes || w > contact::undamaged_opening(m_))
        << w << " " << s;
    if (!undamaged.stays) return;
    EXPECT_EQ(undamaged.sigma, answer.sigma);
    EXPECT_EQ(undamaged.tau, answer.tau);
    EXPECT_EQ(answer.friction + answer.fracture + answer.crushing, 0);
    History wider = h_;
    if (w > wider.kappa) wider.kappa = w;
    EXPECT_TRUE(same_bits(wider, now));
    ++tally_.undamaged;
    tally_.drawn += w > 0;
    tally_.widened += now.kappa > h_.kappa;
  }

  void check_rest(const contact::ElasticStep<double>& rest, double w,
                  const contact::LawUpdate<double>& answer, const History& now) {
    EXPECT_TRUE(same_bits(rest.sigma, answer.sigma)) << rest.sigma << " " << answer.sigma;
    EXPECT_TRUE(same_bits(rest.tau, answer.tau)) << rest.tau << " " << answer.tau;
    EXPECT_TRUE(same_bits(h_, now));
    EXPECT_EQ(answer.friction + answer.fracture + answer.crushing, 0);
    EXPECT_FALSE(contact::history_changed(h_, now));
    tally_.crushed += h_.crush > 0;
    tally_.slid += h_.slip > 0;
    tally_.torn += contact::tension_left<V>(m_, h_.kappa) == 0;
    tally_.worn += h_.shear_damage == 1;
    tally_.open += w + h_.crush >= 0;
  }

  // The change of a point is read from its stresses. Slip and crushing below 1e-9 of their
  // elastic part may vanish in the rounding of the history, so they need not count as a change.
  void check_busy(double w, double s, const contact::LawUpdate<double>& answer,
                  const History& now) {
    const double press = m_.kn * (w + h_.crush), shear = m_.ks * (s - h_.plastic_slip);
    const bool opens = now.kappa > h_.kappa;
    const bool slides = std::fabs(shear) * (1 - 1e-9) > std::fabs(answer.tau);
    const bool crushes = press < 0 && press * (1 - 1e-9) < answer.sigma;
    const bool presses = !slides && now.shear_damage > h_.shear_damage;
    tally_.opens += opens;
    tally_.slides += slides;
    tally_.crushes += crushes;
    tally_.presses += presses;
    if (opens || slides || crushes || presses) {
      EXPECT_TRUE(contact::history_changed(h_, now))
          << "opens " << opens << " slides " << slides << " crushes " << crushes;
    }
  }

  contact::LawConstants<double> m_;
  Dice& dice_;
  Tally& tally_;
  History h_{};
  double w_ = 0, s_ = 0;
};

// 30 paths of about 110 histories for each of three materials, of which the first has a GII that grows with pressure
// on every other path; each history is asked six questions.
Tally walk_variant(Softening softening, Coupling coupling, Unloading unloading, bool cap) {
  Tally tally;
  Dice dice;
  for (JointMaterial m : {scenes::paper_joint(), scenes::paper_unit(),
                          scenes::dry_joint(20e9, 8e9, scenes::degrees(30))}) {
    m.softening = softening;
    m.coupling = coupling;
    m.unloading = unloading;
    if (cap && std::isfinite(m.compressive_strength)) {
      m.compression_cap = 9;
      m.hardening_displacement = 0.09e-3;
      m.dilatancy_angle = 0.5 * m.residual_friction_angle;
    }
    const bool mortar = m.tensile_strength == scenes::paper_joint().tensile_strength;
    for (int path = 0; path < 30; ++path) {
      if (mortar) m.mode_2_energy_per_pressure = path % 2 == 0 ? kUnset : 0.2e-3;
      contact::with_variant(contact::choice_of(m), [&](auto variant) {
        Walker<decltype(variant)>(m, dice, tally).walk();
      });
    }
  }
  return tally;
}

class EveryVariant
    : public testing::TestWithParam<std::tuple<Softening, Coupling, Unloading, bool>> {};

TEST_P(EveryVariant, at_rest_has_the_bits_of_update_and_misses_no_rest) {
  const auto [softening, coupling, unloading, cap] = GetParam();
  const Tally t = walk_variant(softening, coupling, unloading, cap);
  EXPECT_GT(t.open, 100);                           // open, and no wider than before
  EXPECT_GT(t.rest, (cap ? 0.3 : 0.4) * t.closed);  // 36 and 49 % measured; the others move
  EXPECT_GT(t.rest, 0.999 * t.unchanged);           // all measured; rounding may swallow a motion
  // every kind of history comes to rest, and every kind of motion is met
  for (const int met : {t.crushed, t.slid, t.torn, t.worn}) EXPECT_GT(met, 100);
  for (const int met : {t.opens, t.slides, t.crushes, t.presses}) EXPECT_GT(met, 100);
}

TEST_P(EveryVariant, a_whole_point_is_elastic_with_the_bits_of_update) {
  const auto [softening, coupling, unloading, cap] = GetParam();
  const Tally t = walk_variant(softening, coupling, unloading, cap);
  const bool known = coupling != Coupling::kStiffness && !cap;
  for (const int met : {t.undamaged, t.drawn, t.widened}) EXPECT_EQ(met > 30, known) << met;
}

// Each number of the history alone keeps a point from being whole; so does strength that a dry joint lacks.
TEST(WholePoint, remembers_nothing_but_how_far_it_has_opened) {
  const auto law = contact::constants_of(scenes::paper_joint());
  const auto is_undamaged = [&](double History::*number, double value) {
    History h{};
    h.*number = value;
    return contact::is_undamaged<contact::PaperVariant>(law, h);
  };
  EXPECT_TRUE(is_undamaged(&History::kappa, 0));
  EXPECT_TRUE(is_undamaged(&History::kappa, 0.999 * law.w0));
  EXPECT_FALSE(is_undamaged(&History::kappa, law.w0));
  EXPECT_FALSE(is_undamaged(&History::kappa, std::nan("")));
  for (const auto number :
       {&History::crush, &History::plastic_slip, &History::slip, &History::shear_damage})
    EXPECT_FALSE(is_undamaged(number, 1e-12));
  EXPECT_FALSE(is_undamaged(&History::plastic_slip, -1e-12));
  const auto dry = contact::constants_of(scenes::dry_joint(20e9, 8e9, scenes::degrees(30)));
  EXPECT_FALSE(contact::is_undamaged<contact::PaperVariant>(dry, History{}));
}

std::string name_of(const testing::TestParamInfo<EveryVariant::ParamType>& info) {
  constexpr const char* kSoftening[] = {"bilinear", "exponential", "polynomial", "petersson"};
  constexpr const char* kCoupling[] = {"union", "maximum", "stiffness"};
  constexpr const char* kUnloading[] = {"secant", "elastic"};
  const auto [softening, coupling, unloading, cap] = info.param;
  return std::string(kSoftening[static_cast<int>(softening)]) + "_" +
         kCoupling[static_cast<int>(coupling)] + "_" + kUnloading[static_cast<int>(unloading)] +
         (cap ? "_cap" : "");
}

INSTANTIATE_TEST_SUITE_P(
    law_shortcuts, EveryVariant,
    testing::Combine(testing::Values(Softening::kBilinear, Softening::kExponential,
                                     Softening::kPolynomial, Softening::kPetersson),
                     testing::Values(Coupling::kUnion, Coupling::kMaximum, Coupling::kStiffness),
                     testing::Values(Unloading::kSecant, Unloading::kElastic), testing::Bool()),
    name_of);

// --- faces along the tangent ----------------------------------------------------------------------------

using Vector = std::complex<double>;  // x + i y: turning is a product
double dot(Vector a, Vector b) { return std::real(std::conj(a) * b); }
double cross(Vector a, Vector b) { return std::imag(std::conj(a) * b); }
Vector turn(double angle) { return std::polar(1.0, angle); }

// A fixed block, a block on it and one on that; the faces between them slope and overlap in part.
ModelSpec skew_stack(Dice& dice) {
  double height[4], slope[4];
  for (int k = 0; k < 4; ++k) {
    height[k] = 0.4 * k;
    slope[k] = dice.between(-0.3, 0.3);
  }
  std::vector<BlockSpec> blocks;
  for (int k = 0; k < 3; ++k) {
    const double x0 = dice.between(-0.2, 0), x1 = dice.between(0.3, 0.5);
    BlockSpec block;
    block.id = "b" + std::to_string(k);
    block.polygon = {{x0, height[k] + slope[k] * x0},
                     {x1, height[k] + slope[k] * x1},
                     {x1, height[k + 1] + slope[k + 1] * x1},
                     {x0, height[k + 1] + slope[k + 1] * x0}};
    block.fixed = k == 0;
    blocks.push_back(block);
  }
  ModelSpec spec = scenes::assembly(std::move(blocks), scenes::elastic_joint(20e9, 8e9), 0.2, 2000);
  spec.solve.points_per_face = 2 + dice.below(4);
  return scenes::turned(spec, dice.between(-scenes::kPi, scenes::kPi));
}

// Places of a block's centroid at the start and now, and its rotation.
struct Place {
  Vector start, now;
  double theta;
  Vector at(Vector arm) const { return now + turn(theta) * arm; }
};

struct JointForces {
  Vector force{};             // on a
  double on_a = 0, on_b = 0;  // moments about the centroids
  double size = 0, moment_size = 0;
  bool all_closed = true;
};

// (2.2) - (2.4) point by point. An elastic joint: sigma = kn w, tau = ks s.
JointForces plain_forces(const Model& m, const State& s, std::size_t j) {
  const auto place = [&](BlockId block) {
    const auto i = static_cast<std::size_t>(block);
    const Vector start{m.centroid_x[i], m.centroid_y[i]};
    return Place{start, start + Vector{s.ux[i], s.uy[i]}, s.theta[i]};
  };
  const bool on_ground = m.joint_a[j] == kGroundBlock;
  const Place b = place(m.joint_b[j]), a = on_ground ? b : place(m.joint_a[j]);
  const Vector e{m.half_x[j], m.half_y[j]}, t0{m.tangent_x[j], m.tangent_y[j]};
  const Vector t = t0 * turn(on_ground ? 0 : 0.5 * (a.theta + b.theta)), n = t * Vector{0, 1};
  JointForces sum;
  for (std::size_t k = 0; k < m.point_xi.size(); ++k) {
    const Vector arm_b = Vector{m.arm_b_x[j], m.arm_b_y[j]} + m.point_xi[k] * e;
    const Vector arm_a = Vector{m.arm_a_x[j], m.arm_a_y[j]} + m.point_xi[k] * e;
    const Vector xb = b.at(arm_b), xa = on_ground ? b.start + arm_b : a.at(arm_a);
    const Vector jump = xb - xa;
    const double w = dot(jump, n), area = m.area[j] * m.point_weight[k];
    const Vector f = area * (20e9 * w * n + 8e9 * dot(jump, t) * t);
    const Vector acts = on_ground ? xb : 0.5 * (xa + xb);
    sum.force += f;
    sum.on_a += on_ground ? 0 : cross(acts - a.now, f);
    sum.on_b -= cross(acts - b.now, f);
    sum.size += std::abs(f);
    sum.moment_size += std::abs(f) * (std::abs(acts - a.now) + std::abs(acts - b.now));
    sum.all_closed = sum.all_closed && w < 0;
  }
  return sum;
}

// The short form of (2.2), with e along t, depends on this.
TEST(FaceFrame, half_faces_lie_along_the_tangent) {
  Dice dice;
  for (int k = 0; k < 20; ++k) {
    const Model m = compile(skew_stack(dice));
    for (std::size_t j = 0; j < m.joint_b.size(); ++j) {
      const Vector e{m.half_x[j], m.half_y[j]}, t{m.tangent_x[j], m.tangent_y[j]};
      EXPECT_NEAR(cross(t, e), 0, 1e-15 * std::abs(e));
      EXPECT_GT(dot(t, e), 0);
    }
  }
}

// Displacements of decimetres and turns of up to 3 rad of two blocks; 1e-12 stands for some hundred
// roundings and the 2e-15 of the sine's polynomial.
TEST(FaceFrame, forces_and_moments_are_those_of_plain_vectors_at_any_turn) {
  Dice dice;
  int closed = 0, open = 0;
  for (int k = 0; k < 300; ++k) {
    scenes::Rig rig(compile(skew_stack(dice)));
    ASSERT_EQ(rig.model.n_joint, 2);
    ASSERT_EQ(rig.model.n_pair, 1);
    for (auto* array : {&rig.state.ux, &rig.state.uy})
      for (double& u : *array) u = dice.either() * dice.between(0.05, 0.5);
    const double most = k % 2 == 0 ? 0.3 : 3;
    for (double& theta : rig.state.theta) theta = dice.between(-most, most);
    const State before = rig.state;
    rig.step();
    for (std::size_t j = 0; j < 2; ++j) {
      const JointForces plain = plain_forces(rig.model, before, j);
      const auto row = rig.force(j);
      EXPECT_LE(std::abs(Vector{row[0], row[1]} - plain.force), 1e-12 * plain.size);
      EXPECT_LE(std::fabs(row[2] - plain.on_a), 1e-12 * plain.moment_size);
      EXPECT_LE(std::fabs(row[3] - plain.on_b), 1e-12 * plain.moment_size);
      ++(plain.all_closed ? closed : open);
    }
  }
  EXPECT_GT(closed, 100);  // the short way of points at rest
  EXPECT_GT(open, 100);    // update() and its history
}

}  // namespace
}  // namespace wythe::fast_paths_test
