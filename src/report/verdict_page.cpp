// verdict_page(): the page of `wythe assess`, plain HTML without scripts. One sheet of A4: the sentence first, then
// the results of the walls, their basis and what is not modelled. The appendix follows (verdict_appendix.cpp).
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "core/ascii.h"
#include "judge/modes/in_space.h"
#include "judge/modes/wall_parts.h"
#include "report/html.h"
#include "report/model_inputs.h"
#include "report/style.h"
#include "report/svg.h"
#include "report/verdict_words.h"
#include "report/wall_picture.h"
#include "wythe/parts/reading.h"
#include "wythe/parts/report.h"
#include "wythe/parts/verdict.h"

namespace wythe {
namespace {

using namespace report;

constexpr const char* kStyle = R"css(
body{margin:0;background:var(--paper);color:var(--ink);font:15px/1.42 system-ui,"Segoe UI",Roboto,Helvetica,Arial,sans-serif}
main{max-width:190mm;margin:0 auto;padding:6mm 4mm}
header{border-bottom:2px solid var(--ink);padding-bottom:2mm}
h1{font-size:1.35em;line-height:1.2;margin:0;overflow-wrap:anywhere}h2{font-size:1.02em;margin:4mm 0 1mm}
.facts{color:var(--soft);margin:.5mm 0 0;font-size:.88em;overflow-wrap:anywhere}
.verdict{border-left:5px solid var(--soft);padding:2mm 4mm;margin:3mm 0;background:color-mix(in srgb,var(--soft) 8%,transparent)}
.verdict.holds{border-color:#1a7f4b}.verdict.fails,.verdict.unsigned{border-color:var(--open)}
.verdict b{display:block;font-size:1.15em}.verdict p{margin:1mm 0 0}
.cards{display:grid;grid-template-columns:repeat(auto-fit,minmax(36mm,1fr));gap:1mm 5mm;margin:3mm 0 0}
.card{border-top:1px solid var(--hair);padding-top:1mm}
.card .value{font-size:1.15em;font-weight:600;line-height:1.25}.card .name{color:var(--soft);font-size:.85em}
.pair{display:grid;grid-template-columns:repeat(auto-fit,minmax(min(75mm,100%),1fr));gap:0 6mm}
table{border-collapse:collapse;width:100%;font-size:.9em}th,td{text-align:right;padding:.6mm 2mm;border-bottom:1px solid var(--hair);font-variant-numeric:tabular-nums;vertical-align:top}
th{font-weight:600;vertical-align:bottom}.left{text-align:left}tr.decides td,.decides>b{font-weight:600}.fails{color:var(--open)}
td:first-child,th:first-child{padding-left:0}td:last-child,th:last-child{padding-right:0}
.wide{overflow-x:auto}a{color:inherit}ul{margin:.5mm 0;padding-left:4.5mm}li{margin:.4mm 0}.small{font-size:.85em}.soft{color:var(--soft)}
.way{display:flex;flex-wrap:wrap;justify-content:space-between;gap:0 4mm;font-size:.88em;margin-top:1.2mm}
svg.dots{display:block;width:100%;height:15px;overflow:visible}svg.foot{height:34px;font:12px system-ui,sans-serif}
.dot{fill:var(--curve);fill-opacity:.45;stroke:var(--curve)}.dot.fails{fill:var(--open);stroke:var(--open);fill-opacity:.45}
.dot.bound{fill:none}.asked{stroke:var(--open);stroke-width:1.6;stroke-dasharray:5 3}.span{stroke:var(--ink);stroke-width:2.2}
.part{fill:none;stroke:none}.part.hit{fill:var(--open);fill-opacity:.3;stroke:var(--open);stroke-width:1.5}
svg.wall{max-height:88mm}svg.wall text,svg.wall text.small{font-size:19px}svg.wall text.part-name{font-size:26px;font-weight:600}
.signature{display:flex;justify-content:space-between;align-items:flex-end;gap:6mm;margin-top:5mm;font-size:.8em;color:var(--soft)}
.signature .line{border-top:1px solid var(--ink);width:60mm;text-align:center}
figure{margin:1mm 0}figcaption{font-size:.85em;color:var(--soft)}.appendix{border-top:2px solid var(--ink);margin-top:8mm}
code{font-size:.95em;overflow-wrap:anywhere}
@page{size:A4;margin:11mm 12mm}
@media print{:root{--paper:#fff;--ink:#111;--soft:#555;--hair:#ccc;--open:#c04f00;--curve:#0b5c8e;--stone0:#ece2cf;--stone1:#e5d9c2;--stone2:#f0e8d9;--stone3:#dfd2b9;--mortar:#b9ab91;--split:#d8cbb2}
body{font-size:8.6pt;line-height:1.3}main{max-width:none;padding:0}.wide{overflow:visible}svg.wall{max-height:52mm}.verdict{print-color-adjust:exact;-webkit-print-color-adjust:exact}
.appendix{break-before:page;border:0;margin:0}.appendix>h2:first-child{margin-top:0}tr,li,.card,figure{break-inside:avoid}h2{break-after:avoid}thead{display:table-header-group}}
)css";

// Letters of notes that fit on the sheet beside its pictures; if there are more, all notes are moved to the appendix.
constexpr std::size_t kLettersOnSheet = 2000;

// Messages about effects that are left out, not about assumptions.
bool is_left_out(const Message& note) {
  static constexpr std::string_view kLeftOut[] = {
      "assessment.note.out_of_plane", "assessment.note.scaled",
      "assessment.note.strengths",    "assessment.note.space_drift",
      "assessment.note.whole_drift",  "assessment.note.no_record_scatter",
      "assessment.note.floor_mass",   "assessment.note.clauses",
      "verdict.note.no_tests",        "verdict.note.within_only",
      "verdict.note.parts_named",     "verdict.note.parts_named_and_found",
      "verdict.note.parts_found",     "verdict.note.parts_unchecked",
      "verdict.note.parts_held",      "verdict.note.no_parts"};
  return std::find(std::begin(kLeftOut), std::end(kLeftOut), note.code) != std::end(kLeftOut);
}

class VerdictPage {
 public:
  VerdictPage(const WallsVerdict& verdict, const ModelSpec& spec, const Model& model,
              const std::string& language)
      : v_(verdict), spec_(spec), model_(model), words_(language) {
    for (const Message& note : v_.notes) (is_left_out(note) ? left_out_ : assumed_).push_back(note);
  }

  std::string all() {
    std::string page = fmt::format(
        "<!doctype html>\n<html lang=\"{}\">\n<head>\n<meta charset=\"utf-8\">\n<meta "
        "name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>{}: "
        "wythe</title>\n<style>{}{}</style>\n</head>\n<body>\n<main>\n<div class=\"sheet\">\n",
        words_.language(), title(), picture_style(), kStyle);
    page += head() + verdict() + cards() + cautions() + pictures() + limit_states();
    const bool fits = letters_of(v_.notes) + letters_of(v_.cautions) < kLettersOnSheet;
    page += (fits ? notes() : "") + signature() + "</div>\n<section class=\"appendix\">\n" +
            (fits ? "" : notes()) + verdict_appendix(words_, v_, model_inputs(spec_, model_)) +
            "</section>\n";
    return page + "</main>\n</body>\n</html>\n";
  }

 private:
  [[nodiscard]] std::string say(const std::string& key, Places places = {}) const {
    return words_.say(key, places);
  }
  [[nodiscard]] std::string title() const {
    const std::string& own = spec_.project.title.empty() ? spec_.name : spec_.project.title;
    return own.empty() ? say("assess.kind") : escaped(own);
  }
  [[nodiscard]] std::size_t letters_of(const std::vector<Message>& messages) const {
    std::size_t letters = 0;
    for (const Message& message : messages) letters += words_.words(message).size();
    return letters;
  }

  [[nodiscard]] std::string head() const {
    const ProjectSpec& p = spec_.project;
    std::string facts;
    for (const auto& [key, text] : {std::pair("wall", p.title.empty() ? nullptr : &spec_.name),
                                    std::pair("place", &p.place), std::pair("client", &p.client),
                                    std::pair("author", &p.author), std::pair("date", &p.date)})
      if (text != nullptr && !text->empty())
        facts += fmt::format("{}{}: {}", facts.empty() ? "" : " · ",
                             say(std::string("sheet.") + key), escaped(*text));
    if (!facts.empty()) facts = "<p class=\"facts\">" + facts + "</p>";
    const std::string kind = p.title.empty() && spec_.name.empty()
                                 ? ""
                                 : "<p class=\"facts\">" + say("assess.kind") + "</p>";
    return "<header><h1>" + title() + "</h1>" + facts + kind + "</header>\n";
  }

  // "met" or "not met", then the sentence.
  [[nodiscard]] std::string verdict() const {
    const char* key = "assess.undecided";
    if (v_.verdict == AssessmentVerdict::kHolds) key = "assess.holds";
    if (v_.verdict == AssessmentVerdict::kFails) key = "assess.fails";
    const std::string state = capital(words_.state(v_.state()));
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
        v_.may_be_signed ? key + 7 : "unsigned", standing, words_.sentence_of(*said));
  }

  // Data beyond the sentence: the index, and the demand with its source.
  [[nodiscard]] std::string cards() const {
    std::string out;
    const auto card = [&](const std::string& value, const std::string& name) {
      out += "<div class=\"card\"><div class=\"value\">" + value + "</div><div class=\"name\">" +
             name + "</div></div>\n";
    };
    if (const LocalCheck* part = part_of_index())
      card(words_.fixed(part->reserve()), say("assess.index_part", {{"part", name_of(*part)}}));
    else if (v_.verdict != AssessmentVerdict::kNotKnown)
      card(words_.capacity(v_.worst.capacity, 1 / v_.worst.demand, ""), say("assess.index"));
    card(say("assess.code." + v_.spec.code), say("assess.code"));
    if (!std::isnan(v_.spec.confidence_factor)) {
      const std::string level = knowledge_level();
      card((level.empty() ? "" : escaped(level) + ", ") +
               words_.texts().number(v_.spec.confidence_factor),
           say(level.empty() ? "assess.factor" : "assess.level"));
    }
    if (!v_.ways.empty())
      card(say("assess.pushes", {{"walls", fmt::format("{}", v_.ways.front().walls.size())},
                                 {"ways", fmt::format("{}", v_.ways.size())}}),
           say("assess.pushes.means"));
    return "<section class=\"cards\">\n" + out + "</section>\n";
  }

  // The part whose index is that of the sheet; null where the pushes have it: a part that decides the verdict, or one that fails
  // with less than the pushes.
  [[nodiscard]] const LocalCheck* part_of_index() const {
    if (v_.part_decides()) return falls(v_.least_part()) ? v_.least_part() : nullptr;
    double least = v_.worst.capacity.median.value / v_.worst.demand;
    const LocalCheck* found = nullptr;
    for (const LocalCheck& part : v_.parts.checked)
      if (falls(&part) && (part.reserve() < least || std::isnan(least)))
        found = &part, least = part.reserve();
    return found;
  }

  // The knowledge level, "LC2", if the program divided the strengths of the table; a note says so.
  [[nodiscard]] std::string knowledge_level() const {
    for (const Message& note : v_.notes)
      if (note.code == "assessment.note.divided")
        for (const Argument& argument : note.arguments)
          if (argument.name == "level") return std::get<std::string>(argument.value);
    return "";
  }

  [[nodiscard]] std::string cautions() const {
    if (v_.cautions.empty()) return "";
    return "<h2>" + say("assess.why") + "</h2>\n" + words_.list(v_.cautions);
  }
  [[nodiscard]] std::string notes() const {
    if (v_.notes.empty()) return "";
    const auto part = [&](const char* key, const std::vector<Message>& of) {
      return of.empty() ? ""
                        : "<div><h2>" + say(key) + "</h2>\n<div class=\"small\">" +
                              words_.list(of) + "</div></div>\n";
    };
    return "<div class=\"pair\">\n" + part("assess.assumed", assumed_) +
           part("assess.left_out", left_out_) + "</div>\n";
  }

  // --- the wall and the capacity of each wall ----------------------------------------------------------

  [[nodiscard]] std::string pictures() const {
    if (v_.ways.empty()) return "";
    return "<div class=\"pair\">\n" + wall() + figure() + "</div>\n";
  }

  // The wall as built with the names of its piers; piers whose drift ends a limit state are shaded.
  [[nodiscard]] std::string wall() const {
    const std::vector<study::Elevation> all = study::elevations_of(model_);
    const std::vector<study::WallParts> parts = study::find_parts(model_, all);
    std::vector<study::Elevation> walls;
    std::vector<std::vector<WallMark>> marks;
    bool any = false;
    for (std::size_t k = 0; k < all.size(); ++k) {
      if (!is_judged(all[k])) continue;
      walls.push_back(all[k]);
      std::vector<WallMark>& of_wall = marks.emplace_back();
      for (const study::Pier& pier : parts[k].piers) {
        const bool hit = ends(pier.mark);
        any = any || hit;
        of_wall.push_back({.x0 = pier.box.x0,
                           .x1 = pier.box.x1,
                           .y0 = pier.box.y0,
                           .y1 = pier.box.y1,
                           .name = pier.mark,
                           .is_hit = hit});
      }
    }
    if (walls.empty()) return "";
    const std::string svg = dimension_of(model_) == 3
                                ? draw_elevations(model_, walls, marks)
                                : draw_wall(model_, initial_state(model_), 1, marks.front()).svg;
    return "<figure>" + svg + "<figcaption>" + say(any ? "assess.picture.hit" : "assess.picture") +
           "</figcaption></figure>\n";
  }
  // Whether a wall in space counts: it must stand along the push.
  [[nodiscard]] bool is_judged(const study::Elevation& wall) const {
    if (dimension_of(model_) == 2) return true;
    const auto push = std::find_if(model_.stages.rbegin(), model_.stages.rend(),
                                   [](const Stage& s) { return s.push() != nullptr; });
    return push != model_.stages.rend() && study::is_along(wall, push->drive());
  }
  // Whether the drift of this pier ends near collapse, or the deciding limit state, in any wall.
  [[nodiscard]] bool ends(const std::string& mark) const {
    const auto names_it = [&](const RuleOfWalls& rule) {
      return rule.decides > 0 &&
             std::any_of(rule.words.arguments.begin(), rule.words.arguments.end(),
                         [&](const Argument& a) {
                           const auto* text = std::get_if<std::string>(&a.value);
                           return a.name == "mark" && text != nullptr && *text == mark;
                         });
    };
    return std::any_of(v_.limit_states.begin(), v_.limit_states.end(), [&](const StateVerdict& of) {
      return std::any_of(of.rules.begin(), of.rules.end(), names_it);
    });
  }

  // A strip of dots for each way of pushing: the capacities of its walls, and the
  // demand. Positions are shares of the width, so that words keep their size on a phone.
  [[nodiscard]] std::string figure() const {
    const double demand = std::isnan(v_.worst.demand) ? 0 : v_.worst.demand * kToG;
    double most = 1.15 * demand;
    for (const WayOfPushing& way : v_.ways)
      for (const JudgedWall& wall : way.walls)
        if (const Reading r = wall.capacity(v_.worst.state); r.is_known())
          most = std::fmax(most, 1.05 * r.value * kToG);
    if (!(most > 0)) return "";
    const auto place = [&](double g) { return fmt::format("{:.2f}%", 1 + 98 * g / most); };
    std::string out = "<figure>";
    for (const WayOfPushing& way : v_.ways) {
      const bool decides = way.direction == v_.worst.direction && way.pattern == v_.worst.pattern;
      std::string name = words_.name_of(way);
      if (!way.folder.empty())
        name = fmt::format("<a href=\"{}/report.html\">{}</a>", escaped(way.folder), name);
      out += fmt::format("<div class=\"way{}\"><b>{}{}</b><span>{}</span></div>\n",
                         decides ? " decides" : "", name,
                         decides ? " (" + say("assess.decides") + ")" : "", numbers_of(way));
      out +=
          fmt::format("<svg class=\"dots\" role=\"img\" aria-label=\"{}\">", words_.name_of(way));
      if (const Interval& of = way.capacity.with_tests; std::isfinite(of.low))
        out += fmt::format("<line class=\"span\" x1=\"{}\" x2=\"{}\" y1=\"13\" y2=\"13\"/>",
                           place(of.low * kToG),
                           std::isfinite(of.high) ? place(std::fmin(of.high * kToG, most)) : "99%");
      if (demand > 0)
        out += fmt::format("<line class=\"asked\" x1=\"{0}\" x2=\"{0}\" y1=\"-3\" y2=\"17\"/>",
                           place(demand));
      for (const JudgedWall& wall : way.walls) {
        const Reading r = wall.capacity(v_.worst.state);
        if (!r.is_known()) continue;
        const bool fails = wall.verdict(v_.worst.state) == AssessmentVerdict::kFails;
        out += fmt::format("<circle class=\"{}\" cx=\"{}\" cy=\"6\" r=\"4.5\"/>",
                           r.censored ? "dot bound"
                           : fails    ? "dot fails"
                                      : "dot",
                           place(r.value * kToG));
      }
      out += "</svg>\n";
    }
    return out + axis(most, demand) + "<figcaption>" + say("assess.figure") +
           "</figcaption></figure>\n";
  }
  [[nodiscard]] std::string axis(double most, double demand) const {
    const auto at = [&](double g) { return 1 + 98 * g / most; };
    std::string out = fmt::format(
        "<svg class=\"dots foot\" role=\"img\" aria-label=\"{}\">"
        "<line class=\"axis\" x1=\"0\" x2=\"100%\" y1=\"2\" y2=\"2\"/>",
        say("assess.axis"));
    for (const double tick : ticks(0, most, 4)) {
      const char* anchor = at(tick) < 4 ? "start" : at(tick) > 96 ? "end" : "middle";
      out += fmt::format(
          "<line class=\"axis\" x1=\"{0:.2f}%\" x2=\"{0:.2f}%\" y1=\"2\" y2=\"6\"/><text "
          "class=\"small\" x=\"{0:.2f}%\" y=\"17\" text-anchor=\"{1}\">{2}</text>",
          at(tick), anchor, words_.texts().number(tick));
    }
    const bool is_right =
        demand > 0.6 * most;  // the label of the demand: the axis label goes to the other end
    out += fmt::format("<text class=\"small\" x=\"{}%\" y=\"31\" text-anchor=\"{}\">{}</text>",
                       is_right ? 0 : 100, is_right ? "start" : "end", say("assess.axis"));
    if (demand > 0)
      out += fmt::format(
          "<text class=\"small bold\" x=\"{:.2f}%\" y=\"31\" text-anchor=\"{}\">{}</text>",
          at(demand),
          at(demand) < 25 ? "start"
          : is_right      ? "end"
                          : "middle",
          say("assess.asked"));
    return out + "</svg>\n";
  }
  [[nodiscard]] std::string numbers_of(const WayOfPushing& way) const {
    std::string out = words_.capacity(way.capacity, kToG, "g");
    if (way.counts.not_shown > 0)
      out += ", " + say("assess.n_not_shown", {{"n", fmt::format("{}", way.counts.not_shown)}});
    if (way.counts.lost > 0)
      out += ", " + say("assess.n_lost", {{"n", fmt::format("{}", way.counts.lost)}});
    return out;
  }

  // Each limit state with its own spectrum and its risk index.
  [[nodiscard]] std::string limit_states() const {
    if (v_.limit_states.empty()) return "";
    std::string rows;
    for (const StateVerdict& of : v_.limit_states) {
      const bool decides = !v_.part_decides() && part_of_index() == nullptr && of.is_checked &&
                           of.state == v_.worst.state;
      rows += fmt::format(
          "<tr{}><td class=\"left\">{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td></tr>\n",
          decides ? " class=\"decides\"" : "",
          words_.state(of.state) + (decides ? " (" + say("assess.decides") + ")" : ""),
          words_.capacity(of.capacity, kToG, "g"),
          of.is_checked ? words_.fixed(of.demand * kToG, "g") : "–",
          of.is_checked ? words_.capacity(of.capacity, 1 / of.demand, "") : "–",
          of.is_checked ? words_.not_met_of(of.counts) : "–");
    }
    return "<h2>" + say("assess.states") +
           "</h2>\n<div class=\"wide\"><table><thead><tr><th class=\"left\">" +
           say("assess.state") + "</th><th>" + say("assess.capacity") + "</th><th>" +
           say("assess.demand") + "</th><th>ζE</th><th>" + say("assess.not_met_in") +
           "</th></tr></thead>\n" + rows + parts() + "</table></div>\n";
  }

  // Parts out of plane, the one with the least reserve first; the appendix contains all of them.
  [[nodiscard]] std::string parts() const {
    constexpr std::size_t kShown = 4;
    std::vector<const LocalCheck*> parts;
    for (const LocalCheck& part : v_.parts.checked) parts.push_back(&part);
    const auto order = [&](const LocalCheck* part) {
      return std::pair(!falls(part), std::isnan(part->reserve()) ? HUGE_VAL : part->reserve());
    };
    std::stable_sort(parts.begin(), parts.end(),
                     [&](const LocalCheck* a, const LocalCheck* b) { return order(a) < order(b); });
    if (parts.size() > kShown) parts.resize(kShown);
    std::string rows;
    for (const LocalCheck* part : parts) {
      const LocalStateCheck* of = part->deciding();
      const bool decides = part == part_of_index();
      std::string name = say("assess.part_row",
                             {{"state", words_.state(of != nullptr ? of->state : v_.worst.state)},
                              {"part", name_of(*part)}});
      if (decides) name += " (" + say("assess.decides") + ")";
      const auto number = [&](double value, const char* unit) {
        return std::isfinite(value) ? words_.fixed(value, unit) : std::string("–");
      };
      rows += fmt::format(
          "<tr{}><td class=\"left\">{}</td><td>{}</td><td>{}</td><td>{}</td><td{}>{}</td></tr>\n",
          decides ? " class=\"decides\"" : "", name,
          number(of != nullptr ? of->acceleration * kToG : kUnset, "g"),
          number(of != nullptr ? of->ground_demand * kToG : kUnset, "g"),
          number(part->reserve(), ""), falls(part) ? " class=\"fails\"" : "", words_.met(*part));
    }
    return rows;
  }
  [[nodiscard]] std::string name_of(const LocalCheck& part) const {
    return words_.words(words_of_part(part));
  }
  [[nodiscard]] static bool falls(const LocalCheck* part) {
    return part != nullptr && part->verdict == AssessmentVerdict::kFails;
  }

  // Space for a signature, only if the verdict may be signed.
  [[nodiscard]] std::string signature() const {
    return "<div class=\"signature\"><span>" +
           say("assess.made", {{"program", escaped(program())}}) + "</span>" +
           (v_.may_be_signed ? "<span class=\"line\">" + say("sheet.signature") + "</span>" : "") +
           "</div>\n";
  }
  // "wythe 0.1.0"; the appendix has the full version.
  [[nodiscard]] std::string program() const { return v_.program.substr(0, v_.program.find(" (")); }

  const WallsVerdict& v_;
  const ModelSpec& spec_;
  const Model& model_;
  VerdictWords words_;
  std::vector<Message> assumed_, left_out_;
};

}  // namespace

std::string verdict_page(const WallsVerdict& verdict, const ModelSpec& spec, const Model& model,
                         const std::string& language) {
  return VerdictPage(verdict, spec, model, language).all();
}

}  // namespace wythe
