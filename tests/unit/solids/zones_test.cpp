// Zones alone: patch test, rigid motion, forces as the gradient
// of the strain energy, triangulation, moduli and their messages.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "dynamics/meters/residual.h"
#include "reading/zones.h"
#include "scenes/rig.h"
#include "scenes/zones.h"
#include "solids/zone.h"

namespace wythe::zones_test {
namespace {

using scenes::NodeVectors;
using scenes::Rig;
using solids::Corners;
using solids::Outline;

constexpr double kE = 10e9, kNu = 0.3, kThick = 0.2;
const Corners kCrooked{{0.0, 1.2, 1.0, -0.1}, {0.0, 0.1, 0.9, 0.7}};

// Four crooked quadrilaterals round a node that is nowhere near the middle.
Solids crooked_patch(ZoneKind kind) {
  Solids s;
  const double x[9] = {0, 0.45, 1, -0.1, 0.6, 1.1, 0, 0.5, 1};
  const double y[9] = {0, -0.1, 0, 0.5, 0.35, 0.55, 1, 1.1, 0.9};
  const auto material = scenes::zone_material(scenes::elastic_body(kE, kNu, 500), kThick);
  for (int i = 0; i < 9; ++i) {
    s.node_x.push_back(x[i]);
    s.node_y.push_back(y[i]);
  }
  s.n_node = 9;
  for (auto* ones : {&s.node_free_x, &s.node_free_y}) ones->assign(9, 1.0);
  s.node_mass.assign(9, 0.0);
  for (const auto& c : {std::array{0, 1, 4, 3}, {1, 2, 5, 4}, {3, 4, 7, 6}, {4, 5, 8, 7}}) {
    Corners at{};
    for (std::size_t k = 0; k < 4; ++k) {
      at.x[k] = x[c[k]];
      at.y[k] = y[c[k]];
      s.corner[k].push_back(c[k]);
    }
    s.zone_shape.push_back(s.n_zone++);
    s.shapes.push_back(solids::make_shape(at, kind, material));
    for (std::size_t k = 0; k < 4; ++k)
      s.node_mass[c[k]] += s.shapes.back().share[k] * s.shapes.back().mass;
  }
  return s;
}

// A polygon with a notch, cut into triangles.
Solids notched(int parts) {
  const Outline outline{{0, 1, 1, 0.6, 0.5, 0}, {0, 0, 1, 1, 0.5, 0.8}, parts};
  Solids s;
  solids::add_triangles(solids::triangulate(outline),
                        scenes::zone_material(scenes::elastic_body(kE, kNu, 500), kThick), s);
  return s;
}

// --- the patch test ---------------------------------------------------------------------------------

// Linear displacements, small enough that the zones' own turning (its square) drowns in round-off.
constexpr double kExx = 3e-8, kEyy = -2e-8, kHalfGamma = 1e-8;
NodeVectors linear(const Solids& s) {
  return scenes::field(
      s, [](double x, double y) { return kExx * x + kHalfGamma * y; },
      [](double x, double y) { return kHalfGamma * x + kEyy * y; });
}

void expect_patch(const Solids& s, const std::vector<int>& inside) {
  const NodeVectors u = linear(s), f = scenes::forces_of_zones(s, u);
  double greatest = 0;
  for (const double force : f.x) greatest = std::max(greatest, std::fabs(force));
  ASSERT_GT(greatest, 0);
  for (const int node : inside) {
    EXPECT_NEAR(f.x[node], 0, 1e-7 * greatest) << node;
    EXPECT_NEAR(f.y[node], 0, 1e-7 * greatest) << node;
  }
  const double plane = kE / (1 - kNu * kNu);
  Model model = scenes::free_solids(s);
  State state = initial_state(model);
  state.node_ux = u.x;
  state.node_uy = u.y;
  for (const ZoneReading& zone : read_zones(model, state)) {
    EXPECT_NEAR(zone.sigma_x, plane * (kExx + kNu * kEyy), 1e-6 * kE * kExx);
    EXPECT_NEAR(zone.sigma_y, plane * (kEyy + kNu * kExx), 1e-6 * kE * kExx);
    EXPECT_NEAR(zone.tau, kE / (1 + kNu) * kHalfGamma, 1e-6 * kE * kExx);
  }
}

TEST(Zones, a_patch_of_crooked_quadrilaterals_carries_constant_strain) {
  for (const ZoneKind kind : {ZoneKind::kMixed, ZoneKind::kCst})
    expect_patch(crooked_patch(kind), {4});
}

TEST(Zones, a_patch_of_triangles_carries_constant_strain) {
  const Solids s = notched(4);
  std::vector<int> inside;
  const auto& rim = s.bodies[0].rim;
  for (int i = 0; i < s.n_node; ++i)
    if (std::find(rim.begin(), rim.end(), i) == rim.end()) inside.push_back(i);
  ASSERT_GT(inside.size(), 10U);
  expect_patch(s, inside);
}

TEST(Zones, the_patch_s_middle_finds_its_place) {
  Solids s = crooked_patch(ZoneKind::kMixed);
  for (std::size_t i = 0; i < 9; ++i)
    if (i != 4) s.node_free_x[i] = s.node_free_y[i] = 0;
  NodeVectors u = linear(s);
  const double ux = u.x[4], uy = u.y[4];
  u.x[4] = u.y[4] = 0;
  const NodeVectors f = scenes::forces_of_zones(s, u);  // out of balance: the middle is held back
  const NodeVectors correction = scenes::solved(s, f);
  EXPECT_NEAR(correction.x[4], ux, 1e-6 * std::fabs(ux));
  EXPECT_NEAR(correction.y[4], uy, 1e-6 * std::fabs(uy));
}

// --- motion without strain, strain without motion ---------------------------------------------------

TEST(Zones, rigid_motion_however_large_leaves_no_strain) {
  for (const Solids& s :
       {crooked_patch(ZoneKind::kMixed), crooked_patch(ZoneKind::kCst), notched(3)})
    for (const double turn : {1e-6, 0.3, 2.0, 3.1}) {
      const double c = std::cos(turn), n = std::sin(turn);
      const NodeVectors u = scenes::field(
          s, [&](double x, double y) { return c * x - n * y - x + 5; },
          [&](double x, double y) { return n * x + c * y - y - 7; });
      const NodeVectors f = scenes::forces_of_zones(s, u);
      const double unit = kE * kThick;  // force of a strain of 1 over 1 m
      for (std::size_t i = 0; i < f.x.size(); ++i)
        EXPECT_NEAR(std::hypot(f.x[i], f.y[i]) / unit, 0, 1e-13) << turn;
      EXPECT_NEAR(scenes::energy_of_zones(s, u) / unit, 0, 1e-25) << turn;
    }
}

TEST(Zones, a_turned_strain_gives_the_turned_forces) {
  const ZoneShape shape =
      solids::make_shape(kCrooked, ZoneKind::kMixed,
                         scenes::zone_material(scenes::elastic_body(kE, kNu, 500), kThick));
  const double turn = 1.1, c = std::cos(turn), s = std::sin(turn);
  solids::ZoneVectors<double> u{{1e-3, -2e-3, 3e-3, 0}, {2e-3, 1e-3, -1e-3, 4e-4}}, v{};
  for (std::size_t k = 0; k < 4; ++k) {
    const double x = kCrooked.x[k] + u.x[k], y = kCrooked.y[k] + u.y[k];
    v.x[k] = c * x - s * y - kCrooked.x[k];
    v.y[k] = s * x + c * y - kCrooked.y[k];
  }
  const auto f = solids::zone_force(shape, u), g = solids::zone_force(shape, v);
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_NEAR(g.x[k], c * f.x[k] - s * f.y[k], 1e-9 * std::fabs(f.x[0]));
    EXPECT_NEAR(g.y[k], s * f.x[k] + c * f.y[k], 1e-9 * std::fabs(f.x[0]));
  }
  EXPECT_NEAR(solids::zone_energy(shape, v) / solids::zone_energy(shape, u), 1, 1e-9);
}

// Large displacements: central differences of the energy with a step of 1e-6 m, second order.
TEST(Zones, forces_are_the_gradient_of_the_strain_energy_and_have_neither_sum_nor_moment) {
  const ZoneShape shape = solids::make_shape(kCrooked, ZoneKind::kMixed,
                                             scenes::zone_material(scenes::timber_body(), kThick));
  solids::ZoneVectors<double> u{{0.1, -0.2, 0.3, 0.05}, {0.2, 0.4, -0.1, 0.1}};
  const auto f = solids::zone_force(shape, u);
  double sum_x = 0, sum_y = 0, moment = 0, size = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    for (const bool along_x : {true, false}) {
      double& place = along_x ? u.x[k] : u.y[k];
      const double at = place, step = 1e-6;
      place = at + step;
      const double more = solids::zone_energy(shape, u);
      place = at - step;
      const double less = solids::zone_energy(shape, u);
      place = at;
      const double force = along_x ? f.x[k] : f.y[k];
      EXPECT_NEAR(-(more - less) / (2 * step) / force, 1, 1e-6) << k << along_x;
      size = std::max(size, std::fabs(force));
    }
    sum_x += f.x[k];
    sum_y += f.y[k];
    moment += (kCrooked.x[k] + u.x[k]) * f.y[k] - (kCrooked.y[k] + u.y[k]) * f.x[k];
  }
  EXPECT_NEAR(sum_x / size, 0, 1e-13);
  EXPECT_NEAR(sum_y / size, 0, 1e-13);
  EXPECT_NEAR(moment / size, 0, 1e-13);
}

TEST(Zones, a_spinning_block_keeps_its_momenta_and_its_energy) {
  Rig rig(scenes::free_grid({0, 0, 0.6, 0.2, 6, 2}, ZoneKind::kMixed,
                            scenes::elastic_body(1e7, 0.2, 500), kThick));
  rig.controls.damping = 0;
  const Solids& s = rig.model.solids;
  for (std::size_t i = 0; i < s.node_x.size(); ++i) {  // about the lower left corner, and off
    rig.state.node_vx[i] = 2 - 5 * s.node_y[i];
    rig.state.node_vy[i] = 5 * s.node_x[i];
  }
  const auto momenta = [&] {
    std::array<double, 3> p{};
    for (std::size_t i = 0; i < s.node_x.size(); ++i) {
      const double mx = s.node_mass[i] * rig.state.node_vx[i];
      const double my = s.node_mass[i] * rig.state.node_vy[i];
      p[0] += mx;
      p[1] += my;
      p[2] += (s.node_x[i] + rig.state.node_ux[i]) * my - (s.node_y[i] + rig.state.node_uy[i]) * mx;
    }
    return p;
  };
  const auto before = momenta();
  const double kinetic = rig.energy().kinetic;
  rig.run(1.5);  // more than a full turn
  const auto after = momenta();
  for (std::size_t k = 0; k < 3; ++k)
    EXPECT_NEAR(after[k], before[k], 1e-11 * std::fabs(before[0]));  // round-off of 1e4 steps
  EXPECT_GT(rig.energy().elastic, 0);                                // stretched by its spin
  EXPECT_NEAR((rig.energy().kinetic + rig.energy().elastic) / kinetic, 1, 1e-3);
}

TEST(Zones, the_step_bound_holds_and_is_not_wasteful) {
  for (const ZoneKind kind : {ZoneKind::kMixed, ZoneKind::kCst})
    for (const bool triangles : {false, true}) {
      const auto fastest = [&](double share) {
        Rig rig(triangles ? scenes::free_solids(notched(3))
                          : scenes::free_grid({0, 0, 0.6, 0.2, 6, 3}, kind,
                                              scenes::elastic_body(kE, kNu, 500), kThick));
        rig.controls.damping = 0;
        rig.controls.dt = share * 2 / rig.model.omega_max;
        for (std::size_t i = 0; i < rig.state.node_vx.size(); ++i)
          rig.state.node_vx[i] = 1e-6 * std::sin(3.0 * static_cast<double>(i));
        for (int k = 0; k < 4000 && dynamics::runaway_of(rig.view()) < 0; ++k) rig.step();
        double speed = 0;
        for (const double v : rig.state.node_vx) speed = std::max(speed, std::fabs(v));
        return speed;
      };
      EXPECT_LT(fastest(0.99), 1e-4);
      EXPECT_GT(fastest(1.8), 1e-2);  // the true limit is less than 1.8 times the bound away
    }
}

// --- triangles --------------------------------------------------------------------------------------

TEST(Triangulate, covers_the_polygon_with_upright_triangles_and_walks_its_rim) {
  for (const int parts : {1, 2, 5}) {
    const Solids s = notched(parts);
    double area = 0;
    for (const ZoneShape& shape : s.shapes) {
      EXPECT_GT(shape.area, 0);
      area += shape.area;
    }
    EXPECT_NEAR(area, 0.8, 1e-12);  // shoelace formula by hand
    EXPECT_EQ(s.n_zone, 4 * parts * parts);
    const auto& rim = s.bodies[0].rim;
    ASSERT_EQ(rim.size(), 6U * static_cast<std::size_t>(parts));
    double twice = 0;
    for (std::size_t k = 0; k < rim.size(); ++k) {
      const auto p = static_cast<std::size_t>(rim[k]);
      const auto q = static_cast<std::size_t>(rim[(k + 1) % rim.size()]);
      twice += s.node_x[p] * s.node_y[q] - s.node_x[q] * s.node_y[p];
    }
    EXPECT_NEAR(0.5 * twice, 0.8, 1e-12);
    double mass = 0;
    for (const double m : s.node_mass) mass += m;
    EXPECT_NEAR(mass, 500 * kThick * 0.8, 1e-9);
    // Euler: every node is used, no edge hangs: V - E + F = 1 with 3F = 2E - rim
    EXPECT_EQ(2 * (s.n_node - 1), s.n_zone + static_cast<int>(rim.size()));
  }
}

// --- moduli -----------------------------------------------------------------------------------------

std::string problem(const JointMaterial& body) {
  const auto faults = solids::check_elasticity(body);
  return faults.empty() ? ""
                        : faults[0].key + " " + faults[0].value + ": " + faults[0].problem + "; " +
                              faults[0].cure;
}

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(Elasticity, refuses_what_is_not_an_elastic_body) {
  JointMaterial body = scenes::elastic_body(kE, 0.2, 500);
  EXPECT_EQ(problem(body), "");
  EXPECT_EQ(problem(scenes::timber_body()), "");
  body.density = 0;
  EXPECT_TRUE(has(problem(body), "density 0: must be more than 0")) << problem(body);
  body = scenes::elastic_body(kE, 0.2, 500);
  body.youngs_modulus = -1;
  EXPECT_TRUE(has(problem(body), "youngs_modulus -1")) << problem(body);
  body = scenes::elastic_body(kE, 0.6, 500);
  EXPECT_TRUE(has(problem(body), "shear_modulus : makes the Poisson ratio E/2G - 1 = 0.6"))
      << problem(body);
  body = scenes::elastic_body(kE, 0.2, 500);
  body.poisson_ratio = 0.3;  // a third number for two
  EXPECT_TRUE(has(problem(body), "poisson_ratio 0.3: differs from the 0.2 that E = 10 GPa"))
      << problem(body);
  body = scenes::timber_body();
  body.poisson_ratio = kUnset;
  EXPECT_TRUE(has(problem(body), "poisson_ratio : is missing")) << problem(body);
  body = scenes::timber_body();
  body.poisson_ratio = 0.49;
  body.youngs_modulus_across = 20e9;
  EXPECT_TRUE(has(problem(body), "the stiffness is not positive; write less than 10.6 GPa"))
      << problem(body);
}

TEST(Elasticity, plane_stress_and_plane_strain_of_an_isotropic_body) {
  const JointMaterial body = scenes::elastic_body(kE, kNu, 500);
  const auto stress = solids::elasticity_of(body, Plane::kStress);
  const auto strain = solids::elasticity_of(body, Plane::kStrain);
  EXPECT_NEAR(stress[0][0], kE / (1 - kNu * kNu), 1e-12 * kE);
  EXPECT_NEAR(stress[0][1], kNu * kE / (1 - kNu * kNu), 1e-12 * kE);
  const double lame = kE / ((1 + kNu) * (1 - 2 * kNu));
  EXPECT_NEAR(strain[0][0], (1 - kNu) * lame, 1e-12 * kE);
  EXPECT_NEAR(strain[1][0], kNu * lame, 1e-12 * kE);
  EXPECT_NEAR(stress[2][2], kE / (2 * (1 + kNu)), 1e-12 * kE);
  EXPECT_EQ(strain[2][2], stress[2][2]);
}

TEST(Elasticity, timber_is_stiff_along_the_grain_and_soft_across_it) {
  const auto d = solids::elasticity_of(scenes::timber_body(), Plane::kStress);
  // pulled along x with free sides: sigma_x = E1 ex, ey = -nu ex
  const double ex = 1e-3, ey = -0.4 * ex;
  EXPECT_NEAR(d[0][0] * ex + d[0][1] * ey, 10e9 * ex, 1e-6);
  EXPECT_NEAR(d[1][0] * ex + d[1][1] * ey, 0, 1e-6);
  EXPECT_EQ(d[0][1], d[1][0]);
  EXPECT_EQ(d[2][2], 0.6e9);
}

}  // namespace
}  // namespace wythe::zones_test
