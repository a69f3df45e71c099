// Writes SVG elements as text, in pixels to a tenth. Labels and titles are escaped here.
// Ticks are multiples of the step, not sums, so that rounding does not grow along an axis.
#include "report/svg.h"

#include <fmt/format.h>

#include <cmath>

#include "report/html.h"

namespace wythe::report {

Axis Axis::between(double low, double high, double from, double to) {
  const double factor = high > low ? (to - from) / (high - low) : 0;
  return {.offset = from - factor * low, .factor = factor};
}

std::vector<double> ticks(double low, double high, int wanted) {
  if (!(high > low) || wanted < 1) return {low};
  const double raw = (high - low) / wanted;
  const double power = std::pow(10.0, std::floor(std::log10(raw)));
  double step = 10 * power;
  for (double multiple : {1.0, 2.0, 5.0}) {
    if (multiple * power >= raw * 0.999) {
      step = multiple * power;
      break;
    }
  }
  std::vector<double> values;
  // counted, not summed: 0.1 + 0.1 + 0.1 must read 0.3
  const double first = std::ceil(low / step - 1e-9);
  const double last = std::floor(high / step + 1e-9);
  for (double i = first; i <= last; i += 1) values.push_back(i * step);
  return values;
}

std::string line(Pixel from, Pixel to, std::string_view css_class) {
  return fmt::format(
      "<line class=\"{}\" x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\"/>\n", css_class,
      from.x, from.y, to.x, to.y);
}

std::string label(Pixel at, std::string_view text, std::string_view css_class,
                  std::string_view anchor) {
  return fmt::format("<text class=\"{}\" x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\">{}</text>\n",
                     css_class, at.x, at.y, anchor, escaped(text));
}

std::string circle(Pixel at, double radius, std::string_view css_class) {
  return fmt::format("<circle class=\"{}\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:.1f}\"/>\n", css_class,
                     at.x, at.y, radius);
}

std::string path_data(const std::vector<Pixel>& points, bool close) {
  std::string data;
  for (const Pixel& p : points)
    data += fmt::format("{}{:.1f} {:.1f}", data.empty() ? "M" : "L", p.x, p.y);
  return close ? data + "Z" : data;
}

std::string path(std::string_view data, std::string_view css_class) {
  return fmt::format("<path class=\"{}\" d=\"{}\"/>\n", css_class, data);
}

std::string svg_begin(double width, double height, std::string_view css_class,
                      std::string_view title) {
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"{}\" viewBox=\"0 0 {:.0f} {:.0f}\" "
      "role=\"img\">\n<title>{}</title>\n",
      css_class, width, height, escaped(title));
}

}  // namespace wythe::report
