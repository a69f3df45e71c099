// The report of an artificial run: the page's headline, its data, names as text, languages; and the
// SVG pictures of a wall. The drawings by the page's scripts are tested in a browser (tests/web).
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <regex>
#include <string>
#include <vector>

#include "core/text.h"
#include "io/keys/describe.h"
#include "report/bundle.h"
#include "report/html.h"
#include "report/model_inputs.h"
#include "report/svg.h"
#include "report/texts.h"
#include "report/translation.h"
#include "report/wall_arrays.h"
#include "report/wall_picture.h"
#include "scenes/sample_run.h"
#include "scenes/scenes.h"
#include "scenes/zones.h"
#include "wythe/parts/error.h"
#include "wythe/parts/reading.h"
#include "wythe/parts/report.h"
#include "wythe/parts/solve.h"
#include "wythe/parts/statistics.h"

namespace wythe::report_test {
namespace {

using namespace report;

int count(const std::string& text, const std::string& part) {
  int n = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
  return n;
}

// "" when every tag is closed in order, else the tag at fault.
std::string unclosed_tag(const std::string& markup) {
  static const std::regex kTag(R"(<(/?)([a-zA-Z][a-zA-Z0-9]*)((?:"[^"]*"|[^"<>])*?)(/?)>)");
  std::vector<std::string> open;
  for (std::sregex_iterator it(markup.begin(), markup.end(), kTag), end; it != end; ++it) {
    const std::string name = (*it)[2];
    if ((*it)[4] == "/") continue;
    if ((*it)[1] != "/") {
      open.push_back(name);
    } else {
      if (open.empty() || open.back() != name) return "/" + name;
      open.pop_back();
    }
  }
  return open.empty() ? "" : open.back();
}

std::string data_of(const Result& result) {
  return run_data(scenes::sample_spec(), scenes::sample_model(), result);
}
// The part of the page without scripts.
std::string static_part(const std::string& page) {
  const std::size_t from = page.find("<main");
  return page.substr(from, page.find("</main>") + 7 - from);
}
std::string sample_head(const Result& result, const std::string& language = "en") {
  return static_part(report_page(data_of(result), language));
}

TEST(Html, markup_in_a_name_becomes_text) {
  EXPECT_EQ(escaped("<b a=\"1\">&'\x01"), "&lt;b a=&quot;1&quot;&gt;&amp;&#39; ");
}

TEST(Html, numbers_are_rounded_to_what_a_reader_takes_in) {
  EXPECT_EQ(rounded(163.42), "163");
  EXPECT_EQ(rounded(11.04), "11");
  EXPECT_EQ(rounded(0.003514), "0.00351");
  EXPECT_EQ(rounded(-1234.5), "−1234");
  EXPECT_EQ(rounded(2.4e-7), "2.4·10⁻⁷");
  EXPECT_EQ(rounded(0), "0");
  EXPECT_EQ(rounded(kUnset), "–");
  EXPECT_EQ(quantity(kUnlimited, "MPa"), "unlimited");
}

TEST(Text, base64_as_in_rfc_4648) {
  const auto of = [](std::string_view text) {
    return base64({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
  };
  EXPECT_EQ(of(""), "");
  EXPECT_EQ(of("f"), "Zg==");
  EXPECT_EQ(of("fo"), "Zm8=");
  EXPECT_EQ(of("foo"), "Zm9v");
  EXPECT_EQ(of("foobar"), "Zm9vYmFy");
}

TEST(Svg, ticks_are_round_and_within_the_range) {
  EXPECT_EQ(ticks(0, 50, 10), (std::vector<double>{0, 5, 10, 15, 20, 25, 30, 35, 40, 45, 50}));
  const std::vector<double> signed_ticks = ticks(-0.35, 0.35, 5);
  EXPECT_DOUBLE_EQ(signed_ticks.front(), -0.2);
  EXPECT_DOUBLE_EQ(signed_ticks.back(), 0.2);
  EXPECT_EQ(ticks(1, 1, 5).size(), 1u);
}

// --- the page ------------------------------------------------------------------------------------

TEST(Report, static_part_closes_its_tags) {
  EXPECT_EQ(unclosed_tag(sample_head(scenes::sample_result())), "");
}

TEST(Report, no_name_reaches_the_page_as_markup) {
  const std::string page = report_page(data_of(scenes::sample_result()));
  EXPECT_EQ(count(page, "<script>alert(1)"), 0);
  EXPECT_EQ(count(page, "&lt;script&gt;alert(1)"), 2);  // title and heading
}

TEST(Report, page_needs_nothing_from_outside) {
  // the viewer's own code may build such attributes, the static part may not
  const std::string head = sample_head(scenes::sample_result());
  for (const char* door : {"src=", "url(", "href="}) EXPECT_EQ(count(head, door), 0) << door;
  EXPECT_EQ(count(report_page(data_of(scenes::sample_result())), "default-src 'none'"), 1);
}

TEST(Report, headline_says_force_displacement_and_mode) {
  const std::string head = sample_head(scenes::sample_result());
  EXPECT_EQ(count(head, "The wall resists <b>10\u202fkN</b> at <b>2\u202fmm</b>"), 1);
  EXPECT_EQ(count(head, "slides on the bed joint"), 1);
  EXPECT_EQ(count(head, "class=\"card\""), 5);
}

// A run of 50 mm that has fallen below half of its peak.
Result whole_push() {
  Result result = scenes::sample_result();
  result.responses = {};
  result.responses.peak_reaction = 10e3;
  result.responses.displacement_at_peak = 10e-3;
  result.responses.displacement_at_80 = 25e-3;
  result.responses.censored_80 = false;
  result.responses.displacement_max = 50e-3;
  result.responses.censored_max = true;
  result.failure_mode.read_at = 40e-3;
  return result;
}

TEST(Report, a_push_that_went_far_enough_fails_by_its_mode) {
  const std::string head = sample_head(whole_push());
  EXPECT_EQ(count(head, "It fails by <b>FM-1</b>"), 1);
  EXPECT_EQ(count(head, "So far"), 0);
  EXPECT_EQ(count(head, "≥ "), 1);  // the largest displacement
}

TEST(Report, a_push_that_ended_early_says_so_far) {
  Result early = whole_push();
  early.failure_mode.read_at = 20e-3;  // modes are read at 40 mm
  EXPECT_EQ(count(sample_head(early), "So far, at 20\u202fmm, it shows <b>FM-1</b>"), 1);
  Result holding = whole_push();  // has not fallen to 80 %
  holding.responses.displacement_at_80 = 50e-3;
  holding.responses.censored_80 = true;
  EXPECT_EQ(count(sample_head(holding), "So far, at 40\u202fmm, it shows <b>FM-1</b>"), 1);
  EXPECT_EQ(count(sample_head(holding), "It still holds more than 80\u202f% of that force"), 1);
  EXPECT_EQ(count(sample_head(holding, "it"), "Finora, a 40\u202fmm, mostra <b>FM-1</b>"), 1);
  holding.failure_mode.name = "unclear";
  EXPECT_EQ(count(sample_head(holding), "So far, at 40\u202fmm, its failure mode is unclear"), 1);
  holding.status = SolveStatus::kCollapsed;  // it has failed, however early
  holding.failure_mode.name = "FM-1";
  EXPECT_EQ(count(sample_head(holding), "It fails by <b>FM-1</b>"), 1);
}

TEST(Report, a_force_that_was_still_rising_is_a_lower_bound) {
  Result rising = whole_push();
  rising.responses.displacement_at_peak = rising.responses.displacement_max;
  rising.responses.censored_peak = true;
  rising.responses.censored_80 = true;
  const std::string head = sample_head(rising);
  EXPECT_EQ(count(head, "The wall resists at least <b>10\u202fkN</b>: it was still rising"), 1);
  EXPECT_EQ(count(head, "It still holds"), 0);
  EXPECT_EQ(count(head, "<div class=\"value\">≥ "), 4);  // all but the stiffness
}

TEST(Report, italian_has_its_words_and_its_decimal_comma) {
  Result result = scenes::sample_result();
  result.responses.displacement_at_peak = 2.5e-3;
  const std::string head = sample_head(result, "it");
  EXPECT_EQ(count(head, "La parete resiste a <b>10\u202fkN</b>"), 1);
  EXPECT_EQ(count(head, "<b>2,5\u202fmm</b>"), 1);
  EXPECT_EQ(count(report_page(data_of(result), "it"), "<html lang=\"it\""), 1);
  EXPECT_THROW(static_cast<void>(report_page(data_of(result), "tlh")), InputError);
}

TEST(Report, a_run_that_went_wrong_says_so) {
  Result result = scenes::sample_result();
  EXPECT_EQ(count(sample_head(result), "class=\"warning\""), 1);  // of the missing scripts
  result.status = SolveStatus::kUnstable;
  result.reason = as_text("kinetic energy <grew>");
  const std::string head = sample_head(result);
  EXPECT_EQ(count(head, "class=\"warning\""), 2);
  EXPECT_EQ(count(head, "Kinetic energy &lt;grew&gt;"), 1);
}

TEST(Report, an_empty_result_still_makes_a_page) {
  const std::string page = report_page(run_data(ModelSpec{}, scenes::sample_model(), Result{}));
  EXPECT_EQ(unclosed_tag(static_part(page)), "");
  EXPECT_EQ(count(static_part(page), "nothing pushed it"), 1);
}

TEST(Report, load_factor_stands_in_where_nothing_is_pushed) {
  Result result = scenes::sample_result();
  result.responses = {};
  result.load_factor = 0.25;
  result.curve_of = StageKind::kBodyForce;
  EXPECT_EQ(count(sample_head(result), "carries <b>0.25</b> of its weight"), 1);
  result.curve_of = StageKind::kPush;  // the body force is only held
  EXPECT_EQ(count(sample_head(result), "of its weight"), 0);
}

TEST(Report, damaged_data_are_refused) {
  const std::string data = data_of(scenes::sample_result());
  EXPECT_THROW(static_cast<void>(report_page(data.substr(0, data.size() / 2))), IoError);
  EXPECT_THROW(static_cast<void>(report_page("no report")), IoError);
  EXPECT_THROW(static_cast<void>(report_page("")), IoError);
}

// --- the data ------------------------------------------------------------------------------------

TEST(RunData, header_has_the_summary_and_one_entry_a_state) {
  Result result = scenes::sample_result();
  // the end once more, and a state between: labels of one state are kept together
  result.states.snapshots.push_back(result.states.snapshots.back());
  result.states.snapshots.back().label = "10 mm";
  Snapshot between = result.states.snapshots.front();
  between.label.clear();
  between.state.time = 2.0;
  result.states.frames.push_back(between);
  const Json header = header_of(data_of(result));
  EXPECT_EQ(header["kind"], "run");
  EXPECT_EQ(header["summary"]["peak_reaction_kN"], 10.0);
  ASSERT_EQ(header["frames"].size(), 2u);
  EXPECT_EQ(header["frames"][0]["labels"].size(), 0u);
  EXPECT_EQ(header["frames"][1]["labels"].size(), 3u);
  EXPECT_EQ(header["energy"].size(), 2u);
  EXPECT_EQ(header["arrays"]["frame.ux"]["count"], 2 * 2);
  EXPECT_EQ(header["arrays"]["frame.opening"]["count"], 2 * 2);
  EXPECT_EQ(header["arrays"]["curve.reaction_kN"]["count"], 4);
}

// Deformable blocks and their contacts stand behind the rigid ones in every array.
TEST(RunData, zones_go_along) {
  const ModelSpec spec = scenes::lintel_wall(LintelModel::kZones);
  const Model model = compile(spec);
  Result result;
  result.states.snapshots.push_back({"start", 0, 0, initial_state(model)});
  const Json header = header_of(run_data(spec, model, result));
  const auto held = [&](const char* name) { return header["arrays"][name]["count"].get<int>(); };
  EXPECT_EQ(header["wall"]["blocks"], model.n_block + 1);
  EXPECT_EQ(header["wall"]["bodies"], 1);
  EXPECT_EQ(held("wall.outline_begin"), model.n_block + 2);
  EXPECT_EQ(held("wall.outline_x"), held("wall.outline_y"));
  EXPECT_EQ(held("wall.zone"), 4 * model.solids.n_zone);
  EXPECT_EQ(held("wall.joint_b"), model.n_joint + model.solids.n_contact);
  EXPECT_EQ(held("frame.node_ux"), model.solids.n_node);
  EXPECT_EQ(header["wall"]["zones"], model.solids.n_zone);
  EXPECT_EQ(held("frame.zone_greater"), model.solids.n_zone);
  EXPECT_EQ(held("frame.zone_smaller"), model.solids.n_zone);
  EXPECT_EQ(held("frame.ux"), model.n_block + 1);
  EXPECT_EQ(held("frame.opening"), model.n_joint + model.solids.n_contact);
}

// The keys of a material as the model file has them; each is given a value.
struct MaterialKeys {
  std::vector<std::string> names;
  void quantity(const char* name, double& value, const io::Key&) {
    names.emplace_back(name);
    value = 1;
  }
  void number(const char* name, double& value, const io::Key& key) { quantity(name, value, key); }
  template <class E, std::size_t N>
  void choice(const char* name, E&, const Word<E> (&)[N], const io::Key&) {
    names.emplace_back(name);
  }
  void texts(const char*, std::vector<std::string>&, const io::Key&) {
  }  // origin: shown at each value
};

TEST(ModelInputs, a_value_that_was_not_given_says_rule_or_typology_with_formula_and_source) {
  ModelSpec spec;
  spec.material["unit"].origin = {
      "tensile_strength 0.6 MPa: derived by unit_ft_from_fb from unit_strength 15 MPa (typical of "
      "clay_brick_old), unit_type clay"};
  spec.material["joint"].origin = {
      "cohesion 0.15 MPa: typical of tuff_pozzolanic (Pulatsu et al. 2022)",
      "friction_angle 30 deg: given as friction_tan 0.577", "no line of origin"};
  spec.masonry.unit_strength = 15e6;
  const Json inputs = model_inputs(spec, scenes::sample_model());
  const Json& rows = inputs["origins"];
  ASSERT_EQ(rows.size(), 3U);
  EXPECT_EQ(rows[0], Json({"joint", "cohesion", "0.15 MPa", "typical", "tuff_pozzolanic", "",
                           "Neapolitan tuff in pozzolanic mortar", "Pulatsu et al. 2022"}));
  EXPECT_EQ(rows[1][4], "friction_tan 0.577");
  EXPECT_EQ(rows[2][4], "unit_ft_from_fb");
  EXPECT_EQ(rows[2][5], "unit_strength 15 MPa (t: clay_brick_old), unit_type clay");
  EXPECT_EQ(rows[2][6].get<std::string>().substr(0, 10), "ft = c2 fb");
  EXPECT_EQ(inputs["masonry"], Json::array({{"unit_strength", 15.0, "MPa"}}));
}

// Every key of [masonry] is shown, with its name in each language.
TEST(ModelInputs, every_key_of_the_tests_of_masonry_is_shown) {
  ModelSpec spec;
  MaterialKeys keys;
  io::describe(keys, spec.masonry);
  spec.masonry.unit_type = UnitType::kClay;
  std::vector<std::string> shown;
  const Json inputs = model_inputs(spec, scenes::sample_model());
  for (const Json& row : inputs["masonry"]) {
    shown.push_back(row[0]);
    for (const std::string& language : languages())
      EXPECT_NO_THROW(static_cast<void>(Texts(language).say("input." + shown.back())));
  }
  std::sort(shown.begin(), shown.end());
  std::sort(keys.names.begin(), keys.names.end());
  EXPECT_EQ(shown, keys.names);
}

TEST(ModelInputs, every_key_of_a_material_is_shown_in_kilonewtons_and_megapascals) {
  ModelSpec spec;
  MaterialKeys keys;
  io::describe(keys, spec.material["joint"]);
  ASSERT_GE(keys.names.size(), 20u);
  const Json materials = model_inputs(spec, scenes::sample_model())["materials"];
  std::vector<std::string> shown;
  for (const Json& row : materials["rows"]) shown.push_back(row[0]);
  std::sort(shown.begin(), shown.end());
  std::sort(keys.names.begin(), keys.names.end());
  EXPECT_EQ(shown, keys.names);
  for (const Json& row : materials["rows"]) {
    const std::string unit = row[1];
    EXPECT_FALSE(unit == "Pa" || unit == "N" || unit == "N/m" || unit.rfind("GPa", 0) == 0) << row;
    for (const std::string& language : languages())
      EXPECT_NO_THROW(static_cast<void>(Texts(language).say("input." + row[0].get<std::string>())));
    EXPECT_FALSE(row[2][0].is_null()) << row;
  }
}

TEST(LimitReport, headline_says_the_weakest_mechanism_and_the_bracket) {
  const std::string found = R"({
    "mechanisms": [
      {"mode": "FM-1", "hypothesis": "infinite", "force_at_rest_kN": 180.0},
      {"mode": "FM-4", "hypothesis": "macro_block_2", "force_at_rest_kN": 151.5}],
    "limit_loads": [{"name": "dry", "static_kN": 90.0}, {"name": "bonded", "static_kN": 240.0}],
    "comparison": {"bounds": [{"holds": true}, {"holds": false}]}})";
  const std::string data = limit_data(scenes::sample_spec(), scenes::sample_model(), found);
  const std::string head = static_part(report_page(data));
  EXPECT_EQ(count(head, "<b>FM-4</b>: <b>152\u202fkN</b> (Macro-Block 2: foot hinges moved"), 1);
  EXPECT_EQ(count(head, "between <b>90\u202fkN</b> and <b>240\u202fkN</b>"), 1);
  EXPECT_EQ(count(head, "rate effect included: 1. That is an error"), 1);
  EXPECT_EQ(count(head, "class=\"card\""), 3);
  const std::string nothing = R"({"mechanisms": [], "limit_loads": [], "comparison": null})";
  const std::string page = report_page(limit_data({}, scenes::sample_model(), nothing));
  EXPECT_EQ(count(static_part(page), "Nothing was asked for"), 1);
}

// A page is sent about: of the compared folder it holds the name alone.
TEST(LimitReport, no_folder_of_this_machine_goes_along) {
  for (const std::string with : {"/home/someone/out/runs", "/home/someone/out/runs/"}) {
    const std::string found = R"({"mechanisms": [], "limit_loads": [],
      "notes": [")" + with + R"( is of another wall"],
      "notes_message": [{"code": "limit.another_wall", "arguments": {"with": ")" +
                              with + R"("}}],
      "comparison": {"with": ")" +
                              with + R"(", "bounds": []}})";
    const Json opinion =
        header_of(limit_data(scenes::sample_spec(), scenes::sample_model(), found))["opinion"];
    EXPECT_EQ(opinion["comparison"]["with"], "runs");
    EXPECT_TRUE(opinion["notes"][0][0].get<std::string>().starts_with("runs is of another wall"))
        << opinion["notes"];
  }
}

TEST(Bundle, rounding_is_within_half_a_step_and_says_its_step) {
  Bundle bundle;
  bundle.header["kind"] = "test";
  const std::vector<double> values = {-0.05, 0.05, 1e-4, kUnset, 0};
  bundle.add_rounded("x", values);
  const Json place = header_of(bundle.packed())["arrays"]["x"];
  EXPECT_EQ(place["type"], "int16");
  EXPECT_DOUBLE_EQ(place["step"], 0.05 / 32767);
  bundle.add_rounded("zeros", std::vector<double>{0, 0});
  EXPECT_EQ(header_of(bundle.packed())["arrays"]["zeros"]["step"], 1.0);
  EXPECT_EQ(header_of(bundle.packed())["arrays"]["zeros"]["at"].get<int>() % 8, 0);
}

// One step for all would make 1e-6 beside 0.2 a number of two digits.
TEST(Bundle, rows_are_rounded_each_by_itself) {
  Bundle bundle;
  bundle.header["kind"] = "test";
  bundle.add_rounded("x", std::vector<double>{1e-6, -5e-7, 0, 0, 0.2, 0.1}, 3);
  const Json place = header_of(bundle.packed())["arrays"]["x"];
  EXPECT_EQ(place["count"], 6);
  ASSERT_EQ(place["steps"].size(), 3U);
  EXPECT_DOUBLE_EQ(place["steps"][0], 1e-6 / 32767);
  EXPECT_DOUBLE_EQ(place["steps"][1], 1);
  EXPECT_DOUBLE_EQ(place["steps"][2], 0.2 / 32767);
  EXPECT_FALSE(place.contains("step"));
  bundle.add_rounded("none", std::vector<double>{}, 0);
  EXPECT_EQ(header_of(bundle.packed())["arrays"]["none"]["count"], 0);
}

TEST(Bundle, states_that_do_not_fit_are_thinned_but_for_those_with_labels) {
  const auto shown = [](const std::vector<bool>& labelled, int most) {
    std::string marks;
    for (const bool one : states_shown(labelled, most)) marks += one ? 'x' : '-';
    return marks;
  };
  const std::vector<bool> run = {true, false, false, false, false, true, false, false, true};
  EXPECT_EQ(shown(run, 100), "xxxxxxxxx");
  EXPECT_EQ(shown(run, 9), "xxxxxxxxx");
  EXPECT_EQ(shown(run, 6), "x-x-xx-xx");
  EXPECT_EQ(shown(run, 2), "x----x--x");  // what has a label is shown
  EXPECT_EQ(shown({}, 0), "");
  EXPECT_EQ(shown({true}, 0), "x");
}

TEST(Bundle, shares_become_bytes) {
  EXPECT_EQ(share_byte(0), 0);
  EXPECT_EQ(share_byte(1), 255);
  EXPECT_EQ(share_byte(-3), 0);
  EXPECT_EQ(share_byte(7), 255);
  EXPECT_EQ(share_byte(0.5), 128);
}

TEST(Texts, words_are_translated_and_numbers_localised) {
  const Texts italian("it"), english("en");
  EXPECT_EQ(italian.phrase("left pier"), "maschio sinistro");
  EXPECT_EQ(italian.phrase("pier shear + pier rocking"),
            "taglio nei maschi + oscillazione dei maschi");
  EXPECT_EQ(italian.phrase("something else"), "something else");
  EXPECT_EQ(english.phrase("left pier"), "left pier");
  EXPECT_EQ(italian.quantity(1.5, "mm"), "1,5\u202fmm");
  EXPECT_EQ(italian.quantity(kUnlimited, "MPa"), "illimitata");
}

TEST(Html, a_sentence_begins_with_a_capital_in_every_language) {
  EXPECT_EQ(sentence("picco"), "Picco.");
  EXPECT_EQ(sentence("étage souple"), "Étage souple.");
  EXPECT_EQ(sentence("über"), "Über.");
  EXPECT_EQ(sentence("ñandú!"), "Ñandú!");
  EXPECT_EQ(sentence("Été"), "Été.");
  EXPECT_EQ(sentence("÷2"), "÷2.");
  EXPECT_EQ(sentence("λ"), "λ.");
  EXPECT_EQ(sentence(""), "");
}

TEST(Texts, a_value_that_looks_like_a_place_stays) {
  EXPECT_EQ(Texts("en").say("run.resists", {{"force", "{at}"}, {"at", "1 mm"}, {"drift", ""}}),
            "The wall resists {at} at 1 mm.");
  EXPECT_EQ(Texts("en").say("run.resists", {{"force", "1 kN"}}),
            "The wall resists 1 kN at {at}{drift}.");
}

TEST(Texts, a_page_has_those_of_its_language_beside_the_english_ones) {
  for (const std::string& language : languages()) {
    const std::string text = texts_for_page(language);
    EXPECT_EQ(text.find('<'), std::string::npos);
    const Json table = Json::parse(text);
    const Texts texts(language);
    const std::size_t place = texts.place();
    EXPECT_EQ(table["languages"], languages());
    EXPECT_FALSE(table["texts"].contains("studio.title"));
    const Json& row = table["texts"]["kind.run"];
    ASSERT_EQ(row.size(), place + 1);
    EXPECT_EQ(row[0], Texts("en").say("kind.run"));
    EXPECT_EQ(row[place], texts.say("kind.run"));
    for (std::size_t k = 1; k < place; ++k) EXPECT_TRUE(row[k].is_null());
    if (place > 0) {
      EXPECT_EQ(table["phrases"]["rocking"][place - 1], texts.phrase("rocking"));
    }
  }
}

TEST(Said, a_message_is_a_text_in_each_language) {
  EXPECT_EQ(translated(Message{"event.peak"}),
            Json({"peak", "picco", "Maximum", "pic", "pico", "pico"}));
  EXPECT_EQ(translated(as_text("theirs")), "theirs");
  EXPECT_EQ(translated(Message{}), "");
}

// A text that a file has in English and as data is on a page in every language.
TEST(Said, data_beside_a_text_take_its_place) {
  Json json = Json::parse(R"({"peak": 7, "reason": "peak", "reason_message": {"code": "event.peak"},
    "old": "as it was", "rows": [{"why": "x", "why_message": {"code": "no.such_code"}}],
    "notes": ["peak", "plain"], "notes_message": [{"code": "event.peak"}, null]})");
  translate_messages(json);
  EXPECT_EQ(json["peak"], 7);
  EXPECT_EQ(json["reason"][0], "peak");
  EXPECT_EQ(json["reason"][1], "picco");
  EXPECT_EQ(json["reason"].size(), languages().size());
  EXPECT_EQ(json["old"], "as it was");
  EXPECT_EQ(json["rows"].dump(), R"([{"why":"x"}])");
  EXPECT_EQ(json["notes"][0], json["reason"]);
  EXPECT_EQ(json["notes"][1], "plain");
  EXPECT_EQ(json.size(), 5U);
}

TEST(Said, of_many_parts_the_first_three_are_told) {
  std::vector<Message> parts(5, Message{"part.left_pier"});
  EXPECT_EQ(text_of(shortened({"mode.parts", {{"parts", parts}}})),
            "left pier; left pier; left pier; 2 more parts show damage");
}

// Every response a campaign has can be named and explained in every language.
TEST(Texts, every_quantity_has_its_words) {
  for (const std::string& language : languages()) {
    const Texts texts(language);
    for (const Quantity& q : quantities()) {
      const std::string key = std::string("quantity.") + q.name;
      EXPECT_NO_THROW(EXPECT_NE(texts.say(key), "") << key) << key;
      EXPECT_NO_THROW(EXPECT_NE(texts.say(key + ".means"), "") << key) << key;
    }
  }
}

// --- pictures ------------------------------------------------------------------------------------

TEST(WallPicture, damage_is_drawn_where_the_state_has_it) {
  const WallPicture picture = draw_wall(scenes::sample_model(), scenes::sample_state(), 10);
  EXPECT_EQ(picture.open + picture.slipped + picture.closed + picture.softening, 1);
  EXPECT_EQ(picture.slipped, 1);  // 3 mm of slip against 0.3 mm of opening
  EXPECT_EQ(count(picture.svg, "class=\"crack slip\""), 1);
  EXPECT_EQ(count(picture.svg, "class=\"timber\""), 1);
  EXPECT_EQ(count(picture.svg, "class=\"arrow\""), 1);
  EXPECT_EQ(unclosed_tag(picture.svg), "");
}

TEST(WallPicture, a_sound_wall_has_no_cracks) {
  State state = scenes::sample_state();
  for (auto* values : {&state.ux, &state.uy, &state.theta, &state.kappa, &state.crush,
                       &state.plastic_slip, &state.slip, &state.shear_damage})
    for (double& value : *values) value = 0;
  const WallPicture picture = draw_wall(scenes::sample_model(), state, 1);
  EXPECT_EQ(count(picture.svg, "crack"), 0);
  EXPECT_EQ(picture.crushed, 0);
}

TEST(WallPicture, alone_it_is_a_document_with_its_own_style) {
  const std::string svg = wall_svg(scenes::sample_model(), scenes::sample_state(), 1);
  EXPECT_EQ(svg.rfind("<?xml", 0), 0u);
  EXPECT_EQ(count(svg, "<style>"), 1);
  EXPECT_EQ(unclosed_tag(svg), "");
}

// --- what holds a wall -----------------------------------------------------------------------

TEST(ReportLinks, are_drawn_with_their_forces_and_stand_in_the_page_s_data) {
  ModelSpec spec = scenes::tied(scenes::small_wall());
  spec.stage.resize(1);
  StoreySpec storey;
  storey.name = "<ground>";
  storey.height = spec.wall.height;
  spec.storey = {storey};
  const Model model = compile(spec);
  State state = initial_state(model);
  Result result = solve(model, state);
  result.states.snapshots = {{"end", 0, 0, state}};
  const std::string svg = wall_svg(model, state, 1);
  EXPECT_EQ(unclosed_tag(svg.substr(svg.find("<svg"))), "");
  EXPECT_EQ(count(svg, "class=\"link tie"), 2);
  EXPECT_EQ(count(svg, "class=\"link diaphragm"), 2);
  EXPECT_EQ(count(svg, "class=\"link spring"), 1);
  EXPECT_EQ(count(wall_svg(model, initial_state(model), 1), "link tie slack"), 2);
  EXPECT_EQ(count(svg, "link tie slack"), read_links(model, state)[1].force > 0 ? 0 : 1);
  EXPECT_EQ(count(svg, "class=\"level\""), 1);
  EXPECT_NE(svg.find("<title>across: +"), std::string::npos);
  const Json header = header_of(run_data(spec, model, result));
  ASSERT_EQ(header["wall"]["links"].size(), 5U);
  EXPECT_EQ(header["wall"]["links"][1]["a"], -1) << "an anchor that does not move";
  EXPECT_EQ(header["wall"]["storeys"][0]["name"], "<ground>");
  EXPECT_EQ(header["arrays"]["frame.link_force"]["count"].get<std::size_t>() %
                header["wall"]["links"].size(),
            0U);
  const Json& carried = header["inputs"]["carried"];
  ASSERT_EQ(carried.size(), 4U);
  EXPECT_EQ(carried[0]["kind"], "tie");
  EXPECT_EQ(carried[2]["kind"], "diaphragm");
  EXPECT_EQ(carried[3]["kind"], "spring");
}

TEST(ReportInputs, floors_ring_beams_sills_and_storeys_stand_in_the_list) {
  ModelSpec spec = scenes::small_wall();
  spec.material["concrete"] = scenes::paper_joint();
  spec.material["concrete"].density = 2500;
  spec.material["concrete"].youngs_modulus = 30e9;
  spec.material["concrete"].shear_modulus = 12e9;
  RingBeamSpec ring;
  ring.y = 0.77;
  ring.height = 0.11;
  ring.material = "concrete";
  spec.ring_beam = {ring};
  FloorSpec floor;
  floor.y = 0.88;
  floor.load = 10e3;
  spec.floor = {floor};
  const Model model = compile(spec);
  const Json inputs = model_inputs(spec, model);
  ASSERT_EQ(inputs["carried"].size(), 2U);
  EXPECT_EQ(inputs["carried"][0]["kind"], "ring_beam");
  EXPECT_EQ(inputs["carried"][0]["where"], "y = 0.77 m");
  EXPECT_EQ(inputs["carried"][1]["rows"][0], Json({"line_load", 10.0, "kN/m"}));
  const std::string svg = wall_svg(model, initial_state(model), 1);
  EXPECT_GE(count(svg, "class=\"plate\""), 1);
}

}  // namespace
}  // namespace wythe::report_test
