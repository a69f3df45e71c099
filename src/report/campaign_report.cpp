// campaign_report(): the sections in the order a reader asks: how strong, how far, how does it fail,
// what decides it, how sure, from what.
#include <fmt/format.h>

#include "report/campaign_charts.h"
#include "report/campaign_sections.h"
#include "report/html.h"
#include "report/style.h"
#include "wythe/provenance.h"
#include "wythe/report.h"

namespace wythe {
namespace {

using namespace report;

std::string curves_section(const Campaign& campaign, const Statistics& s) {
  if (s.answered == 0) return "";
  return "<h2>All curves</h2>\n" + mode_legend(s) + "<figure>" + curves_svg(campaign, s) +
         fmt::format(
             "<figcaption>Samples: {}, coloured by failure mode. Upper axis: drift at the "
             "load's height.</figcaption></figure>\n",
             s.answered) +
         "<details><summary>The same curves, each up to where it has fallen to 80\u202f% of its "
         "peak</summary>\n<figure>" +
         curves_svg(campaign, s, CurvesTo::k80Percent) + "</figure></details>\n";
}

std::string mean_curves_section(const Statistics& s) {
  if (s.answered < 2) return "";
  return "<h2>Mean curves by failure mode</h2>\n<figure>" + mean_curves_svg(s) +
         "<figcaption>Mean of the reactions at equal displacement; band: 5 to 95\u202f% of the "
         "curves. A line ends where less than half of its curves go on.</figcaption></figure>\n";
}

std::string head(const std::string& name) {
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<title>{}: wythe campaign</title>\n<style>{}{}{}</style>\n</head>\n<body>\n<main>\n",
      name, picture_style(), page_style(), campaign_style());
}

}  // namespace

std::string campaign_report(const Campaign& campaign, const Statistics& s) {
  const std::string name = escaped(s.study.empty() ? "Campaign" : s.study);
  std::string page = head(name);
  page += fmt::format(
      "<header>\n<p class=\"kind\">Discrete rigid block analysis, campaign</p>\n<h1>{}</h1>\n"
      "{}{}</header>\n",
      name, campaign_headline(s), campaign_warning(s));
  page += campaign_cards(s) + curves_section(campaign, s) + shares_section(s);
  page += mean_curves_section(s) + table_section(s) + capacity_section(s);
  page += influence_section(campaign, s) + precision_section(campaign, s);
  page += unanswered_section(s) + study_section(campaign, s) + replay_section(campaign, s);
  page += fmt::format(
      "<footer>wythe {}. The numbers are in statistics.json and samples.csv, the curves in "
      "campaign.db.</footer>\n",
      provenance().version);
  return page + "</main>\n</body>\n</html>\n";
}

}  // namespace wythe
