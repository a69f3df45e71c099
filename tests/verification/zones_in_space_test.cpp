// Deformable blocks in space as beams: stretch, bending about both axes, twist and shear against closed forms.
// Alone and in the engine between rigid blocks, with the order of convergence where a mesh is not exact.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "reading/zones_in_space.h"
#include "record.h"
#include "scenes/space_rig.h"
#include "scenes/zones_in_space.h"

namespace wythe::zones_in_space_test {
namespace {

using scenes::Column;
using scenes::SpaceRig;
using verification::verify;

// --- zones alone: solved at once ---------------------------------------------------------------------------

// Consistent forces of a traction on the level face at height y: 3 x 3 points of Gauss on each side of a zone.
template <class Traction>
void pull_face(const SpaceSolidBody& body, const SpaceSolids& s, int row, const Traction& traction,
               Eigen::VectorXd& load) {
  const double g[3] = {-std::sqrt(0.6), 0, std::sqrt(0.6)}, w[3] = {5.0 / 9, 8.0 / 9, 5.0 / 9};
  for (int k = 0; k < body.count[2]; ++k)
    for (int i = 0; i < body.count[0]; ++i) {
      const int node[4] = {body.node(i, row, k), body.node(i + 1, row, k),
                           body.node(i + 1, row, k + 1), body.node(i, row, k + 1)};
      const auto at = [&](int n) { return s.node[node[n]]; };
      const double area = length(cross(at(1) - at(0), at(3) - at(0)));
      for (int a = 0; a < 3; ++a)
        for (int b = 0; b < 3; ++b) {
          const double share[4] = {(1 - g[a]) * (1 - g[b]) / 4, (1 + g[a]) * (1 - g[b]) / 4,
                                   (1 + g[a]) * (1 + g[b]) / 4, (1 - g[a]) * (1 + g[b]) / 4};
          Vec3 place;
          for (int n = 0; n < 4; ++n) place = place + share[n] * at(n);
          const Vec3 t = 0.25 * area * w[a] * w[b] * traction(place);
          for (int n = 0; n < 4; ++n) {
            load(3 * node[n]) += share[n] * t.x;
            load(3 * node[n] + 1) += share[n] * t.y;
            load(3 * node[n] + 2) += share[n] * t.z;
          }
        }
    }
}

// Work of a cantilever's exact stresses, acting on both of its ends, over its exact energy
// F^2 L^3/6EI + (6/5) F^2 L/2GA: 1 but for what the mesh cannot follow. Bent across x or across z.
double flexure(int through, bool across_x) {
  Column c{.wide = 0.2, .deep = 0.1, .high = 0.4};
  c.zones = 4 * through;
  c.zone_length = 0.1 / through;
  const Model m = compile(scenes::column_of_zones(c));
  const SpaceSolids& s = m.space.solids;
  const SpaceSolidBody& body = s.bodies[0];
  const double h = across_x ? c.wide : c.deep, b = across_x ? c.deep : c.wide, l = c.high;
  const double inertia = b * h * h * h / 12, area = b * h, e = c.youngs_modulus, g = e / 2;
  constexpr double kForce = 1000;
  Eigen::VectorXd load = Eigen::VectorXd::Zero(3 * s.n_node);
  const auto shear = [&](Vec3 p, double sense) {
    const double y = across_x ? p.x : p.z;
    const double tau = sense * kForce / (2 * inertia) * (h * h / 4 - y * y);
    return across_x ? Vec3{tau, 0, 0} : Vec3{0, 0, tau};
  };
  pull_face(
      body, s, body.count[1], [&](Vec3 p) { return shear(p, 1); }, load);
  pull_face(
      body, s, 0,
      [&](Vec3 p) {
        Vec3 t = shear(p, -1);
        t.y = kForce * l * (across_x ? p.x : p.z) / inertia;
        return t;
      },
      load);
  // held as little as a body needs; the loads are in balance
  std::vector<bool> held(static_cast<std::size_t>(3 * s.n_node), false);
  const auto hold = [&](int node, int direction) { held[3 * node + direction] = true; };
  const int last = body.count[0], far = body.count[2];
  for (int d = 0; d < 3; ++d) hold(body.node(0, 0, 0), d);
  hold(body.node(last, 0, 0), 1), hold(body.node(last, 0, 0), 2);
  hold(body.node(0, 0, far), 1);
  const Eigen::VectorXd u =
      scenes::solved_in_space(s, load, held, Eigen::VectorXd::Zero(3 * s.n_node));
  return 0.5 * load.dot(u) /
         (kForce * kForce * l * l * l / (6 * e * inertia) + 0.6 * kForce * kForce * l / (g * area));
}

TEST(ZonesInSpace, bending_with_shear_converges_about_both_axes) {
  for (const bool across_x : {true, false}) {
    const std::string axis = across_x ? "z" : "x";
    const double four = flexure(4, across_x), eight = flexure(8, across_x);
    verify({"SP40",
            "zones in space: bending with shear about " + axis +
                ", error of eight zones through the thinner side over that of four",
            "-", 0.25, 0.05, "second order, up to terms of the fourth"},
           (eight - 1) / (four - 1));
    verify({"SP40",
            "zones in space: bending with shear about " + axis +
                ", eight zones through the thinner side: work over exact energy",
            "-", 1, 1e-3, "the mesh"},
           eight);
  }
}

// Saint-Venant's torsion: one layer of zones whose ends turn against each other and warp freely. The energy tells GJ.
double torsion(double wide, double deep, int nx, int nz) {
  Column c{.wide = wide, .deep = deep, .high = 0.07, .zones = 1};
  c.zone_length = wide / nx;
  c.poisson_ratio = 0.25;
  const Model m = compile(scenes::column_of_zones(c));
  const SpaceSolids& s = m.space.solids;
  EXPECT_EQ(s.bodies[0].count[0], nx);
  EXPECT_EQ(s.bodies[0].count[2], nz);
  constexpr double kTwist = 1e-3;  // [rad/m]
  Eigen::VectorXd u = Eigen::VectorXd::Zero(3 * s.n_node);
  std::vector<bool> held(static_cast<std::size_t>(3 * s.n_node), false);
  for (int n = 0; n < s.n_node; ++n) {
    const Vec3 p = s.node[n];
    u(3 * n) = kTwist * p.y * p.z;
    u(3 * n + 2) = -kTwist * p.y * p.x;
    held[3 * n] = held[3 * n + 2] = true;
  }
  held[1] = true;  // warping is known but for a shift
  const Eigen::VectorXd found =
      scenes::solved_in_space(s, Eigen::VectorXd::Zero(3 * s.n_node), held, u);
  const double energy = 0.5 * found.dot(scenes::stiffness_of_zones(s) * found);
  const double g = c.youngs_modulus / (2 * (1 + c.poisson_ratio));
  return 2 * energy / (g * kTwist * kTwist * c.high);
}

TEST(ZonesInSpace, twist_has_the_closed_form_of_one_zone_and_converges_to_saint_venant) {
  const double a = 0.2, b = 0.1, one = a * a * a * b * b * b / (3 * (a * a + b * b));
  verify({"SP41", "zones in space: torsion constant of one zone, 2 : 1", "m^4", one, 1e-9,
          "closed form (8.12)"},
         torsion(a, b, 1, 1));
  const double exact = 0.228682 * a * b * b * b;
  double before = 0;
  for (const int n : {4, 8, 16}) {
    const double off = torsion(a, b, 2 * n, n) / exact - 1;
    if (before > 0)
      verify({"SP41", "zones in space: torsion, error of halved zones over the one before", "-",
              0.25, 0.05, "second order, up to terms of the fourth"},
             off / before);
    before = off;
  }
  verify({"SP41", "zones in space: torsion constant, 32 x 16 zones, 2 : 1", "m^4", exact, 2e-3,
          "Saint-Venant's series; the mesh"},
         torsion(a, b, 32, 16));
}

// --- in the engine: a column on a floor, a rigid cap loaded ----------------------------------------------------

struct Tip {
  Vec3 moved, turned;
};
Tip load_cap(const Column& column, Vec3 force, Vec3 moment) {
  Model model = compile(scenes::column_of_zones(column));
  scenes::add_load(model, 0, {}, force);
  const double arm = 0.05;
  const auto couple = [&](Vec3 along, Vec3 across, double size) {
    for (const double sense : {1.0, -1.0}) {
      const Vec3 a = sense * arm * along, f = sense * size / (2 * arm) * across;
      model.stages[0].loads.push_back({0, a.x, a.y, f.x, f.y, a.z, f.z});
    }
  };
  couple({0, 1, 0}, {0, 0, 1}, moment.x);
  couple({0, 0, 1}, {1, 0, 0}, moment.y);
  couple({1, 0, 0}, {0, 1, 0}, moment.z);
  SpaceRig rig(std::move(model));
  rig.state.load_scale[0] = 1;
  rig.controls.damping = 0.4;
  rig.load_state();
  rig.run(0.25);
  const Quaternion<double> q = rig.turn(0);
  return {rig.moved(0), 2.0 * Vec3{q.v.x, q.v.y, q.v.z}};
}

TEST(ZonesInSpace, a_column_in_the_engine_stretches_and_bends_as_a_beam_on_its_joints) {
  const Column c{.zones = 5, .zone_length = 0.2};  // one zone through each side of the section
  const double area = c.wide * c.deep, l = c.high, e = c.youngs_modulus;
  const double about_x = c.wide * std::pow(c.deep, 3) / 12,
               about_z = c.deep * std::pow(c.wide, 3) / 12;
  const char* why = "settled with damping; second order of the turns";
  constexpr double kForce = 100, kMoment = 10;
  const Tip pulled = load_cap(c, {0, kForce, 0}, {});
  verify({"SP42", "column of zones in space: stretch", "m",
          kForce * (l / (e * area) + 2 / (c.kn * area)), 1e-4, why},
         pulled.moved.y);
  const Tip bent = load_cap(c, {}, {kMoment, 0, kMoment});
  verify({"SP42", "column of zones in space: moment about x, turn", "rad",
          kMoment * (l / (e * about_x) + 2 / (c.kn * about_x)), 1e-4, why},
         bent.turned.x);
  verify({"SP42", "column of zones in space: moment about z, turn", "rad",
          kMoment * (l / (e * about_z) + 2 / (c.kn * about_z)), 1e-4, why},
         bent.turned.z);
  // the line of bending: the cap's middle stands half of its height above the end
  const double middle = 0.05, turn = kMoment / (e * about_z);
  verify({"SP42", "column of zones in space: moment about z, deflection along -x", "m",
          turn * l * (l / 2 + middle) + kMoment / (c.kn * about_z) * (l + 2 * middle), 1e-4, why},
         -bent.moved.x);
}

TEST(ZonesInSpace, a_column_in_the_engine_bends_by_forces_and_twists) {
  Column c{.zones = 10, .zone_length = 0.05};
  const double area = c.wide * c.deep, l = c.high, e = c.youngs_modulus, g = e / 2;
  const double about_x = c.wide * std::pow(c.deep, 3) / 12,
               about_z = c.deep * std::pow(c.wide, 3) / 12;
  constexpr double kForce = 100, kMoment = 10, kMiddle = 0.05;
  // force on the cap's middle: of the beam, its shear, both joints. Each zone knows one curvature along the beam:
  // of the moment that grows with the height h it takes the mean, int h^2 dh less l a^2/12.
  const double a = l / c.zones;
  const auto deflection = [&](double inertia) {
    const double up = l + kMiddle;  // the force's height above the lower joint
    return kForce *
           (((up * up * up - kMiddle * kMiddle * kMiddle) / 3 - l * a * a / 12) / (e * inertia) +
            l / (5.0 / 6 * g * area) + (up * up + kMiddle * kMiddle) / (c.kn * inertia) +
            2 / (c.ks * area));
  };
  const char* why = "shear of beam theory; how the joints hold the ends";
  verify({"SP42", "column of zones in space: force along x, deflection", "m", deflection(about_z),
          2e-3, why},
         load_cap(c, {kForce, 0, 0}, {}).moved.x);
  verify({"SP42", "column of zones in space: force along z, deflection", "m", deflection(about_x),
          1e-3, why},
         load_cap(c, {0, 0, kForce}, {}).moved.z);
  const double polar = area * (c.wide * c.wide + c.deep * c.deep) / 12;
  const double j = torsion(c.wide, c.deep, 4, 2);  // of the same section
  verify({"SP42", "column of zones in space: twist, against the torsion constant of its mesh",
          "rad", kMoment * (l / (g * j) + 2 / (c.ks * polar)), 0.03, "the ends do not warp freely"},
         load_cap(c, {}, {0, kMoment, 0}).turned.y);
}

// --- the sag of a lintel ---------------------------------------------------------------------------------------

// A lintel of zones on two bearings of length b, under its own weight w a length, along x or z. The bearings are soft, so
// their pressure is even and acts at their middles, L apart; ends of c = b/2 stick out. Turned by t about its axis, an end
// leans on its bearing by kn wide b^3/12 t, and drags its lower edge along it: a thrust H = ks wide b t deep/2, which acts
// deep/2 below the axis. Together that is k t with k = kn wide b^3/12 + ks wide b deep^2/4, which is little. Sag of the middle against the ends, and the turn of one end against the
// other, of a beam with shear:
//   M = w c^2/2 + k t,   t = (w L^3/24 - M L/2)/EI
//   sag = 5 w L^4/384 EI - M L^2/8 EI + w L^2/8 kGA + t c - w c^4/8 EI,   turn = 2 (t - w c^3/6 EI)
// A zone of length a has its weight at its ends, so the moment is straight between them, by w a^2/12 less in the mean; and it
// knows one curvature, of the mean moment, which takes a^2/12 int M' m' dx: w L^2 a^2/96 EI each. Poisson's ratio is 0, as
// beams know none.
struct Lintel {
  double span = 1.9, bearing = 0.1, deep = 0.1, wide = 0.2, zone = 0.1, kn = 1e8,
         youngs_modulus = 1e10;
  double poisson_ratio = 0, density = 2400;
};
struct Sag {
  double sag = 0, turn = 0, axial = 0;
};
Sag closed_form(const Lintel& l) {
  const double area = l.deep * l.wide, w = l.density * 9.81 * area, c = l.bearing / 2,
               ei = l.youngs_modulus * l.wide * std::pow(l.deep, 3) / 12,
               shear = 5.0 / 6 * area * l.youngs_modulus / (2 * (1 + l.poisson_ratio)),
               drag = 0.4 * l.kn * l.wide * l.bearing * l.deep / 2,
               k = l.kn * l.wide * std::pow(l.bearing, 3) / 12 + drag * l.deep / 2, span = l.span;
  const double t = (w * std::pow(span, 3) / 24 - w * c * c * span / 4) / (ei + k * span / 2);
  const double moment = w * c * c / 2 + k * t;
  return {5 * w * std::pow(span, 4) / (384 * ei) - moment * span * span / (8 * ei) +
              w * span * span / (8 * shear) + t * c - w * std::pow(c, 4) / (8 * ei) -
              w * span * span * l.zone * l.zone / (48 * ei),
          2 * (t - w * std::pow(c, 3) / (6 * ei)), -drag * t};
}
Sag of_zones(const Lintel& l, bool along_z) {
  const double all = l.span + l.bearing;
  const auto place = [&](double along, double y, double across) {
    return along_z ? Vec3{across, y, along} : Vec3{along, y, across};
  };
  std::vector<BodySpec> bodies{
      scenes::box_body("left", place(0, -0.2, 0), place(l.bearing, 0, l.wide), true),
      scenes::box_body("right", place(all - l.bearing, -0.2, 0), place(all, 0, l.wide), true),
      scenes::box_body("lintel", place(0, 0, 0), place(all, l.deep, l.wide)),
      scenes::box_body("stone", place(0, -0.2, 1), place(0.2, 0, 1.2)),
      scenes::box_body("floor", place(-1, -0.4, 0.5), place(1, -0.2, 2), true)};
  bodies[2].role = "lintel", bodies[2].material = "stuff";
  bodies[2].zone.zones = 2, bodies[2].zone.length = l.zone;
  ModelSpec spec = scenes::in_space(bodies, scenes::elastic_joint(l.kn, 0.4 * l.kn), 2000);
  spec.material["stuff"] = scenes::elastic_body(l.youngs_modulus, l.poisson_ratio, l.density);
  spec.solve.raise_light_inertia = false;
  SpaceRig rig(compile(spec));
  rig.set_gravity({0, -9.81, 0});
  rig.controls.damping = 0.4;
  rig.load_state();
  rig.run(1.0);
  const reading::LintelMeasures now = reading::lintel_measures_in_space(rig.model, rig.state);
  return {now.deflection, now.end_rotation, now.axial};
}

TEST(ZonesInSpace, a_lintel_on_two_bearings_sags_as_a_beam) {
  const Lintel lintel;
  const Sag hand = closed_form(lintel);
  const char* why = "shear of beam theory; how the bearings hold the ends";
  for (const bool along_z : {false, true}) {
    const std::string along = along_z ? "lintel of zones along z: " : "lintel of zones along x: ";
    const Sag zones = of_zones(lintel, along_z);
    verify({"SP43", along + "sag of its middle under its weight", "m", hand.sag, 0.005, why},
           zones.sag);
    verify({"SP43", along + "turn of one end against the other", "rad", hand.turn, 0.005, why},
           zones.turn);
    verify({"SP43", along + "thrust from its bearings", "N", hand.axial, 0.02, why}, zones.axial);
  }
}

}  // namespace
}  // namespace wythe::zones_in_space_test
