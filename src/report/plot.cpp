#include "report/plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "report/html.h"

namespace wythe::report {
namespace {

Span with_width(Span span) {
  if (!(span.high > span.low)) {
    const double half = span.low == 0 ? 0.5 : 0.1 * std::fabs(span.low);
    return {span.low - half, span.low + half};
  }
  return span;
}

constexpr std::size_t kLongest = 50;  // letters of a name beside a plot
constexpr double kLetter = 7.6;       // mean width of a bold one [pixel]

double distance(Pixel p, Pixel a, Pixel b) {
  const double dx = b.x - a.x, dy = b.y - a.y, length = std::hypot(dx, dy);
  if (length == 0) return std::hypot(p.x - a.x, p.y - a.y);
  return std::fabs((p.x - a.x) * dy - (p.y - a.y) * dx) / length;
}

}  // namespace

double room_for(const std::vector<std::string>& names, double least) {
  std::size_t longest = 0;
  for (const std::string& name : names) longest = std::max(longest, cut_to_fit(name).size());
  return std::clamp(20 + kLetter * static_cast<double>(longest), least, 400.0);
}

std::string cut_to_fit(const std::string& name) {
  if (name.size() <= kLongest) return name;
  std::size_t end = kLongest - 2;
  // not within a character of several bytes
  while (end > 0 && (static_cast<unsigned char>(name[end]) & 0xc0U) == 0x80U) --end;
  return name.substr(0, end) + "…";
}

void Span::take(double value) {
  if (!std::isfinite(value)) return;
  low = std::min(low, value), high = std::max(high, value);
}

std::vector<Pixel> thinned(const std::vector<Pixel>& points, double tolerance) {
  if (points.size() < 3) return points;
  std::vector<char> keep(points.size(), 0);
  keep.front() = keep.back() = 1;
  std::vector<std::pair<std::size_t, std::size_t>> open = {{0, points.size() - 1}};
  while (!open.empty()) {
    const auto [first, last] = open.back();
    open.pop_back();
    std::size_t worst = first;
    double off = tolerance;
    for (std::size_t i = first + 1; i < last; ++i) {
      const double d = distance(points[i], points[first], points[last]);
      if (d > off) off = d, worst = i;
    }
    if (worst == first) continue;
    keep[worst] = 1;
    open.emplace_back(first, worst);
    open.emplace_back(worst, last);
  }
  std::vector<Pixel> out;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (keep[i]) out.push_back(points[i]);
  return out;
}

Plot::Plot(PlotSize size, Span x, Span y)
    : size_(size),
      x_span_(with_width(x)),
      y_span_(with_width(y)),
      x_(Axis::between(x_span_.low, x_span_.high, left(), right())),
      y_(Axis::between(y_span_.low, y_span_.high, bottom(), top())) {}

std::string Plot::begin(std::string_view title, std::string_view x_title,
                        std::string_view y_title) const {
  std::string out = svg_begin(size_.width, size_.height, "chart", title);
  for (double x : ticks(x_span_.low, x_span_.high, static_cast<int>((right() - left()) / 75))) {
    out += line({x_(x), top()}, {x_(x), bottom()}, "grid");
    out += label({x_(x), bottom() + 18}, rounded(x, 4), "soft", "middle");
  }
  for (double y : ticks(y_span_.low, y_span_.high, static_cast<int>((bottom() - top()) / 45))) {
    out += line({left(), y_(y)}, {right(), y_(y)}, "grid");
    out += label({left() - 8, y_(y) + 4.5}, rounded(y, 4), "soft", "end");
  }
  out += line({left(), bottom()}, {right(), bottom()}, "axis");
  out += line({left(), top()}, {left(), bottom()}, "axis");
  out += label({(left() + right()) / 2, bottom() + 40}, x_title, "", "middle");
  if (y_title.empty()) return out;
  const double x = 15, y = (top() + bottom()) / 2;
  return out + fmt::format(
                   "<text x=\"{0}\" y=\"{1:.1f}\" text-anchor=\"middle\" "
                   "transform=\"rotate(-90 {0} {1:.1f})\">{2}</text>\n",
                   x, y, escaped(y_title));
}

std::string Plot::curve(const std::vector<Pixel>& values, std::string_view css_class) const {
  std::vector<Pixel> points;
  for (const Pixel& v : values)
    if (std::isfinite(v.x) && std::isfinite(v.y)) points.push_back(at(v.x, v.y));
  if (points.size() < 2) return "";
  return path(path_data(thinned(points, 0.4), false), css_class);
}

std::string Plot::band(const std::vector<double>& x, const std::vector<double>& low,
                       const std::vector<double>& high, std::string_view css_class) const {
  std::vector<Pixel> up, down;
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (!std::isfinite(low[i]) || !std::isfinite(high[i])) continue;
    up.push_back(at(x[i], std::clamp(high[i], y_span_.low, y_span_.high)));
    down.push_back(at(x[i], std::clamp(low[i], y_span_.low, y_span_.high)));
  }
  if (up.size() < 2) return "";
  up = thinned(up, 0.4), down = thinned(down, 0.4);
  up.insert(up.end(), down.rbegin(), down.rend());
  return path(path_data(up, true), css_class);
}

}  // namespace wythe::report
