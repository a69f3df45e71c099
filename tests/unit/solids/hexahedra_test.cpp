// Zones in space alone: patch test, rigid motion, forces as the gradient of the energy,
// bending and twist of one zone against closed forms (docs/theory/zones.md, "Zones in space").
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <array>
#include <cmath>
#include <vector>

#include "solids/hexahedron.h"

namespace wythe::hexahedra_test {
namespace {

using solids::HexahedronCorners;
using solids::HexahedronVectors;
using Field = Vec3 (*)(Vec3);

constexpr double kE = 10e9, kNu = 0.3, kDensity = 500;

JointMaterial isotropic(double nu = kNu) {
  JointMaterial m;
  m.density = kDensity;
  m.youngs_modulus = kE;
  m.shear_modulus = kE / (2 * (1 + nu));
  return m;
}
JointMaterial timber() {
  JointMaterial m;
  m.density = kDensity;
  m.youngs_modulus = 11e9;
  m.youngs_modulus_across = 0.4e9;
  m.shear_modulus = 0.6e9;
  m.poisson_ratio = 0.35;
  return m;
}

HexahedronCorners box(double a, double b, double c) {
  HexahedronCorners at;
  constexpr int kSide[8][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                               {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
  for (std::size_t i = 0; i < 8; ++i)
    at[i] = {(kSide[i][0] - 0.5) * a, (kSide[i][1] - 0.5) * b, (kSide[i][2] - 0.5) * c};
  return at;
}

// Eight crooked zones round a node that is nowhere near the middle.
struct Patch {
  std::vector<Vec3> node;
  std::vector<std::array<int, 8>> corner;
  std::vector<HexahedronShape> shape;
};
Patch crooked_patch(const JointMaterial& material) {
  Patch p;
  for (int k = 0; k < 3; ++k)
    for (int j = 0; j < 3; ++j)
      for (int i = 0; i < 3; ++i) {
        const double n = 9 * k + 3 * j + i;
        p.node.push_back({0.5 * i + 0.09 * std::sin(7 * n), 0.4 * j + 0.07 * std::sin(5 * n + 1),
                          0.3 * k + 0.05 * std::sin(3 * n + 2)});
      }
  p.node[13] = {0.58, 0.33, 0.36};
  const auto at = [](int i, int j, int k) { return 9 * k + 3 * j + i; };
  for (int k = 0; k < 2; ++k)
    for (int j = 0; j < 2; ++j)
      for (int i = 0; i < 2; ++i) {
        p.corner.push_back({at(i, j, k), at(i + 1, j, k), at(i + 1, j + 1, k), at(i, j + 1, k),
                            at(i, j, k + 1), at(i + 1, j, k + 1), at(i + 1, j + 1, k + 1),
                            at(i, j + 1, k + 1)});
        HexahedronCorners c;
        for (std::size_t n = 0; n < 8; ++n) c[n] = p.node[p.corner.back()[n]];
        EXPECT_GT(solids::least_jacobian(c), 0.2);
        p.shape.push_back(solids::make_hexahedron(
            c, solids::elasticity_in_space(material, {1, 0.4, -0.2}), kDensity));
      }
  return p;
}

Vector<double> vec(Vec3 v) { return {v.x, v.y, v.z}; }
double magnitude_of(const Vector<double>& v) { return std::sqrt(dot(v, v)); }

template <class Displace>
HexahedronVectors moved(const HexahedronCorners& c, const Displace& displace) {
  HexahedronVectors u;
  for (std::size_t i = 0; i < 8; ++i) u[i] = vec(displace(c[i]));
  return u;
}

// --- the patch test -----------------------------------------------------------------------------------------

TEST(Hexahedra, every_constant_strain_passes_through_crooked_zones) {
  constexpr double kStrain =
      1e-8;  // so small that the zones' own turning (its square) drowns in round-off
  for (const JointMaterial& material : {isotropic(), timber()}) {
    const Patch p = crooked_patch(material);
    const auto d = solids::elasticity_in_space(material, {1, 0.4, -0.2});
    double volume = 0;
    for (const HexahedronShape& s : p.shape) volume += s.volume;
    for (int strain = 0; strain < 6; ++strain) {
      constexpr int kPair[6][2] = {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {1, 2}, {2, 0}};
      const auto [r, t] = kPair[strain];
      const auto displace = [&, r = r, t = t](Vec3 x) {
        const double place[3] = {x.x, x.y, x.z};
        double u[3] = {};
        u[r] += 0.5 * kStrain * place[t];
        u[t] += 0.5 * kStrain * place[r];
        return Vec3{u[0], u[1], u[2]};
      };
      std::vector<Vector<double>> force(p.node.size(), {0, 0, 0});
      double energy = 0;
      for (std::size_t z = 0; z < p.shape.size(); ++z) {
        HexahedronCorners c;
        for (std::size_t n = 0; n < 8; ++n) c[n] = p.node[p.corner[z][n]];
        const HexahedronVectors u = moved(c, displace);
        const HexahedronVectors f = solids::hexahedron_force(p.shape[z], u);
        for (std::size_t n = 0; n < 8; ++n) {
          auto& sum = force[p.corner[z][n]];
          sum = sum + f[n];
        }
        energy += solids::hexahedron_energy(p.shape[z], u);
        const auto stress = solids::hexahedron_stress(p.shape[z], u);
        for (std::size_t i = 0; i < 6; ++i)
          EXPECT_NEAR(stress[i], d[i][strain] * kStrain, 1e-6 * kE * kStrain)
              << "strain " << strain << ", stress " << i;
      }
      double greatest = 0;
      for (const auto& f : force) greatest = std::fmax(greatest, magnitude_of(f));
      ASSERT_GT(greatest, 0);
      EXPECT_LT(magnitude_of(force[13]), 1e-7 * greatest) << "strain " << strain;
      const double modulus = d[strain][strain];
      EXPECT_NEAR(energy / (0.5 * modulus * kStrain * kStrain * volume), 1, 1e-7) << strain;
    }
  }
}

// The patch again with the middle node free: it stays where the strain puts it.
TEST(Hexahedra, a_free_node_of_a_strained_patch_goes_along) {
  const Patch p = crooked_patch(isotropic());
  Eigen::Matrix3d k = Eigen::Matrix3d::Zero();
  Eigen::Vector3d pull = Eigen::Vector3d::Zero();
  const auto displace = [](Vec3 x) {
    return 1e-8 * Vec3{x.x + 0.3 * x.y, 0.3 * x.x - 0.5 * x.y + 0.2 * x.z, 0.2 * x.y + 0.7 * x.z};
  };
  for (std::size_t z = 0; z < p.shape.size(); ++z)
    for (std::size_t n = 0; n < 8; ++n) {
      if (p.corner[z][n] != 13) continue;
      for (std::size_t m = 0; m < 8; ++m) {
        Eigen::Matrix3d block;
        for (int r = 0; r < 3; ++r)
          for (int c = 0; c < 3; ++c)
            block(r, c) = p.shape[z].stiffness[3 * n + static_cast<std::size_t>(r)]
                                              [3 * m + static_cast<std::size_t>(c)];
        if (p.corner[z][m] == 13) {
          k += block;
        } else {
          const Vec3 u = displace(p.node[p.corner[z][m]]);
          pull -= block * Eigen::Vector3d(u.x, u.y, u.z);
        }
      }
    }
  const Eigen::Vector3d found = k.ldlt().solve(pull);
  const Vec3 right = displace(p.node[13]);
  EXPECT_NEAR(found.x(), right.x, 1e-12 * 1e-8 * 1e4);
  EXPECT_NEAR(found.y(), right.y, 1e-12 * 1e-8 * 1e4);
  EXPECT_NEAR(found.z(), right.z, 1e-12 * 1e-8 * 1e4);
}

// --- one zone, any motion -----------------------------------------------------------------------------------

HexahedronCorners crooked_corners() {
  return {{{0, 0, 0},
           {1.2, 0.1, -0.1},
           {1.0, 0.9, 0.05},
           {-0.1, 0.7, 0},
           {0.1, -0.1, 0.8},
           {1.0, 0, 0.9},
           {1.1, 1.0, 1.0},
           {0, 0.8, 0.7}}};
}
HexahedronShape crooked() {
  return solids::make_hexahedron(crooked_corners(),
                                 solids::elasticity_in_space(isotropic(), {1, 0, 0}), kDensity);
}

TEST(Hexahedra, a_rigid_motion_makes_no_force) {
  const HexahedronShape shape = crooked();
  for (const double angle : {0.1, 1.0, 2.0, 3.1})
    for (const Vec3 axis : {Vec3{1, 0, 0}, Vec3{0.2, -0.9, 0.4}, Vec3{1, 1, 1}}) {
      const Rotation turn{angle / length(axis) * axis};
      const HexahedronVectors u = moved(crooked_corners(), [&](Vec3 x) {
        return turned(x, turn, {5, -3, 2}) - x;
      });
      for (const Vector<double>& f : solids::hexahedron_force(shape, u))
        EXPECT_LT(magnitude_of(f), 1e-13 * kE) << angle;  // E times a metre squared
    }
  const HexahedronVectors rest = moved(crooked_corners(), [](Vec3) { return Vec3{}; });
  for (const Vector<double>& f : solids::hexahedron_force(shape, rest)) {
    EXPECT_EQ(f.x, 0);
    EXPECT_EQ(f.y, 0);
    EXPECT_EQ(f.z, 0);
  }
}

// A crooked zone, turned far and strained as no real one is.
HexahedronVectors wild(double strain) {
  const Rotation turn{{0.7, -1.1, 0.4}};
  const HexahedronCorners c = crooked_corners();
  HexahedronVectors u;
  for (std::size_t i = 0; i < 8; ++i) {
    const double n = static_cast<double>(i);
    const Vec3 bent = c[i] + strain * Vec3{std::sin(3 * n), std::cos(2 * n), std::sin(5 * n + 1)};
    u[i] = vec(turned(bent, turn, {0.3, 0.2, -0.5}) - c[i]);
  }
  return u;
}

TEST(Hexahedra, the_force_is_the_slope_of_the_energy) {
  const HexahedronShape shape = crooked();
  const HexahedronVectors u = wild(0.05), f = solids::hexahedron_force(shape, u);
  double greatest = 0;
  for (const auto& one : f) greatest = std::fmax(greatest, magnitude_of(one));
  for (std::size_t i = 0; i < 8; ++i)
    for (int c = 0; c < 3; ++c) {
      const auto energy = [&](double by) {
        HexahedronVectors other = u;
        (c == 0 ? other[i].x : c == 1 ? other[i].y : other[i].z) += by;
        return solids::hexahedron_energy(shape, other);
      };
      constexpr double kStep = 1e-5;
      const double slope =
          (8 * (energy(kStep) - energy(-kStep)) - (energy(2 * kStep) - energy(-2 * kStep))) /
          (12 * kStep);
      const double own = c == 0 ? f[i].x : c == 1 ? f[i].y : f[i].z;
      EXPECT_NEAR(own, -slope, 1e-8 * greatest) << i << " " << c;
    }
}

TEST(Hexahedra, the_forces_have_no_sum_and_no_moment) {
  const HexahedronShape shape = crooked();
  const HexahedronCorners c = crooked_corners();
  for (const double strain : {1e-4, 0.05, 0.2}) {
    const HexahedronVectors u = wild(strain), f = solids::hexahedron_force(shape, u);
    Vector<double> sum{0, 0, 0}, moment{0, 0, 0};
    double size = 0;
    for (std::size_t i = 0; i < 8; ++i) {
      sum = sum + f[i];
      moment = moment + cross(vec(c[i]) + u[i], f[i]);
      size += magnitude_of(f[i]);
    }
    EXPECT_LT(magnitude_of(sum), 1e-14 * kE) << strain;
    EXPECT_LT(magnitude_of(moment), 1e-13 * kE) << strain;
    EXPECT_GT(size, 1e-6 * kE * strain);
  }
}

TEST(Hexahedra, nothing_but_rigid_motions_is_free) {
  for (const bool is_box : {true, false}) {
    const HexahedronShape shape =
        is_box ? solids::make_hexahedron(box(0.4, 0.2, 0.1),
                                         solids::elasticity_in_space(timber(), {1, 0, 0}), kDensity)
               : crooked();
    Eigen::MatrixXd k(24, 24);
    for (int i = 0; i < 24; ++i)
      for (int j = 0; j < 24; ++j) k(i, j) = shape.stiffness[i][j];
    const Eigen::VectorXd values = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(k).eigenvalues();
    for (int i = 0; i < 6; ++i) EXPECT_NEAR(values(i) / values(23), 0, 1e-14);
    EXPECT_GT(values(6) / values(23), 1e-5);
  }
}

TEST(Hexahedra, shares_of_the_mass_are_above_0_and_all_of_it) {
  const HexahedronShape shape = crooked();
  double sum = 0;
  for (const double share : shape.share) {
    EXPECT_GT(share, 0.05);
    sum += share;
  }
  EXPECT_NEAR(sum, 1, 1e-14);
  const HexahedronShape cube = solids::make_hexahedron(
      box(0.5, 0.4, 0.3), solids::elasticity_in_space(isotropic(), {1, 0, 0}), kDensity);
  EXPECT_NEAR(cube.volume, 0.06, 1e-16);
  for (const double share : cube.share) EXPECT_NEAR(share, 0.125, 1e-15);
}

// --- bending and twist of one zone ---------------------------------------------------------------------------

// Pure bending about z or y, of a zone as flat or long as one likes, and of any Poisson ratio: the energy is the
// beam's, with one zone through the depth.
TEST(Hexahedra, pure_bending_does_not_lock) {
  constexpr double kCurvature = 1e-7;
  for (const double nu : {0.0, 0.3, 0.4999})
    for (const double a : {0.1, 0.4, 2.0})
      for (const bool about_z : {true, false}) {
        const double b = 0.2, c = 0.3;
        const HexahedronShape shape = solids::make_hexahedron(
            box(a, b, c), solids::elasticity_in_space(isotropic(nu), {1, 0, 0}), kDensity);
        const HexahedronVectors u = moved(box(a, b, c), [&](Vec3 x) {
          const double h = about_z ? x.y : x.z, t = about_z ? x.z : x.y;
          const double bent = 0.5 * kCurvature * (x.x * x.x + nu * (h * h - t * t));
          const double widened = nu * kCurvature * h * t;
          return Vec3{-kCurvature * x.x * h, about_z ? bent : widened, about_z ? widened : bent};
        });
        const double i = about_z ? c * b * b * b / 12 : b * c * c * c / 12;
        EXPECT_NEAR(
            solids::hexahedron_energy(shape, u) / (0.5 * kE * i * kCurvature * kCurvature * a), 1,
            1e-6)
            << "nu " << nu << ", length " << a << (about_z ? ", about z" : ", about y");
      }
}

// Twist of one zone with the warping u = w y z that costs least: GJ of b^3 c^3 / 3 (b^2 + c^2), (8.14).
TEST(Hexahedra, the_twist_of_one_zone_is_that_of_bilinear_warping) {
  constexpr double kTwist = 1e-7, kLength = 0.35;
  for (const double b : {0.1, 0.2, 0.3}) {
    const double c = 0.2, g = isotropic().shear_modulus;
    const HexahedronShape shape = solids::make_hexahedron(
        box(kLength, b, c), solids::elasticity_in_space(isotropic(), {1, 0, 0}), kDensity);
    const auto energy = [&](double warp) {
      return solids::hexahedron_energy(
          shape, moved(box(kLength, b, c), [&](Vec3 x) {
            return kTwist * Vec3{warp * x.y * x.z, -x.x * x.z, x.x * x.y};
          }));
    };
    const double least = (c * c - b * b) / (b * b + c * c);
    const double j = b * b * b * c * c * c / (3 * (b * b + c * c));
    EXPECT_NEAR(energy(least) / (0.5 * g * j * kTwist * kTwist * kLength), 1, 1e-6) << b;
    EXPECT_GT(energy(least + 0.1), energy(least));
    EXPECT_GT(energy(least - 0.1), energy(least));
  }
}

TEST(Hexahedra, the_grain_lies_where_it_is_said_to) {
  const auto along = solids::elasticity_in_space(timber(), {1, 0, 0});
  const auto up = solids::elasticity_in_space(timber(), {0, 1, 0});
  EXPECT_GT(along[0][0], 10 * along[1][1]);
  EXPECT_NEAR(up[1][1] / along[0][0], 1, 1e-12);
  EXPECT_NEAR(up[0][0] / along[1][1], 1, 1e-12);
  EXPECT_NEAR(up[3][3] / along[3][3], 1, 1e-12);
  EXPECT_NEAR(up[5][5] / along[4][4], 1, 1e-12);  // across both: E2 / 2 (1 + nu)
  EXPECT_NEAR(along[4][4], 0.4e9 / (2 * 1.35), 1);
  // E along the grain is what a bar pulled along it shows
  Eigen::Matrix<double, 6, 6> d;
  const auto skew = solids::elasticity_in_space(timber(), {1, 2, -0.5});
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < 6; ++j) d(i, j) = skew[i][j];
  const Eigen::Vector3d a = Eigen::Vector3d(1, 2, -0.5).normalized();
  Eigen::Vector<double, 6> pull;
  pull << a.x() * a.x(), a.y() * a.y(), a.z() * a.z(), a.x() * a.y(), a.y() * a.z(), a.z() * a.x();
  const Eigen::Vector<double, 6> strain = d.ldlt().solve(pull);
  Eigen::Matrix3d e;
  e << strain(0), strain(3) / 2, strain(5) / 2, strain(3) / 2, strain(1), strain(4) / 2,
      strain(5) / 2, strain(4) / 2, strain(2);
  EXPECT_NEAR(1 / (a.transpose() * e * a)(0), 11e9, 1e3);
}

}  // namespace
}  // namespace wythe::hexahedra_test
