// Random fields: factors against covariances, marginals and correlations against
// closed forms over many seeds, refusals, and the effect of a field on a wall.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "campaign/draws/field_factor.h"
#include "campaign/draws/generator.h"
#include "model/field_places.h"
#include "scenes/scenes.h"
#include "scenes/small_study.h"
#include "wythe/parts/error.h"
#include "wythe/parts/field_notes.h"
#include "wythe/parts/io.h"
#include "wythe/parts/limit.h"
#include "wythe/parts/solve.h"
#include "wythe/parts/study.h"

namespace wythe::random_fields_test {
namespace {

// A wall of 0.8 x 0.8 m in half units of 100 x 100 mm, as in a file.
const std::string kWall = R"(
[wall]
length = "0.8 m"
height = "0.8 m"
thickness = "0.2 m"
[wall.unit]
length = "200 mm"
height = "100 mm"
density = "2000 kg/m^3"
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
[material.unit]
normal_stiffness = "20 GPa/m"
shear_stiffness = "8 GPa/m"
tensile_strength = "0.5 MPa"
cohesion = "0.75 MPa"
friction_angle = "38 deg"
residual_friction_angle = "38 deg"
residual_cohesion = "0 MPa"
mode_1_energy = "20 N/m"
mode_2_energy = "550 N/m"
compressive_strength = "4 MPa"
compressive_energy = "12800 N/m"
[[stage]]
name = "gravity"
[[stage]]
name = "push"
at = { x = "0 m", y = "0.75 m" }
velocity = "4 mm/s"
damping = 0.2
until = "0.2 mm"
)";
const std::string kField = R"([field.ft]
path = "material.joint.tensile_strength"
cov = 0.25
along = "0.4 m"
across = "0.15 m"
)";

ModelSpec wall_with(const std::string& fields, const std::vector<std::string>& settings = {}) {
  return parse_model(kWall + fields, "wall.toml", settings);
}

std::vector<FieldPlace> places_of(const ModelSpec& spec, const std::string& path) {
  FaultList none;
  return field_places(spec, geometry::build_assembly(spec, none), *field_target(path));
}

// The text of what is refused.
std::string refusal(const std::string& fields, const std::vector<std::string>& settings = {}) {
  try {
    (void)compile(wall_with(fields, settings));
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

// --- factors -------------------------------------------------------------------------------------

double greatest_miss(const FieldFactor& f, const std::vector<double>& c) {
  double worst = 0;
  for (std::size_t i = 0; i < f.n; ++i)
    for (std::size_t j = 0; j < f.n; ++j) {
      double sum = 0;
      for (std::size_t k = 0; k < f.rank; ++k) sum += f.at(i, k) * f.at(j, k);
      worst = std::max(worst, std::fabs(sum - c[i * f.n + j]));
    }
  return worst;
}

TEST(field_factor, gives_back_its_covariance_to_rounding) {
  std::vector<double> x;
  for (int i = 0; i < 60; ++i) x.push_back(0.1 * i + 0.013 * (i % 7));
  for (const FieldKernel kernel : {FieldKernel::kExponential, FieldKernel::kSquaredExponential})
    for (const double length : {0.05, 0.5, 5.0, 500.0}) {
      std::vector<double> c;
      for (const double a : x)
        for (const double b : x) c.push_back(correlation_at(kernel, a - b, length));
      const FieldFactor f = factor_of(c, x.size());
      // n rounding errors of 1; where the matrix is singular to rounding its own entries' 1e-13 (real.h)
      const bool singular = kernel == FieldKernel::kSquaredExponential && length > 1;
      EXPECT_LT(greatest_miss(f, c), singular ? 1e-12 : 60 * 4 * 2.3e-16) << length;
      if (singular) {
        EXPECT_LT(f.rank, 30U);
      }
    }
}

// The draw of a grid is linear in w, so unit vectors give the columns of its factor.
TEST(field_factor, a_grid_has_the_covariance_of_its_places) {
  std::vector<double> x, y;
  for (int row = 0; row < 7; ++row)
    for (int column = 0; column < 9; ++column) {
      if ((row * 9 + column) % 5 == 3) continue;  // an opening
      x.push_back(0.155 * column + 0.0775 * (row % 2));
      y.push_back(0.11 * row);
    }
  FieldGrid grid(x, y, 1e-6);
  grid.correlate(FieldKernel::kExponential, 0.7, 0.25);
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
      const double wanted = std::exp(-std::fabs(x[i] - x[j]) / 0.7 - std::fabs(y[i] - y[j]) / 0.25);
      EXPECT_NEAR(sum, wanted, 1e-12);  // exp of core/real.h: 1e-13
    }
}

// --- many walls ----------------------------------------------------------------------------------

// Of `walls` seeds: mean and cov of each place's factor, and the correlation of the logarithms of places.
struct Moments {
  std::vector<std::vector<double>> log_of;  // (n_wall, n_place)
  [[nodiscard]] double mean(std::size_t i) const {
    double sum = 0;
    for (const auto& wall : log_of) sum += wall[i];
    return sum / static_cast<double>(log_of.size());
  }
  [[nodiscard]] double covariance(std::size_t i, std::size_t j) const {
    const double a = mean(i), b = mean(j);
    double sum = 0;
    for (const auto& wall : log_of) sum += (wall[i] - a) * (wall[j] - b);
    return sum / static_cast<double>(log_of.size() - 1);
  }
  [[nodiscard]] double correlation(std::size_t i, std::size_t j) const {
    return covariance(i, j) / std::sqrt(covariance(i, i) * covariance(j, j));
  }
};

Moments moments_of(ModelSpec spec, const std::vector<std::string>& names, int walls) {
  Moments m;
  for (int seed = 0; seed < walls; ++seed) {
    for (auto& [name, field] : spec.field) field.seed = seed;
    draw_fields(spec);
    std::vector<double>& wall = m.log_of.emplace_back();
    for (const std::string& name : names)
      for (const double factor : spec.field.at(name).drawn) wall.push_back(std::log(factor));
  }
  return m;
}

// 1000 walls: an empirical correlation r of true rho has z = atanh(r) with deviation 1/sqrt(997). Of about 120
// tested pairs none may miss by more than 4.5 deviations: significance 120 * 7e-6 < 0.1 %.
constexpr int kWalls = 1000;
void expect_correlation(double found, double wanted, const std::string& what) {
  EXPECT_LT(std::fabs(std::atanh(found) - std::atanh(wanted)), 4.5 / std::sqrt(kWalls - 3.0))
      << what << ": " << found << " against " << wanted;
}

TEST(random_field, has_its_covariance_mean_and_scatter_over_many_walls) {
  const ModelSpec spec = wall_with(kField);
  const auto places = places_of(spec, "material.joint.tensile_strength");
  const Moments m = moments_of(spec, {"ft"}, kWalls);
  const double variance = std::log1p(0.25 * 0.25);
  for (std::size_t i = 0; i < places.size(); i += 17) {
    for (std::size_t j = i + 3; j < places.size(); j += 29) {
      const double rho = std::exp(-std::fabs(places[i].x - places[j].x) / 0.4 -
                                  std::fabs(places[i].y - places[j].y) / 0.15);
      expect_correlation(m.correlation(i, j), rho, "places");
    }
    // log of a lognormal of mean 1: mean -s2/2 with deviation s/sqrt(n), variance s2 within chi-square
    EXPECT_NEAR(m.mean(i), -variance / 2, 4.5 * std::sqrt(variance / kWalls));
    EXPECT_NEAR(m.covariance(i, i) / variance, 1, 4.5 * std::sqrt(2.0 / (kWalls - 1)));
  }
}

TEST(random_field, of_two_tied_fields_have_their_correlation_and_others_none) {
  const std::string other = R"([field.c]
path = "material.joint.cohesion"
cov = 0.3
along = "0.4 m"
across = "0.15 m"
)";
  for (const double tie : {0.6, -0.4, 0.0}) {
    const std::string text =
        tie == 0 ? "" : "correlation = { ft = { gaussian = " + std::to_string(tie) + " } }\n";
    const ModelSpec spec = wall_with(kField + other + text);
    const std::size_t n = spec.field.at("ft").drawn.size();
    const Moments m = moments_of(spec, {"ft", "c"}, kWalls);
    for (std::size_t i = 0; i < n; i += 31) expect_correlation(m.correlation(i, n + i), tie, "tie");
  }
}

TEST(random_field, by_course_unit_and_joint_share_what_they_say) {
  const auto drawn = [](const std::string& by) {
    return wall_with("[field.ft]\npath = \"material.joint.tensile_strength\"\ncov = 0.3\nby = \"" +
                     by + "\"\n");
  };
  for (const std::string by : {"course", "unit", "joint"}) {
    const ModelSpec spec = drawn(by);
    const auto places = places_of(spec, "material.joint.tensile_strength");
    std::map<int, double> of;
    std::map<double, int> seen;
    for (std::size_t p = 0; p < places.size(); ++p) {
      const int label = by == "course" ? places[p].course
                        : by == "unit" ? places[p].unit
                                       : places[p].entity;
      const double value = spec.field.at("ft").drawn[p];
      const auto [known, is_new] = of.try_emplace(label, value);
      EXPECT_EQ(known->second, value);
      if (is_new) ++seen[value];
    }
    for (const auto& [value, times] : seen) EXPECT_EQ(times, 1) << by;
    EXPECT_GT(of.size(), by == "course" ? 6U : by == "unit" ? 25U : 80U) << by;
  }
}

TEST(random_field, a_seed_gives_each_name_a_stream_of_its_own) {
  const std::string c =
      "[field.c]\npath = \"material.joint.cohesion\"\ncov = 0.25\n"
      "along = \"0.4 m\"\nacross = \"0.15 m\"\n";
  const ModelSpec both = wall_with(kField + c), alone = wall_with(kField);
  EXPECT_EQ(both.field.at("ft").drawn, alone.field.at("ft").drawn);
  EXPECT_NE(both.field.at("ft").drawn, both.field.at("c").drawn);
  EXPECT_NE(wall_with(kField, {"field.ft.seed=1"}).field.at("ft").drawn,
            alone.field.at("ft").drawn);
}

// Mean of a marginal cut off on one side or both, over the standard normal; 1 to the search's accuracy.
TEST(random_field, what_is_cut_off_keeps_the_mean_and_the_bounds) {
  for (const char* kind : {"lognormal", "normal", "weibull", "uniform", "triangular"})
    for (const char* bounds : {"lower = 0.6\n", "upper = 1.6\n", "lower = 0.7\nupper = 2\n"}) {
      const ModelSpec spec = wall_with(
          "[field.ft]\npath = \"material.joint.tensile_strength\"\n"
          "cov = 0.4\nby = \"joint\"\ndistribution = \"" +
          std::string(kind) + "\"\n" + bounds);
      const FieldSpec& field = spec.field.at("ft");
      const double low = std::isnan(field.lower) ? -1e9 : field.lower;
      const double high = std::isnan(field.upper) ? 1e9 : field.upper;
      double sum = 0, squares = 0, n = 0;
      ModelSpec again = spec;
      for (int seed = 0; seed < 60; ++seed) {
        again.field.at("ft").seed = seed;
        draw_fields(again);
        for (const double x : again.field.at("ft").drawn) {
          EXPECT_GE(x, low - 1e-12);
          EXPECT_LE(x, high + 1e-12);
          sum += x, squares += x * x, ++n;
        }
      }
      const double mean = sum / n, deviation = std::sqrt(squares / n - mean * mean);
      EXPECT_NEAR(mean, 1, 4.5 * deviation / std::sqrt(n)) << kind << ' ' << bounds;
    }
}

// --- the wall ------------------------------------------------------------------------------------

TEST(random_field, without_scatter_is_the_plain_wall_to_the_bit) {
  const std::string none =
      "[field.ft]\npath = \"material.joint.tensile_strength\"\ncov = 0\n"
      "along = \"0.4 m\"\nacross = \"0.2 m\"\n"
      "[field.rho]\npath = \"wall.unit.density\"\ncov = 0\nby = \"unit\"\n";
  const Model plain = compile(wall_with("")), graded = compile(wall_with(none));
  ASSERT_GT(graded.materials.size(), plain.materials.size() + 50);
  State a = initial_state(plain), b = initial_state(graded);
  const Result one = solve(plain, a, {}), two = solve(graded, b, {});
  EXPECT_EQ(one.state_hash, two.state_hash);
  EXPECT_EQ(one.energy.fracture, two.energy.fracture);
  EXPECT_GT(one.energy.fracture, 0);
}

TEST(random_field, each_joint_has_its_own_strength_and_what_follows_it) {
  const ModelSpec spec = wall_with(
      kField + "[field.GI]\npath = \"material.joint.mode_1_energy\"\nformula = \"30 um * ft\"\n");
  const Model m = compile(spec);
  int own = 0;
  for (int j = 0; j < m.n_joint; ++j) {
    const auto material = m.joint_material[j];
    const std::string& name = m.material_names[material];
    EXPECT_EQ(m.stated(material) != material, name == "joint");
    if (name != "joint") continue;
    ++own;
    const JointMaterial& law = m.materials[material];
    EXPECT_NEAR(law.mode_1_energy, 30e-6 * law.tensile_strength, 1e-12);
    EXPECT_EQ(m.anatomy.fields[1].of_joint[j], law.tensile_strength);
  }
  EXPECT_EQ(m.anatomy.fields[1].name, "ft");
  EXPECT_GT(own, 80);
}

TEST(random_field, a_density_field_is_the_mass_of_units) {
  const Model m =
      compile(wall_with("[field.rho]\npath = \"wall.unit.density\"\ncov = 0.2\nby = \"unit\"\n"));
  const Model plain = compile(wall_with(""));
  const DrawnField& rho = m.anatomy.fields.front();
  double least = 1e9, most = 0;
  for (int i = 0; i < m.n_block; ++i) {
    EXPECT_NEAR(m.mass[i] / plain.mass[i], rho.of_block[i] / 2000, 1e-12);
    least = std::min(least, rho.of_block[i]);
    most = std::max(most, rho.of_block[i]);
  }
  EXPECT_GT(most, 1.2 * least);
}

TEST(random_field, a_written_model_is_drawn_again_the_same) {
  const ModelSpec spec = wall_with(kField, {"field.ft.seed=12"});
  const ModelSpec again = parse_model(write_model(spec), "again.toml");
  EXPECT_EQ(again.field.at("ft").drawn, spec.field.at("ft").drawn);
}

TEST(random_field, a_wall_changed_after_it_was_drawn_is_refused) {
  ModelSpec spec = wall_with(kField);
  spec.wall.length = 1.0;
  EXPECT_THROW((void)compile(spec), InputError);
  draw_fields(spec);
  EXPECT_NO_THROW((void)compile(spec));
}

// --- refused -------------------------------------------------------------------------------------

TEST(random_field, says_what_is_wrong_where_and_what_to_write) {
  const auto expect = [](const std::string& fields, const std::string& words) {
    const std::string said = refusal(fields);
    EXPECT_NE(said.find(words), std::string::npos) << words << "\n" << said;
    EXPECT_NE(said.find("wall.toml:"), std::string::npos) << said;
  };
  const std::string head = "[field.f]\npath = \"material.joint.cohesion\"\ncov = 0.2\n";
  expect(head + "along = \"0 m\"\nacross = \"1 m\"\n", "must be");
  expect(head + "along = \"1 mm\"\nacross = \"1 mm\"\n", "joints are independent");
  expect(head + "along = \"900 m\"\nacross = \"900 m\"\n", "all of it has one value");
  expect(head, "write the correlation length");
  expect(head + "by = \"unit\"\nalong = \"1 m\"\n", "has no meaning beside by");
  expect("[field.f]\npath = \"material.joint.softening\"\ncov = 0.2\nby = \"joint\"\n",
         "has no place in the wall");
  expect("[field.f]\npath = \"wall.length\"\ncov = 0.2\nby = \"joint\"\n", "has no place");
  expect("[field.f]\npath = \"material.jiont.cohesion\"\ncov = 0.2\nby = \"joint\"\n", "joint");
  expect("[field.f]\npath = \"material.joint.residual_cohesion\"\ncov = 0.2\nby = \"joint\"\n",
         "is 0 in the model");
  expect("[field.f]\npath = \"material.joint.cohesion\"\nby = \"joint\"\n", "write e.g. cov");
  expect(head + "by = \"joint\"\ndistribution = \"empirical\"\n", "no distribution of a field");
  expect(head + "by = \"joint\"\nlower = 1.2\n", "leaves out the mean");
  expect(
      kField + "[field.g]\npath = \"material.joint.tensile_strength\"\ncov = 0.1\nby = \"unit\"\n",
      "has a field already");
  expect(kField + head + "by = \"joint\"\ncorrelation.ft.gaussian = 0.5\n",
         "do not vary over the same lengths");
  expect(head + "by = \"joint\"\ncorrelation.nil.gaussian = 0.5\n", "names no field");
  expect("[field.f]\npath = \"material.joint.cohesion\"\nformula = \"2 * cov\"\n", "there is no");
  expect(kField + "[field.g]\npath = \"material.joint.mode_1_energy\"\nformula = \"2 * ft\"\n",
         "but material.joint.mode_1_energy is in N/m");
}

TEST(random_field, names_the_nearest_correlations_that_are_positive_definite) {
  const auto field = [](const char* name, const char* key, const std::string& tied) {
    return std::string("[field.") + name + "]\npath = \"material.joint." + key +
           "\"\ncov = 0.1\nby = \"joint\"\n" + tied;
  };
  const std::string said = refusal(
      field("a", "cohesion", "correlation.b.gaussian = 0.9\ncorrelation.c.gaussian = 0.9\n") +
      field("b", "tensile_strength", "correlation.c.gaussian = -0.9\n") +
      field("c", "mode_2_energy", ""));
  EXPECT_NE(said.find("not positive definite"), std::string::npos) << said;
  EXPECT_NE(said.find("a and b gaussian = 0."), std::string::npos) << said;
}

TEST(random_field, snap_back_of_one_joint_is_told_with_its_place) {
  const std::string said =
      refusal("[field.ft]\npath = \"material.joint.tensile_strength\"\ncov = 3\nby = \"joint\"\n");
  EXPECT_NE(said.find("material.joint.mode_1_energy"), std::string::npos) << said;
  EXPECT_NE(said.find("at the joint at x = "), std::string::npos) << said;
  EXPECT_NE(said.find("formula"), std::string::npos) << said;
}

// --- other readers -------------------------------------------------------------------------------

// All joints but one strong: the limit load is that of its own friction, not of the mean.
TEST(random_field, the_limit_load_reads_each_joint) {
  const std::string phi =
      "[field.phi]\npath = \"material.joint.friction_angle\"\ncov = 0.2\n"
      "by = \"course\"\nupper = 1.5\n"
      "[field.res]\npath = \"material.joint.residual_friction_angle\"\n"
      "formula = \"0.8 * phi\"\n";
  const auto factor = [&](int seed) {
    const std::string text = std::to_string(seed);
    return limit_load(compile(wall_with(phi, {"field.phi.seed=" + text})), {}, {}).load;
  };
  EXPECT_NE(factor(1), factor(2));
}

TEST(random_field, what_a_cut_leaves_of_its_scatter_is_told) {
  const std::string normal =
      "[field.ft]\npath = \"material.joint.tensile_strength\"\nby = \"joint\"\n"
      "distribution = \"normal\"\ncov = 0.25\n";
  const auto cov = [&](const std::string& more) {
    return cov_of(wall_with(normal + more).field.at("ft"));
  };
  EXPECT_EQ(cov(""), 0.25);
  // cut at one deviation on both sides: closed form, 1 - 2 phi(1) / (2 Phi(1) - 1)
  const double density = std::exp(-0.5) / std::sqrt(2 * 3.14159265358979),
               inside = std::erf(std::sqrt(0.5));
  EXPECT_NEAR(cov("lower = 0.75\nupper = 1.25\n"), 0.25 * std::sqrt(1 - 2 * density / inside),
              1e-4);
  const auto notes = [&](const std::string& more) {
    return texts_of(notes_of_fields(wall_with(normal + more)));
  };
  EXPECT_TRUE(notes("").empty());
  EXPECT_TRUE(notes("lower = 0.01\nupper = 1.99\n").empty());  // 4 deviations: nothing that counts
  EXPECT_EQ(
      notes("lower = 0.75\nupper = 1.25\n").at(0),
      "field ft: its bounds leave a scatter (CoV) of 13.5 %; the 25.0 % of the file are of the "
      "distribution before it is cut");
}

// --- studies -------------------------------------------------------------------------------------

const std::string kStudyField =
    "[field.ft]\ncov = 0.2\nalong = \"0.5 m\"\nacross = \"0.2 m\"\nupper = 2\n";

StudySpec study_with_fields(int samples) {
  return parse_study(write_study(scenes::small_study(samples)) + kStudyField, "small_study.toml");
}

TEST(random_field, of_a_study_takes_its_mean_from_the_variable_and_dependents_follow) {
  const StudySpec study = study_with_fields(6);
  ASSERT_EQ(study.field.size(), 1U);
  EXPECT_EQ(study.field.front().path, "material.joint.tensile_strength");
  const SampleTable samples = draw_samples(study);
  const ModelBuilder build = model_builder(study);
  for (int i = 0; i < 6; ++i) {
    const Model m = compile(build(settings_of(samples, i)));
    double sum = 0;
    int n = 0;
    for (int j = 0; j < m.n_joint; ++j) {
      const auto material = m.joint_material[j];
      if (m.material_names[material] != "joint") continue;
      const JointMaterial& law = m.materials[material];
      EXPECT_NEAR(law.cohesion, 1.5 * law.tensile_strength, 1e-9 * law.cohesion);
      sum += law.tensile_strength, ++n;
    }
    const double mean = samples.value[i][0];
    EXPECT_NEAR(sum / n, mean, 0.25 * mean);  // one correlated wall
    EXPECT_EQ(m.materials[m.stated(m.joint_material[0])].tensile_strength, mean);
  }
}

TEST(random_field, sample_i_is_the_same_for_any_number_of_samples) {
  const StudySpec few = study_with_fields(4), many = study_with_fields(9);
  const SampleTable a = draw_samples(few), b = draw_samples(many);
  for (int i = 0; i < 4; ++i) EXPECT_EQ(a.more_setting[i][0], b.more_setting[i][0]);
  std::vector<std::string> seeds;
  for (const auto& settings : b.more_setting) seeds.push_back(settings[0]);
  std::sort(seeds.begin(), seeds.end());
  EXPECT_EQ(std::unique(seeds.begin(), seeds.end()), seeds.end());
}

TEST(random_field, a_study_written_and_read_again_has_its_fields) {
  const StudySpec study = study_with_fields(3);
  const StudySpec again = parse_study(write_study(study), "again.toml");
  EXPECT_EQ(draw_samples(again).more_setting, draw_samples(study).more_setting);
}

TEST(random_field, of_a_study_is_refused_at_its_line) {
  const std::string text = write_study(scenes::small_study(3));
  const auto said = [&](const std::string& field) -> std::string {
    try {
      (void)parse_study(text + field, "small_study.toml");
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_NE(said("[field.ft]\ncov = 0.2\n").find("small_study.toml:"), std::string::npos)
      << said("[field.ft]\ncov = 0.2\n");
  EXPECT_NE(said("[field.ft]\npath = \"material.joint.cohesion\"\ncov = 0.2\nby = \"joint\"\n")
                .find("is not what variable.ft sets"),
            std::string::npos);
  EXPECT_NE(said("[field.ft]\ncov = 0.2\nby = \"joint\"\nlong = 3\n").find("no such key"),
            std::string::npos);
}

const std::string kFollows =
    "[field.c2]\npath = \"material.joint.cohesion\"\nformula = \"1.33 * ft\"\n";

TEST(random_field, what_a_formula_sets_anew_is_neither_a_variable_nor_a_setting) {
  const std::string text = "[study]\nname = \"s\"\nmodel = \"m.toml\"\nmodel_text = '''\n" + kWall +
                           kField + kFollows + "'''\nsamples = 3\nseed = 7\n";
  const std::string other =
      "[variable.phi]\npath = \"material.joint.friction_angle\"\ndistribution = \"normal\"\n"
      "mean = \"30 deg\"\ncov = 0.1\n";
  const auto said = [&](const std::string& more,
                        const std::vector<std::string>& settings = {}) -> std::string {
    try {
      (void)parse_study(text + more, "study.toml", settings);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  const std::string words = "has no effect, it is set by field.c2.formula";
  EXPECT_EQ(said(other), "");
  for (const std::string& refused :
       {said("[variable.coh]\npath = \"material.joint.cohesion\"\ndistribution = \"normal\"\n"
             "mean = \"0.45 MPa\"\ncov = 0.1\n"),
        said(other + "[dependent.coh]\npath = \"material.joint.cohesion\"\n"
                     "formula = \"0.45 MPa * phi / 30 deg\"\n"),
        said(other +
             "[[variant]]\nname = \"strong\"\nset = [\"material.joint.cohesion=0.9 MPa\"]\n")}) {
    EXPECT_NE(refused.find(words), std::string::npos) << refused;
    EXPECT_NE(refused.find("study.toml:"), std::string::npos) << refused;
  }
  EXPECT_NE(said(other, {"material.joint.cohesion=0.9 MPa"}).find(words), std::string::npos);
  // the model alone
  EXPECT_NE(refusal(kField + kFollows, {"material.joint.cohesion=0.9 MPa"}).find(words),
            std::string::npos);
  EXPECT_EQ(refusal(kField + kFollows, {"material.joint.tensile_strength=0.1 MPa"}), "");
  // a whole table that holds the key
  const std::string in_table = "its cohesion " + words;
  std::string joint = kWall.substr(kWall.find("[material.joint]") + 17);
  joint.resize(joint.find("\n["));
  std::replace(joint.begin(), joint.end(), '\n', ',');
  const std::string table = "material.joint={" + joint + "}";
  EXPECT_EQ(refusal(kField, {table}), "");
  EXPECT_NE(refusal(kField + kFollows, {table}).find(in_table), std::string::npos);
  const std::string own = "field.c2={path=\"material.joint.cohesion\", formula=\"1.5 * ft\"}";
  EXPECT_EQ(refusal(kField + kFollows, {table, own}), "");  // as a sample gives it
  const std::string option =
      said(other + "[[variant]]\nname = \"strong\"\nset = ['''" + table + "''']\n");
  for (const char* part : {"variant \"strong\": ", in_table.c_str(), "study.toml:"})
    EXPECT_NE(option.find(part), std::string::npos) << option;
}

TEST(random_field, a_seed_that_each_sample_sets_is_no_setting) {
  const std::string text = write_study(scenes::small_study(3));
  for (const std::string& more :
       {kStudyField + "seed = 7\n",
        kStudyField + "[[variant]]\nname = \"other\"\nset = [\"field.ft.seed=7\"]\n"}) {
    try {
      (void)parse_study(text + more, "small_study.toml");
      ADD_FAILURE() << more;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find("has no effect, it is set by study.seed"),
                std::string::npos)
          << error.what();
    }
  }
}

TEST(random_field, a_distribution_that_is_none_is_refused_in_words_at_its_place) {
  const std::string head =
      "[field.ft]\npath = \"material.joint.tensile_strength\"\nby = \"joint\"\n";
  const std::string beta = head + "distribution = \"beta\"\nlow = 0.4\nhigh = 2\n";
  for (const std::string& field :
       {beta + "cov = 0.7\nupper = 1.3\n", beta + "cov = 0.3\nupper = 1.02\n",
        head + "cov = 1e200\n", head + "cov = 30\n",
        head + "cov = 1e200\ndistribution = \"weibull\"\n",
        head + "cov = 9\ndistribution = \"weibull\"\nupper = 1.01\n"}) {
    const std::string said = refusal(field);
    EXPECT_NE(said.find("wall.toml:"), std::string::npos) << field << said;
    EXPECT_NE(said.find("field.ft."), std::string::npos) << field << said;
    EXPECT_EQ(said.find("MUST"), std::string::npos) << said;
    EXPECT_EQ(said.find("boost"), std::string::npos) << said;
  }
}

}  // namespace
}  // namespace wythe::random_fields_test
