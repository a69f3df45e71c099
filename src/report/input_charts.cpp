// Inputs of a campaign against its answers: scatter, correlation, modes in bins, histograms.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "report/campaign_charts.h"
#include "report/html.h"
#include "report/plot.h"

namespace wythe::report {
namespace {

constexpr PlotSize kThird{.width = 400, .height = 300, .left = 60, .right = 14};
constexpr int kBars = 20;

double shown(const InputColumn& column, double si) { return si * column.to_unit + column.offset; }
std::string title_of(const InputColumn& column) {
  return column.unit == "1" || column.unit.empty() ? column.name
                                                   : column.name + " [" + column.unit + "]";
}

// Density of a variable [1/SI]; 0 where its distribution is not drawn.
double density(const VariableSpec& v, double x) {
  constexpr double kRootTwoPi = 2.5066282746310002;
  const double sd = std::isfinite(v.cov) ? v.cov * v.mean : v.standard_deviation;
  if (!std::isfinite(v.mean) || !(sd > 0)) return 0;
  if (v.distribution == DistributionKind::kNormal) {
    const double z = (x - v.mean) / sd;
    return std::exp(-z * z / 2) / (sd * kRootTwoPi);
  }
  if (v.distribution != DistributionKind::kLognormal || !(x > 0)) return 0;
  const double s = std::sqrt(std::log(1 + sd * sd / (v.mean * v.mean)));
  const double z = (std::log(x / v.mean) + s * s / 2) / s;
  return std::exp(-z * z / 2) / (x * s * kRootTwoPi);
}

// The density of a variable where it is known in closed form; truncation lifts what is left.
std::string density_line(const Plot& plot, const Campaign& campaign, const InputColumn& column,
                         double area) {
  const std::vector<VariableSpec>& variables = campaign.study.variable;
  for (std::size_t v = 0; v < variables.size(); ++v) {
    if (variables[v].name != column.name) continue;
    if (v < campaign.samples.cut_off.size()) area /= 1 - campaign.samples.cut_off[v];
    std::vector<Pixel> points;
    for (int i = 0; i <= 100; ++i) {
      const double x = plot.x().low + (plot.x().high - plot.x().low) * i / 100;
      const double here = density(variables[v], (x - column.offset) / column.to_unit);
      if (here > 0) points.push_back({x, here / column.to_unit * area});
    }
    return plot.curve(points, "fit");
  }
  return "";
}

struct Bars {
  Span x{kUnlimited, -kUnlimited};
  std::vector<int> count = std::vector<int>(kBars, 0);
  int highest = 0;
};

Bars bars_of(const Campaign& campaign, int k) {
  const InputColumn& column = campaign.samples.column[k];
  Bars bars;
  for (const auto& row : campaign.samples.value) bars.x.take(shown(column, row.at(k)));
  for (const auto& row : campaign.samples.value) {
    const double place = (shown(column, row[k]) - bars.x.low) / (bars.x.high - bars.x.low);
    const int bar = std::clamp(static_cast<int>(place * kBars), 0, kBars - 1);
    bars.highest = std::max(bars.highest, ++bars.count[bar]);
  }
  return bars;
}

std::string bar(Pixel low, Pixel high, const std::string& css, const std::string& title = "") {
  const std::string inner = title.empty() ? "" : "<title>" + escaped(title) + "</title>";
  return fmt::format(
      "<rect class=\"box {}\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" "
      "height=\"{:.1f}\">{}</rect>\n",
      css, low.x, high.y, high.x - low.x, low.y - high.y, inner);
}

}  // namespace

std::string scatter_svg(const Campaign& campaign, const Statistics& s, int k, std::size_t q) {
  const InputColumn& column = campaign.samples.column.at(k);
  const Quantity& what = quantities()[q];
  Span x{kUnlimited, -kUnlimited}, y{kUnlimited, -kUnlimited};
  for (const SampleRecord& record : campaign.records) {
    if (!is_answered(record)) continue;
    x.take(shown(column, record.inputs.at(k)));
    y.take(what.read(record.responses).value * what.to_unit);
  }
  if (!(x.high > x.low)) return "";
  const double air_x = 0.03 * (x.high - x.low), air_y = 0.05 * (y.high - y.low);
  const Plot plot(kThird, {x.low - air_x, x.high + air_x}, {y.low - air_y, y.high + air_y});
  std::string out = plot.begin(title_of(column) + " against " + what.words, title_of(column),
                               std::string(what.words) + " [" + what.unit + "]");
  for (const SampleRecord& record : campaign.records) {
    if (!is_answered(record)) continue;
    const Reading reading = what.read(record.responses);
    out += circle(plot.at(shown(column, record.inputs[k]), reading.value * what.to_unit), 3.2,
                  "dot " + mode_class(s.modes, record.failure_mode.name));
  }
  return out + Plot::end();
}

std::string mode_bins_svg(const Statistics& s, const ModeAgainstInput& against) {
  if (against.bin.empty()) return "";
  const InputColumn& column = against.column;
  Span x{shown(column, against.bin.front().low), shown(column, against.bin.back().high)};
  const Plot plot({.width = 400, .height = 280, .left = 60, .right = 14}, x, {0, 100});
  std::string out = plot.begin("Failure modes against " + title_of(column), title_of(column),
                               "share of the modes [%]");
  for (std::size_t b = 0; b < against.bin.size(); ++b) {
    const ModeBin& bin = against.bin[b];
    // bins meet half-way between their values
    const double low = b == 0 ? bin.low : 0.5 * (against.bin[b - 1].high + bin.low);
    const double high =
        b + 1 == against.bin.size() ? bin.high : 0.5 * (bin.high + against.bin[b + 1].low);
    double below = 0;
    for (std::size_t m = 0; m < against.modes.size(); ++m) {
      const Estimate& e = bin.share[m];
      if (!(e.value > 0)) continue;
      out += bar(plot.at(shown(column, low), below),
                 plot.at(shown(column, high), below + e.value * 100),
                 mode_class(s.modes, against.modes[m]),
                 fmt::format("{}: {:.0f} % ({:.0f} to {:.0f} %) of {} samples", against.modes[m],
                             e.value * 100, e.interval.low * 100, e.interval.high * 100, bin.n));
      below += e.value * 100;
    }
  }
  return out + Plot::end();
}

std::string correlation_svg(const CorrelationTable& table) {
  if (table.input.empty()) return "";
  constexpr double kRow = 30;
  std::vector<std::string> names;
  for (const Correlation& c : table.input) names.push_back(c.input);
  const double left = std::min(room_for(names, 120), 220.0);
  const double height = kRow * static_cast<double>(table.input.size()) + 60;
  const Plot plot({.width = 540, .height = height, .left = left, .right = 20, .top = 6}, {-1, 1},
                  {0, 1});
  std::string out = svg_begin(540, height, "chart", "Rank correlation with " + table.quantity);
  for (double tick : {-1.0, -0.5, 0.0, 0.5, 1.0}) {
    const double x = plot.at(tick, 0).x;
    out += line({x, plot.top()}, {x, plot.bottom()}, tick == 0 ? "axis" : "grid");
    out += label({x, plot.bottom() + 18}, rounded(tick), "soft", "middle");
  }
  out += label({plot.at(0, 0).x, plot.bottom() + 38}, "Spearman's rank correlation", "", "middle");
  for (std::size_t i = 0; i < table.input.size(); ++i) {
    const Estimate& rho = table.input[i].spearman;
    const double y = plot.top() + kRow * (static_cast<double>(i) + 0.5);
    out += label({left - 10, y + 4.5}, cut_to_fit(table.input[i].input), "", "end");
    if (!std::isfinite(rho.value)) continue;
    const double from = std::min(rho.value, 0.0), to = std::max(rho.value, 0.0);
    out += bar({plot.at(from, 0).x, y + 8}, {plot.at(to, 0).x, y - 8}, "");
    if (std::isfinite(rho.interval.low))
      out += line({plot.at(rho.interval.low, 0).x, y}, {plot.at(rho.interval.high, 0).x, y},
                  "whisker");
  }
  return out + Plot::end();
}

std::string histogram_svg(const Campaign& campaign, int k) {
  const InputColumn& column = campaign.samples.column.at(k);
  const Bars bars = bars_of(campaign, k);
  if (!(bars.x.high > bars.x.low)) return "";
  const double width = (bars.x.high - bars.x.low) / kBars;
  const Plot plot({.width = 400, .height = 220, .left = 46, .right = 14}, bars.x,
                  {0, 1.12 * bars.highest});
  std::string out = plot.begin("Histogram of " + column.name, title_of(column), "samples");
  for (int b = 0; b < kBars; ++b) {
    if (bars.count[b] == 0) continue;
    out += bar(plot.at(bars.x.low + b * width, 0),
               plot.at(bars.x.low + (b + 1) * width, bars.count[b]), "");
  }
  out += density_line(plot, campaign, column, width * campaign.samples.n_sample());
  return out + Plot::end();
}

}  // namespace wythe::report
