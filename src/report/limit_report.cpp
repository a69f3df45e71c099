// The page of `wythe limit`: what the limit analysis says, the mechanisms drawn, their curves beside
// those of runs, and whether they agree. Reads a SecondOpinion, called by the command.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "report/html.h"
#include "report/plot.h"
#include "report/style.h"
#include "report/svg.h"
#include "report/wall_picture.h"
#include "wythe/provenance.h"
#include "wythe/report.h"

namespace wythe {
namespace {

using namespace report;

constexpr double kMost = 0.08;  // displacement drawn, of the wall's height

std::string style() {
  return R"css(
.body0,.body1,.body2{stroke:var(--ink);stroke-width:1.6;fill-opacity:.45}
.body0{fill:#0072b2}.body1{fill:#e69f00}.body2{fill:#009e73}
.before{fill:none;stroke:var(--soft);stroke-width:1.2;stroke-dasharray:5 4}
.hinge{fill:var(--paper);stroke:var(--crush);stroke-width:2.4}
.infinite{--c:#d55e00}.macro_block_1{--c:#0072b2}.macro_block_2{--c:#009e73}.run{--c:#8a8f96}
.mean{fill:none;stroke:var(--c);stroke-width:2.4;stroke-linejoin:round}
.thin{fill:none;stroke:var(--c);stroke-width:.8;opacity:.45}
.spread{fill:var(--c);opacity:.18;stroke:none}
svg text.named{fill:var(--c);font-weight:650}
svg.mechanism,svg.chart{display:block;width:100%;height:auto;font:13px system-ui,sans-serif}
svg.mechanism{max-width:520px;background:var(--paper)}
.three{display:grid;grid-template-columns:repeat(auto-fit,minmax(min(100%,330px),1fr));gap:16px}
)css";
}

const char* title_of(Hypothesis h) {
  switch (h) {
    case Hypothesis::kInfinite: return "infinite strength";
    case Hypothesis::kMacroBlock1: return "Macro-Block 1";
    case Hypothesis::kMacroBlock2: return "Macro-Block 2";
  }
  return "";
}

// --- pictures of mechanisms

struct Canvas {
  Axis x, y;
  double width = 0, height = 0;
  [[nodiscard]] Pixel operator()(Point p) const { return {x(p.x), y(p.y)}; }
};

Canvas canvas_of(const Model& model) {
  constexpr double kWall = 420, kMargin = 60;
  const Anatomy& a = model.anatomy;
  const auto [x0, x1] = std::minmax_element(a.outline_x.begin(), a.outline_x.end());
  const auto [y0, y1] = std::minmax_element(a.outline_y.begin(), a.outline_y.end());
  const double scale = kWall / std::max(*x1 - *x0, *y1 - *y0);
  const double width = scale * (*x1 - *x0), height = scale * (*y1 - *y0);
  return {Axis::between(*x0, *x1, kMargin, kMargin + width),
          Axis::between(*y0, *y1, kMargin + height, kMargin), width + 2 * kMargin,
          height + 2 * kMargin};
}

// The state that is seen well: up to `kMost` of the height, at most half the way.
const ChainState& shown_state(const Model& model, const Mechanism& m) {
  const auto& states = m.curve.states;
  const double wanted = std::min(kMost * model.anatomy.height, 0.5 * states.back().displacement);
  for (const ChainState& s : states)
    if (s.displacement >= wanted) return s;
  return states.back();
}

std::string blocks_at_rest(const Model& model, const Canvas& canvas) {
  const Anatomy& a = model.anatomy;
  std::string data;
  for (std::size_t b = 0; b + 1 < a.outline_begin.size(); ++b) {
    std::vector<Pixel> outline;
    for (int i = a.outline_begin[b]; i < a.outline_begin[b + 1]; ++i)
      outline.push_back(canvas(
          {a.outline_x[static_cast<std::size_t>(i)], a.outline_y[static_cast<std::size_t>(i)]}));
    data += path_data(outline, true);
  }
  return path(data, "mortar");
}

std::string bodies(const Mechanism& m, const ChainState& now, const Canvas& canvas) {
  std::string before, after;
  for (std::size_t i = 0; i < m.chain.bodies.size(); ++i) {
    std::vector<Pixel> rest, moved;
    for (const Point& p : m.chain.bodies[i].outline) {
      rest.push_back(canvas(p));
      moved.push_back(canvas(placed(m.chain, now, i, p)));
    }
    before += path(path_data(rest, true), "before");
    after += path(path_data(moved, true), fmt::format("body{}", i));
  }
  return before + after;
}

std::string hinges(const ChainState& now, const Canvas& canvas) {
  constexpr const char* kNames[] = {"C1", "C12", "C23", "C3"};
  std::string out;
  for (std::size_t i = 0; i < now.hinges.size(); ++i) {
    const Pixel at = canvas(now.hinges[i]);
    out += circle(at, 5.5, "hinge");
    out += label({at.x + 9, at.y + (i == 1 ? -8 : 17)}, kNames[i], "bold halo");
  }
  return out;
}

std::string arrow(const Mechanism& m, const ChainState& now, const Canvas& canvas) {
  const auto body = static_cast<std::size_t>(m.chain.loaded_body);
  const Pixel tip = canvas(placed(m.chain, now, body, m.chain.load_point));
  const double back = -m.chain.direction;
  return path(
      path_data({{tip.x + 46 * back, tip.y}, tip}, false) +
          path_data({{tip.x + 9 * back, tip.y - 6}, tip, {tip.x + 9 * back, tip.y + 6}}, false),
      "arrow");
}

std::string title_of(const Mechanism& m) { return m.mode + ", " + title_of(m.hypothesis); }

// --- charts

std::string overlay(const SecondOpinion& o, const std::string& mode) {
  const std::vector<EnvelopePoint> band = envelope(o.comparison.runs, mode);
  Span x{0, 1}, y{0, 1};
  for (const EnvelopePoint& p : band) x.take(p.displacement * 1e3), y.take(p.high * 1e-3);
  for (const Mechanism& m : o.mechanisms) {
    if (m.mode != mode) continue;
    y.take(1.05e-3 * m.curve.states.front().force);
    if (band.empty()) x.take(m.curve.states.back().displacement * 1e3);
  }
  const Plot plot({.width = 1080, .height = 430, .right = 130}, x, y);
  std::string out =
      plot.begin(mode + ": mechanisms and runs", "displacement of the load [mm]", "force [kN]");
  std::vector<double> at, low, high;
  std::vector<Pixel> mean;
  for (const EnvelopePoint& p : band) {
    at.push_back(p.displacement * 1e3), low.push_back(p.low * 1e-3), high.push_back(p.high * 1e-3);
    mean.push_back({p.displacement * 1e3, p.mean * 1e-3});
  }
  if (!band.empty()) out += plot.band(at, low, high, "spread run") + plot.curve(mean, "mean run");
  for (const Mechanism& m : o.mechanisms) {
    if (m.mode != mode) continue;
    std::vector<Pixel> points;
    for (const ChainState& s : m.curve.states)
      if (s.displacement * 1e3 <= x.high) points.push_back({s.displacement * 1e3, s.force * 1e-3});
    const std::string css = to_string(m.hypothesis);
    out += plot.curve(points, "mean " + css);
    const Pixel end = plot.at(points.back().x, points.back().y);
    out += label({end.x + 4, end.y + 4}, title_of(m.hypothesis), "named " + css);
  }
  return out + Plot::end();
}

std::string curves_section(const SecondOpinion& o) {
  std::string out;
  for (const char* mode : {"FM-1", "FM-4"}) {
    const bool has = std::any_of(o.mechanisms.begin(), o.mechanisms.end(),
                                 [&](const Mechanism& m) { return m.mode == mode; });
    if (has) out += fmt::format("<h3>{}</h3>\n<figure>{}</figure>\n", mode, overlay(o, mode));
  }
  if (out.empty()) return "";
  return "<h2>Mechanisms</h2>\n" + out +
         (o.comparison.runs.empty() ? ""
                                    : "<p class=\"soft\">Grey: runs of the mode, lowest to "
                                      "highest, and their mean.</p>\n");
}

std::string mechanisms_section(const Model& model, const SecondOpinion& o) {
  if (o.mechanisms.empty()) return "";
  std::vector<std::vector<std::string>> rows{
      {"mechanism", "force at rest", "force nil at", "spandrel/left", "right/left"}};
  std::string pictures;
  for (const Mechanism& m : o.mechanisms) {
    const ChainState& start = m.curve.states.front();
    rows.push_back({title_of(m), quantity(start.force * 1e-3, "kN", 4),
                    quantity(m.curve.states.back().displacement * 1e3, "mm", 4),
                    rounded(start.rate[1]), rounded(start.rate[2])});
    std::string svg = mechanism_svg(model, m);
    svg.erase(0, svg.find("<svg "));
    pictures += "<figure>" + svg + "<figcaption>" + title_of(m) + "</figcaption></figure>\n";
  }
  return table(rows) + "<div class=\"three\">\n" + pictures + "</div>\n";
}

std::string limits_section(const Model& model, const SecondOpinion& o) {
  if (o.limits.empty()) return "";
  std::vector<std::vector<std::string>> rows{
      {"joints", "static theorem", "kinematic theorem", "time"}};
  for (const NamedLimit& limit : o.limits) {
    const LimitAnswer& a = limit.answer;
    const double unit = a.is_force ? 1e-3 : 1;
    const char* name = a.is_force ? "kN" : "";
    rows.push_back({escaped(limit.name), quantity(a.load * unit, name, 6),
                    quantity(a.kinematic * unit, name, 6), quantity(a.seconds, "s", 2)});
  }
  const LimitAnswer& first = o.limits.front().answer;
  State state = initial_state(model);
  double most = 1e-12;
  for (std::size_t i = 0; i < first.vx.size(); ++i)
    most = std::max(most, std::hypot(first.vx[i], first.vy[i]));
  const double scale = 0.03 * model.anatomy.height / most;
  for (std::size_t i = 0; i < first.vx.size(); ++i) {
    state.ux[i] = scale * first.vx[i];
    state.uy[i] = scale * first.vy[i];
    state.theta[i] = scale * first.omega[i];
  }
  return "<h2>Limit analysis of the blocks</h2>\n" + table(rows) + "<figure>" +
         draw_wall(model, state, 1).svg +
         "<figcaption>Collapse mechanism, joints: " + escaped(o.limits.front().name) +
         "</figcaption></figure>\n";
}

// --- the verdict

std::string bound_section(const Comparison& c) {
  std::string out;
  for (const BoundVerdict& b : c.bounds)
    if (!b.holds())
      out += fmt::format(
          "<div class=\"warning\"><b>{}: error of the run.</b> Its peak is {} times what limit "
          "analysis says its joints can carry; {} % are allowed.</div>\n",
          escaped(b.run), rounded(b.peak / b.bound, 4), rounded(100 * b.allowance));
  return out;
}

std::string verdict_section(const Comparison& c) {
  if (c.with.empty()) return "";
  std::vector<std::vector<std::string>> rows{
      {"runs", "mechanism", "number", "mean peak", "peak / mechanism", "post-peak gap"}};
  for (const GroupVerdict& g : c.groups)
    rows.push_back({escaped(g.mode), escaped(g.mechanism), std::to_string(g.runs),
                    quantity(g.mean_peak * 1e-3, "kN", 4), rounded(g.peak_ratio),
                    quantity(g.gap * 1e-3, "kN") + fmt::format(" ({:.0f} %)", 100 * g.gap_share)});
  return "<h2>Do they agree</h2>\n<p class=\"soft\">With " + escaped(c.with) +
         ". Gap: mean absolute difference from the run's peak to its end, also as a share of the "
         "peak.</p>\n" +
         bound_section(c) + table(rows);
}

}  // namespace

std::string mechanism_svg(const Model& model, const Mechanism& mechanism) {
  const Canvas canvas = canvas_of(model);
  const ChainState& now = shown_state(model, mechanism);
  const std::string caption =
      fmt::format("{}: {:.1f} kN at rest; drawn at {:.0f} mm", title_of(mechanism),
                  1e-3 * mechanism.curve.states.front().force, 1e3 * now.displacement);
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n" +
         svg_begin(canvas.width, canvas.height, "mechanism", title_of(mechanism)) + "<style>" +
         picture_style() + style() + "</style>\n" + blocks_at_rest(model, canvas) +
         bodies(mechanism, now, canvas) + hinges(now, canvas) + arrow(mechanism, now, canvas) +
         label({canvas.width / 2, 24}, caption, "bold", "middle") + "</svg>\n";
}

std::string limit_section(const Model& model, const SecondOpinion& opinion) {
  return verdict_section(opinion.comparison) + curves_section(opinion) +
         mechanisms_section(model, opinion) + limits_section(model, opinion);
}

std::string limit_report(const ModelSpec& spec, const Model& model, const SecondOpinion& opinion) {
  const std::string name = escaped(spec.name.empty() ? "Wall" : spec.name);
  return fmt::format(
             "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
             "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
             "<title>{}: wythe limit</title>\n<style>{}{}{}</style>\n</head>\n<body>\n<main>\n"
             "<header>\n<p class=\"kind\">Macro-blocks and limit analysis</p>\n<h1>{}</h1>\n"
             "</header>\n",
             name, picture_style(), page_style(), style(), name) +
         limit_section(model, opinion) +
         fmt::format(
             "<footer>wythe {}. Every number is in mechanisms.json.</footer>\n</main>\n"
             "</body>\n</html>\n",
             provenance().version);
}

}  // namespace wythe
