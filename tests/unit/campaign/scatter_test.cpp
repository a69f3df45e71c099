// [scatter] of a model: the fields that it creates, and the properties that follow them.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <map>
#include <numeric>
#include <utility>

#include "geometry/assembly.h"
#include "model/field_places.h"
#include "scenes/scenes.h"
#include "scenes/small_study.h"
#include "wythe/parts/contact_law.h"
#include "wythe/parts/error.h"
#include "wythe/parts/field_notes.h"
#include "wythe/parts/io.h"
#include "wythe/parts/study.h"
#include "wythe/parts/verdict.h"

namespace wythe::scatter_test {
namespace {

// A wall of 5 x 5 m in brick, whose units may crack.
ModelSpec wall_of(const std::string& scatter, const std::vector<std::string>& settings = {}) {
  const std::string text = R"(
[wall]
length = "5 m"
height = "5 m"
thickness = "0.25 m"
[wall.unit]
length = "250 mm"
height = "62.5 mm"
split = "at_joints"
density = "1800 kg/m^3"
[material.joint]
normal_stiffness = "60 GPa/m"
shear_stiffness = "24 GPa/m"
tensile_strength = "0.25 MPa"
cohesion = "0.35 MPa"
friction_angle = "35 deg"
residual_friction_angle = "30 deg"
residual_cohesion = "0.05 MPa"
mode_1_energy = "1 N/m"
mode_2_energy = "40 N/m"
compressive_strength = "8 MPa"
compressive_energy = "12000 N/m"
[material.unit]
normal_stiffness = "60 GPa/m"
shear_stiffness = "24 GPa/m"
tensile_strength = "2 MPa"
cohesion = "2.8 MPa"
friction_angle = "45 deg"
residual_friction_angle = "45 deg"
residual_cohesion = "0 MPa"
mode_1_energy = "60 N/m"
mode_2_energy = "300 N/m"
compressive_strength = "20 MPa"
compressive_energy = "30000 N/m"
[[stage]]
name = "gravity"
)";
  return parse_model(text + scatter, "wall.toml", settings);
}

struct Spread {
  double mean = 0, cov = 0, least = 1e300, most = 0;
};
Spread spread_of(const std::vector<double>& values) {
  Spread s;
  const double n = static_cast<double>(values.size());
  s.mean = std::accumulate(values.begin(), values.end(), 0.0) / n;
  double squares = 0;
  for (const double v : values) {
    squares += (v - s.mean) * (v - s.mean);
    s.least = std::min(s.least, v), s.most = std::max(s.most, v);
  }
  s.cov = std::sqrt(squares / (n - 1)) / s.mean;
  return s;
}

TEST(Scatter, a_kind_of_masonry_gives_its_scatter) {
  const ModelSpec spec = wall_of("[scatter]\nuse = \"clay_brick\"\n");
  // some 1600 units: a CoV of 0.30 is met within 2.2 % of itself (one standard deviation), a mean within 0.8 %
  const Spread ft = spread_of(spec.field.at("scatter_joint_tensile_strength").drawn);
  EXPECT_NEAR(ft.cov, 0.30, 0.03);
  EXPECT_NEAR(ft.mean, 1, 0.03);
  EXPECT_NEAR(spread_of(spec.field.at("scatter_joint_cohesion").drawn).cov, 0.25, 0.03);
  EXPECT_NEAR(spread_of(spec.field.at("scatter_unit_tensile_strength").drawn).cov, 0.20, 0.03);
  EXPECT_EQ(spec.field.at("scatter_joint_tensile_strength").distribution,
            DistributionKind::kWeibull);
}

TEST(Scatter, numbers_take_the_place_of_a_kind) {
  const ModelSpec spec = wall_of("[scatter]\njoint_tension = 0.5\nby = \"joint\"\n");
  EXPECT_NEAR(spread_of(spec.field.at("scatter_joint_tensile_strength").drawn).cov, 0.5, 0.05);
  EXPECT_FALSE(spec.field.contains("scatter_joint_cohesion"));
  EXPECT_FALSE(spec.field.contains("scatter_unit_tensile_strength"));
}

// The joint's GI of 1 N/m stands at 1.9 times the least that its mean strength allows, so a joint of twice the strength
// would snap back if GI only grew with ft; the units' at 1.8.
TEST(Scatter, no_draw_is_refused_for_snap_back) {
  for (int seed = 0; seed < 20; ++seed) {
    const ModelSpec spec = wall_of(
        "[scatter]\nuse = \"stone\"\njoint_tension = 0.6\nseed = " + std::to_string(seed) + "\n");
    EXPECT_NO_THROW(static_cast<void>(compile(spec))) << seed;
    EXPECT_GT(spread_of(spec.field.at("scatter_joint_tensile_strength").drawn).most, 2) << seed;
  }
}

// GII is stated far below what snap-back asks for at fc, which b gives; twice the cohesion asks for four times as much
// without pressure too.
TEST(Scatter, no_draw_is_refused_where_energy_grows_with_pressure) {
  const std::vector<std::string> rising = {"material.joint.friction_angle=50 deg",
                                           "material.joint.mode_2_energy=3.5 N/m",
                                           "material.joint.mode_2_energy_per_pressure=0.1 mm"};
  for (int seed = 0; seed < 20; ++seed) {
    const ModelSpec spec = wall_of(
        "[scatter]\nuse = \"stone\"\njoint_cohesion = 0.6\nseed = " + std::to_string(seed) + "\n",
        rising);
    EXPECT_NO_THROW(static_cast<void>(compile(spec))) << seed;
    const auto& c = spec.field.at("scatter_joint_cohesion").drawn;
    const auto& g2 = spec.field.at("scatter_joint_mode_2_energy").drawn;
    EXPECT_GT(spread_of(c).most, 2) << seed;
    for (std::size_t i = 0; i < c.size(); ++i) {
      if (c[i] < 1) {
        EXPECT_NEAR(g2[i], 3.5 * c[i], 1e-9) << seed;
      }
    }
  }
}

TEST(Scatter, energies_and_residuals_follow_their_strengths) {
  const ModelSpec spec =
      wall_of("[scatter]\nuse = \"clay_brick\"\n",
              {"material.joint.mode_1_energy=20 N/m", "material.joint.mode_2_energy=400 N/m"});
  const auto& ft = spec.field.at("scatter_joint_tensile_strength").drawn;
  const auto& c = spec.field.at("scatter_joint_cohesion").drawn;
  const auto& g1 = spec.field.at("scatter_joint_mode_1_energy").drawn;
  const auto& g2 = spec.field.at("scatter_joint_mode_2_energy").drawn;
  const auto& kept = spec.field.at("scatter_joint_residual_cohesion").drawn;
  ASSERT_EQ(g1.size(), ft.size());
  for (std::size_t i = 0; i < ft.size(); ++i) {
    EXPECT_NEAR(g1[i], 20 * ft[i], 1e-9 * g1[i]);
    EXPECT_NEAR(g2[i], 400 * c[i], 1e-9 * g2[i]);
    EXPECT_NEAR(kept[i], 0.05e6 * c[i], 1e-9 * kept[i]);
  }
}

TEST(Scatter, walls_of_another_seed_differ_and_the_same_is_the_same) {
  const auto drawn = [](int seed) {
    return wall_of("[scatter]\nuse = \"tuff\"\nseed = " + std::to_string(seed) + "\n")
        .field.at("scatter_joint_cohesion")
        .drawn;
  };
  EXPECT_EQ(drawn(1), drawn(1));
  EXPECT_NE(drawn(1), drawn(2));
}

// The share of common places that have the same factor in both walls.
double share_alike(const ModelSpec& a, const ModelSpec& b, const std::string& field) {
  const auto factors = [&](const ModelSpec& spec) {
    FaultList faults;
    const geometry::Assembly assembly = geometry::build_assembly(spec, faults);
    const FieldSpec& drawn = spec.field.at(field);
    std::map<std::pair<long, long>, double> out;
    std::size_t k = 0;
    for (const FieldPlace& p : field_places(spec, assembly, *field_target(drawn.path)))
      out[{std::lround(1e5 * p.x), std::lround(1e5 * p.y)}] = drawn.drawn[k++];
    return out;
  };
  const auto in_a = factors(a), in_b = factors(b);
  double common = 0, alike = 0;
  for (const auto& [place, factor] : in_a)
    if (const auto found = in_b.find(place); found != in_b.end())
      ++common, alike += factor == found->second ? 1 : 0;
  return alike / common;
}

TEST(Scatter, drawn_in_place_a_wall_with_an_opening_has_the_same_units_elsewhere) {
  const std::string use = "[scatter]\nuse = \"clay_brick\"\nseed = 5\n";
  const std::string door =
      "[[wall.opening]]\nname = \"door\"\nx = \"2 m\"\ny = \"0 m\"\nwidth = \"1 m\"\n"
      "height = \"2 m\"\n";
  std::vector<std::string> in_place;
  for (const char* key : {"joint_tensile_strength", "joint_cohesion", "unit_tensile_strength"})
    in_place.push_back(std::string("field.scatter_") + key + ".in_place=true");
  const ModelSpec before = wall_of(use, in_place), after = wall_of(use + door, in_place);
  for (const char* field : {"scatter_joint_tensile_strength", "scatter_joint_cohesion",
                            "scatter_unit_tensile_strength"}) {
    EXPECT_GT(share_alike(before, after, field), 0.97) << field;  // but at the edge of the door
    EXPECT_LT(share_alike(wall_of(use), wall_of(use + door), field), 0.2) << field;
  }
  const Spread joint = spread_of(before.field.at("scatter_joint_tensile_strength").drawn);
  EXPECT_NEAR(joint.mean, 1, 0.03);
  EXPECT_NEAR(joint.cov, 0.30, 0.02);
  // the two strengths of a joint stay tied (Spearman's would be 0.68)
  const std::vector<double>& ft = before.field.at("scatter_joint_tensile_strength").drawn;
  const std::vector<double>& c = before.field.at("scatter_joint_cohesion").drawn;
  const Spread cohesion = spread_of(c);
  double product = 0;
  for (std::size_t k = 0; k < c.size(); ++k)
    product += (ft[k] - joint.mean) * (c[k] - cohesion.mean);
  const double n = static_cast<double>(c.size());
  EXPECT_NEAR(product / n / (joint.cov * joint.mean * cohesion.cov * cohesion.mean), 0.68, 0.06);
}

TEST(Scatter, a_field_of_the_model_itself_holds) {
  const ModelSpec spec = wall_of(
      "[scatter]\nuse = \"clay_brick\"\n[field.own]\npath = "
      "\"material.joint.tensile_strength\"\ncov = 0.1\nby = \"joint\"\n");
  EXPECT_FALSE(spec.field.contains("scatter_joint_tensile_strength"));
  EXPECT_NEAR(spread_of(spec.field.at("own").drawn).cov, 0.1, 0.01);
}

// A property that would follow a strength keeps its mean if that strength has a field of another name, and a note says so.
TEST(Scatter, what_does_not_follow_a_field_of_the_model_is_told) {
  const auto notes = [](const std::string& scatter, const std::string& name, const std::string& key,
                        const std::string& more = "cov = 0.1\nby = \"joint\"\n") {
    return texts_of(notes_of_fields(wall_of("[scatter]\n" + scatter + "\n[field." + name +
                                            "]\npath = \"material." + key + "\"\n" + more)));
  };
  using Texts = std::vector<std::string>;
  const std::string use = "use = \"clay_brick\"";
  const auto told = [](const std::string& field, const std::string& keys, const std::string& name) {
    return Texts{
        "field " + field +
        " takes the place of that of [scatter], so these keep their means and do not follow it: " +
        keys + ". Call it field." + name +
        " without a formula, and they follow; or give them formulas"};
  };
  EXPECT_EQ(notes(use, "own", "joint.tensile_strength"),
            told("own", "material.joint.mode_1_energy", "scatter_joint_tensile_strength"));
  EXPECT_EQ(notes(use, "own", "joint.cohesion"),
            told("own", "material.joint.mode_2_energy, material.joint.residual_cohesion",
                 "scatter_joint_cohesion"));
  EXPECT_EQ(notes(use, "own", "unit.tensile_strength"),
            told("own",
                 "material.unit.mode_1_energy, material.unit.cohesion, material.unit.mode_2_energy",
                 "scatter_unit_tensile_strength"));
  const Texts none;
  EXPECT_EQ(notes(use, "scatter_joint_tensile_strength", "joint.tensile_strength", "cov = 0.1\n"),
            none);
  EXPECT_EQ(notes(use, "own", "joint.friction_angle"), none);
  EXPECT_EQ(notes("joint_tension = 0.3", "own", "joint.cohesion"), none);  // in no one's place
  EXPECT_EQ(notes(use, "own", "joint.tensile_strength",
                  "cov = 0.1\nby = \"joint\"\n[field.gi]\npath = "
                  "\"material.joint.mode_1_energy\"\nformula = "
                  "\"4e-6 m * own\"\n"),
            none);
}

TEST(Scatter, one_change_of_its_own_field_holds) {
  const char* kUse = "[scatter]\nuse = \"clay_brick\"\n";
  const auto field = [&](const std::string& key, const std::string& change) {
    return wall_of(kUse + ("[field.scatter_joint_" + key + "]\n" + change + "\n"))
        .field.at("scatter_joint_" + key);
  };
  const FieldSpec wider = field("tensile_strength", "cov = 0.45");
  EXPECT_EQ(wider.cov, 0.45);
  EXPECT_EQ(wider.by, FieldBy::kUnit);
  const FieldSpec tied = field("tensile_strength", "formula = \"0.7 * scatter_joint_cohesion\"");
  EXPECT_EQ(tied.formula, "0.7 * scatter_joint_cohesion");
  EXPECT_TRUE(std::isnan(tied.cov));
  const FieldSpec free = field("mode_1_energy", "cov = 0.05\nby = \"joint\"");
  EXPECT_EQ(free.formula, "");
}

TEST(Scatter, what_is_written_reads_back_as_the_same_wall) {
  const ModelSpec spec = wall_of("[scatter]\nuse = \"clay_brick\"\nseed = 3\n");
  const ModelSpec again = parse_model(write_model(spec), "again.toml");
  ASSERT_EQ(again.field.size(), spec.field.size());
  for (const auto& [name, field] : spec.field)
    EXPECT_EQ(again.field.at(name).drawn, field.drawn) << name;
}

// Forty walls whose mean strengths scatter by `cov`: how many have a factor above 2, and the first refusal.
struct Means {
  int strong = 0;
  std::string refusal;
};
std::string assessed_wall(const scenes::TemporaryFolder& folder,
                          const std::vector<std::string>& settings, const std::string& more = "") {
  std::vector<std::string> all = {"wall.length=0.5 m", "wall.height=0.25 m"};
  all.insert(all.end(), settings.begin(), settings.end());
  ModelSpec spec = wall_of("[scatter]\nuse = \"stone\"\n", all);
  spec.field.clear();
  std::ofstream(folder / "model.toml") << write_model(spec) << R"([assessment]
code = "circolare_2019"
[assessment.spectrum]
kind = "ntc2018"
ground_acceleration = "1.5 m/s^2"
amplification = 2.5
corner_period = "0.30 s"
[[stage]]
name = "push"
at = { x = "0 m", y = "0.2 m" }
velocity = "1 mm/s"
until = "1 mm"
)" << more;
  return folder / "model.toml";
}
Means walls_between(double cov, const std::vector<std::string>& settings) {
  const scenes::TemporaryFolder folder;
  const StudySpec study =
      assess_study({.model_file = assessed_wall(folder, settings), .walls = 40, .between = cov});
  const SampleTable samples = draw_samples(study);
  Means out;
  for (int i = 0; i < samples.n_sample(); ++i) {
    out.strong += samples.value[i].front() > 2 ? 1 : 0;
    const std::vector<Fault> why = refusal_of(samples, i, model_builder(study));
    if (out.refusal.empty()) out.refusal = in_one_line(why);
  }
  return out;
}

// Energies stand at 1.1 to 1.9 times the least that their mean strengths allow: tension, shear with and without what it
// gains by pressure, crushing with and without a cap and hardening.
TEST(Scatter, no_wall_is_refused_for_its_mean_strength) {
  for (const std::vector<std::string>& settings : std::vector<std::vector<std::string>>{
           {},
           {"material.joint.friction_angle=50 deg", "material.joint.mode_2_energy=3.5 N/m",
            "material.joint.mode_2_energy_per_pressure=0.1 mm"},
           {"material.joint.compressive_strength=unlimited", "material.joint.mode_2_energy=60 N/m"},
           {"material.joint.compressive_energy=600 N/m",
            "material.unit.compressive_energy=4000 N/m"},
           {"material.unit.compression_cap=2", "material.unit.hardening_displacement=0.5 mm",
            "material.unit.compressive_energy=13000 N/m"},
           {"material.joint.softening=exponential", "material.joint.mode_1_energy=1.2 N/m",
            "material.joint.mode_2_energy=80 N/m"}}) {
    const Means walls = walls_between(0.6, settings);
    EXPECT_GT(walls.strong, 0);
    EXPECT_EQ(walls.refusal, "") << (settings.empty() ? "" : settings.front());
  }
}

constexpr const char* kByRules = R"(
[wall]
length = "0.6 m"
height = "0.34 m"
thickness = "0.25 m"
[wall.unit]
length = "290 mm"
height = "75 mm"
density = "1750 kg/m^3"
mortar = { bed = "10 mm", head = "10 mm" }
[masonry]
use = "clay_brick_old"
vertical_stress = "0.2 MPa"
shear_modulus = "rule"
unit_youngs_modulus = "rule"
[material.joint]
missing = "rule"
[material.unit]
missing = "rule"
[scatter]
use = "clay_brick"
[assessment]
code = "circolare_2019"
[assessment.spectrum]
kind = "ntc2018"
ground_acceleration = "1.5 m/s^2"
amplification = 2.5
corner_period = "0.30 s"
[[stage]]
name = "gravity"
[[stage]]
name = "push"
at = { x = "0 m", y = "0.2 m" }
velocity = "1 mm/s"
until = "1 mm"
)";

// A rule reads other keys of its table, and some rules stand back where one of them is given: a wall of mean strength is
// the model for all that.
TEST(Scatter, a_wall_of_mean_strength_is_the_model_by_rules_too) {
  const scenes::TemporaryFolder folder;
  std::ofstream(folder / "model.toml") << kByRules;
  const StudySpec study =
      assess_study({.model_file = folder / "model.toml", .walls = 3, .between = 1e-9});
  const ModelSpec model = model_builder(study)({});
  const ModelSpec wall = model_builder(study)(settings_of(draw_samples(study), 2));
  EXPECT_GT(model.material.at("joint").mode_2_energy_per_pressure, 0);
  for (const char* name : {"joint", "unit"})
    for (const FieldKey& key : field_keys()) {
      const double mean = model.material.at(name).*key.value;
      if (!std::isfinite(mean)) continue;
      EXPECT_NEAR(wall.material.at(name).*key.value, mean, 1e-6 * mean) << name << "." << key.name;
    }
}

// [scatter] and the factor of a wall use the model's values, with its settings, but not values set by a formula.
TEST(Scatter, settings_of_what_scatters_are_its_means) {
  const scenes::TemporaryFolder folder;
  const std::vector<std::string> settings = {"material.joint.tensile_strength=0.5 MPa",
                                             "material.joint.mode_1_energy=12 N/m"};
  for (const double between : {kUnset, 0.2}) {
    const StudySpec study = assess_study({.model_file = assessed_wall(folder, {}),
                                          .overrides = settings,
                                          .walls = 2,
                                          .between = between});
    const SampleTable samples = draw_samples(study);
    const ModelSpec wall = model_builder(study)(settings_of(samples, 0));
    const double factor = std::isnan(between) ? 1 : samples.value.front().front();
    const JointMaterial& joint = wall.material.at("joint");
    EXPECT_NEAR(joint.tensile_strength, factor * 0.5e6, 1e-3);
    EXPECT_NEAR(joint.mode_1_energy, factor * 12, 1e-9);
    const auto& ft = wall.field.at("scatter_joint_tensile_strength").drawn;
    const auto& g1 = wall.field.at("scatter_joint_mode_1_energy").drawn;
    for (std::size_t i = 0; i < ft.size(); ++i) EXPECT_NEAR(g1[i], factor * 12 * ft[i], 1e-9);
  }
  const std::string own = assessed_wall(
      folder, {}, "[field.own]\npath = \"material.joint.mode_1_energy\"\nformula = \"4 N/m\"\n");
  EXPECT_THROW(
      static_cast<void>(assess_study({.model_file = own, .overrides = settings, .walls = 2})),
      InputError);
}

std::string fault_of(const std::string& scatter, const std::vector<std::string>& settings = {}) {
  try {
    static_cast<void>(wall_of(scatter, settings));
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(Scatter, bad_input_is_named_and_cured) {
  const std::string kind = fault_of("[scatter]\nuse = \"clay_bricks\"\n");
  EXPECT_NE(kind.find("scatter.use"), std::string::npos) << kind;
  EXPECT_NE(kind.find("clay_brick"), std::string::npos) << kind;
  EXPECT_NE(fault_of("[scatter]\nuse = \"tuff\"\nby = \"place\"\n").find("scatter.by"),
            std::string::npos);
  EXPECT_NE(fault_of("[scatter]\njoint_tension = -0.1\n").find("joint_tension"), std::string::npos);
  // dry joints that cannot crack, and units without planes: nothing scatters
  const std::string nothing =
      fault_of("[scatter]\nuse = \"stone\"\n",
               {"material.joint.tensile_strength=0 MPa", "material.joint.cohesion=0 MPa",
                "material.joint.residual_cohesion=0 MPa", "wall.unit.split=none"});
  EXPECT_NE(nothing.find("changes nothing"), std::string::npos) << nothing;
}

}  // namespace
}  // namespace wythe::scatter_test
