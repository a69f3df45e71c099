// What the run answers: headline, key numbers, curve, pictures, failure mode.
#include "report/sections.h"

#include <fmt/format.h>

#include <cmath>

#include "report/curve_svg.h"
#include "report/html.h"
#include "report/wall_picture.h"

namespace wythe::report {
namespace {

std::string kilonewtons(double newtons) { return quantity(newtons * 1e-3, "kN"); }
std::string millimetres(double metres) { return quantity(metres * 1e3, "mm"); }

// Drift that belongs to a displacement, by the curve's own ratio [-]; NaN without a curve.
double drift_at(const Result& result, double displacement) {
  for (const CurveRow& row : result.curve)
    if (std::abs(row.displacement) > 1e-9) return row.drift / row.displacement * displacement;
  return kUnset;
}

std::string ductility_sentence(const Result& result) {
  const Responses& r = result.responses;
  if (!r.censored_80) {
    return fmt::format(" Past the peak it keeps 80\u202f% of that force up to <b>{}</b>.",
                       millimetres(r.displacement_at_80));
  }
  return fmt::format(
      " It still holds more than 80\u202f% of that force where the run ended, at <b>{}</b>.",
      millimetres(r.displacement_at_80));
}

std::string mode_sentence(const FailureMode& mode) {
  if (mode.sentence.empty() && mode.name == "unclear") return " The failure mode is unclear.";
  if (mode.sentence.empty()) return fmt::format(" It fails by <b>{}</b>.", escaped(mode.name));
  return fmt::format(" <b>{}</b>: {}", escaped(mode.name), sentence(mode.sentence));
}

struct Number {
  std::string value, name, means;
};

std::string cards(const std::vector<Number>& numbers) {
  std::string out = "<section class=\"numbers\">\n";
  for (const Number& n : numbers) {
    out += fmt::format(
        "<div class=\"number\"><div class=\"value\">{}</div><div class=\"name\">{}</div>"
        "<div class=\"means\">{}</div></div>\n",
        n.value, n.name, n.means);
  }
  return out + "</section>\n";
}

struct LegendItem {
  const char *css, *words;
};

std::string legend() {
  static constexpr LegendItem kItems[] = {
      {"crack open", "open crack; the wider, the thicker"},
      {"crack slip", "slipped more than opened"},
      {"crack closed", "cracked through, closed again"},
      {"crack softening", "softening, not yet cracked through"}};
  std::string out = "<ul class=\"legend\">\n";
  for (const LegendItem& item : kItems) {
    out += fmt::format(
        "<li><svg viewBox=\"0 0 34 14\"><line class=\"{}\" stroke-width=\"3\" x1=\"2\" y1=\"7\" "
        "x2=\"32\" y2=\"7\"/></svg>{}</li>\n",
        item.css, item.words);
  }
  out +=
      "<li><svg viewBox=\"0 0 34 14\"><circle class=\"crushed\" cx=\"17\" cy=\"7\" r=\"5\"/></svg>"
      "crushed joint end</li>\n";
  return out + "</ul>\n";
}

std::string plural(int count, const char* one, const char* many) {
  return fmt::format("{} {}", count, count == 1 ? one : many);
}

bool same_state(const Snapshot& a, const Snapshot& b) {
  return a.state.step == b.state.step && a.state.ux == b.state.ux;
}

std::string picture_caption(const Snapshot& snapshot, double scale, const WallPicture& picture) {
  std::string out = fmt::format("<figcaption><b>{}</b>: {}, {}", escaped(snapshot.label),
                                millimetres(snapshot.displacement), kilonewtons(snapshot.reaction));
  out += scale == 1 ? "; displacements to scale. "
                    : fmt::format("; displacements × {}. ", rounded(scale));
  if (picture.open + picture.slipped + picture.closed + picture.softening + picture.crushed == 0)
    return out + "No crack.</figcaption>\n";
  out += fmt::format("{}, {} slipped, {} closed again, {} softening; ",
                     plural(picture.open, "open joint", "open joints"), picture.slipped,
                     picture.closed, picture.softening);
  out += plural(picture.crushed, "crushed joint end", "crushed joint ends");
  return out + fmt::format(". Widest opening {}, longest slip {}.</figcaption>\n",
                           quantity(picture.widest * 1e3, "mm", 2),
                           quantity(picture.longest * 1e3, "mm", 2));
}

}  // namespace

std::string headline(const Model& model, const Result& result) {
  const Responses& r = result.responses;
  std::string out = "<p class=\"headline\">";
  if (shows_load_factor(result)) {
    out += fmt::format("The wall carries <b>{}</b> of its weight sideways (load factor λ).",
                       rounded(result.load_factor));
  } else if (result.curve.empty() || !(r.peak_reaction > 0)) {
    out += fmt::format("The wall weighs {}; nothing pushed it.", kilonewtons(model.weight));
    return out + "</p>\n";
  } else {
    out += fmt::format("The wall resists <b>{}</b> at <b>{}</b> ({} drift).",
                       kilonewtons(r.peak_reaction), millimetres(r.displacement_at_peak),
                       quantity(drift_at(result, r.displacement_at_peak) * 1e2, "%"));
    out += ductility_sentence(result);
  }
  return out + mode_sentence(result.failure_mode) + "</p>\n";
}

std::string warning(const Result& result) {
  const char* words = nullptr;
  switch (result.status) {
    case SolveStatus::kCompleted: return "";
    case SolveStatus::kCollapsed: words = "The wall collapsed"; break;
    case SolveStatus::kInterrupted: words = "The run was interrupted"; break;
    case SolveStatus::kNotSettled: words = "A stage did not come to rest"; break;
    case SolveStatus::kUnstable: words = "The computation became unstable"; break;
    case SolveStatus::kBudgetSpent: words = "The step budget was spent before the end"; break;
  }
  return fmt::format("<p class=\"warning\"><b>{}.</b> {}</p>\n", words, escaped(result.reason));
}

std::string key_numbers(const Result& result) {
  const Responses& r = result.responses;
  if (shows_load_factor(result)) {
    return cards(
        {{rounded(result.load_factor), "load factor",
          "largest horizontal force, as a share of each block's weight, carried in "
          "equilibrium (tilt: tangent of the angle)"},
         {millimetres(result.top_displacement), "top displacement", "at the end of the run"}});
  }
  if (result.curve.empty()) return "";
  const std::string at_least = "≥ ";
  return cards(
      {{kilonewtons(r.peak_reaction), "peak reaction",
        "largest force that resists the push, averaged over the output window"},
       {millimetres(r.displacement_at_peak), "displacement at the peak",
        "mean of the pushed blocks; drift " +
            quantity(drift_at(result, r.displacement_at_peak) * 1e2, "%")},
       {(r.censored_80 ? at_least : "") + millimetres(r.displacement_at_80),
        "displacement at 80\u202f%",
        r.censored_80 ? "the force never fell to 0.8 of the peak: the last displacement"
                      : "first fall to 0.8 of the peak after it; drift " +
                            quantity(drift_at(result, r.displacement_at_80) * 1e2, "%")},
       {(r.censored_max ? at_least : "") + millimetres(r.displacement_max), "largest displacement",
        r.censored_max ? "the force never stayed below 0.2 of the peak: the last displacement"
                       : "from here on the force stays below 0.2 of the peak"},
       {quantity(r.initial_stiffness * 1e-6, "kN/mm"), "initial stiffness",
        "secant between 10 and 30 % of the peak"}});
}

std::string curve_section(const Result& result) {
  const std::string picture = curve_svg(result);
  if (picture.empty()) return "";
  std::string out = "<h2>Force and displacement</h2>\n<figure>\n" + picture;
  if (!result.events.empty()) {
    out += "<ol class=\"marks\">\n";
    for (const Event& e : result.events) {
      out += fmt::format("<li><b>{}</b> <span class=\"soft\">{}, {}</span>{}{}</li>\n",
                         escaped(e.name), millimetres(e.displacement), kilonewtons(e.reaction),
                         e.where.empty() ? "" : ": ", escaped(e.where));
    }
    out += "</ol>\n";
  }
  return out + "</figure>\n";
}

std::string pictures_section(const Model& model, const Result& result) {
  if (result.snapshots.empty()) return "";
  std::string out = "<h2>The wall on its way</h2>\n" + legend() + "<div class=\"pictures\">\n";
  std::string label;
  for (std::size_t i = 0; i < result.snapshots.size(); ++i) {
    Snapshot snapshot = result.snapshots[i];
    // one picture for "30 mm" and "end" when they are one state
    label += (label.empty() ? "" : ", ") + snapshot.label;
    if (i + 1 < result.snapshots.size() && same_state(snapshot, result.snapshots[i + 1])) continue;
    snapshot.label = label;
    label.clear();
    const double scale = fitting_scale(model, snapshot.state);
    const WallPicture picture = draw_wall(model, snapshot.state, scale);
    out += "<figure>\n" + picture.svg + picture_caption(snapshot, scale, picture) + "</figure>\n";
  }
  return out + "</div>\n";
}

namespace {

std::string first_seen(double displacement) {
  return std::isnan(displacement) ? "–" : millimetres(displacement);
}

// What happened to each part of the wall, and from which stored state on.
std::string elements_table(const std::vector<ElementState>& elements) {
  if (elements.empty()) return "";
  std::vector<std::vector<std::string>> rows = {{"element", "what happened", "first seen at"}};
  for (const ElementState& e : elements)
    rows.push_back({escaped(e.element), escaped(e.state), first_seen(e.displacement_first)});
  return table(rows, "second");
}

std::string measures_table(const std::vector<Evidence>& evidence, const char* reached_word) {
  std::vector<std::vector<std::string>> rows = {
      {"element", "sign", "measured", "threshold", reached_word}};
  for (const Evidence& e : evidence) {
    // a share is a plain number between 0 and 1
    const std::string unit = e.unit == "share" || e.unit == "-" ? "" : e.unit;
    rows.push_back({escaped(e.element), escaped(e.measure), quantity(e.value, unit),
                    quantity(e.threshold, unit), e.holds() ? "<b>yes</b>" : "no"});
  }
  return table(rows, "second");
}

// "FM-5 at 10 mm, at 20 mm; unclear with crack width x 1.25": the readings that give another name.
std::string sensitivity_sentence(const FailureMode& mode) {
  if (mode.sensitivity.empty()) return "";
  std::string others;
  for (const NameReading& r : mode.sensitivity)
    if (r.name != mode.name)
      others +=
          fmt::format("{}{}: {}", others.empty() ? "" : "; ", escaped(r.what()), escaped(r.name));
  const std::size_t n = mode.sensitivity.size();
  if (others.empty())
    return fmt::format(
        "<p>Read in {} other ways (other states, thresholds a quarter lower or "
        "higher) it gets the same name.</p>\n",
        n);
  return fmt::format(
      "<p>Of {} other readings (other states, thresholds a quarter lower or higher) "
      "these give another name: {}.</p>\n",
      n, others);
}

}  // namespace

std::string failure_section(const FailureMode& mode) {
  if (mode.evidence.empty()) return "";
  std::string out = fmt::format(
      "<h2>Why it is called {}</h2>\n<p class=\"soft\">Measured on the wall "
      "at {}, against the threshold of each sign.</p>\n",
      escaped(mode.name), millimetres(mode.read_at));
  out += elements_table(mode.elements) + sensitivity_sentence(mode);
  if (!mode.flags.empty()) out += "<h3>How severe</h3>\n" + measures_table(mode.flags, "raised");
  if (!mode.elements.empty()) out += "<h3>The measures</h3>\n";
  return out + measures_table(mode.evidence, "reached");
}

}  // namespace wythe::report
