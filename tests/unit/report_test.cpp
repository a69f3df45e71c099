// The report of a hand-made run: text is escaped, tags close, marks are as many as the state has.
#include <gtest/gtest.h>

#include <regex>
#include <string>
#include <vector>

#include "report/curve_svg.h"
#include "report/html.h"
#include "report/svg.h"
#include "report/wall_picture.h"
#include "scenes/sample_run.h"
#include "wythe/report.h"

namespace wythe {
namespace {

using namespace report;

int count(const std::string& text, const std::string& part) {
  int n = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
  return n;
}

// "" when every tag is closed in order, else the tag at fault; void elements of HTML need no end.
std::string unclosed_tag(const std::string& markup) {
  static const std::regex kTag(R"(<(/?)([a-zA-Z][a-zA-Z0-9]*)((?:"[^"]*"|[^"<>])*?)(/?)>)");
  std::vector<std::string> open;
  for (std::sregex_iterator it(markup.begin(), markup.end(), kTag), end; it != end; ++it) {
    const std::string name = (*it)[2];
    if (name == "meta" || (*it)[4] == "/") continue;
    if ((*it)[1] != "/") {
      open.push_back(name);
    } else {
      if (open.empty() || open.back() != name) return "/" + name;
      open.pop_back();
    }
  }
  return open.empty() ? "" : open.back();
}

std::string sample_page() {
  return run_report(scenes::sample_spec(), scenes::sample_model(), scenes::sample_result());
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

TEST(Svg, ticks_are_round_and_within_the_range) {
  EXPECT_EQ(ticks(0, 50, 10), (std::vector<double>{0, 5, 10, 15, 20, 25, 30, 35, 40, 45, 50}));
  const std::vector<double> signed_ticks = ticks(-0.35, 0.35, 5);
  EXPECT_DOUBLE_EQ(signed_ticks.front(), -0.2);
  EXPECT_DOUBLE_EQ(signed_ticks.back(), 0.2);
  EXPECT_EQ(ticks(1, 1, 5).size(), 1u);
}

TEST(Report, tags_close_in_order) { EXPECT_EQ(unclosed_tag(sample_page()), ""); }

TEST(Report, no_name_reaches_the_page_as_markup) {
  const std::string page = sample_page();
  EXPECT_EQ(count(page, "<script"), 0);
  EXPECT_EQ(count(page, "&lt;script&gt;alert(1)"), 2);  // title and heading
}

TEST(Report, page_needs_nothing_from_outside) {
  const std::string page = sample_page();
  EXPECT_EQ(count(page, "src="), 0);
  EXPECT_EQ(count(page, "url("), 0);
  EXPECT_EQ(count(page, "href="), 0);
}

TEST(Report, headline_says_force_displacement_and_mode) {
  const std::string page = sample_page();
  EXPECT_EQ(
      count(page, "The wall resists <b>10\u202fkN</b> at <b>2\u202fmm</b> (1.33\u202f% drift)"), 1);
  EXPECT_EQ(count(page, "slides on the bed joint"), 1);
}

TEST(Report, a_run_that_went_wrong_says_so) {
  Result result = scenes::sample_result();
  EXPECT_EQ(count(sample_page(), "class=\"warning\""), 0);
  result.status = SolveStatus::kUnstable;
  result.reason = "kinetic energy <grew>";
  const std::string page = run_report(scenes::sample_spec(), scenes::sample_model(), result);
  EXPECT_EQ(count(page, "class=\"warning\""), 1);
  EXPECT_EQ(count(page, "kinetic energy &lt;grew&gt;"), 1);
}

TEST(Report, an_empty_result_still_makes_a_page) {
  Result result;
  const std::string page = run_report(ModelSpec{}, scenes::sample_model(), result);
  EXPECT_EQ(unclosed_tag(page), "");
  EXPECT_EQ(count(page, "nothing pushed it"), 1);
}

TEST(CurvePicture, marks_as_many_as_events_and_no_stray_numbers) {
  Result result = scenes::sample_result();
  result.events.push_back(result.events.front());
  const std::string svg = curve_svg(result);
  EXPECT_EQ(count(svg, "class=\"mark\""), 2);
  EXPECT_EQ(count(svg, "class=\"peak\""), 2);  // the peak and the 80 % crossing
  EXPECT_EQ(count(svg, "nan"), 0);
  result.responses.censored_80 = true;
  EXPECT_EQ(count(curve_svg(result), "class=\"peak\""), 1);
}

TEST(CurvePicture, load_factor_stands_in_where_nothing_is_pushed) {
  Result result = scenes::sample_result();
  for (CurveRow& row : result.curve) {
    row.load_factor = row.reaction / 1e5;
    row.reaction = 0;
  }
  EXPECT_EQ(count(curve_svg(result), "load factor"), 1);
  EXPECT_EQ(count(curve_svg(scenes::sample_result()), "load factor"), 0);
}

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

}  // namespace
}  // namespace wythe
