// Deformable blocks as beams: stiffening by locking in pure bending, convergence to elasticity, and
// the step against an independent static solution.
//
//     y ^   +--+--+--+--+--+--+--+      c = half the depth h, L the length; tractions of the exact
//       |   |  |  |  |  |  |  |  |      plane solutions act on the ends, so that only the error of
//       +---+--+--+--+--+--+--+--+-> x  the zones remains
//
// Exact solutions: Timoshenko, Goodier, Theory of Elasticity, articles 21 and 22.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "scenes/rig.h"
#include "scenes/zones.h"
#include "verification/record.h"

namespace wythe::verification::zone_beams_test {
namespace {

using scenes::NodeVectors;
using scenes::Rig;
using solids::Grid;

constexpr double kE = 10e9, kNu = 0.2, kThick = 0.3, kHalf = 0.1;  // c [m]
constexpr double kG = kE / (2 * (1 + kNu));
constexpr double kI = kThick * 2 * kHalf * kHalf * kHalf / 3;
constexpr double kArea = kThick * 2 * kHalf;

const char* name_of(ZoneKind kind) { return kind == ZoneKind::kMixed ? "mixed" : "cst"; }

// `rows` zones through the depth, each `aspect` times as long as deep.
Model beam(double length, int rows, ZoneKind kind, double aspect = 1,
           const JointMaterial& body = scenes::elastic_body(kE, kNu, 500),
           Plane plane = Plane::kStress) {
  const double zone = aspect * 2 * kHalf / rows;
  const Grid grid{0, -kHalf, length, kHalf, static_cast<int>(std::lround(length / zone)), rows};
  return scenes::free_grid(grid, kind, body, kThick, plane);
}

void hold(Model& m, int node, bool x, bool y) {
  if (x) m.solids.node_free_x[node] = 0;
  if (y) m.solids.node_free_y[node] = 0;
}

// Consistent forces of the traction (tx, ty) per area on a column of nodes; Simpson on each edge.
template <class Tx, class Ty>
void pull_end(const Model& m, int column, const Tx& tx, const Ty& ty, NodeVectors& load) {
  const SolidBody& body = m.solids.bodies[0];
  for (int j = 0; j < body.rows; ++j) {
    const auto p = static_cast<std::size_t>(body.node(column, j));
    const auto q = static_cast<std::size_t>(body.node(column, j + 1));
    const double a = m.solids.node_y[p], b = m.solids.node_y[q], middle = 0.5 * (a + b);
    const double sixth = kThick * (b - a) / 6;
    load.x[p] += sixth * (tx(a) + 2 * tx(middle));
    load.x[q] += sixth * (2 * tx(middle) + tx(b));
    load.y[p] += sixth * (ty(a) + 2 * ty(middle));
    load.y[q] += sixth * (2 * ty(middle) + ty(b));
  }
}

// --- pure bending: how much a zone locks --------------------------------------------------------

// Stiffness of n rows of zones over EI: each zone is bent by the factor R, n = 1, and
//   1 + (R - 1)/n^2,   R cst = 3/(1 - nu^2) + 1.5/(1 + nu) (a/b)^2
//                      R mixed = 1.5/(1 + nu) (1 + (a/b)^2)      (docs/theory/zones.md)
double stiffening(ZoneKind kind, int rows, double aspect) {
  const double shear = 1.5 / (1 + kNu) * aspect * aspect;
  const double r = shear + (kind == ZoneKind::kMixed ? 1.5 / (1 + kNu) : 3 / (1 - kNu * kNu));
  return 1 + (r - 1) / (rows * rows);
}

TEST(ZoneBeams, pure_bending_locks_by_the_closed_form) {
  constexpr double kLength = 0.8, kCurvature = 1e-6;
  for (const ZoneKind kind : {ZoneKind::kCst, ZoneKind::kMixed})
    for (const double aspect : {1.0, 2.0})
      for (const int rows : {1, 2, 4}) {
        const Model m = beam(kLength, rows, kind, aspect);
        const NodeVectors u = scenes::field(
            m.solids, [&](double x, double y) { return -kCurvature * x * y; },
            [&](double x, double y) { return 0.5 * kCurvature * (x * x + kNu * y * y); });
        const double energy = scenes::energy_of_zones(m.solids, u);
        verify(
            {"zones",
             std::string(name_of(kind)) + ", " + std::to_string(rows) +
                 (rows == 1 ? " zone" : " zones") + " through the depth, " +
                 (aspect > 1 ? "twice as long as deep" : "square") + ": bending stiffness over EI",
             "-", stiffening(kind, rows, aspect), 1e-6,
             "closed form; the turning of the zones at a curvature of 1e-6"},
            energy / (0.5 * kE * kI * kCurvature * kCurvature * kLength));
      }
}

// In the plane stress of a body with grain the section turns as in an isotropic one, E being along
// the grain; in plane strain E and nu become E/(1 - nu^2 r) and nu (1 + nu)/(1 - nu^2 r), r the
// modulus across over that along.
TEST(ZoneBeams, pure_bending_with_grain_and_in_plane_strain) {
  constexpr double kLength = 0.8, kCurvature = 1e-6;
  struct Case {
    const char* name;
    JointMaterial body;
    Plane plane;
  };
  for (const Case& c :
       {Case{"timber, plane stress", scenes::timber_body(), Plane::kStress},
        Case{"timber, plane strain", scenes::timber_body(), Plane::kStrain},
        Case{"isotropic, plane strain", scenes::elastic_body(kE, kNu, 500), Plane::kStrain}}) {
    const bool grain = !std::isnan(c.body.youngs_modulus_across);
    const double nu = grain ? c.body.poisson_ratio : kNu;
    const double ratio = grain ? c.body.youngs_modulus_across / c.body.youngs_modulus : 1;
    const double held = c.plane == Plane::kStrain ? 1 : 0;
    const double less = 1 - held * nu * nu * ratio;
    const double e = c.body.youngs_modulus / less, nu_plane = nu * (1 + held * nu) / less;
    double error[3];
    for (int k = 0; k < 3; ++k) {
      const Model m = beam(kLength, 4 << k, ZoneKind::kMixed, 1, c.body, c.plane);
      const NodeVectors u = scenes::field(
          m.solids, [&](double x, double y) { return -kCurvature * x * y; },
          [&](double x, double y) { return 0.5 * kCurvature * (x * x + nu_plane * y * y); });
      const double exact = 0.5 * e * kI * kCurvature * kCurvature * kLength;
      error[k] = scenes::energy_of_zones(m.solids, u) / exact - 1;
    }
    EXPECT_NEAR(std::log2(error[0] / error[1]), 2.0, 0.02) << c.name;
    EXPECT_NEAR(std::log2(error[1] / error[2]), 2.0, 0.02) << c.name;
    verify({"zones", std::string(c.name) + ": E of bending, extrapolated", "Pa", e, 2e-4,
            "the second order of 8 and 16 mixed zones through the depth"},
           e * (1 + (4 * error[2] - error[1]) / 3));
  }
}

// --- convergence to the exact plane solutions -----------------------------------------------------

// Compliance of the cantilever, 2 W/P^2, for P at x = 0 and the reactions of article 21 at x = L:
// exactly L^3/3EI + 6 L/5GA, Timoshenko's beam, also where E is along the grain and G is timber's:
// the stresses are the same, and the strains they make fit together.
constexpr double kLength = 1.6;
double cantilever(int rows, ZoneKind kind,
                  const JointMaterial& body = scenes::elastic_body(kE, kNu, 500)) {
  Model m = beam(kLength, rows, kind, 1, body);
  const int last = m.solids.bodies[0].columns;
  const auto shear = [](double y) { return (kHalf * kHalf - y * y) / (2 * kI); };
  NodeVectors load(m.solids);
  pull_end(
      m, 0, [](double) { return 0.0; }, shear, load);
  pull_end(
      m, last, [](double y) { return -kLength * y / kI; }, [&](double y) { return -shear(y); },
      load);
  hold(m, m.solids.bodies[0].node(last, 0), true, true);
  hold(m, m.solids.bodies[0].node(last, rows), true, false);
  return scenes::work(load, scenes::solved(m.solids, load));
}

TEST(ZoneBeams, cantilever_converges_to_timoshenko_with_the_second_order) {
  const double bending = kLength * kLength * kLength / (3 * kE * kI);
  const double exact = bending + 6 * kLength / (5 * kG * kArea);
  EXPECT_GT(exact / bending, 1.005);  // the shear matters at the accuracy asked below
  for (const ZoneKind kind : {ZoneKind::kCst, ZoneKind::kMixed}) {
    double error[3];
    for (int k = 0; k < 3; ++k) error[k] = exact / cantilever(4 << k, kind) - 1;
    EXPECT_NEAR(std::log2(error[0] / error[1]), 2.0, 0.1) << name_of(kind);
    EXPECT_NEAR(std::log2(error[1] / error[2]), 2.0, 0.1) << name_of(kind);
    verify({"zones",
            std::string(name_of(kind)) + ", cantilever, 16 zones through the depth: compliance",
            "m/N", exact, 0.015, "second order: stiffening - 1 = 0.013 (cst), 0.006 (mixed)"},
           exact / (1 + error[2]));
  }
}

TEST(ZoneBeams, cantilever_of_timber_converges_to_timoshenko) {
  const JointMaterial timber = scenes::timber_body();
  const double bending = kLength * kLength * kLength / (3 * timber.youngs_modulus * kI);
  const double exact = bending + 6 * kLength / (5 * timber.shear_modulus * kArea);
  EXPECT_GT(exact / bending, 1.07);  // shear: an isotropic beam would miss this
  double error[3];
  for (int k = 0; k < 3; ++k) error[k] = exact / cantilever(8 << k, ZoneKind::kMixed, timber) - 1;
  EXPECT_NEAR(std::log2(error[1] / error[2]), 2.0, 0.1);
  verify({"zones", "timber along the grain, cantilever, extrapolated: compliance", "m/N", exact,
          1e-3, "the second order of 16 and 32 mixed zones through the depth"},
         exact / (1 + (4 * error[2] - error[1]) / 3));
}

// Deflection of the axis at mid-span under 1 N/m on top (article 22), half span l = L/2:
//   5 q l^4/24EI (1 + 12/5 c^2/l^2 (4/5 + nu/2))
double simply_supported(int rows, ZoneKind kind) {
  Model m = beam(kLength, rows, kind);
  const SolidBody& body = m.solids.bodies[0];
  const double l = 0.5 * kLength, c2 = kHalf * kHalf, per = 1 / (2 * kI);
  NodeVectors load(m.solids);
  const double edge = kLength / body.columns;
  for (int i = 0; i <= body.columns; ++i)
    load.y[body.node(i, rows)] -= i == 0 || i == body.columns ? 0.5 * edge : edge;
  const auto normal = [&](double y) { return -per * (2.0 / 3 * y * y * y - 0.4 * c2 * y); };
  const auto shear = [&](double y) { return per * l * (c2 - y * y); };
  NodeVectors ends(m.solids);
  pull_end(
      m, 0, [&](double y) { return -normal(y); }, shear, ends);
  pull_end(m, body.columns, normal, shear, ends);
  for (std::size_t i = 0; i < load.x.size(); ++i) {
    load.x[i] += ends.x[i];
    load.y[i] += ends.y[i];
  }
  hold(m, body.node(0, rows / 2), true, true);
  hold(m, body.node(body.columns, rows / 2), false, true);
  const NodeVectors u = scenes::solved(m.solids, load);
  return -u.y[body.node(body.columns / 2, rows / 2)];
}

TEST(ZoneBeams, simply_supported_beam_converges_to_the_exact_deflection_with_the_second_order) {
  const double l = 0.5 * kLength, ratio = kHalf * kHalf / (l * l);
  const double euler = 5 * std::pow(l, 4) / (24 * kE * kI);
  const double exact = euler * (1 + 2.4 * ratio * (0.8 + 0.5 * kNu));
  for (const ZoneKind kind : {ZoneKind::kCst, ZoneKind::kMixed}) {
    double error[3];
    for (int k = 0; k < 3; ++k) error[k] = exact / simply_supported(4 << k, kind) - 1;
    EXPECT_NEAR(std::log2(error[0] / error[1]), 2.0, 0.1) << name_of(kind);
    EXPECT_NEAR(std::log2(error[1] / error[2]), 2.0, 0.1) << name_of(kind);
    verify(
        {"zones",
         std::string(name_of(kind)) + ", simply supported, 16 zones through the depth: deflection",
         "m", exact, 0.015, "second order: stiffening - 1 = 0.013 (cst), 0.006 (mixed)"},
        exact / (1 + error[2]));
  }
}

// --- the step finds the same ------------------------------------------------------------------------

Model clamped(int rows, ZoneKind kind, double length) {
  Model m = beam(length, rows, kind);
  const SolidBody& body = m.solids.bodies[0];
  for (int j = 0; j <= rows; ++j) hold(m, body.node(0, j), true, true);
  return m;
}

TEST(ZoneBeams, the_step_settles_on_the_static_solution_of_a_cantilever_under_its_weight) {
  for (const ZoneKind kind : {ZoneKind::kCst, ZoneKind::kMixed}) {
    Rig rig(clamped(2, kind, 2.0));
    NodeVectors weight(rig.model.solids);
    for (std::size_t i = 0; i < weight.y.size(); ++i)
      weight.y[i] = -9.81 * rig.model.solids.node_gravity_mass[i];
    const NodeVectors expected = scenes::solved(rig.model.solids, weight);
    rig.state.gravity_y = -9.81;
    rig.run(1.0);  // some 25 periods, a third of the swing left after each half
    const auto tip = static_cast<std::size_t>(
        rig.model.solids.bodies[0].node(rig.model.solids.bodies[0].columns, 1));
    verify(
        {"zones", std::string(name_of(kind)) + ", cantilever under its weight, stepped: deflection",
         "m", -expected.y[tip], 1e-5, "turns of 1e-4 and what still swings"},
        -rig.state.node_uy[tip]);
    const double beam_theory =
        500 * 9.81 * kArea * std::pow(2.0, 4) / (8 * kE * kI) / stiffening(kind, 2, 1.0);
    EXPECT_NEAR(-expected.y[tip] / beam_theory, 1.0, 0.02);  // shear and the clamp
  }
}

TEST(ZoneBeams, the_first_period_of_a_cantilever) {
  constexpr double kSpan = 4.0;  // 20 times the depth
  Rig rig(clamped(4, ZoneKind::kMixed, kSpan));
  NodeVectors weight(rig.model.solids);
  for (std::size_t i = 0; i < weight.y.size(); ++i)
    weight.y[i] = -0.01 * rig.model.solids.node_gravity_mass[i];
  const NodeVectors bent = scenes::solved(rig.model.solids, weight);
  rig.state.node_ux = bent.x;
  rig.state.node_uy = bent.y;
  rig.controls.damping = 0;
  const auto tip = static_cast<std::size_t>(
      rig.model.solids.bodies[0].node(rig.model.solids.bodies[0].columns, 2));
  double first = 0, last = 0, before = rig.state.node_uy[tip];
  int crossings = 0;
  while (crossings < 7) {
    rig.step();
    const double now = rig.state.node_uy[tip];
    if ((now > 0) != (before > 0)) {
      last = rig.state.time - rig.controls.dt * now / (now - before);
      if (crossings++ == 0) first = last;
    }
    before = now;
  }
  // Euler-Bernoulli with the zones' stiffening; shear after Dunkerley: 1/w^2 = 1/wb^2 + 1/ws^2
  const double stiff = stiffening(ZoneKind::kMixed, 4, 1.0);
  const double wb =
      1.8751041 * 1.8751041 / (kSpan * kSpan) * std::sqrt(stiff * kE * kI / (500 * kArea));
  const double ws = 0.5 * 3.14159265358979 / kSpan * std::sqrt(5.0 / 6 * kG / 500);
  verify({"zones", "cantilever 20 times as long as deep: period of the first mode", "s",
          2 * 3.14159265358979 * std::sqrt(1 / (wb * wb) + 1 / (ws * ws)), 5e-3,
          "rotary inertia, clamp and the second mode in the start"},
         (last - first) / 3);
}

// A smooth pulse u = f(x - ct) runs at sqrt(E/rho) where nothing spreads sideways (nu = 0).
TEST(ZoneBeams, an_axial_wave_runs_at_the_speed_of_sound) {
  constexpr double kWidth = 0.3, kStart = 1.5, kTravel = 3.0;
  Rig rig(scenes::free_grid({0, 0, 6, 0.05, 240, 2}, ZoneKind::kMixed,
                            scenes::elastic_body(kE, 0, 500), kThick));
  const double speed = std::sqrt(kE / 500);
  rig.controls.damping = 0;
  Solids& s = rig.model.solids;
  const auto pulse = [&](double x) { return 1e-6 * std::exp(-0.5 * x * x / (kWidth * kWidth)); };
  for (std::size_t i = 0; i < s.node_x.size(); ++i) {
    const double x = s.node_x[i] - kStart, half = x + 0.5 * speed * rig.controls.dt;
    rig.state.node_ux[i] = pulse(x);
    rig.state.node_vx[i] = speed * half / (kWidth * kWidth) * pulse(half);
  }
  const auto centre = [&] {
    double energy = 0, moment = 0;
    for (std::size_t i = 0; i < s.node_x.size(); ++i) {
      const double e = s.node_mass[i] * rig.state.node_vx[i] * rig.state.node_vx[i];
      energy += e;
      moment += e * s.node_x[i];
    }
    return moment / energy;
  };
  const double from = centre(), start = rig.state.time;
  rig.run(kTravel / speed);
  verify({"zones", "speed of an axial wave", "m/s", speed, 2e-3,
          "dispersion of zones of 25 mm in a pulse of 0.3 m"},
         (centre() - from) / (rig.state.time - start));
}

}  // namespace
}  // namespace wythe::verification::zone_beams_test
