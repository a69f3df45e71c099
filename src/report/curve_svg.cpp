#include "report/curve_svg.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "report/html.h"
#include "report/svg.h"

namespace wythe::report {
namespace {

constexpr double kWidth = 1080, kHeight = 470;
constexpr double kLeft = 72, kRight = 1056, kTop = 58, kBottom = 410;

// Ranges and maps of the plot, in the units shown (mm, kN or -).
struct Plot {
  double x_low = 0, x_high = 1, y_low = 0, y_high = 1;
  double drift_per_mm = 0;  // [%/mm]
  bool factor = false;
  Axis x, y;
  [[nodiscard]] double force(const CurveRow& row) const {
    return factor ? row.load_factor : row.reaction * 1e-3;
  }
  [[nodiscard]] Pixel at(double mm, double value) const { return {x(mm), y(value)}; }
};

Plot plot_of(const Result& result) {
  Plot plot;
  plot.factor = shows_load_factor(result);
  double x_low = 0, x_high = 0, y_low = 0, y_high = 0;
  for (const CurveRow& row : result.curve) {
    x_low = std::fmin(x_low, row.displacement * 1e3),
    x_high = std::fmax(x_high, row.displacement * 1e3);
    y_low = std::fmin(y_low, plot.force(row)), y_high = std::fmax(y_high, plot.force(row));
    if (std::abs(row.displacement) > 1e-9)
      plot.drift_per_mm = row.drift * 1e2 / (row.displacement * 1e3);
  }
  plot.x_low = x_low, plot.x_high = x_high > x_low ? x_high : x_low + 1;
  // air above the peak for its label
  const double span = y_high > y_low ? y_high - y_low : 1;
  plot.y_low = y_low < -0.02 * span ? y_low - 0.06 * span : 0;
  plot.y_high = y_high + 0.14 * span;
  plot.x = Axis::between(plot.x_low, plot.x_high, kLeft, kRight);
  plot.y = Axis::between(plot.y_low, plot.y_high, kBottom, kTop);
  return plot;
}

std::string draw_axes(const Plot& plot) {
  std::string out;
  for (double mm : ticks(plot.x_low, plot.x_high, 9)) {
    out += line({plot.x(mm), kTop}, {plot.x(mm), kBottom}, "grid");
    out += label({plot.x(mm), kBottom + 20}, rounded(mm, 4), "soft", "middle");
  }
  for (double value : ticks(plot.y_low, plot.y_high, 6)) {
    out += line({kLeft, plot.y(value)}, {kRight, plot.y(value)}, "grid");
    out += label({kLeft - 9, plot.y(value) + 4.5}, rounded(value, 4), "soft", "end");
  }
  const double zero = plot.y(std::max(plot.y_low, 0.0));
  out +=
      line({kLeft, zero}, {kRight, zero}, "axis") + line({kLeft, kTop}, {kLeft, kBottom}, "axis");
  out += label({(kLeft + kRight) / 2, kBottom + 46}, "displacement of the pushed blocks [mm]", "",
               "middle");
  const char* title = plot.factor ? "load factor [–]" : "reaction [kN]";
  return out + label({kLeft - 56, kTop - 12}, title, "bold");
}

// Drift runs with displacement: the same grid, other numbers.
std::string draw_drift_axis(const Plot& plot) {
  if (!(std::abs(plot.drift_per_mm) > 0)) return "";
  std::string out = line({kLeft, kTop}, {kRight, kTop}, "grid");
  const double low = plot.x_low * plot.drift_per_mm;
  const double high = plot.x_high * plot.drift_per_mm;
  for (double drift : ticks(std::min(low, high), std::max(low, high), 7)) {
    const double x = plot.x(drift / plot.drift_per_mm);
    out += line({x, kTop}, {x, kTop - 5}, "axis");
    out += label({x, kTop - 10}, rounded(drift, 3), "small", "middle");
  }
  return out + label({kRight, kTop - 30}, "drift [%]", "small", "end");
}

std::string draw_curves(const Plot& plot, const std::vector<CurveRow>& curve) {
  std::vector<Pixel> force, base;
  for (const CurveRow& row : curve) {
    if (!std::isfinite(plot.force(row))) continue;
    force.push_back(plot.at(row.displacement * 1e3, plot.force(row)));
    if (std::isfinite(row.base_shear))
      base.push_back(plot.at(row.displacement * 1e3, row.base_shear * 1e-3));
  }
  return (plot.factor ? "" : path(path_data(base, false), "base")) +
         path(path_data(force, false), "force");
}

std::string draw_peak(const Plot& plot, const Responses& r) {
  if (plot.factor || !(r.peak_reaction > 0)) return "";
  const double mm = r.displacement_at_peak * 1e3;
  const Pixel peak = plot.at(mm, r.peak_reaction * 1e-3);
  std::string out = line({kLeft, peak.y}, peak, "guide") + line(peak, {peak.x, kBottom}, "guide");
  out += circle(peak, 5, "peak");
  const std::string text =
      "peak " + quantity(r.peak_reaction * 1e-3, "kN") + " at " + quantity(mm, "mm");
  const bool right_half = peak.x > 0.6 * kRight;
  out += label({peak.x + (right_half ? 6.0 : -2.0), peak.y - 13}, text, "bold halo",
               right_half ? "end" : "start");
  return out;
}

std::string draw_80(const Plot& plot, const Responses& r) {
  if (plot.factor || r.censored_80 || !(r.peak_reaction > 0)) return "";
  const double mm = r.displacement_at_80 * 1e3;
  const Pixel at = plot.at(mm, 0.8 * r.peak_reaction * 1e-3);
  const bool right_half = at.x > 0.8 * kRight;
  return line(at, {at.x, kBottom}, "guide") + circle(at, 5, "peak") +
         label({at.x + (right_half ? -10.0 : 10.0), at.y + 26},
               "80\u202f% of the peak at " + quantity(mm, "mm"), "halo",
               right_half ? "end" : "start");
}

// Numbered marks on the curve; the list under the picture has the words.
std::string draw_events(const Plot& plot, const std::vector<Event>& events) {
  std::string out;
  double last_x = -100, last_y = -100;
  for (std::size_t i = 0; i < events.size(); ++i) {
    Pixel at = plot.at(events[i].displacement * 1e3, plot.factor ? 0 : events[i].reaction * 1e-3);
    if (!std::isfinite(at.x) || !std::isfinite(at.y)) continue;
    // marks at one place stack downwards, to the right of the curve
    if (std::hypot(at.x - last_x, at.y - last_y) < 17) at = {last_x + 12, last_y + 13};
    last_x = at.x, last_y = at.y;
    out += circle(at, 8, "mark");
    out += label({at.x, at.y + 3.6}, std::to_string(i + 1), "markno", "middle");
  }
  return out;
}

std::string draw_key(const Plot& plot) {
  if (plot.factor) return "";
  const double y = kBottom + 42;
  return line({kRight - 232, y}, {kRight - 204, y}, "force") +
         label({kRight - 198, y + 4}, "reaction", "soft") +
         line({kRight - 122, y}, {kRight - 94, y}, "base") +
         label({kRight - 88, y + 4}, "base shear", "soft");
}

}  // namespace

bool shows_load_factor(const Result& result) {
  double force = 0, factor = 0;
  for (const CurveRow& row : result.curve) {
    force = std::fmax(force, std::abs(row.reaction));
    factor = std::fmax(factor, std::abs(row.load_factor));
  }
  return force == 0 && factor > 0;
}

std::string curve_svg(const Result& result) {
  if (result.curve.size() < 2) return "";
  const Plot plot = plot_of(result);
  return svg_begin(kWidth, kHeight, "curve", "Force-displacement curve") + draw_axes(plot) +
         draw_drift_axis(plot) + draw_curves(plot, result.curve) +
         draw_peak(plot, result.responses) + draw_80(plot, result.responses) +
         draw_events(plot, result.events) + draw_key(plot) + "</svg>\n";
}

}  // namespace wythe::report
