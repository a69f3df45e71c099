// One typing mistake in a model gives one message: each line of a model with each of some twenty mistakes.
#include <gtest/gtest.h>

#include <functional>
#include <regex>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "wythe/parts/error.h"
#include "wythe/parts/io.h"
#include "wythe/parts/model.h"
#include "wythe/parts/study.h"

namespace wythe::slips_test {
namespace {

// A wall by rule from tests, with an opening, a storey named elsewhere, a load and a push.
const char* const kPier = R"([wall]
length = "2.5 m"
thickness = "0.25 m"
fit = "cut"

[wall.unit]
length = "250 mm"
height = "120 mm"
density = "1800 kg/m^3"
split = "none"

[[wall.opening]]
name = "door"
storey = "ground"
x = "1.0 m"
y = "0 m"
width = "0.5 m"
height = "0.96 m"

[wall.opening.lintel]
kind = "timber"
depth = "0.12 m"
bearing = "0.25 m"
material = "timber"

[wall.beam]
height = "0.2 m"

[[storey]]
name = "ground"
height = "1.44 m"

[[storey]]
name = "first"
height = "1.2 m"

[masonry]
unit_type = "clay"
unit_strength = "20 MPa"
mortar_strength = "5 MPa"
masonry_strength = "rule"
youngs_modulus = "rule"
shear_modulus = "rule"

[material.joint]
missing = "rule"
cohesion = "0.2 MPa"
friction_angle = "35 deg"

[material.timber]
density = "600 kg/m^3"
youngs_modulus = "10 GPa"
shear_modulus = "0.6 GPa"

[[stage]]
name = "gravity"

[[stage]]
name = "weight"
pier_load = "40 kN"
as = "pressure"

[[stage]]
name = "push"
at = { beam = true }
velocity = "1 mm/s"
until = "10 mm"
)";

const char* const kStudy = R"([study]
model = "model.toml"
samples = 4
seed = 7

[variable.ft]
path = "material.joint.cohesion"
distribution = "lognormal"
mean = "0.2 MPa"
cov = 0.2

[variable.share]
distribution = "normal"
mean = 0.5
standard_deviation = 0.1
lower = 0.2

[[correlation]]
between = ["ft", "share"]
rank = 0.3

[dependent.angle]
path = "material.joint.friction_angle"
formula = "30 deg * share / 0.5"
)";

struct Slip {
  std::string what, line;  // "": the line is gone
};

std::vector<Slip> slips_of_head(const std::string& line) {
  static const std::regex kHead(R"((\[+)([\w.]+)(\]+))");
  std::smatch part;
  if (!std::regex_match(line, part, kHead)) return {};
  const std::string open = part[1], name = part[2], close = part[3];
  const bool list = open == "[[";
  return {{"a letter is lacking", open + name.substr(0, name.size() - 1) + close},
          {"brackets of the other kind", list ? "[" + name + "]" : "[[" + name + "]]"},
          {"no closing bracket", open + name}};
}

std::vector<Slip> slips_of_text(const std::string& key, const std::string& text) {
  const auto line = [&](const std::string& value) { return fmt::format("{} = {}", key, value); };
  std::vector<Slip> out = {{"no quotes", line(text)}, {"one quote", line("\"" + text)}};
  const std::size_t blank = text.find(' ');
  if (blank == std::string::npos) {
    out.push_back({"a word that is near", line("\"" + text.substr(0, text.size() - 1) + "\"")});
    out.push_back({"a foreign word", line("\"zebra\"")});
    return out;
  }
  const std::string number = text.substr(0, blank), unit = text.substr(blank + 1);
  for (const auto& [what, value] : std::vector<std::pair<const char*, std::string>>{
           {"no unit", fmt::format("\"{}\"", number)},
           {"a bare number", number},
           {"unit behind the quotes", fmt::format("\"{}\" {}", number, unit)},
           {"an unknown unit", fmt::format("\"{} {}x\"", number, unit)},
           {"a unit of something else", fmt::format("\"{} s\"", number)},
           {"a decimal comma",
            fmt::format("\"{},5 {}\"", number.substr(0, number.find('.')), unit)},
           {"a million times too large", fmt::format("\"{}000000 {}\"", number, unit)},
           {"below zero", fmt::format("\"-{} {}\"", number, unit)},
           {"zero", fmt::format("\"0 {}\"", unit)}})
    out.push_back({what, line(value)});
  return out;
}

std::vector<Slip> slips_of_key(const std::string& line) {
  const std::size_t equals = line.find(" = ");
  if (equals == std::string::npos) return {};
  const std::string key = line.substr(0, equals), value = line.substr(equals + 3);
  std::vector<Slip> out = {{"gone", ""},
                           {"a letter is lacking", key.substr(0, key.size() - 1) + " = " + value},
                           {"a letter too many", key + "x = " + value},
                           {"a semicolon", line + ";"},
                           {"a comma", line + ","},
                           {"a colon", key + " : " + value},
                           {"a remark of C", line + " // so"},
                           {"a list", key + " = []"},
                           {"a table", key + " = {}"}};
  if (value.front() == '"' && value.back() == '"')
    for (Slip& slip : slips_of_text(key, value.substr(1, value.size() - 2)))
      out.push_back(std::move(slip));
  return out;
}

// The rows of what a user is told; "" where the model is sound.
std::string told(const std::string& text) {
  try {
    (void)compile(parse_model(text, "model.toml"));
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

// The rows of what is told of a study of the pier.
std::string told_of_study(const std::string& text) {
  const std::string inside = "model_text = \"\"\"\n" + std::string(kPier) + "\"\"\"\n";
  std::string whole = text;
  const std::size_t at = whole.find("seed = 7");
  whole.insert(at == std::string::npos ? whole.find("samples") : at, inside);
  try {
    (void)parse_study(whole, "study.toml");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = text.find('\n', begin);
    lines.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return lines;
}

// The numbers of mistakes tried and refused in a text; each refusal has one message and a cure.
std::pair<int, int> try_slips(const std::string& whole,
                              const std::function<std::string(const std::string&)>& tell) {
  const std::vector<std::string> lines = lines_of(whole);
  int tried = 0, refused = 0;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    std::vector<Slip> slips = slips_of_head(lines[i]);
    for (Slip& slip : slips_of_key(lines[i])) slips.push_back(std::move(slip));
    for (const Slip& slip : slips) {
      std::string text;
      for (std::size_t k = 0; k < lines.size(); ++k) text += (k == i ? slip.line : lines[k]) + "\n";
      const std::string said = tell(text);
      ++tried;
      if (said.empty()) continue;  // what is left is sound too
      ++refused;
      EXPECT_EQ(said.find('\n'), std::string::npos)
          << slip.what << ": " << lines[i] << " -> " << slip.line << "\n"
          << said;
      EXPECT_EQ(said.find("Error while"), std::string::npos) << slip.line << "\n" << said;
      EXPECT_NE(said.find("; "), std::string::npos) << "no cure: " << slip.line << "\n" << said;
    }
  }
  return {tried, refused};
}

TEST(Slips, each_line_of_a_model_with_each_slip_gives_one_message_with_a_cure) {
  ASSERT_EQ(told(kPier), "");
  const auto [tried, refused] = try_slips(kPier, told);
  EXPECT_GT(tried, 500);
  EXPECT_GT(refused, 400);
}

TEST(Slips, each_line_of_a_study_with_each_slip_gives_one_message_with_a_cure) {
  ASSERT_EQ(told_of_study(kStudy), "");
  const auto [tried, refused] = try_slips(kStudy, told_of_study);
  EXPECT_GT(tried, 150);
  EXPECT_GT(refused, 100);
}

// The text with one line in the place of another.
std::string with(const std::string& line, const std::string& other) {
  std::string text = kPier;
  const std::size_t at = text.find(line + "\n");
  EXPECT_NE(at, std::string::npos) << line;
  return text.replace(at, line.size(), other);
}

void expect_one(const std::string& text, const std::vector<std::string>& words) {
  const std::string said = told(text);
  EXPECT_EQ(said.find('\n'), std::string::npos) << said;
  for (const std::string& word : words)
    EXPECT_NE(said.find(word), std::string::npos) << word << "\n" << said;
}

TEST(Slips, a_head_that_was_left_out_is_named) {
  expect_one(with("[masonry]", ""), {"unit_strength", "they belong under [masonry]"});
  expect_one(with("[material.joint]", ""), {"cohesion", "[material.<name>]"});
}

TEST(Slips, words_of_other_programs_are_understood) {
  expect_one(with("friction_angle = \"35 deg\"", "friction_coefficient = 0.7"),
             {"did you mean friction_tan?"});
  expect_one(with("friction_angle = \"35 deg\"", "mu = 0.7"), {"did you mean friction_tan?"});
  expect_one(with("friction_angle = \"35 deg\"", "friction_tan = \"35 deg\""),
             {"write friction_angle = \"35 deg\""});
  expect_one(with("youngs_modulus = \"10 GPa\"", "E = \"10 GPa\""),
             {"did you mean youngs_modulus?"});
}

TEST(Slips, a_value_outside_of_two_rules_is_told_once) {
  expect_one(with("cohesion = \"0.2 MPa\"", "cohesion = \"200 MPa\""),
             {"ft_from_cohesion", "gii_from_cohesion", "check cohesion", "200 MPa"});
}

TEST(Slips, a_name_that_nothing_has_any_more_is_told_once) {
  expect_one(with("[material.timber]", "[material.wood]"), {"material.timber", "lintel"});
  expect_one(with("name = \"ground\"", "name = \"base\""), {"no such storey"});
}

TEST(Slips, a_lintel_without_its_kind_is_not_left_out_in_silence) {
  const std::string bare = with("kind = \"timber\"", "");
  expect_one(bare, {"wall.opening.0.lintel.kind", "write e.g. kind = \"timber\""});
  expect_one(with("[wall.opening.lintel]\nkind = \"timber\"", "[wall.opening.sill]"),
             {"wall.opening.0.sill.kind"});
  expect_one(with("[wall.opening.lintel]\nkind = \"timber\"\ndepth = \"0.12 m\"\nbearing = \"0.25 "
                  "m\"\nmaterial = \"timber\"",
                  "[wall.opening.arch]\nrise = \"0.1 m\""),
             {"wall.opening.0.arch.kind", "segmental"});
}

TEST(Slips, marks_of_other_formats_are_named) {
  expect_one(with("at = { beam = true }", "at = { beam = True }"), {"beam = true }"});
  expect_one(with("at = { beam = true }", "at = { beam : true }"), {"{ beam = true }"});
  expect_one(with("at = { beam = true }", "at = { beam = yes }"), {"beam = true }"});
  expect_one(with("name = \"push\"", "name = push on the beam"),
             {"write name = \"push on the beam\""});
  expect_one(with("name = \"push\"", "name = push, off"), {"write name = \"push, off\""});
  expect_one(with("at = { beam = true }", "at = {\n beam = true\n}"), {"in one line"});
  expect_one(with("at = { beam = true }", "at = \"beam\""), {"write at = { x ="});
  expect_one(with("[wall.unit]", "[wall,unit]"), {"write [wall.unit]"});
  expect_one(with("[wall.unit]", "[wall/unit]"), {"write [wall.unit]"});
  expect_one(with("length = \"250 mm\"", "length = \"250\" mm"), {"write length = \"250 mm\""});
}

// The study with one line in the place of another.
std::string study_with(const std::string& line, const std::string& other) {
  std::string text = kStudy;
  const std::size_t at = text.find(line + "\n");
  EXPECT_NE(at, std::string::npos) << line;
  return text.replace(at, line.size(), other);
}

void expect_one_of_study(const std::string& text, const std::vector<std::string>& words) {
  const std::string said = told_of_study(text);
  EXPECT_EQ(said.find('\n'), std::string::npos) << said;
  for (const std::string& word : words)
    EXPECT_NE(said.find(word), std::string::npos) << word << "\n" << said;
}

TEST(Slips, each_cure_can_be_written_as_it_stands) {
  expect_one_of_study(study_with("formula = \"30 deg * share / 0.5\"", ""),
                      {"write e.g. formula = \"1.5 * ft_j\""});
  expect_one_of_study(
      study_with("path = \"material.joint.cohesion\"", "path = \"material.joints.cohesion\""),
      {"did you mean material.joint.cohesion?"});
  expect_one_of_study(study_with("seed = 7", "seed = 7\nstates = [1, 2]"),
                      {"states.0", "states = [\"10 mm\", \"40 mm\"]"});
}

TEST(Slips, a_list_of_named_members_is_told_once) {
  std::string text = study_with("[variable.ft]", "[[variable]]\nname = \"ft\"");
  const std::string other = "[variable.share]";
  text.replace(text.find(other), other.size(), "[[variable]]\nname = \"share\"");
  expect_one_of_study(text, {"must be named tables", "[variable.ft]"});
}

TEST(Slips, a_study_of_other_words_is_told_once) {
  expect_one_of_study(study_with("rank = 0.3", "pearson = 0.3"), {"pearson", "gaussian"});
  expect_one_of_study(study_with("lower = 0.2", "min = 0.2"), {"min", "did you mean low"});
  expect_one_of_study(
      std::string(kStudy) + "[[variant]]\nname = \"tie\"\nset = \"wall.length=2 m\"\n",
      {"variant.0.set", "list of"});
  expect_one_of_study(
      study_with("distribution = \"lognormal\"",
                 "distribution = \"empirical\"\nvalues = [\"0.1 MPa\", \"0.2 MPa\"]"),
      {"has no mean, cov"});
}

TEST(Slips, a_floor_load_by_area_is_told_from_one_along_the_wall) {
  expect_one(std::string(kPier) + "[[floor]]\ny = \"1.44 m\"\nload = \"5 kN/m^2\"\n",
             {"load by area", "kN/m", "g1, g2, q, psi2 and span"});
}

TEST(Slips, a_place_in_the_plane_has_no_depth) {
  expect_one(
      std::string(kPier) +
          "[[tie]]\narea = \"491 mm^2\"\nyoungs_modulus = \"200 GPa\"\nfrom = { x = \"0.1 m\", "
          "y = \"1.3 m\", z = \"1 m\" }\nto = { x = \"2.4 m\", y = \"1.3 m\" }\n",
      {"tie.0.from.z", "lies in a plane", "leave z out"});
}

TEST(Slips, a_joint_law_alone_is_told_once_too) {
  const auto told_of_law = [](const std::string& text) {
    try {
      (void)parse_law(text, "law.toml");
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  std::string law =
      "[material.joint]\nnormal_stiffness = \"20 GPa/m\"\nshear_stiffness = \"8 GPa/m\"\n"
      "tensile_strength = \"0 MPa\"\ncohesion = \"0 MPa\"\nresidual_cohesion = \"0 MPa\"\n"
      "friction_angle = \"30 deg\"\nresidual_friction_angle = \"30 deg\"\n"
      "compressive_strength = \"unlimited\"\n";
  ASSERT_EQ(told_of_law(law), "");
  const std::string bare = told_of_law(law.substr(law.find('\n') + 1));
  EXPECT_EQ(bare.find('\n'), std::string::npos) << bare;
  EXPECT_NE(bare.find("[material.<name>]"), std::string::npos) << bare;
  const std::string typo = told_of_law(law.replace(law.find("cohesion"), 8, "cohesoin"));
  EXPECT_EQ(typo.find('\n'), std::string::npos) << typo;
  EXPECT_NE(typo.find("did you mean cohesion?"), std::string::npos) << typo;
}

// Valid text is not changed: a semicolon or slashes within quotes, a colon in a time, several lines of a list.
TEST(Slips, marks_within_a_text_are_its_own) {
  EXPECT_EQ(told("note = \"a; b // c: d, True\"\n" + std::string(kPier)), "");
}

}  // namespace
}  // namespace wythe::slips_test
