// Force-displacement, mean curves, shares, running means and exceedance of a campaign.
#include "report/campaign_charts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "report/html.h"
#include "report/plot.h"

namespace wythe::report {
namespace {

constexpr PlotSize kHalf{.width = 540, .height = 330};

Span curves_span_x(const Statistics& s) {
  Span x{0, 0};
  for (const MeanCurve& curve : s.mean_curve)
    for (const CurvePoint& p : curve.point) x.take(p.displacement * 1e3);
  return x;
}

std::string one_curve(const Plot& plot, const Statistics& s, const SampleRecord& record,
                      CurvesTo to) {
  std::vector<Pixel> points;
  for (const CurveRow& row : record.curve)
    if (to == CurvesTo::kEnd || row.displacement <= record.responses.displacement_at_80)
      points.push_back({row.displacement * 1e3, row.reaction * 1e-3});
  const std::string drawn = plot.curve(points, (s.answered > 40 ? "thin " : "thin few ") +
                                                   mode_class(s.modes, record.failure_mode.name));
  if (to != CurvesTo::kEnd) return drawn;
  // pointing at a curve tells the sample
  return fmt::format("<g><title>sample {}: {}, peak {}</title>{}</g>\n", record.sample,
                     escaped(record.failure_mode.name),
                     quantity(record.responses.peak_reaction * 1e-3, "kN"), drawn);
}

// Points of a mean curve while at least half of its curves go on.
std::vector<CurvePoint> carried(const MeanCurve& curve) {
  std::vector<CurvePoint> points;
  for (const CurvePoint& p : curve.point)
    if (2 * p.n >= curve.n) points.push_back(p);
  return points;
}

std::string spread_of(const Plot& plot, const std::vector<CurvePoint>& points,
                      const std::string& css) {
  std::vector<double> x, low, high;
  for (const CurvePoint& p : points)
    x.push_back(p.displacement * 1e3), low.push_back(p.low * 1e-3), high.push_back(p.high * 1e-3);
  return plot.band(x, low, high, "spread " + css);
}

std::string line_of(const Plot& plot, const std::vector<CurvePoint>& points,
                    const std::string& css) {
  std::vector<Pixel> values;
  for (const CurvePoint& p : points) values.push_back({p.displacement * 1e3, p.mean * 1e-3});
  return plot.curve(values, "mean " + css);
}

std::string drift_axis(const Plot& plot, double height) {
  if (!(height > 0)) return "";
  const double percent_per_mm = 0.1 / height;
  std::string out;
  for (double drift : ticks(0, plot.x().high * percent_per_mm, 7)) {
    const Pixel at = plot.at(drift / percent_per_mm, plot.y().high);
    out += line({at.x, at.y - 5}, at, "axis");
    out += label({at.x, at.y - 9}, rounded(drift, 3) + "\u202f%", "small", "middle");
  }
  return out;
}

// Names at the right ends of lines, pushed apart where they would touch.
struct Tag {
  double y;
  std::string name, css;
};
std::string draw_tags(double x, std::vector<Tag> tags) {
  std::sort(tags.begin(), tags.end(), [](const Tag& a, const Tag& b) { return a.y < b.y; });
  std::string out;
  double free = 0;
  for (Tag& tag : tags) {
    tag.y = std::max(tag.y, free);
    free = tag.y + 15;
    out += label({x, tag.y + 4}, cut_to_fit(tag.name), "mode " + tag.css);
  }
  return out;
}

std::string whisker(Pixel from, Pixel to) {
  return line(from, to, "whisker") + line({from.x, from.y - 4}, {from.x, from.y + 4}, "whisker") +
         line({to.x, to.y - 4}, {to.x, to.y + 4}, "whisker");
}

std::string limit_lines(const Plot& plot, const Statistics& s) {
  std::string out;
  double last = 0;
  int row = 0;
  for (const DriftLimit& limit : s.drift_limit) {
    const double x = limit.limit * 1e2;
    if (limit.state != "near collapse" || x > plot.x().high) continue;
    const double at = plot.at(x, 0).x;
    row = at - last < 120 ? row + 1 : 0;
    last = at;
    out += line({at, plot.top()}, {at, plot.bottom()}, "limit");
    const std::string words = rounded(x) + "\u202f% " +
                              limit.element.substr(0, limit.element.find(' ')) + ", " +
                              limit.mechanism.substr(0, limit.mechanism.find(' '));
    const bool at_right = at > plot.right() - 110;
    out += label({at_right ? at - 4 : at + 4, plot.top() + 12 + 14.0 * row}, words, "small halo",
                 at_right ? "end" : "start");
  }
  return out;
}

}  // namespace

std::string curves_svg(const Campaign& campaign, const Statistics& s, CurvesTo to) {
  if (s.answered == 0) return "";
  Span y{0, 0};
  for (const SampleRecord& record : campaign.records)
    if (is_answered(record)) y.take(record.responses.peak_reaction * 1.08e-3);
  const Plot plot({.height = 480, .top = 44}, curves_span_x(s), y);
  std::string out =
      plot.begin(to == CurvesTo::kEnd ? "Force-displacement curves of all samples"
                                      : "Force-displacement curves up to 80 % of their peak",
                 "displacement [mm]", "reaction [kN]");
  out += drift_axis(plot, s.load_height);
  for (const SampleRecord& record : campaign.records)
    if (is_answered(record)) out += one_curve(plot, s, record, to);
  return out + Plot::end();
}

std::string mean_curves_svg(const Statistics& s) {
  if (s.answered == 0) return "";
  Span y{0, 0};
  for (const MeanCurve& curve : s.mean_curve)
    for (const CurvePoint& p : carried(curve)) y.take(p.high * 1.05e-3);
  const Plot plot({.height = 440, .right = room_for(s.modes, 76), .top = 44}, curves_span_x(s), y);
  std::string bands, lines;
  std::vector<Tag> tags;
  for (const MeanCurve& curve : s.mean_curve) {
    const std::vector<CurvePoint> points = carried(curve);
    // "all" only where it says something the modes don't
    if (points.empty() || (curve.group == "all" && s.mean_curve.size() > 2)) continue;
    const std::string css = curve.group == "all" ? "all" : mode_class(s.modes, curve.group);
    if (curve.n >= 5) bands += spread_of(plot, points, css);
    lines += line_of(plot, points, css);
    tags.push_back({plot.at(0, points.back().mean * 1e-3).y, curve.group, css});
  }
  return plot.begin("Mean force-displacement curve of each failure mode", "displacement [mm]",
                    "reaction [kN]") +
         drift_axis(plot, s.load_height) + bands + lines + draw_tags(plot.right() + 8, tags) +
         Plot::end();
}

std::string shares_svg(const Statistics& s) {
  if (s.share.empty()) return "";
  constexpr double kRow = 34, kRight = 1020;
  std::vector<std::string> names;
  for (const Share& share : s.share) names.push_back(share.name);
  const double left = room_for(names, 160);
  Span x{0, 10};
  for (const Share& share : s.share) x.take(share.share.interval.high * 100);
  const double height = kRow * static_cast<double>(s.share.size()) + 62;
  const Plot plot({.height = height, .left = left, .right = 1080 - kRight, .top = 8}, x, {0, 1});
  std::string out = svg_begin(1080, height, "chart", "Share of each failure mode");
  for (double tick : ticks(0, plot.x().high, 8)) {
    out += line({plot.at(tick, 0).x, plot.top()}, {plot.at(tick, 0).x, plot.bottom()}, "grid");
    out += label({plot.at(tick, 0).x, plot.bottom() + 18}, rounded(tick), "soft", "middle");
  }
  out += label({(left + kRight) / 2, plot.bottom() + 40}, "share of the samples [%]", "", "middle");
  for (std::size_t i = 0; i < s.share.size(); ++i) {
    const Share& share = s.share[i];
    const double y = plot.top() + kRow * (static_cast<double>(i) + 0.5);
    const double end = plot.at(share.share.value * 100, 0).x;
    const std::string css = share.modes.size() == 1 ? mode_class(s.modes, share.modes[0]) : "all";
    out += fmt::format(
        "<rect class=\"box {}\" x=\"{}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"20\"{}/>\n", css,
        left, y - 10, end - left, css == "all" ? " opacity=\".35\"" : "");
    out += whisker({plot.at(share.share.interval.low * 100, 0).x, y},
                   {plot.at(share.share.interval.high * 100, 0).x, y});
    out += label({left - 10, y + 4.5}, cut_to_fit(share.name),
                 share.modes.size() == 1 ? "bold" : "", "end");
    out += label({plot.at(share.share.interval.high * 100, 0).x + 8, y + 4.5},
                 quantity(share.share.value * 100, "%"), "bold halo");
  }
  return out + line({left, plot.top()}, {left, plot.bottom()}, "axis") + Plot::end();
}

std::string running_svg(const Statistics& s, std::size_t q) {
  const RunningMean& running = s.running.at(q);
  if (running.n.size() < 2) return "";
  const Quantity& what = quantities()[q];
  // the wide intervals of the first few samples would flatten the rest
  const std::size_t from = std::min<std::size_t>(9, running.n.size() - 1);
  const double last = running.mean.back().value * what.to_unit;
  Span y{last, last};
  std::vector<double> n, low, high;
  std::vector<Pixel> mean;
  for (std::size_t i = 0; i < running.n.size(); ++i) {
    const Estimate& e = running.mean[i];
    n.push_back(running.n[i]), low.push_back(e.interval.low * what.to_unit);
    high.push_back(e.interval.high * what.to_unit);
    if (i >= from) y.take(low.back()), y.take(high.back());
    if (i >= from) y.take(e.value * what.to_unit);
  }
  const Plot plot(kHalf, {0, static_cast<double>(running.n.size())}, y);
  for (std::size_t i = 0; i < n.size(); ++i) {
    const double value = running.mean[i].value * what.to_unit;
    if (value >= plot.y().low && value <= plot.y().high) mean.push_back({n[i], value});
  }
  return plot.begin(std::string("Running mean: ") + what.words, "samples",
                    std::string("mean ") + what.words + " [" + what.unit + "]") +
         plot.band(n, low, high, "spread") + plot.curve(mean, "step") + Plot::end();
}

std::string exceedance_svg(const Statistics& s, const Exceedance& e) {
  if (e.point.size() < 2) return "";
  const bool force = e.quantity == "peak_reaction";
  const double to_unit = force ? 1e-3 : (s.load_height > 0 ? 1e2 / s.load_height : 1e3);
  const std::string unit = force ? "kN" : (s.load_height > 0 ? "%" : "mm");
  const double first = e.point.front().value * to_unit, last = e.point.back().value * to_unit;
  const double low = force ? first - 0.05 * (last - first) : 0;
  const Plot plot(kHalf, {low, last + 0.05 * (last - low)}, {0, 1});
  std::vector<Pixel> steps = {{low, 1}}, fit;
  std::vector<double> x, band_low, band_high;
  for (const ExceedancePoint& p : e.point) {
    steps.push_back({p.value * to_unit, steps.back().y});
    steps.push_back({p.value * to_unit, p.probability.value});
    x.push_back(p.value * to_unit), band_low.push_back(p.probability.interval.low);
    band_high.push_back(p.probability.interval.high);
  }
  for (int i = 0; i <= 100 && std::isfinite(e.median.value); ++i) {
    const double value = low + (plot.x().high - low) * i / 100;
    const double z = std::log(value / (e.median.value * to_unit)) / e.beta.value;
    fit.push_back({value, value > 0 ? 0.5 * std::erfc(z / std::sqrt(2.0)) : 1});
  }
  const std::string axis = force
                               ? "peak force [kN]"
                               : (e.quantity == "displacement_max" ? "largest displacement"
                                                                   : "drift at 80 % of the peak") +
                                     std::string(" [") + unit + "]";
  return plot.begin("Probability of exceedance: " + e.quantity, axis, "share that goes beyond") +
         plot.band(x, band_low, band_high, "spread") + (force ? "" : limit_lines(plot, s)) +
         plot.curve(steps, "step") + plot.curve(fit, "fit") + Plot::end();
}

}  // namespace wythe::report
