// Inputs that are refused early, with place and message:
// sizes, places of faults, texts of users in messages.
#include <fmt/core.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <regex>
#include <string>
#include <vector>

#include "core/text.h"
#include "geometry/assembly.h"
#include "model/size.h"
#include "scenes/scenes.h"
#include "unit/io_helpers.h"
#include "wythe/parts/error.h"
#include "wythe/parts/io.h"
#include "wythe/parts/model.h"
#include "wythe/parts/solve.h"
#include "wythe/parts/text.h"

namespace wythe::guards_test {
namespace {

using io_tests::kModel;
using io_tests::with;

std::vector<Fault> refusals(const std::string& text, std::vector<std::string> set = {}) {
  for (const char* rest : {"wall.unit.split=none", "material.timber.youngs_modulus=10 GPa",
                           "material.timber.shear_modulus=0.6 GPa"})
    set.insert(set.begin(), rest);  // what the text leaves out
  try {
    (void)compile(parse_model(text, "model.toml", set));
  } catch (const InputError& error) {
    return error.faults();
  }
  return {};
}

std::string first_refusal(const std::vector<std::string>& set) {
  const std::vector<Fault> faults = refusals(kModel, set);
  return faults.empty() ? "" : to_string(faults.front());
}

bool says(const std::string& text, const std::string& word) {
  return text.find(word) != std::string::npos;
}

// Each of these took minutes, gigabytes or forever before it was refused.
// --- sizes ---------------------------------------------------------------------------------------

TEST(Size, a_wall_of_40_million_blocks_is_refused_with_count_memory_time_and_cure) {
  {
    const std::string said =
        first_refusal({"wall.length=100 m", "wall.height=20 m", "wall.unit.length=10 mm",
                       "wall.unit.height=5 mm", "stage.push.at.y=3 m"});
    for (const char* word : {"wall.unit", "40 million blocks", "of memory", "of computing",
                             "larger units", "WYTHE_MEMORY"})
      EXPECT_TRUE(says(said, word)) << said;
  }
}

TEST(Size, a_kilometre_of_millimetre_bricks_is_beyond_what_is_numbered) {
  const std::string said =
      first_refusal({"wall.length=1 km", "wall.unit.length=1 mm", "wall.unit.height=1 mm"});
  EXPECT_TRUE(says(said, "the most that are numbered")) << said;
  EXPECT_FALSE(says(said, "WYTHE_MEMORY")) << said;
}

TEST(Size, memory_is_what_the_machine_has_or_what_is_stated) {
  ::setenv("WYTHE_MEMORY", "8 GB", 1);
  EXPECT_DOUBLE_EQ(memory_limit(), 8e9);
  ::setenv("WYTHE_MEMORY", "1 MB", 1);
  EXPECT_TRUE(says(first_refusal({}), "1 MB may be used")) << first_refusal({});
  ::setenv("WYTHE_MEMORY", "plenty", 1);
  EXPECT_THROW((void)memory_limit(), InputError);
  ::unsetenv("WYTHE_MEMORY");
  EXPECT_GT(memory_limit(), 1e8);
  EXPECT_TRUE(refusals(kModel, {}).empty() || !says(first_refusal({}), "memory"));
}

TEST(Size, is_about_that_of_the_wall_that_is_built) {
  const ModelSpec spec = scenes::plain_wall(20, 20, 1e-3, 0.01);
  EXPECT_NEAR(size_of(spec).blocks / compile(spec).n_block, 1, 0.1);
  EXPECT_NEAR(size_of(spec).steps / static_cast<double>(estimate(compile(spec)).steps), 1, 0.9);
}

// The forecast steps each kind of stage with what watches it; one that ends at once costs as the dearest.
TEST(Size, a_forecast_has_seconds_for_every_kind_of_stage) {
  const auto forecast = [](std::vector<StageSpec> stages) {
    ModelSpec spec = scenes::plain_wall(4, 4, 1e-3, 0.01);
    stages.insert(stages.begin(), spec.stage.front());
    spec.stage = std::move(stages);
    const RunEstimate e = estimate(compile(spec));
    EXPECT_TRUE(std::isfinite(e.seconds) && e.seconds > 0) << e.seconds;
    EXPECT_GT(e.steps, 0);
    return e;
  };
  const std::vector<StageSpec> pushed = scenes::plain_wall(4, 4, 1e-3, 0.01).stage;
  const RunEstimate settled = forecast({});
  const RunEstimate push = forecast({pushed.back()});
  EXPECT_GT(push.steps, settled.steps);
  StageSpec tilt{.name = "tilt", .action = TiltStage{.tilt_rate = 0.1, .tilt_until = 0.1}};
  EXPECT_GT(forecast({tilt}).steps, settled.steps);
  StageSpec still = pushed.front();  // nothing is left to settle
  still.name = "still";
  EXPECT_GE(forecast({still}).steps, settled.steps);
}

TEST(Size, rows_of_a_tiny_window_are_counted_not_made) {
  {
    const std::string said = first_refusal({"output.window=1e-5 mm"});
    for (const char* word :
         {"--set: output.window", "rows", "1 million", "write window = \"5e-05 mm\""})
      EXPECT_TRUE(says(said, word)) << said;
    EXPECT_FALSE(says(first_refusal({"output.window=5e-05 mm"}), "window"));
  }
}

TEST(Size, a_run_that_would_not_end_is_refused_at_the_key_that_makes_it_long) {
  const std::string said = first_refusal({"stage.push.velocity=1e-9 mm/s"});
  for (const char* word : {"stage.push.velocity", "steps", "years"})
    EXPECT_TRUE(says(said, word)) << said;
}

// Squares and products of such values leave the range of a double: runs said "completed" with sums that are no numbers.
TEST(Size, values_no_wall_has_are_refused_large_and_small) {
  for (const char* key :
       {"wall.thickness m", "wall.unit.density kg/m^3", "material.joint.normal_stiffness Pa/m",
        "material.joint.cohesion Pa", "material.joint.mode_2_energy N/m", "solve.gravity m/s^2",
        "solve.settle_limit s", "stage.push.velocity m/s"}) {
    const std::string text = key, path = text.substr(0, text.find(' '));
    for (const char* size : {"1e300", "1e-300"}) {
      const std::string said = first_refusal({path + "=" + size + text.substr(text.find(' '))});
      EXPECT_TRUE(says(said, path)) << said;
      EXPECT_TRUE(says(said, "of a wall") || says(said, "up to") || says(said, "less than"))
          << said;
      EXPECT_TRUE(says(said, "write e.g.")) << said;
    }
  }
  EXPECT_TRUE(says(first_refusal({"solve.settle_ratio=1e300"}), "larger than any"));
  EXPECT_EQ(first_refusal({"material.joint.cohesion=0 Pa"}).find("than any"), std::string::npos);
}

TEST(Size, speeds_and_lengths_no_wall_has_are_refused_with_their_range) {
  EXPECT_TRUE(says(first_refusal({"stage.push.velocity=1e15 m/s"}), "less than 100000 mm/s"))
      << first_refusal({"stage.push.velocity=1e15 m/s"});
  for (const char* key : {"wall.length", "wall.thickness", "wall.unit.length", "stage.push.until",
                          "wall.opening.0.x", "stage.push.at.y", "output.window"})
    EXPECT_TRUE(says(first_refusal({std::string(key) + "=1e18 m"}), "up to 10000") ||
                says(first_refusal({std::string(key) + "=1e18 m"}), "to 10000"))
        << first_refusal({std::string(key) + "=1e18 m"});
}

TEST(Size, more_courses_than_the_wall_has_are_not_looked_for) {
  {
    const std::string said = first_refusal({"stage.push.at.courses=10000000"});
    EXPECT_TRUE(says(said, "at.courses")) << said;
    EXPECT_TRUE(says(said, "33 courses")) << said;
  }
}

TEST(Size, boxes_that_lie_on_each_other_are_refused_at_once) {
  for (const bool fixed : {false, true}) {
    std::vector<BlockSpec> blocks(20'000, scenes::rectangle("b", 0, 0, 1, 1));
    for (std::size_t i = 0; i < blocks.size(); ++i) {
      blocks[i].id = "b" + std::to_string(i);
      blocks[i].fixed = fixed && i > 0;
    }
    blocks[0] = scenes::rectangle("alone", 3, 0, 1, 1);
    const ModelSpec spec = scenes::assembly(blocks, scenes::paper_joint(), 0.1, 2000);
    std::size_t told = 0;
    {
      FaultList faults;
      (void)geometry::build_assembly(spec, faults);
      told = faults.all().size();
      // supports may overlap; all others stop there, for all pairs take minutes
      EXPECT_EQ(!fixed, std::ranges::any_of(faults.all(), [](const Fault& fault) {
        return fault.problem.starts_with("more than 20000 pairs are one block each");
      }));
    }
    EXPECT_GE(told, 1U);
    EXPECT_LT(told, 30U);
  }
}

TEST(Size, an_outline_of_200_000_corners_is_refused_at_once) {
  BlockSpec round = scenes::rectangle("round", 0, 0, 1, 1);
  round.polygon.clear();
  for (int k = 0; k < 200'000; ++k)
    round.polygon.push_back({std::cos(k * scenes::kPi / 1e5), std::sin(k * scenes::kPi / 1e5)});
  const ModelSpec spec = scenes::assembly({round}, scenes::paper_joint(), 0.1, 2000);
  FaultList faults;
  (void)geometry::build_assembly(spec, faults);
  ASSERT_FALSE(faults.empty());
  EXPECT_TRUE(says(to_string(faults.all().front()), "200000 corners"))
      << to_string(faults.all().front());
  EXPECT_TRUE(says(to_string(faults.all().front()), "at most 1000"));
}

// --- overload ------------------------------------------------------------------------------------

TEST(Overload, a_wall_that_cannot_carry_its_load_is_told_so_and_not_to_lower_its_step) {
  for (const double load : {2e6, 1e8, 1e12}) {
    const Model model = compile(scenes::small_wall(1e-3, 0.02, load));
    State state = initial_state(model);
    const Result result = solve(model, state);
    EXPECT_EQ(result.status, SolveStatus::kCollapsed) << load << ": " << result.reason;
    EXPECT_TRUE(says(text_of(result.reason), "can't carry its load"))
        << load << ": " << result.reason;
    EXPECT_FALSE(says(text_of(result.reason), "step_fraction")) << result.reason;
  }
}

// --- places --------------------------------------------------------------------------------------

TEST(Places, faults_of_geometry_have_file_and_line) {
  const auto line_of = [](const std::string& from, const std::string& to) {
    const std::vector<Fault> faults = refusals(with(kModel, from, to));
    return faults.empty() ? std::string() : to_string(faults.front());
  };
  EXPECT_TRUE(says(line_of("x = \"1.70 m\"", "x = \"1.62 m\""), "model.toml:12: wall.opening.0.x"))
      << line_of("x = \"1.70 m\"", "x = \"1.62 m\"");
  EXPECT_TRUE(says(line_of("bearing = \"150 mm\"", "bearing = \"5 mm\""), "model.toml:16:"));
  EXPECT_TRUE(says(line_of("length = \"310 mm\"", "length = \"700 mm\""), "model.toml:7:"));
  EXPECT_TRUE(says(line_of("courses = 3", "courses = 99"), "model.toml:38: stage.2.at.courses"))
      << line_of("courses = 3", "courses = 99");
  EXPECT_TRUE(says(first_refusal({"wall.opening.door.x=1.62 m"}), "--set: wall.opening.door.x"))
      << first_refusal({"wall.opening.door.x=1.62 m"});
}

TEST(Places, keys_beside_a_blocks_file_are_named_as_not_used) {
  const std::string blocks = R"({"units": "m", "blocks_xyxy": [[0, 0, 1, 0.5], [0, 0.5, 1, 1]]})";
  std::string text = with(kModel, "[wall]\n", "[wall]\nblocks = \"b.json\"\n");
  text = with(text, "bond = \"running\"", "bond = \"stack\"");
  text = with(text, "courses = 3", "courses = 1");
  text = with(text, "y = \"3.12 m\"", "y = \"0.75 m\"");
  const Model model = compile(parse_model(text, "model.toml", {}, blocks));
  std::string notes;
  for (const Message& note : model.anatomy.notes) notes += text_of(note) + "\n";
  EXPECT_TRUE(says(notes,
                   "wall.length, wall.height, wall.bond, wall.unit.length, wall.unit.height, "
                   "wall.opening are not used"))
      << notes;
}

TEST(Places, keys_that_have_no_effect_are_refused) {
  for (const char* set : {"wall.up=z", "wall.blocks_unit=mm", "wall.supports=[\"a\"]"}) {
    const std::string path = std::string(set).substr(0, std::string(set).find('='));
    const std::string said = first_refusal({set});
    EXPECT_TRUE(says(said, path) && says(said, "has no effect")) << set << ": " << said;
  }
}

TEST(Places, a_missing_file_is_the_user_s_and_gets_the_nearest_name) {
  const io_tests::Folder folder;
  const std::string there = folder.write("model.toml", kModel);
  const std::string typed = there.substr(0, there.size() - 10) + "modle.toml";
  try {
    (void)read_model(typed);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_TRUE(says(error.what(), "no such file")) << error.what();
    EXPECT_TRUE(says(error.what(), "did you mean " + there)) << error.what();
  }
  EXPECT_THROW((void)read_model(there.substr(0, there.size() - 11)), InputError);  // the folder
  EXPECT_THROW((void)read_study(typed), InputError);
  EXPECT_THROW((void)read_law(typed), InputError);
  EXPECT_THROW((void)read_contact_path(typed), InputError);
}

// --- cures ---------------------------------------------------------------------------------------

// What a cure states before its first alternative: `write x = "1.7 m" and width = "1.5 m"; or ...`.
std::vector<std::string> settings_of_cure(const Fault& fault) {
  std::size_t end = fault.cure.size();
  for (const char* other : {" (or", ", or", "; or"}) end = std::min(end, fault.cure.find(other));
  const std::string cure = fault.cure.substr(0, end);
  const std::string table = fault.path.substr(0, fault.path.rfind('.') + 1);
  std::vector<std::string> settings;
  const std::regex stated("(\\w+) = (\"[^\"]+\")");
  for (std::sregex_iterator it(cure.begin(), cure.end(), stated), none; it != none; ++it)
    settings.push_back(table + (*it)[1].str() + "=" + (*it)[2].str());
  return settings;
}

// Settings of the model with all cures applied, or nothing where one states no value.
std::optional<std::vector<std::string>> cured(std::vector<std::string> settings) {
  for (const Fault& fault : refusals(kModel, settings)) {
    const std::vector<std::string> more = settings_of_cure(fault);
    if (more.empty()) return std::nullopt;
    for (const std::string& setting : more) settings.push_back(setting);
  }
  return settings;
}

std::string all_of(const std::vector<Fault>& faults) {
  std::string text;
  for (const Fault& fault : faults) text += to_string(fault) + "\n";
  return text;
}

TEST(Cures, hold_when_all_of_them_are_applied) {
  const std::vector<std::vector<std::string>> faulty = {
      {"wall.opening.door.x=1.62 m"},
      {"wall.opening.door.width=1.63 m"},
      {"wall.opening.door.x=1.62 m", "wall.opening.door.width=1.62 m"},
      {"wall.opening.door.y=0.16 m", "wall.opening.door.height=1.21 m"},
      {"wall.unit.length=700 mm"},
      {"wall.unit.length=700 mm", "wall.unit.height=290 mm", "wall.opening.door.x=1.95 m"},
      {"wall.opening.door.x=4 m"},
      {"wall.opening.door.height=9 m"},
      {"wall.opening.door.x=4 m", "wall.opening.door.height=9 m"},
      {"wall.opening.door.lintel.bearing=5 mm"},
      {"wall.opening.door.lintel.bearing=4 m"},
      {"wall.opening.door.lintel.depth=3 m"},
      {"wall.opening.door.x=1.62 m", "wall.opening.door.lintel.bearing=5 mm"}};
  for (const auto& settings : faulty) {
    EXPECT_FALSE(refusals(kModel, settings).empty()) << settings.front();
    const auto after = cured(settings);
    ASSERT_TRUE(after) << all_of(refusals(kModel, settings));
    EXPECT_TRUE(refusals(kModel, *after).empty()) << all_of(refusals(kModel, settings)) << "then\n"
                                                  << all_of(refusals(kModel, *after));
  }
}

TEST(Cures, hold_for_any_opening_and_unit) {
  int refused = 0;
  EXPECT_TRUE(rc::check([&] {
    const auto mm = [](const char* key, int low, int high) {
      return fmt::format("{}={} mm", key, *rc::gen::inRange(low, high));
    };
    const std::vector<std::string> settings = {mm("wall.opening.door.x", 400, 5000),
                                               mm("wall.opening.door.width", 100, 3000),
                                               mm("wall.opening.door.y", 0, 1500),
                                               mm("wall.opening.door.height", 100, 3000),
                                               mm("wall.unit.length", 150, 700),
                                               mm("wall.unit.height", 60, 300),
                                               mm("wall.opening.door.lintel.bearing", 5, 400)};
    const auto only_geometry = [&](const std::vector<std::string>& all) {
      std::vector<Fault> faults = refusals(kModel, all);
      std::erase_if(faults, [](const Fault& fault) { return says(fault.path, "stage"); });
      return faults;
    };
    if (only_geometry(settings).empty()) return;
    const auto after = cured(settings);
    if (!after) return;
    ++refused;
    RC_ASSERT(all_of(only_geometry(*after)) == "");
  }));
  EXPECT_GT(refused, 10);
}

// --- lintels -------------------------------------------------------------------------------------

TEST(Lintel, a_bearing_that_would_grow_more_than_twofold_is_refused) {
  const std::string said = first_refusal({"wall.opening.door.lintel.bearing=5 mm"});
  for (const char* word : {"lintel.bearing", "5 mm", "31 times", "write bearing = \"154.545 mm\""})
    EXPECT_TRUE(says(said, word)) << said;
  EXPECT_TRUE(says(first_refusal({"wall.opening.door.lintel.bearing=77 mm"}), "times"));
  EXPECT_FALSE(says(first_refusal({"wall.opening.door.lintel.bearing=78 mm"}), "times"));
}

TEST(Lintel, a_kind_that_is_no_known_word_is_said_to_have_no_effect) {
  ModelSpec spec = scenes::small_wall();
  spec.material["timber"].density = 500;
  spec.material["timber"].youngs_modulus = 1e9;
  spec.material["timber"].shear_modulus = 0.4e9;
  LintelSpec& lintel = spec.wall.opening[0].lintel;
  lintel.depth = 0.11, lintel.bearing = 0.155, lintel.material = "timber";
  const auto notes = [&](const char* kind) {
    lintel.kind = kind;
    std::string all;
    for (const Message& note : compile(spec).anatomy.notes) all += text_of(note) + "\n";
    return all;
  };
  EXPECT_TRUE(says(notes("none"), "kind = \"none\" has no effect: the lintel is there"));
  EXPECT_FALSE(says(notes("timber"), "no effect"));
}

// --- texts ---------------------------------------------------------------------------------------

TEST(Readable, control_characters_are_shown) {
  EXPECT_EQ(readable("red \x1b[31m\n\t\x7f"), "red \\x1b[31m\\n\\t\\x7f");
  EXPECT_EQ(readable("\xc2\x9b"
                     "31m"),
            "\\xc2\\x9b31m");  // CSI in one character
  EXPECT_EQ(readable("a\xe2\x80\xae"
                     "b"),
            "a\\xe2\\x80\\xae"
            "b");  // turns what follows round
  EXPECT_EQ(readable("c\xc3\xa0 \xe2\x88\x9e"), "c\xc3\xa0 \xe2\x88\x9e");
}

TEST(Readable, bytes_that_are_no_text_are_shown) {
  EXPECT_EQ(readable("wall\x86\xff"), "wall\\x86\\xff");
  EXPECT_EQ(readable("a\xc3"), "a\\xc3");                            // a character cut short
  EXPECT_EQ(readable("\xc0\xaf"), "\\xc0\\xaf");                     // "/" in two bytes
  EXPECT_EQ(readable("\xe0\x80\xaf"), "\\xe0\\x80\\xaf");            // "/" in three
  EXPECT_EQ(readable("\xed\xa0\x80"), "\\xed\\xa0\\x80");            // half of a pair of UTF-16
  EXPECT_EQ(readable("\xf4\x90\x80\x80"), "\\xf4\\x90\\x80\\x80");   // beyond the last character
  EXPECT_EQ(readable("\xf0\x9f\xa7\xb1"), "\xf0\x9f\xa7\xb1");       // a brick
  EXPECT_TRUE(is_utf8("\xed\x9f\xbf\xee\x80\x80\xf4\x8f\xbf\xbf"));  // the last ones that are
  EXPECT_FALSE(is_utf8("\xf0\x80\x80\x80"));
}

TEST(Readable, long_values_are_cut_between_characters) {
  const std::string cut = readable(std::string(1000, 'x'), 10);
  EXPECT_EQ(cut, "xxxxxxxxxx... (1000 characters)");
  EXPECT_EQ(readable("\xc3\xa0\xc3\xa0\xc3\xa0", 3), "\xc3\xa0\xc3\xa0... (6 characters)");
  Fault fault{"m.toml", "wall.length", std::string(100'000, 'y'), "is odd", "", 1};
  EXPECT_LT(to_string(fault).size(), 300U);
}

TEST(Readable, a_message_cannot_drive_the_terminal) {
  const std::string said =
      first_refusal({"wall.bond=\"\\u001b[2J\\u001b[31m" + std::string(5000, 'z') + "\""});
  EXPECT_FALSE(said.empty());
  EXPECT_EQ(said.find('\x1b'), std::string::npos);
  EXPECT_LT(said.size(), 600U);
}

}  // namespace
}  // namespace wythe::guards_test
