// A chart's frame: two axes with ticks, grid and titles, and what is drawn inside it.
//
// Charts of a campaign (campaign_charts.cpp) are made of it; colours are the style sheet's.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "report/svg.h"

namespace wythe::report {

struct Span {
  double low = 0, high = 1;
  // Widened to hold a value; NaN and infinite values are passed over.
  void take(double value);
};

struct PlotSize {
  double width = 1080, height = 430;
  double left = 66, right = 24, top = 22, bottom = 52;
};

class Plot {
 public:
  // Ranges of no width get one. Titles are text, not markup.
  Plot(PlotSize size, Span x, Span y);
  [[nodiscard]] Pixel at(double x, double y) const { return {x_(x), y_(y)}; }
  [[nodiscard]] double left() const { return size_.left; }
  [[nodiscard]] double right() const { return size_.width - size_.right; }
  [[nodiscard]] double top() const { return size_.top; }
  [[nodiscard]] double bottom() const { return size_.height - size_.bottom; }
  [[nodiscard]] Span x() const { return x_span_; }
  [[nodiscard]] Span y() const { return y_span_; }

  // <svg>, grid, ticks and titles; shapes follow, then end().
  [[nodiscard]] std::string begin(std::string_view title, std::string_view x_title,
                                  std::string_view y_title) const;
  [[nodiscard]] static std::string end() { return "</svg>\n"; }

  // A line through points, thinned so that none dropped is farther than 0.4 pixel off.
  [[nodiscard]] std::string curve(const std::vector<Pixel>& values,
                                  std::string_view css_class) const;
  // An area between two lines over the same x.
  [[nodiscard]] std::string band(const std::vector<double>& x, const std::vector<double>& low,
                                 const std::vector<double>& high, std::string_view css_class) const;

 private:
  PlotSize size_;
  Span x_span_, y_span_;
  Axis x_, y_;
};

// Room a column of names needs beside a plot [pixel], within `least` and 400; and a name cut to fit.
[[nodiscard]] double room_for(const std::vector<std::string>& names, double least);
[[nodiscard]] std::string cut_to_fit(const std::string& name);

// Points that keep a line within `tolerance` of all of them (Douglas and Peucker).
[[nodiscard]] std::vector<Pixel> thinned(const std::vector<Pixel>& points, double tolerance);

}  // namespace wythe::report
