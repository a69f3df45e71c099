// SVG primitives: a canvas that maps the user's axes (y up) to pixels (y down) and collects shapes.
// Shapes have a class and no colour, because colours are in the style sheet (report/style.h).
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace wythe::report {

// A linear map: pixel = offset + factor * value.
struct Axis {
  double offset = 0, factor = 1;
  [[nodiscard]] double operator()(double value) const { return offset + factor * value; }
  // Maps [low, high] to the pixels [from, to].
  [[nodiscard]] static Axis between(double low, double high, double from, double to);
};

// Round numbers (1, 2, 5 times a power of ten) from `low` to `high`, about `wanted` of them.
[[nodiscard]] std::vector<double> ticks(double low, double high, int wanted);

struct Pixel {
  double x = 0, y = 0;
};

[[nodiscard]] std::string line(Pixel from, Pixel to, std::string_view css_class);
// `anchor`: start, middle or end.
[[nodiscard]] std::string label(Pixel at, std::string_view text, std::string_view css_class,
                                std::string_view anchor = "start");
[[nodiscard]] std::string circle(Pixel at, double radius, std::string_view css_class);
// "M.. L.. L.. Z", or left open.
[[nodiscard]] std::string path_data(const std::vector<Pixel>& points, bool close);
[[nodiscard]] std::string path(std::string_view data, std::string_view css_class);
// Opening tag with the view box; `title` is for screen readers.
[[nodiscard]] std::string svg_begin(double width, double height, std::string_view css_class,
                                    std::string_view title);

}  // namespace wythe::report
