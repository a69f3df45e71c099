// verdict_page(): the page of `wythe assess`, plain HTML that needs no script. One sheet of A4 with the sentence
// first, then what each wall did.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/check.h"
#include "report/html.h"
#include "report/style.h"
#include "report/svg.h"
#include "report/texts.h"
#include "wythe/report.h"
#include "wythe/verdict.h"

namespace wythe {
namespace {

using namespace report;

constexpr double kToG = 1 / kStandardGravity;

constexpr const char* kStyle = R"css(
body{margin:0;background:var(--paper);color:var(--ink);font:15px/1.45 system-ui,"Segoe UI",Roboto,Helvetica,Arial,sans-serif}
main{max-width:190mm;margin:0 auto;padding:6mm 5mm}
header{display:flex;flex-wrap:wrap;gap:2mm 6mm;justify-content:space-between;align-items:baseline;border-bottom:2px solid var(--ink);padding-bottom:2mm}
h1{font-size:1.35em;margin:0}h2{font-size:1.02em;margin:5mm 0 1.5mm}
.facts{color:var(--soft);margin:0;font-size:.9em}
.verdict{border-left:5px solid var(--soft);padding:2mm 4mm;margin:4mm 0;background:color-mix(in srgb,var(--soft) 8%,transparent)}
.verdict.holds{border-color:#1a7f4b}.verdict.fails,.verdict.unsigned{border-color:var(--open)}
.verdict b{display:block;font-size:1.15em}.verdict p{margin:1mm 0 0}
.cards{display:grid;grid-template-columns:repeat(auto-fit,minmax(38mm,1fr));gap:3mm;margin:3mm 0}
.card{border:1px solid var(--hair);border-radius:2mm;padding:2mm 3mm}
.card .value{font-size:1.3em;font-weight:600}.card .name{font-weight:600;font-size:.9em}.card .means{color:var(--soft);font-size:.85em}
table{border-collapse:collapse;width:100%;font-size:.9em}th,td{text-align:right;padding:.7mm 2mm;border-bottom:1px solid var(--hair);font-variant-numeric:tabular-nums}
th{font-weight:600;vertical-align:bottom}.left{text-align:left}tr.decides td{font-weight:600}
.wide{overflow-x:auto}.wide svg{min-width:150mm}td:not(.left){white-space:nowrap}a{color:inherit}ul{margin:1mm 0;padding-left:5mm}li{margin:.5mm 0}.small{font-size:.85em;color:var(--soft)}
.signature{display:flex;justify-content:space-between;align-items:flex-end;margin-top:7mm;font-size:.85em;color:var(--soft)}
.signature span:last-child{border-top:1px solid var(--ink);width:60mm;text-align:center}
.dot{fill:var(--curve);fill-opacity:.45;stroke:var(--curve)}.dot.fails{fill:var(--open);stroke:var(--open);fill-opacity:.45}
.dot.bound{fill:none}.asked{stroke:var(--open);stroke-width:1.6;stroke-dasharray:5 3}.span{stroke:var(--ink);stroke-width:2.2}
figure{margin:2mm 0}figcaption{font-size:.85em;color:var(--soft)}
@media print{.wide svg{min-width:0}@page{size:A4;margin:12mm}:root{--paper:#fff;--ink:#111;--soft:#555;--hair:#ccc}body{font-size:9.5pt}main{max-width:none;padding:0}
.appendix{break-before:page}tr,li,.card{break-inside:avoid}}
)css";

class VerdictPage {
 public:
  VerdictPage(const WallsVerdict& verdict, const ProjectSpec& project, const std::string& language)
      : v_(verdict), project_(project), language_(language), texts_(language) {}

  std::string all() {
    std::string page = fmt::format(
        "<!doctype html>\n<html lang=\"{}\">\n<head>\n<meta charset=\"utf-8\">\n<meta "
        "name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>{}: "
        "wythe</title>\n<style>{}{}</style>\n</head>\n<body>\n<main>\n",
        language_, title(), picture_style(), kStyle);
    page += head() + verdict() + cards() + cautions();
    if (!v_.ways.empty()) page += ways() + limit_states();
    page += notes() + signature();
    if (!v_.ways.empty()) page += walls();
    return page + "</main>\n</body>\n</html>\n";
  }

 private:
  [[nodiscard]] std::string say(const char* key, Places places = {}) const {
    return texts_.say(key, places);
  }
  // Three decimals, so that numbers below each other compare.
  [[nodiscard]] std::string fixed(double value, const char* unit) const {
    std::string text = fmt::format("{:.3f}", value);
    if (language_ == "it") std::replace(text.begin(), text.end(), '.', ',');
    return *unit == 0 ? text : text + "\u202f" + unit;
  }
  [[nodiscard]] std::string g(double acceleration) const { return fixed(acceleration * kToG, "g"); }
  [[nodiscard]] std::string words(const Message& message) const {
    return sentence(text_of(message, language_));
  }
  [[nodiscard]] std::string title() const {
    return project_.title.empty() ? say("assess.kind") : escaped(project_.title);
  }

  [[nodiscard]] std::string head() const {
    std::string facts;
    for (const auto& [key, text] :
         {std::pair("place", &project_.place), std::pair("client", &project_.client),
          std::pair("author", &project_.author), std::pair("date", &project_.date)})
      if (!text->empty())
        facts += fmt::format("{}{}: {}", facts.empty() ? "" : " · ",
                             texts_.say(std::string("sheet.") + key), escaped(*text));
    return fmt::format(
        "<header><div><h1>{}</h1><p class=\"facts\">{}</p></div><p "
        "class=\"facts\">{}</p></header>\n",
        title(), facts, project_.title.empty() ? "" : say("assess.kind"));
  }

  // Met or not in a word, then the sentence.
  [[nodiscard]] std::string verdict() const {
    const char* key = "assess.undecided";
    if (v_.verdict == AssessmentVerdict::kHolds) key = "assess.holds";
    if (v_.verdict == AssessmentVerdict::kFails) key = "assess.fails";
    std::string state =
        texts_.say("assessment." + std::string(word_of(kLimitStateWords, v_.worst.state)));
    state[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(state[0])));
    std::string standing = v_.verdict == AssessmentVerdict::kNotKnown
                               ? say("assess.unknown")
                               : say(key, {{"state", state}});
    if (!v_.may_be_signed) standing += " " + say("assess.unsigned");
    const Message* said = &v_.sentence;  // without its cautions, which follow in a list
    if (v_.sentence.code == "assessment.unsigned")
      for (const Argument& argument : v_.sentence.arguments)
        if (argument.name == "verdict")
          said = &std::get<std::vector<Message>>(argument.value).front();
    return fmt::format(
        "<section class=\"verdict {}\" id=\"verdict\"><b>{}</b><p "
        "id=\"sentence\">{}</p></section>\n",
        v_.may_be_signed ? key : "unsigned", standing, words(*said));
  }

  // "0.14 to 0.24 g"; "" without an interval.
  [[nodiscard]] std::string interval(const Interval& of, double scale, const char* unit) const {
    if (std::isnan(of.low)) return "";
    if (std::isinf(of.high)) return say("assess.or_more", {{"from", fixed(of.low * scale, unit)}});
    return say("assess.between",
               {{"from", fixed(of.low * scale, "")}, {"to", fixed(of.high * scale, unit)}});
  }
  [[nodiscard]] std::string median(const WallCapacity& c, double scale, const char* unit) const {
    const std::string value = fixed(c.median.value * scale, unit);
    return c.at_least ? say("assess.at_least", {{"value", value}}) : value;
  }

  [[nodiscard]] static std::string not_met_of(const WallCounts& counts) {
    return fmt::format("{} / {}", counts.not_met, counts.met + counts.not_met);
  }

  [[nodiscard]] std::string cards() const {
    if (v_.verdict == AssessmentVerdict::kNotKnown) return "";
    const auto card = [](const std::string& value, const std::string& name,
                         const std::string& means) {
      return fmt::format(
          "<div class=\"card\"><div class=\"value\">{}</div><div class=\"name\">{}</div><div "
          "class=\"means\">{}</div></div>\n",
          value, name, means);
    };
    const double demand = v_.worst.demand;
    const WallCapacity& capacity = v_.worst.capacity;
    const auto more = [&](const std::string& range, const std::string& means) {
      return range.empty() ? means : range + "; " + means;
    };
    const Interval share = v_.worst.counts.with_tests();
    const auto percent = [&](double x) { return texts_.quantity(100 * x, "%", 2); };
    return "<section class=\"cards\">\n" +
           card(median(capacity, kToG, "g"), say("assess.capacity"),
                more(interval(capacity.with_tests, kToG, "g"), say("assess.capacity.means"))) +
           card(g(demand), say("assess.demand"), say("assess.demand.means")) +
           card(median(capacity, 1 / demand, ""), say("assess.index"),
                more(interval(capacity.with_tests, 1 / demand, ""), say("assess.index.means"))) +
           card(not_met_of(v_.worst.counts), say("assess.share"),
                say("assess.share.means",
                    {{"from", percent(share.low)}, {"to", percent(share.high)}})) +
           "</section>\n";
  }

  [[nodiscard]] std::string list(const std::vector<Message>& messages) const {
    std::string out = "<ul>\n";
    for (const Message& message : messages) out += "<li>" + words(message) + "</li>\n";
    return out + "</ul>\n";
  }
  [[nodiscard]] std::string cautions() const {
    if (v_.cautions.empty()) return "";
    return "<h2>" + say("assess.why") + "</h2>\n" + list(v_.cautions);
  }
  [[nodiscard]] std::string notes() const {
    if (v_.notes.empty()) return "";
    return "<h2>" + say("assess.assumed") + "</h2>\n<div class=\"small\">" + list(v_.notes) +
           "</div>\n";
  }

  [[nodiscard]] std::string name_of(const WayOfPushing& way) const {
    return escaped(way.direction + ", " + text_of(words_of_pattern(way.pattern), language_));
  }

  [[nodiscard]] std::string ways() const {
    std::string rows;
    for (const WayOfPushing& way : v_.ways) {
      const bool decides = way.direction == v_.worst.direction && way.pattern == v_.worst.pattern;
      rows += fmt::format(
          "<tr{}><td class=\"left\"><a href=\"{}/report.html\">{}</a>{}</td><td>{}</td><td>{}</td>"
          "<td>{}</td><td>{}</td><td>{}</td></tr>\n",
          decides ? " class=\"decides\"" : "", escaped(way.folder), name_of(way),
          decides ? " (" + say("assess.decides") + ")" : "", median(way.capacity, kToG, "g"),
          interval(way.capacity.with_tests, kToG, "g"), not_met_of(way.counts),
          way.counts.not_shown, way.counts.lost);
    }
    return "<h2>" + say("assess.ways") + "</h2>\n" + figure() +
           "<div class=\"wide\"><table><tr><th class=\"left\">" + say("assess.way") + "</th><th>" +
           say("assess.median") + "</th><th>" + say("assess.interval") + "</th><th>" +
           say("assess.not_met") + "</th><th>" + say("assess.not_shown") + "</th><th>" +
           say("assess.lost") + "</th></tr>\n" + rows + "</table></div>\n";
  }

  // A row of dots for each way: what its walls carry, against the demand.
  [[nodiscard]] std::string figure() const {
    constexpr double kWidth = 700, kRow = 30, kLeft = 250, kRight = 20, kFoot = 34;
    const double demand = std::isnan(v_.worst.demand) ? 0 : v_.worst.demand * kToG;
    double most = 1.15 * demand;
    for (const WayOfPushing& way : v_.ways)
      for (const JudgedWall& wall : way.walls)
        if (const Reading r = wall.capacity(v_.worst.state); r.is_known())
          most = std::fmax(most, 1.05 * r.value * kToG);
    if (!(most > 0)) return "";
    const double height = kRow * static_cast<double>(v_.ways.size()) + kFoot;
    const Axis X = Axis::between(0, most, kLeft, kWidth - kRight);
    std::string out =
        "<figure><div class=\"wide\">" + svg_begin(kWidth, height, "curve", say("assess.figure"));
    const double foot = height - kFoot;
    for (const double tick : ticks(0, most, 6)) {
      out += line({X(tick), 0}, {X(tick), foot}, "grid");
      out += label({X(tick), foot + 14}, texts_.number(tick), "small", "middle");
    }
    const bool is_right =
        demand > 0.5 * most;  // the demand's own label: the axis goes to the other end
    out += label({is_right ? kLeft : kWidth - kRight, foot + 29}, "PGA, g", "small",
                 is_right ? "start" : "end");
    double y = 0.5 * kRow;
    for (const WayOfPushing& way : v_.ways) {
      out += label({0, y + 4}, name_of(way), "");
      const Interval& of = way.capacity.with_tests;
      if (std::isfinite(of.low))
        out += line({X(of.low * kToG), y + 9},
                    {std::isfinite(of.high) ? X(of.high * kToG) : kWidth - kRight, y + 9}, "span");
      for (const JudgedWall& wall : way.walls) {
        const Reading r = wall.capacity(v_.worst.state);
        if (!r.is_known()) continue;
        const char* kind =
            wall.verdict(v_.worst.state) == AssessmentVerdict::kFails ? "dot fails" : "dot";
        out += circle({X(r.value * kToG), y}, 4.5, r.censored ? "dot bound" : kind);
      }
      y += kRow;
    }
    if (demand > 0) {
      out += line({X(demand), 0}, {X(demand), foot + 4}, "asked");
      out += label({X(demand), foot + 29}, say("assess.demand") + " " + texts_.number(demand),
                   "small bold", "middle");
    }
    return out + "</svg></div><figcaption>" + say("assess.figure") + "</figcaption></figure>\n";
  }

  // Each limit state against its own spectrum, with its risk index.
  [[nodiscard]] std::string limit_states() const {
    if (v_.limit_states.empty()) return "";
    std::string rows;
    for (const StateVerdict& of : v_.limit_states) {
      const WallCapacity& c = of.capacity;
      const bool decides = of.is_checked && of.state == v_.worst.state;
      rows += fmt::format(
          "<tr{}><td "
          "class=\"left\">{}{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td>"
          "<td>{}</td></tr>\n",
          decides ? " class=\"decides\"" : "",
          texts_.say("assessment." + std::string(word_of(kLimitStateWords, of.state))),
          decides ? " (" + say("assess.decides") + ")" : "", median(c, kToG, "g"),
          interval(c.with_tests, kToG, "g"), of.is_checked ? g(of.demand) : "–",
          of.is_checked ? median(c, 1 / of.demand, "") : "–",
          of.is_checked ? interval(c.with_tests, 1 / of.demand, "") : "",
          of.is_checked ? not_met_of(of.counts) : "–");
    }
    return "<h2>" + say("assess.states") +
           "</h2>\n<div class=\"wide\"><table><tr><th class=\"left\">" + say("assess.state") +
           "</th><th>" + say("assess.median") + "</th><th>" + say("assess.interval") + "</th><th>" +
           say("assess.demand") + "</th><th>ζE</th><th>" + say("assess.interval") + "</th><th>" +
           say("assess.not_met") + "</th></tr>\n" + rows + "</table></div>\n" + rules();
  }

  // What may end each limit state side by side: the fall of the force, the drift of each pier, q*.
  [[nodiscard]] std::string rules() const {
    std::string rows;
    for (const StateVerdict& of : v_.limit_states) {
      std::string state =
          texts_.say("assessment." + std::string(word_of(kLimitStateWords, of.state)));
      for (const RuleOfWalls& rule : of.rules) {
        rows += fmt::format(
            "<tr><td class=\"left\">{}</td><td class=\"left\">{}</td><td>{}</td><td>{} / "
            "{}</td></tr>\n",
            state, escaped(text_of(rule.words, language_)),
            texts_.quantity(1e3 * rule.displacement, "mm", 3), rule.decides, of.worst.size());
        state.clear();
      }
    }
    return "<h2>" + say("assess.rules") +
           "</h2>\n<div class=\"wide\"><table><tr><th class=\"left\">" + say("assess.state") +
           "</th><th class=\"left\">" + say("assess.rule") + "</th><th>" + say("assess.rule_at") +
           "</th><th>" + say("assess.rule_decides") + "</th></tr>\n" + rows + "</table></div>\n";
  }

  [[nodiscard]] std::string signature() const {
    return "<div class=\"signature\"><span>" + escaped(v_.program) + "</span><span>" +
           texts_.say("sheet.signature") + "</span></div>\n";
  }

  [[nodiscard]] std::string verdict_of(const JudgedWall& wall) const {
    switch (wall.verdict(v_.worst.state)) {
      case AssessmentVerdict::kHolds: return say("assess.holds.short");
      case AssessmentVerdict::kFails: return say("assess.not_met");
      case AssessmentVerdict::kNotShown: return say("assess.not_shown");
      default: return say("assess.lost");
    }
  }

  [[nodiscard]] std::string walls() const {
    std::string rows;
    for (const WayOfPushing& way : v_.ways)
      for (const JudgedWall& wall : way.walls) {
        const Reading r = wall.capacity(v_.worst.state);
        const std::string value = r.is_known() ? g(r.value) : "–";
        rows += fmt::format(
            "<tr><td class=\"left\">{}</td><td>{}</td><td>{}</td><td class=\"left\">{}</td><td "
            "class=\"left\">{}</td></tr>\n",
            name_of(way), wall.wall,
            r.censored ? say("assess.at_least", {{"value", value}}) : value, verdict_of(wall),
            wall.is_lost() ? words(wall.lost) : escaped(texts_.phrase(wall.mode)));
      }
    return "<section class=\"appendix\"><h2>" + say("assess.walls") +
           "</h2>\n<div class=\"wide\"><table><tr><th class=\"left\">" + say("assess.way") +
           "</th><th>" + say("assess.wall") + "</th><th>" + say("assess.capacity") +
           "</th><th class=\"left\">" + say("assess.verdict") + "</th><th class=\"left\">" +
           say("assess.mode") + "</th></tr>\n" + rows + "</table></div></section>\n";
  }

  const WallsVerdict& v_;
  const ProjectSpec& project_;
  const std::string& language_;
  Texts texts_;
};

}  // namespace

std::string verdict_page(const WallsVerdict& verdict, const ProjectSpec& project,
                         const std::string& language) {
  return VerdictPage(verdict, project, language).all();
}

}  // namespace wythe
