// A key without effect is refused or noted with the reason: each input has an effect, or the user is told that it has none.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "wythe/parts/error.h"
#include "wythe/parts/io.h"
#include "wythe/parts/message.h"
#include "wythe/parts/model.h"

namespace wythe::idle_keys_test {
namespace {

const std::string kWall = R"(
[wall]
length = "1.2 m"
height = "1.2 m"
thickness = "0.2 m"
unit = { length = "200 mm", height = "100 mm", density = "1800 kg/m^3" }
beam = { height = "100 mm" }
[material.joint]
normal_stiffness = "20 GPa/m"
shear_stiffness = "8 GPa/m"
tensile_strength = "0 MPa"
cohesion = "0 MPa"
residual_cohesion = "0 MPa"
friction_angle = "30 deg"
residual_friction_angle = "30 deg"
compressive_strength = "unlimited"
[material.unit]
normal_stiffness = "20 GPa/m"
shear_stiffness = "8 GPa/m"
tensile_strength = "0 MPa"
cohesion = "0 MPa"
residual_cohesion = "0 MPa"
friction_angle = "30 deg"
residual_friction_angle = "30 deg"
compressive_strength = "unlimited"
[[stage]]
name = "gravity"
)";

std::string shaken(const std::string& record, const std::string& more = "") {
  return kWall + "[[stage]]\nname = \"quake\"\nrecord = { " + record + " }\n" + more;
}
std::string pushed(const std::string& keys) {
  return kWall + "[[stage]]\nname = \"push\"\nat = { beam = true }\n" + keys;
}

std::string refusal(const std::string& text) {
  try {
    (void)compile(parse_model(text, "model.toml"));
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

std::vector<std::string> notes(const std::string& text) {
  const Model model = compile(parse_model(text, "model.toml"));
  std::vector<std::string> out;
  for (const Message& note : model.anatomy.notes) out.push_back(text_of(note));
  return out;
}

void expect_refused(const std::string& text, const std::vector<std::string>& words) {
  const std::string said = refusal(text);
  EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 0) << said;
  for (const std::string& word : words)
    EXPECT_NE(said.find(word), std::string::npos) << word << "\n" << said;
}

void expect_noted(const std::string& text, const std::string& words) {
  const std::vector<std::string> all = notes(text);
  EXPECT_TRUE(std::any_of(all.begin(), all.end(), [&](const std::string& note) {
    return note.find(words) != std::string::npos;
  })) << words;
}
void expect_not_noted(const std::string& text, const std::string& words) {
  for (const std::string& note : notes(text))
    EXPECT_EQ(note.find(words), std::string::npos) << note;
}

const std::string kList = "accelerations = [0, 0.1, 0, -0.1, 0], unit = \"g\"";
const std::string kPulse = "pulse = \"cycle\", amplitude = \"1 m/s^2\", period = \"0.1 s\"";

TEST(IdleKeys, of_a_record_belong_to_one_way_of_giving_it) {
  EXPECT_EQ(refusal(shaken(kList + ", step = \"0.02 s\"")), "");
  EXPECT_EQ(refusal(shaken(kList + ", times = [0, 0.02, 0.04, 0.06, 0.08]")), "");
  EXPECT_EQ(refusal(shaken(kPulse)), "");
  expect_refused(shaken(kList + ", step = \"0.1 s\", times = [0, 0.02, 0.04, 0.06, 0.08]"),
                 {"step", "stands beside times"});
  for (const char* key : {"amplitude = \"5 m/s^2\"", "period = \"0.5 s\"", "column = \"acc\""})
    expect_refused(shaken(kList + ", step = \"0.02 s\", " + key), {"has no effect", "it is of"});
  for (const char* key :
       {"unit = \"g\"", "step = \"0.02 s\"", "column = \"acc\"", "times = [0, 0.02]"})
    expect_refused(shaken(kPulse + ", " + key), {"has no effect", "leave it out"});
}

TEST(IdleKeys, of_a_push_that_goes_to_and_fro) {
  EXPECT_EQ(refusal(pushed("until = \"2 mm\"\n")), "");
  for (const char* path :
       {"amplitudes = [\"1 mm\", \"2 mm\"]\ncycles = 1\n", "targets = [\"1 mm\", \"-1 mm\"]\n",
        "drifts = [\"0.1 %\"]\ncycles = 1\n"}) {
    EXPECT_EQ(refusal(pushed(path)), "") << path;
    expect_noted(pushed("until = \"15 mm\"\n" + std::string(path)), "until = 15 mm has no effect");
  }
  expect_refused(pushed("until = \"2 mm\"\nvelocity = \"1 mm/s\"\nfast_below = 0.1\n"),
                 {"fast_below", "fast_velocity"});
}

TEST(IdleKeys, of_a_plate_that_is_not_there) {
  const std::string load = kWall + "[[stage]]\nname = \"load\"\nbeam_load = \"20 kN\"\n";
  EXPECT_EQ(refusal(load), "");
  expect_refused(load + "plate_joint = \"joint\"\n", {"plate_joint", "no plate"});
}

TEST(IdleKeys, of_a_lintel_sill_or_arch_without_its_kind) {
  const auto with = [](const std::string& table) {
    std::string text = kWall;
    const std::string opening =
        "[[wall.opening]]\nx = \"0.4 m\"\ny = \"0.3 m\"\nwidth = \"0.4 m\"\nheight = \"0.3 m\"\n";
    return text.insert(text.find("[material.joint]"), opening + table);
  };
  EXPECT_EQ(refusal(with("")), "");
  for (const char* key :
       {"bond = \"unit\"", "bearing_bond = \"unit\"", "top_bond = \"unit\"", "model = \"zones\"",
        "zones = 3", "zone_length = \"0.1 m\"", "zone_kind = \"cst\"", "plane = \"strain\""})
    expect_refused(with("lintel = { " + std::string(key) + " }\n"), {"lintel.kind", "is missing"});
  expect_refused(with("sill = { joint = \"unit\" }\n"), {"sill.kind", "is missing"});
  expect_refused(with("arch = { rise = \"0.1 m\" }\n"), {"arch.kind", "is missing"});
}

TEST(IdleKeys, two_members_of_one_name_are_refused) {
  const auto twice = [](const std::string& head, const std::string& keys) {
    const std::string one = "[[" + head + "]]\nname = \"f\"\n" + keys;
    std::string text = kWall;
    return text.insert(text.find("[material.joint]"), one + one);
  };
  expect_refused(twice("floor", "y = \"1.2 m\"\nload = \"5 kN/m\"\n"),
                 {"floor.1.name", "two floors have this name"});
  expect_refused(twice("region",
                       "x = \"0 m\"\ny = \"0 m\"\nwidth = \"0.4 m\"\nheight = \"0.4 m\"\n"
                       "density = \"1900 kg/m^3\"\n"),
                 {"region.1.name", "two regions have this name"});
  expect_refused(twice("wall.opening",
                       "x = \"0.4 m\"\ny = \"0.3 m\"\nwidth = \"0.4 m\"\n"
                       "height = \"0.3 m\"\n"),
                 {"wall.opening.1.name", "two openings have this name"});
}

TEST(IdleKeys, a_knowledge_level_that_divides_nothing_is_refused) {
  const std::string level =
      "[masonry]\nuse = \"circolare_brick_lime\"\nknowledge_level = \"LC1\"\n";
  expect_refused(kWall + level,
                 {"masonry.knowledge_level", "none is divided", "missing = \"rule\""});
}

TEST(IdleKeys, a_share_is_no_angle) {
  std::string text = kWall;
  text.replace(text.find("\"30 deg\""), 8, "\"60 %\"");
  expect_refused(text, {"friction_angle", "no angle", "friction_tan"});
}

TEST(IdleKeys, a_slope_is_no_angle) {
  const auto with = [](const std::string& value) {
    std::string text = kWall;
    return text.replace(text.find("\"30 deg\""), 8, '"' + value + '"');
  };
  for (const char* slope : {"60 percent", "0.6 m/m", "0.6 kN/kN"})
    expect_refused(with(slope), {"friction_angle", "no angle", "friction_tan"});
  for (const char* angle : {"30 degrees", "0.53 rad", "530 mrad", "30°", "1800 arcmin"})
    EXPECT_EQ(refusal(with(angle)), "") << angle;
}

TEST(IdleKeys, local_damping_in_a_shake_is_noted) {
  expect_noted(shaken(kPulse, "damping = 0.2\n"), "brakes every motion of a shake");
  expect_not_noted(shaken(kPulse), "brakes every motion");
  expect_not_noted(pushed("until = \"2 mm\"\ndamping = 0.2\n"), "brakes every motion");
}

TEST(IdleKeys, a_state_that_no_push_comes_to_is_noted) {
  const std::string states = "[output]\nstates = [\"1 mm\", \"50 mm\"]\n";
  expect_noted(pushed("until = \"2 mm\"\n") + states, "asks for a state at 50 mm");
  expect_not_noted(pushed("until = \"2 mm\"\n") + states, "asks for a state at 1 mm");
  expect_noted(pushed("until = \"60 mm\"\ntargets = [\"1 mm\", \"-1 mm\"]\n") + states,
               "asks for a state at 50 mm");  // an idle end is no end
  expect_not_noted(
      pushed("targets = [\"1 mm\", \"-60 mm\"]\n") + "[output]\nstates = [\"-50 mm\"]\n",
      "asks for a state");
}

TEST(IdleKeys, a_material_that_nothing_is_made_of_is_noted) {
  const std::string timber =
      "[material.timber]\ndensity = \"600 kg/m^3\"\nyoungs_modulus = \"10 GPa\"\n"
      "shear_modulus = \"0.6 GPa\"\n";
  expect_noted(kWall + timber, "no block is made of [material.timber]");
  std::string text = kWall + timber;
  text.insert(text.find("[material.joint]"),
              "[[wall.opening]]\nx = \"0.4 m\"\ny = \"0.3 m\"\nwidth = \"0.4 m\"\n"
              "height = \"0.3 m\"\nlintel = { kind = \"timber\", depth = \"0.1 m\", bearing = "
              "\"0.1 m\", material = \"timber\" }\n");
  expect_not_noted(text, "no block is made of");
  expect_not_noted(kWall + "[material.masonry]\ndensity = \"1700 kg/m^3\"\n",
                   "no block is made of");
}

TEST(IdleKeys, values_of_masonry_without_a_rule_are_noted) {
  const std::string masonry = "[masonry]\nuse = \"circolare_brick_lime\"\n";
  expect_noted(kWall + masonry, "[masonry] has no effect");
  expect_noted(kWall + "[masonry]\nunit_strength = \"20 MPa\"\n", "[masonry] has no effect");
  std::string text = kWall + masonry;
  const std::string stated = "compressive_strength = \"unlimited\"";
  text.replace(text.find(stated), stated.size(),
               "compressive_strength = \"rule\"\ncompressive_energy = \"rule\"");
  expect_not_noted(text, "[masonry] has no effect");
}

TEST(IdleKeys, the_width_of_a_unit_without_headers_is_noted) {
  const auto with = [](const std::string& unit, const std::string& bond) {
    std::string text = kWall;
    text.replace(text.find("unit = {"), 8, bond + "unit = { " + unit);
    return text;
  };
  const std::string width = "width = \"100 mm\", ";
  expect_noted(with(width, ""), "wall.unit.width has no effect");
  expect_noted(with(width, "bond = \"stack\"\n"), "wall.unit.width has no effect");
  expect_not_noted(with(width, "bond = \"english\"\n"), "has no effect");
  expect_not_noted(with("", ""), "has no effect");
}

TEST(IdleKeys, a_form_of_damping_of_space_is_noted_in_the_plane) {
  expect_noted(kWall + "[solve]\ndamping_form = \"components\"\n", "damping_form has no effect");
  expect_not_noted(kWall, "damping_form");
}

TEST(IdleKeys, values_a_thousand_times_off_are_noted) {
  const auto with = [](const std::string& old, const std::string& other) {
    std::string text = pushed("until = \"2 mm\"\n");
    return text.replace(text.find(old), old.size(), other);
  };
  expect_noted(with("thickness = \"0.2 m\"", "thickness = \"200 m\""), "wall.thickness is 200 m");
  expect_noted(with("friction_angle = \"30 deg\"\nresidual_friction_angle = \"30 deg\"",
                    "friction_angle = \"0.6 deg\"\nresidual_friction_angle = \"0.6 deg\""),
               "material.joint.friction_angle is 0.6 deg");
  expect_noted(with("normal_stiffness = \"20 GPa/m\"", "normal_stiffness = \"20 kN/m^3\""),
               "material.joint.normal_stiffness");
  expect_noted(with("cohesion = \"0 MPa\"", "cohesion = \"0.15 N/m^2\""),
               "material.joint.cohesion");
  // the strength of a mortar, 50 kg/cm2, is not that of its bond
  expect_noted(with("cohesion = \"0 MPa\"", "mode_2_energy = \"5 kN/m\"\ncohesion = \"4.9 MPa\""),
               "material.joint.cohesion");
  expect_noted(
      with("cohesion = \"0 MPa\"\nresidual_cohesion = \"0 MPa\"",
           "cohesion = \"0.2 MPa\"\nresidual_cohesion = \"0.2 Pa\"\nmode_2_energy = \"50 N/m\""),
      "material.joint.residual_cohesion");
  expect_noted(pushed("until = \"2 mm\"\n") + "[masonry]\nunit_strength = \"20 N/m^2\"\n",
               "masonry.unit_strength");
  expect_noted(kWall + "[[stage]]\nname = \"weight\"\npressure = \"0.4 N/m^2\"\n",
               "stage.weight.pressure");
  expect_noted(with("until = \"2 mm\"", "until = \"2 mm\"\nvelocity = \"10 m/s\""),
               "stage.push.velocity");
  expect_noted(pushed("until = \"2 mm\"\n") + "[solve]\ngravity = \"9810 m/s^2\"\n",
               "solve.gravity");
  expect_not_noted(pushed("until = \"2 mm\"\n"), "check its unit");
}

TEST(IdleKeys, three_decimals_that_are_thousands_are_noted) {
  const auto loaded = [](const std::string& load) {
    return kWall + "[[stage]]\nname = \"weight\"\nbeam_load = \"" + load + "\"\n";
  };
  expect_noted(loaded("150.000 N"),
               "stage.weight.beam_load = \"150.000 N\" has three decimals here; for "
               "thousands write \"150000 N\"");
  expect_noted(loaded("12.000 kN"), "write \"12000 kN\"");
  const auto with = [](const std::string& old, const std::string& other) {
    std::string text = kWall;
    return text.replace(text.find(old), old.size(), other);
  };
  expect_noted(with("1800 kg/m^3", "1.800 kg/m^3"), "write \"1800 kg/m^3\"");
  expect_noted(with("1800 kg/m^3", "1.845 kg/m^3"), "write \"1845 kg/m^3\"");
  expect_not_noted(with("1800 kg/m^3", "1.800 kg/m^3"), "check its unit");
  expect_noted(with("200 mm", "1.200 mm"), "write \"1200 mm\"");
  for (const char* load : {"0.150 kN", "12.125 kN", "12.00 kN", "1500.000 N"})
    expect_not_noted(loaded(load), "thousands");
  expect_not_noted(with("\"1.2 m\"", "\"1.200 m\""), "thousands");
}

TEST(IdleKeys, commas_are_refused_with_both_readings) {
  const auto refused = [](const std::string& load) {
    return refusal(kWall + "[[stage]]\nname = \"weight\"\nbeam_load = \"" + load + "\"\n");
  };
  const auto expect = [&](const std::string& load, const std::string& cure) {
    EXPECT_NE(refused(load).find(cure), std::string::npos) << refused(load);
  };
  expect("0,15 kN", "write \"0.15 kN\"");
  expect("1.234,5 N", "write \"1234.5 N\"");
  expect("150,000 N", "write \"150000 N\" for thousands, \"150.000 N\" for decimals");
  expect("1,234,567 N", "write \"1234567 N\"");
}

}  // namespace
}  // namespace wythe::idle_keys_test
