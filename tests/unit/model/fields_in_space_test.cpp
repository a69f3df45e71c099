// Random fields of walls in space: covariance of places in plan, statistics
// over many walls, courses and units, and the effect of a field on the wall.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "campaign/draws/field_factor.h"
#include "model/field_places.h"
#include "model/space/space.h"
#include "scenes/scenes.h"
#include "wythe/parts/error.h"
#include "wythe/parts/io.h"
#include "wythe/parts/limit.h"
#include "wythe/parts/solve.h"
#include "wythe/parts/study.h"

namespace wythe::fields_in_space_test {
namespace {

const std::string kJoints = R"(
[wall]
height = "0.6 m"
thickness = "0.1 m"
[wall.unit]
length = "200 mm"
height = "100 mm"
density = "2000 kg/m^3"
split = "none"
[material.joint]
normal_stiffness = "20 GPa/m"
shear_stiffness = "8 GPa/m"
tensile_strength = "0.15 MPa"
cohesion = "0.15 MPa"
friction_angle = "30 deg"
residual_friction_angle = "25 deg"
residual_cohesion = "0 MPa"
mode_1_energy = "4.3 N/m"
mode_2_energy = "125 N/m"
compressive_strength = "4 MPa"
compressive_energy = "12800 N/m"
[[stage]]
name = "gravity"
[[stage]]
name = "push"
at = { block = "front.c05*" }
direction = "+z"
velocity = "4 mm/s"
damping = 0.2
until = "0.2 mm"
)";
const std::string kCorner = R"(
[[plan_wall]]
name = "front"
line = [["0 m", "0 m"], ["0.75 m", "0 m"]]
[[plan_wall]]
name = "side"
line = [["0 m", "0 m"], ["0 m", "0.75 m"]]
)";
const std::string kField = R"([field.ft]
path = "material.joint.tensile_strength"
cov = 0.25
along = "0.4 m"
across = "0.15 m"
)";

ModelSpec wall_with(const std::string& fields, const std::vector<std::string>& settings = {}) {
  return parse_model(kJoints + kCorner + fields, "wall.toml", settings);
}

std::vector<FieldPlace> places_of(const ModelSpec& spec, const std::string& path) {
  FaultList none;
  return field_places(spec, assemble_space(spec, none), *field_target(path));
}

double distance(const FieldPlace& a, const FieldPlace& b) {
  return std::hypot(a.x - b.x, a.z - b.z);
}

std::string refusal(const std::string& fields) {
  try {
    (void)compile(wall_with(fields));
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

// The draw of a grid is linear in w, so unit vectors give the columns of its factor.
TEST(FieldsInSpace, places_in_plan_have_the_covariance_of_their_distance) {
  std::vector<double> x, z, y;
  for (int row = 0; row < 6; ++row)
    for (int k = 0; k < 11; ++k) {
      const double s = 0.2 * k + 0.1 * (row % 2);
      x.push_back(k < 6 ? s : 1.1);
      z.push_back(k < 6 ? 0 : s - 1.1);
      y.push_back(0.1 * row);
    }
  for (const FieldKernel kernel : {FieldKernel::kExponential, FieldKernel::kSquaredExponential}) {
    FieldGrid grid(x, z, y, 1e-6);
    grid.correlate(kernel, 0.7, 0.25);
    std::vector<std::vector<double>> column;
    for (std::size_t k = 0; k < grid.numbers(); ++k) {
      std::vector<double> w(grid.numbers(), 0.0);
      w[k] = 1;
      column.push_back(grid.draw(w));
    }
    for (std::size_t i = 0; i < x.size(); ++i)
      for (std::size_t j = 0; j < x.size(); ++j) {
        double sum = 0;
        for (const std::vector<double>& f : column) sum += f[i] * f[j];
        const double along = std::hypot(x[i] - x[j], z[i] - z[j]) / 0.7,
                     up = std::fabs(y[i] - y[j]) / 0.25;
        const double wanted = kernel == FieldKernel::kExponential
                                  ? std::exp(-along - up)
                                  : std::exp(-along * along - up * up);
        EXPECT_NEAR(sum, wanted, 1e-11);  // exp of core/real.h 1e-13; a matrix singular to rounding
      }
  }
}

// As in the plane (random_fields_test.cpp): of about 60 tested pairs none may miss by more than 4.5 deviations.
TEST(FieldsInSpace, has_its_covariance_mean_and_scatter_round_a_corner_over_many_walls) {
  constexpr int kWalls = 600;
  ModelSpec spec = wall_with(kField);
  const std::vector<FieldPlace> places = places_of(spec, "material.joint.tensile_strength");
  std::vector<std::vector<double>> log_of;
  for (int seed = 0; seed < kWalls; ++seed) {
    spec.field.at("ft").seed = seed;
    draw_fields(spec);
    std::vector<double>& wall = log_of.emplace_back();
    for (const double factor : spec.field.at("ft").drawn) wall.push_back(std::log(factor));
  }
  const auto mean = [&](std::size_t i) {
    double sum = 0;
    for (const auto& wall : log_of) sum += wall[i];
    return sum / kWalls;
  };
  const auto covariance = [&](std::size_t i, std::size_t j) {
    const double a = mean(i), b = mean(j);
    double sum = 0;
    for (const auto& wall : log_of) sum += (wall[i] - a) * (wall[j] - b);
    return sum / (kWalls - 1);
  };
  const double variance = std::log1p(0.25 * 0.25);
  for (std::size_t i = 0; i < places.size(); i += 17) {
    for (std::size_t j = i + 3; j < places.size(); j += 23) {
      const double rho = std::exp(-distance(places[i], places[j]) / 0.4 -
                                  std::fabs(places[i].y - places[j].y) / 0.15);
      const double found = covariance(i, j) / std::sqrt(covariance(i, i) * covariance(j, j));
      EXPECT_LT(std::fabs(std::atanh(found) - std::atanh(rho)), 4.5 / std::sqrt(kWalls - 3.0))
          << found << ' ' << rho;
    }
    EXPECT_NEAR(mean(i), -variance / 2, 4.5 * std::sqrt(variance / kWalls));
    EXPECT_NEAR(covariance(i, i) / variance, 1, 4.5 * std::sqrt(2.0 / (kWalls - 1)));
  }
}

TEST(FieldsInSpace, courses_go_round_the_corner_and_units_are_those_of_their_wall) {
  const auto drawn = [](const std::string& by) {
    return wall_with("[field.ft]\npath = \"material.joint.tensile_strength\"\ncov = 0.3\nby = \"" +
                     by + "\"\n");
  };
  for (const std::string by : {"course", "unit", "joint"}) {
    const ModelSpec spec = drawn(by);
    const std::vector<FieldPlace> places = places_of(spec, "material.joint.tensile_strength");
    std::map<int, double> of;
    for (std::size_t p = 0; p < places.size(); ++p) {
      const int label = by == "course" ? places[p].course
                        : by == "unit" ? places[p].unit
                                       : places[p].entity;
      const auto [known, is_new] = of.try_emplace(label, spec.field.at("ft").drawn[p]);
      EXPECT_EQ(known->second, spec.field.at("ft").drawn[p]) << by;
    }
    std::set<double> values;
    for (const auto& [label, value] : of) values.insert(value);
    EXPECT_EQ(values.size(), of.size()) << by;
    // six courses of both walls together
    if (by == "course") {
      EXPECT_EQ(of.size(), 6U);
    }
  }
}

TEST(FieldsInSpace, without_scatter_is_the_plain_wall_to_the_bit) {
  const std::string none =
      "[field.ft]\npath = \"material.joint.tensile_strength\"\ncov = 0\nalong = \"0.4 m\"\nacross "
      "= \"0.2 m\"\n"
      "[field.rho]\npath = \"wall.unit.density\"\ncov = 0\nby = \"unit\"\n";
  const Model plain = compile(wall_with("")), graded = compile(wall_with(none));
  ASSERT_GT(graded.materials.size(), plain.materials.size() + 30);
  State a = initial_state(plain), b = initial_state(graded);
  const Result one = solve(plain, a, {}), two = solve(graded, b, {});
  EXPECT_EQ(one.state_hash, two.state_hash);
  EXPECT_GT(one.responses.peak_reaction, 0);
}

TEST(FieldsInSpace, each_joint_has_its_own_strength_and_what_follows_it) {
  const ModelSpec spec = wall_with(
      kField + "[field.GI]\npath = \"material.joint.mode_1_energy\"\nformula = \"30 um * ft\"\n");
  const Model m = compile(spec);
  int own = 0;
  std::set<double> strengths;
  for (int j = 0; j < m.n_joint; ++j) {
    const auto material = m.joint_material[j];
    if (m.stated(material) == material) continue;
    ++own;
    const JointMaterial& law = m.materials[material];
    EXPECT_NEAR(law.mode_1_energy, 30e-6 * law.tensile_strength, 1e-12);
    EXPECT_EQ(m.anatomy.fields[1].of_joint[j], law.tensile_strength);
    strengths.insert(law.tensile_strength);
  }
  EXPECT_EQ(own, m.n_joint);
  EXPECT_EQ(strengths.size(), static_cast<std::size_t>(own));
}

TEST(FieldsInSpace, a_density_field_is_the_mass_of_units) {
  const Model m =
      compile(wall_with("[field.rho]\npath = \"wall.unit.density\"\ncov = 0.2\nby = \"unit\"\n"));
  const Model plain = compile(wall_with(""));
  const DrawnField& rho = m.anatomy.fields.front();
  std::set<double> all;
  for (int i = 0; i < m.n_block; ++i) {
    EXPECT_NEAR(m.mass[i] / plain.mass[i], rho.of_block[i] / 2000, 1e-12);
    EXPECT_NEAR(m.space.inertia[i].y / plain.space.inertia[i].y, rho.of_block[i] / 2000, 1e-12);
    all.insert(rho.of_block[i]);
  }
  EXPECT_GT(all.size(), 10U);
}

TEST(FieldsInSpace, what_cannot_be_is_refused_as_in_the_plane) {
  EXPECT_NE(refusal("[field.ft]\npath = \"material.joint.tensile_strength\"\ncov = 0.25\n")
                .find("field.ft.along"),
            std::string::npos);
  EXPECT_NE(refusal("[field.ft]\npath = \"material.mortar.cohesion\"\ncov = 0.25\nby = \"joint\"\n")
                .find("names no material"),
            std::string::npos);
  EXPECT_NE(refusal("[field.ft]\npath = \"material.joint.tensile_strength\"\ncov = 0.2\nalong = "
                    "\"900 m\"\nacross = \"900 m\"\n")
                .find("all of it has one value"),
            std::string::npos);
  EXPECT_NE(refusal("[field.ft]\npath = \"material.joint.tensile_strength\"\ncov = 0.2\nalong = "
                    "\"5 mm\"\nacross = \"5 mm\"\n")
                .find("joints are independent"),
            std::string::npos);
  // a body of no course
  ModelSpec spec = scenes::in_space({scenes::box("floor", {-1, -0.2, -1}, {2, 0.2, 2}, true),
                                     scenes::box("b", {0, 0, 0}, {0.2, 0.1, 0.1})},
                                    scenes::paper_joint(), 2000);
  spec.stage = {scenes::gravity_stage()};
  spec.field["ft"].path = "material.joint.tensile_strength";
  spec.field["ft"].cov = 0.2;
  spec.field["ft"].by = FieldBy::kCourse;
  EXPECT_THROW(draw_fields(spec), InputError);
  // drawn for another wall
  ModelSpec moved = wall_with(kField);
  for (BodySpec& body : moved.body) body.id += "x";
  EXPECT_THROW((void)compile(moved), InputError);
}

}  // namespace
}  // namespace wythe::fields_in_space_test
