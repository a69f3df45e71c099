// Models: valid input, and for each bad input the
// place, the value and the cure in its message.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "core/text.h"
#include "io/keys/same_spec.h"
#include "unit/io_helpers.h"
#include "wythe/parts/error.h"
#include "wythe/parts/io.h"

namespace wythe::io_test {
namespace {

using namespace io_tests;

// --- models --------------------------------------------------------------------------------------

TEST(Model, example_is_understood) {
  const ModelSpec spec = parse_model(kModel, "walls/model.toml");
  EXPECT_EQ(spec.folder, "walls");
  EXPECT_EQ(spec.wall.length, 5.1);
  EXPECT_EQ(spec.wall.unit.length, 0.31);
  EXPECT_EQ(spec.wall.opening.at(0).lintel.bond, "joint");
  EXPECT_EQ(spec.material.at("joint").tensile_strength, 0.15e6);
  EXPECT_TRUE(std::isnan(spec.material.at("timber").cohesion));
  ASSERT_EQ(spec.stage.size(), 3U);
  EXPECT_EQ(spec.stage[0].kind(), StageKind::kGravity);
  EXPECT_EQ(spec.stage[1].kind(), StageKind::kLoad);
  EXPECT_EQ(spec.stage[2].kind(), StageKind::kPush);
  EXPECT_EQ(spec.stage[2].get<PushStage>().at.courses, 3);
  EXPECT_TRUE(std::isnan(spec.stage[2].damping));
}

TEST(Model, written_and_read_is_the_same) {
  const ModelSpec spec = parse_model(kModel, "model.toml");
  EXPECT_EQ(io::first_difference(spec, parse_model(write_model(spec), "model.toml")), "");
}

TEST(Model, comparison_sees_every_bit) {
  const ModelSpec spec = parse_model(kModel, "model.toml");
  ModelSpec other = spec;
  other.stage[2].get<PushStage>().velocity =
      std::nextafter(other.stage[2].get<PushStage>().velocity, 1.0);
  EXPECT_NE(io::first_difference(spec, other).find("stage.2.velocity"), std::string::npos);
}

TEST(Model, kind_is_told_from_the_keys) {
  const std::string stages =
      "name = \"a\"\nrate = \"0.1 /s\"\nfactor = 0.5\n[[stage]]\nname = \"b\"\n"
      "tilt_rate = \"1 deg/s\"\ntilt_until = \"30 deg\"\n[[stage]]\nname = \"c\"\n"
      "duration = \"1 s\"\n[[stage]]\nname = \"gravity\"\n";
  const ModelSpec spec = parse_model(with(kModel, "name = \"gravity\"\n", stages), "model.toml");
  EXPECT_EQ(spec.stage[0].kind(), StageKind::kBodyForce);
  EXPECT_EQ(spec.stage[1].kind(), StageKind::kTilt);
  EXPECT_EQ(spec.stage[2].kind(), StageKind::kHold);
}

// One friction angle before and after: no shear strength is lost at any pressure.
TEST(Model, compressive_strength_may_be_unlimited) {
  for (const char* word : {"unlimited", "inf MPa"}) {
    const std::string text = with(with(kModel, "3.96 MPa", word), "16.2 deg", "14.6 deg");
    EXPECT_EQ(parse_model(text, "m").material.at("joint").compressive_strength, kUnlimited) << word;
  }
}

TEST(ModelRefused, infinite_is_unlimited_in_other_words) {
  EXPECT_EQ(fault_of("\"3.96 MPa\"", "\"infinite\""),
            "model.toml:27: material.joint.compressive_strength = infinite: 'infinite' is not a "
            "number with a unit; write compressive_strength = \"unlimited\"");
}

TEST(Model, missing_file_is_an_input_error_that_names_it) {
  try {
    (void)read_model("/nowhere/model.toml");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("/nowhere/model.toml"), std::string::npos);
  }
}

TEST(Model, reference_page_has_every_key_of_the_example) {
  const std::string page = reference_page();
  for (const char* text : {"## `[wall.unit]`", "## `[[stage]]`", "## `[material.<name>]`",
                           "| `mode_1_energy` | N/m |", "`tilt_until`", "more than 0 m"})
    EXPECT_NE(page.find(text), std::string::npos) << text;
}

// --- values refused ------------------------------------------------------------------------------

TEST(ModelRefused, bare_number) {
  EXPECT_EQ(fault_of("length = \"5.10 m\"", "length = 5.10"),
            "model.toml:2: wall.length = 5.1: has no unit; write it with its unit, e.g. "
            "length = \"5.10 m\"");
}

TEST(ModelRefused, number_in_quotes_without_unit) {
  EXPECT_EQ(fault_of("\"5.10 m\"", "\"5.10\""),
            "model.toml:2: wall.length = 5.10: has no unit; write it with its unit, e.g. "
            "length = \"5.10 m\"");
}

TEST(ModelRefused, wrong_dimension) {
  EXPECT_EQ(
      fault_of("\"0.31 m\"", "\"0.31 kg\""),
      "model.toml:4: wall.thickness = 0.31 kg: kg is not the unit of a length [m]; write e.g. "
      "thickness = \"0.31 m\"");
}

TEST(ModelRefused, negative_length) {
  EXPECT_EQ(
      fault_of("\"5.10 m\"", "\"-3 m\""),
      "model.toml:2: wall.length = -3 m: must be more than 0 m; write e.g. length = \"5.10 m\"");
}

TEST(ModelRefused, nan_and_infinity) {
  EXPECT_EQ(
      fault_of("\"5.10 m\"", "\"nan m\""),
      "model.toml:2: wall.length = nan m: is not a finite number; write e.g. length = \"5.10 m\"");
  EXPECT_EQ(
      fault_of("\"5.10 m\"", "\"inf m\""),
      "model.toml:2: wall.length = inf m: is not a finite number; write e.g. length = \"5.10 m\"");
  EXPECT_EQ(joined(faults_of(kModel + "[solve]\nsettle_ratio = nan\n"), "\n"),
            "model.toml:43: solve.settle_ratio = nan: is not a finite number; write e.g. "
            "settle_ratio = 1e-5");
}

TEST(ModelRefused, unlimited_where_it_is_no_value) {
  for (const char* word : {"unlimited", "inf MPa"})
    for (const char* key : {"tensile_strength", "cohesion"}) {
      const std::string line = std::string(key) + " = \"0.15 MPa\"";
      const std::string fault = fault_of(line, std::string(key) + " = \"" + word + "\"");
      EXPECT_NE(fault.find(std::string("material.joint.") + key + " = " + word + ": "),
                std::string::npos);
      EXPECT_NE(fault.find("write e.g. " + line), std::string::npos) << fault;
    }
}

TEST(ModelRefused, angle_beyond_its_range) {
  EXPECT_EQ(
      fault_of("\"16.2 deg\"", "\"90 deg\""),
      "model.toml:22: material.joint.friction_angle = 90 deg: must be from 0 deg to less than "
      "90 deg; write e.g. friction_angle = \"16.2 deg\"");
}

TEST(ModelRefused, word_that_is_none_of_the_words) {
  EXPECT_EQ(fault_of("\"running\"", "\"runing\""),
            "model.toml:5: wall.bond = runing: must be one of running, stack, flemish, english, "
            "header; did you mean \"running\"?");
}

TEST(ModelRefused, fraction_for_a_whole_number) {
  EXPECT_EQ(fault_of("courses = 3", "courses = 3.5"),
            "model.toml:38: stage.2.at.courses = 3.5: must be a whole number without quotes; write "
            "e.g. courses = 3");
}

// The cure repeats the number that the text holds, if it is one of the key's.
TEST(ModelRefused, number_with_a_unit_or_in_quotes) {
  const auto fault = [](const std::string& value) {
    return joined(faults_of(kModel + "[solve]\ndamping = \"" + value + "\"\n"), "\n");
  };
  const std::string place = "model.toml:43: solve.damping = ",
                    problem = ": must be a number without quotes; ";
  for (const char* value : {"0.15 g", "0.15", "15 %"})
    EXPECT_EQ(fault(value), place + value + problem + "write damping = 0.15");
  for (const char* value : {"15 g", "0.15 m", "much"})  // out of range, of another kind, none
    EXPECT_EQ(fault(value), place + value + problem + "write e.g. damping = 0.8");
  EXPECT_EQ(fault_of("courses = 3", "courses = \"4\""),
            "model.toml:38: stage.2.at.courses = 4: must be a whole number without quotes; write "
            "courses = 4");
  // no whole number of the file is as large: the cure would be refused again
  EXPECT_EQ(fault_of("courses = 3", "courses = \"3e9\""),
            "model.toml:38: stage.2.at.courses = 3e9: must be a whole number without quotes; write "
            "e.g. courses = 3");
}

TEST(ModelRefused, text_for_a_flag) {
  EXPECT_EQ(
      fault_of("courses = 3", "beam = \"yes\""),
      "model.toml:38: stage.2.at.beam = yes: must be true or false, without quotes; write e.g. "
      "beam = true");
}

TEST(ModelRefused, number_for_a_text) {
  EXPECT_EQ(fault_of("name = \"door\"", "name = 3"),
            "model.toml:11: wall.opening.0.name = 3: must be a text in quotes; write e.g. "
            "name = \"door\"");
}

TEST(ModelRefused, quantity_for_a_list) {
  EXPECT_EQ(fault_of("until = \"50 mm\"", "targets = \"5 mm\""),
            "model.toml:41: stage.2.targets = 5 mm: must be a list of quantities; write e.g. "
            "targets = [\"2 mm\", \"-2 mm\", \"4 mm\"]");
}

TEST(ModelRefused, member_of_a_list_by_its_index) {
  EXPECT_EQ(fault_of("until = \"50 mm\"", "targets = [\"5 mm\", 3]"),
            "model.toml:41: stage.2.targets.1 = 3: has no unit; write it with its unit, e.g. "
            "targets = [\"2 mm\", \"-2 mm\", \"4 mm\"]");
}

TEST(ModelRefused, text_for_a_table) {
  EXPECT_EQ(faults_of("wall = \"high\"\n" + kModel.substr(kModel.find("[material.joint]"))).at(0),
            "model.toml:1: wall = high: must be a table; write it under [wall]");
}

TEST(ModelRefused, single_brackets_for_a_list) {
  const std::string tail =
      kModel.substr(0, kModel.find("[[stage]]")) + "[stage]\nname = \"gravity\"\n";
  EXPECT_EQ(faults_of(tail),
            Texts{"model.toml:31: stage = a table: must be a list of tables; write "
                  "each under [[stage]], with two brackets"});
}

// --- keys refused --------------------------------------------------------------------------------

TEST(ModelRefused, unknown_key_with_the_nearest) {
  EXPECT_EQ(fault_of("thickness =", "thicknes ="),
            "model.toml:4: wall.thicknes = 0.31 m: no such key thicknes; did you mean thickness?");
}

TEST(ModelRefused, unknown_key_with_the_known) {
  EXPECT_EQ(
      fault_of("kind = \"timber\"", "colour = \"red\""),
      "model.toml:16: wall.opening.0.lintel.colour = red: no such key colour; known here: kind, "
      "depth, bearing, material, bond, bearing_bond, top_bond, model, zones, zone_length, "
      "zone_kind, plane");
}

TEST(ModelRefused, syntax_error_with_its_line) {
  const std::string fault = fault_of("height = \"3.62 m\"", "height = = 3");
  EXPECT_TRUE(fault.starts_with("model.toml:3: not valid TOML: ")) << fault;
}

// One slip, one fault, and a cure that gives a valid file.
TEST(ModelRefused, slips_of_the_hand_with_their_cure) {
  const std::string right = "height = \"3.62 m\"";
  const std::pair<const char*, const char*> slips[] = {
      {"height = \"3.62 m", "lacks a quote; write height = \"3.62 m\""},
      {"height = 3.62 m\"", "lacks a quote; write height = \"3.62 m\""},
      {"height = 3.62 m", "without quotes; write height = \"3.62 m\""},
      {"height = 3,62 m", "has a decimal comma; write height = \"3.62 m\""},
      {"height \"3.62 m\"", "has no =; write key = value"},
      {"height = “3.62 m”", "quotes of a text program; write straight ones"}};
  for (const auto& [slip, told] : slips) {
    const std::string fault = fault_of(right, slip);
    EXPECT_TRUE(fault.starts_with("model.toml:3: not valid TOML: ")) << fault;
    EXPECT_NE(fault.find(told), std::string::npos) << slip << '\n' << fault;
  }
  EXPECT_NE(fault_of("[wall]", "[wall").find("has no ] at its end; write [wall]"),
            std::string::npos);
}

// Each of these had the words of the parser's library and no cure.
TEST(ModelRefused, what_no_toml_has_is_told_with_its_cure) {
  const std::string right = "height = \"3.62 m\"";
  const std::pair<const char*, const char*> slips[] = {
      {"height == \"3.62 m\"", "has == where TOML has =; write height = \"3.62 m\""},
      {"height = 30.", "write height = 30.0, or height = \"30.0 UNIT\""},
      {"height = -.5", "write height = -0.5, or"},
      {"height = 1__0", "write height = 10, or"},
      {"height = 030", "write height = 30, or"},
      {"height = 1.234.567", "several points in a number; write one point"},
      {"height = 99999999999999999999999", "larger than a whole number may be"},
      {"height = –3", "dash of a text program; write a minus sign"},
      {"height = '3.62 m", "lacks a quote"},
      {"height = \"\"\"3.62 m", "ends within a text or a list; close what is open above"},
      {"\"height = \"3.62 m\"", "lacks a quote; write height = \"3.62 m\""},
      {"the height = \"3.62 m\"", "has a blank in its key; write the_height = \"3.62 m\""},
      {"wall..height = \"3.62 m\"", "without a name in its key"},
      {"hauteür = \"3.62 m\"", "letters of English"},
      {"height = 2026-13-40", "is read as a date"},
      {"height = \"3.62\x01 m\"", "control character"},
      {"height = { a = 1, }", "a comma before its }; write height = { a = 1 }"},
      {"height = { a = 1,", "has no } in its line"},
      {"; a remark", "mark of remarks that TOML has not; write # a remark"},
      {"% a remark", "write # a remark"},
      {"/* a remark */", "write # a remark"},
      {"[[stage]", "has one ] where two belong; write [[stage]]"},
      {"[]", "names no table; write e.g. [wall]"},
      {"height:", "is YAML, it seems, and a model is TOML; write [height]"},
      {"{\"wall\": 1}", "is JSON"},
      {"<wall>", "is XML"},
      {"height = [\"3.62 m\"", "list that is not closed; write ]"},
      {"height = ?", "write each line as key = value or [table]"}};
  for (const auto& [slip, told] : slips) {
    const std::string fault = fault_of(right, slip);
    EXPECT_NE(fault.find(told), std::string::npos) << slip << '\n' << fault;
    EXPECT_EQ(fault.find("Error while"), std::string::npos) << fault;
  }
  EXPECT_NE(fault_of("[material.joint]",
                     "[[wall.opening]]\nname = { a = 1 }\n[wall.opening.name.b]\n"
                     "[material.joint]")
                .find("write it within these { }"),
            std::string::npos);
}

TEST(ModelRefused, a_path_of_windows_in_double_quotes) {
  for (const char* path : {"C:\\temp\\new.json", "data\\test.json", "b\\rows.json"}) {
    const std::string fault =
        fault_of("thickness =", std::string("blocks = \"") + path + "\"\nthickness =");
    std::string meant = path;
    std::replace(meant.begin(), meant.end(), '\\', '/');
    EXPECT_NE(fault.find("write blocks = \"" + meant + "\""), std::string::npos) << fault;
  }
  const std::string fault =
      fault_of("thickness =", "blocks = \"D:\\walls\\house.json\"\nthickness =");
  EXPECT_NE(fault.find("write blocks = \"D:/walls/house.json\""), std::string::npos) << fault;
}

TEST(ModelRefused, every_fault_at_once_in_order_of_lines) {
  const std::string text =
      with(with(with(kModel, "\"5.10 m\"", "5"), "\"+x\"", "\"x\""), "\"310 mm\"", "\"0 mm\"");
  const Texts faults = faults_of(text);
  ASSERT_EQ(faults.size(), 3U);
  EXPECT_TRUE(faults[0].starts_with("model.toml:2: wall.length"));
  EXPECT_TRUE(faults[1].starts_with("model.toml:7: wall.unit.length"));
  EXPECT_TRUE(faults[2].starts_with("model.toml:39: stage.2.direction"));
}

// --- materials -----------------------------------------------------------------------------------

TEST(ModelRefused, joint_law_without_a_parameter) {
  const std::string fault = fault_of("cohesion = \"0.15 MPa\"\n", "");
  EXPECT_TRUE(fault.starts_with("model.toml:17: material.joint.cohesion: is missing")) << fault;
}

TEST(ModelRefused, refused_value_is_not_also_called_missing) {
  EXPECT_EQ(faults_of(with(kModel, "\"4.3 N/m\"", "4.3")).size(), 1U);
}

// --- stages --------------------------------------------------------------------------------------

TEST(StageRefused, none_at_all) {
  EXPECT_EQ(
      faults_of(kModel.substr(0, kModel.find("[[stage]]"))).at(0),
      "model.toml:1: stage: is missing, a model needs at least one stage; write [[stage]] and "
      "under it name = \"gravity\"");
}

TEST(StageRefused, kind_that_cannot_be_deduced) {
  const std::string fault = fault_of("name = \"gravity\"", "name = \"weight\"");
  EXPECT_TRUE(fault.starts_with("model.toml:31: stage.0.kind: can't be deduced")) << fault;
  EXPECT_NE(fault.find("write kind = \"gravity\""), std::string::npos);
}

TEST(StageRefused, keys_of_several_kinds) {
  EXPECT_EQ(fault_of("velocity =", "pressure = \"1 MPa\"\nvelocity ="),
            "model.toml:36: stage.2: has keys of several kinds: pressure (load), velocity "
            "(push), until (push); make them separate stages");
}

TEST(StageRefused, key_of_another_kind) {
  EXPECT_EQ(
      fault_of("name = \"gravity\"",
               "name = \"gravity\"\nkind = \"gravity\"\nvelocity = \"1 mm/s\""),
      "model.toml:34: stage.0.velocity = 1 mm/s: a gravity stage has no such key; it belongs to "
      "stages of kind push");
}

TEST(StageDefault, push_may_leave_its_velocity_out) {
  const std::string text = with(kModel, "velocity = \"10 mm/s\"\n", "");
  EXPECT_TRUE(std::isnan(parse_model(text, "model.toml").stage[2].get<PushStage>().velocity));
  EXPECT_EQ(fault_of("velocity = \"10 mm/s\"\n", "fast_velocity = \"0.05 mm/s\"\n"),
            "model.toml:40: stage.2.fast_velocity = 0.05 mm/s: is slower than velocity, 0.1 mm/s "
            "where none is given; write a "
            "faster one, or leave it out for one velocity throughout");
}

TEST(StageRefused, push_at_rest) {
  EXPECT_EQ(fault_of("\"10 mm/s\"", "\"0 mm/s\""),
            "model.toml:40: stage.2.velocity = 0 mm/s: must be more than 0 mm/s; write e.g. "
            "velocity = \"10 mm/s\"");
}

TEST(StageRefused, push_without_end) {
  EXPECT_EQ(fault_of("until = \"50 mm\"\n", ""),
            "model.toml:36: stage.2.until: is missing, a push needs until or targets; write e.g. "
            "until = \"50 mm\"");
}

TEST(StageRefused, a_protocol_that_cannot_be_run) {
  const auto refused = [](const std::string& keys) { return fault_of("until = \"50 mm\"", keys); };
  const std::string levels = "amplitudes = [\"2 mm\", \"4 mm\"]\n";
  EXPECT_EQ(
      refused("amplitudes = [\"2 mm\", \"4 mm\", \"3 mm\"]"),
      "model.toml:41: stage.2.amplitudes.2 = 3 mm: falls back behind the level before it, 4 mm; "
      "write levels that grow; for any other order write every displacement in targets");
  EXPECT_EQ(
      refused("drifts = [\"0.2 %\", \"0.1 %\"]"),
      "model.toml:41: stage.2.drifts.1 = 0.1 %: falls back behind the level before it, 0.2 %; "
      "write levels that grow; for any other order write every displacement in targets");
  EXPECT_EQ(refused("amplitudes = [\"2 mm\", \"0 mm\"]"),
            "model.toml:41: stage.2.amplitudes.1 = 0 mm: must be more than 0 mm; write e.g. "
            "amplitudes = [\"2 mm\", \"4 mm\", \"8 mm\"]");
  EXPECT_EQ(
      refused(levels + "cycles = 0"),
      "model.toml:42: stage.2.cycles.0 = 0: asks for no cycle; write a whole number from 1 on, or "
      "leave the level out");
  EXPECT_EQ(
      refused(levels + "cycles = [1, 2.5]"),
      "model.toml:42: stage.2.cycles.1 = 2.5: is no number of cycles; write a whole number from 1 "
      "on, or leave the level out");
  EXPECT_EQ(
      refused(levels + "cycles = [1, 2, 3]"),
      "model.toml:42: stage.2.cycles: must be one number, or one a level: 2 and not 3; write e.g. "
      "cycles = 2");
  EXPECT_EQ(refused(levels + "cycles = \"two\""),
            "model.toml:42: stage.2.cycles = two: must be a number, or a list of them, without "
            "quotes; write "
            "e.g. cycles = 2");
  EXPECT_EQ(refused(levels + "cycles = inf").substr(0, 53),
            "model.toml:42: stage.2.cycles = inf: must be a number");
  EXPECT_EQ(
      refused(levels + "cycles = 1000000"),
      "model.toml:42: stage.2.cycles: asks for 2e+06 cycles in all, at most 10000 are run; write "
      "fewer cycles, or fewer levels");
  EXPECT_EQ(refused("amplitudes = []").substr(0, 48),
            "model.toml:41: stage.2.amplitudes = a list: is e");
  EXPECT_EQ(
      refused("until = \"50 mm\"\ncycles = 2"),
      "model.toml:42: stage.2.cycles: has no levels; write e.g. amplitudes = [\"2 mm\", \"4 mm\", "
      "\"8 mm\"]");
  EXPECT_EQ(refused(levels + "targets = [\"2 mm\"]"),
            "model.toml:42: stage.2.targets: says where the push goes, and so do the levels of a "
            "protocol; "
            "keep one of them");
  EXPECT_EQ(
      refused(levels + "drifts = [\"1 %\"]"),
      "model.toml:42: stage.2.drifts: states levels, and so does amplitudes; keep one of them");
}

TEST(StageRead, one_number_of_cycles_is_for_all_levels) {
  const auto read = [](const std::string& cycles) {
    const std::string keys = "drifts = [\"0.1 %\", \"0.2 %\"]\n" + cycles;
    return parse_model(with(kModel, "until = \"50 mm\"", keys), "model.toml")
        .stage[2]
        .get<PushStage>();
  };
  EXPECT_EQ(read("cycles = 3").cycles, std::vector<double>{3});
  EXPECT_EQ(read("cycles = [3, 1]").cycles, (std::vector<double>{3, 1}));
  EXPECT_EQ(read("").drifts, (std::vector<double>{0.001, 0.002}));
}

TEST(StageRefused, push_without_place) {
  EXPECT_EQ(fault_of("at = { x = \"0 m\", y = \"3.12 m\", courses = 3 }\n", ""),
            "model.toml:36: stage.2.at: is missing, a push needs at, or a pattern with its levels; "
            "write e.g. "
            "at = { x = \"0 m\", y = \"3.12 m\", courses = 3 }");
}

TEST(StageRefused, place_with_half_a_point) {
  EXPECT_EQ(fault_of("y = \"3.12 m\", ", ""),
            "model.toml:38: stage.2.at = a table: needs both x and y; write e.g. "
            "at = { x = \"0 m\", y = \"3.12 m\", courses = 3 }");
}

TEST(StageRefused, load_without_load_and_with_two) {
  const std::string none = fault_of("pier_load = \"200 kN\"", "kind = \"load\"");
  EXPECT_EQ(none,
            "model.toml:33: stage.1: a load stage needs pier_load, pressure, beam_load, force, "
            "line_load or floors = true; "
            "write e.g. pier_load = \"200 kN\"");
  const std::string two = fault_of("pier_load =", "pressure = \"1 MPa\"\npier_load =");
  EXPECT_EQ(two,
            "model.toml:33: stage.1: has more than one of pier_load, pressure, beam_load, force, "
            "line_load and floors; "
            "make them separate stages");
}

TEST(StageRefused, manner_of_another_kind) {
  EXPECT_EQ(fault_of("pier_load =", "as = \"each\"\npier_load ="),
            "model.toml:35: stage.1.as = each: a load acts as pressure or plate; write e.g. "
            "as = \"plate\"");
  EXPECT_EQ(fault_of("velocity =", "as = \"plate\"\nvelocity ="),
            "model.toml:40: stage.2.as = plate: a push acts as spreader or each; write e.g. "
            "as = \"spreader\"");
}

TEST(StageRefused, plate_without_piers) {
  EXPECT_EQ(fault_of("pier_load = \"200 kN\"", "as = \"plate\"\npressure = \"1 MPa\""),
            "model.toml:35: stage.1.as = plate: a plate stands on each pier and needs pier_load; "
            "leave `as` out, or write pier_load");
}

TEST(StageRefused, body_force_tilt_and_hold_without_their_keys) {
  const auto fault = [](const std::string& keys) {
    return joined(faults_of(with(kModel, "name = \"gravity\"", "name = \"s\"\n" + keys)), "\n");
  };
  EXPECT_EQ(fault("rate = \"0.1 /s\""),
            "model.toml:31: stage.0.factor: is missing, a body_force stage needs it; write e.g. "
            "factor = 0.5");
  EXPECT_EQ(fault("tilt_rate = \"1 deg/s\""),
            "model.toml:31: stage.0.tilt_until: is missing, a tilt stage needs it; write e.g. "
            "tilt_until = \"30 deg\"");
  EXPECT_EQ(fault("kind = \"hold\""),
            "model.toml:31: stage.0.duration: is missing, a hold stage needs it; write e.g. "
            "duration = \"1 s\"");
}

TEST(StageRefused, two_of_one_name) {
  EXPECT_EQ(
      fault_of("\"precompression\"", "\"gravity\""),
      "model.toml:34: stage.1.name = gravity: two stages have this name; give each stage a name "
      "of its own");
}

TEST(StageRefused, no_name) {
  EXPECT_EQ(
      fault_of("name = \"precompression\"\n", ""),
      "model.toml:33: stage.1.name: is missing, a stage needs one; write e.g. name = \"push\"");
}

TEST(ContactRefused, no_material_and_one_block_material) {
  EXPECT_EQ(
      faults_of(kModel + "[[contact]]\nbetween = [\"stone\"]\n"),
      (Texts{"model.toml:42: contact.0.material: is missing, a contact rule needs it; write e.g. "
             "material = \"joint\"",
             "model.toml:43: contact.0.between = a list: must be a list of 2 texts in quotes; "
             "write e.g. between = [\"stone\", \"ground\"]"}));
}

// --- --set ---------------------------------------------------------------------------------------

TEST(Set, changes_members_by_name_and_by_index) {
  const ModelSpec spec =
      parse_model(kModel, "m",
                  {"stage.push.velocity=1 mm/s", "wall.opening.0.width=\"1.2 m\"",
                   "wall.opening.door.x = 2 m", "stage.2.at.courses=5", "wall.bond=stack"});
  EXPECT_EQ(spec.stage[2].get<PushStage>().velocity, 0.001);
  EXPECT_EQ(spec.wall.opening[0].width, 1.2);
  EXPECT_EQ(spec.wall.opening[0].x, 2.0);
  EXPECT_EQ(spec.stage[2].get<PushStage>().at.courses, 5);
  EXPECT_EQ(spec.wall.bond, Bond::kStack);
}

TEST(Set, makes_missing_tables_and_lists_of_values) {
  const ModelSpec spec =
      parse_model(kModel, "m",
                  {"wall.beam.height=250 mm", "solve.damping=0.7",
                   "output.states=[\"1 mm\", \"2 mm\"]", "output.states.1=5 mm"});
  EXPECT_EQ(spec.wall.beam.height, 0.25);
  EXPECT_EQ(spec.solve.damping, 0.7);
  EXPECT_EQ(spec.output.states, (std::vector<double>{0.001, 0.005}));
}

TEST(Set, later_one_wins) {
  EXPECT_EQ(parse_model(kModel, "m", {"wall.length=1 m", "wall.length=2 m"}).wall.length, 2.0);
}

TEST(SetRefused, no_equals_sign) {
  EXPECT_EQ(fault_of_set("stage.push.velocity"),
            "--set: stage.push.velocity: has no '='; write path=value, e.g. --set "
            "stage.push.velocity=\"1 mm/s\"");
}

TEST(SetRefused, unknown_key_with_the_nearest) {
  EXPECT_EQ(fault_of_set("stage.push.velocty=1 mm/s"),
            "--set: stage.push.velocty = 1 mm/s: no such key velocty; did you mean velocity?");
}

TEST(SetRefused, unknown_member_with_the_nearest) {
  EXPECT_EQ(fault_of_set("stage.psh.velocity=1 mm/s"),
            "--set: stage.psh.velocity = 1 mm/s: stage has no member psh; did you mean push?");
  EXPECT_EQ(
      fault_of_set("wall.opening.4.width=1 m"),
      "--set: wall.opening.4.width = 1 m: wall.opening has no member 4; it has 1, counted from 0");
}

TEST(SetRefused, unknown_table) {
  EXPECT_EQ(fault_of_set("wal.length=1 m"),
            "--set: wal.length: no such key wal; did you mean wall?");
}

TEST(SetRefused, path_below_a_value) {
  EXPECT_EQ(fault_of_set("wall.length.x=1 m"),
            "--set: wall.length.x = 1 m: wall.length is a value, nothing stands below it");
}

TEST(SetRefused, value_out_of_range) {
  EXPECT_EQ(fault_of_set("stage.push.velocity=-1 mm/s"),
            "--set: stage.push.velocity = -1 mm/s: must be more than 0 mm/s; write e.g. "
            "velocity = \"10 mm/s\"");
}

// --- written models ------------------------------------------------------------------------------

TEST(Written, unset_keys_and_absent_tables_are_left_out) {
  const std::string text = write_model(parse_model(kModel, "m"));
  for (const char* absent : {"[wall.beam]", "nan", "ramp", "collapse_displacement", "note"})
    EXPECT_EQ(text.find(absent), std::string::npos) << absent;
  for (const char* present :
       {"length = \"5.1 m\"", "friction_angle = \"16.2 deg\"", "fit = \"whole\"", "rows = 500",
        "split = \"middle\"", "velocity = \"10 mm/s\""})
    EXPECT_NE(text.find(present), std::string::npos) << present;
}

TEST(Written, texts_and_names_are_escaped) {
  ModelSpec spec = parse_model(kModel, "m");
  spec.note = "a \"quoted\" \\ back\nline\ttab \x01\x7f é = # [x]";
  spec.material["my \"mix\". 1"] = spec.material.at("joint");
  EXPECT_EQ(io::first_difference(spec, parse_model(write_model(spec), "m")), "");
}

}  // namespace
}  // namespace wythe::io_test
