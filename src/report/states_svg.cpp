// Several states of one wall side by side in one picture, each with its displacement.
#include <fmt/format.h>

#include <algorithm>

#include "report/html.h"
#include "report/style.h"
#include "report/svg.h"
#include "report/wall_picture.h"
#include "wythe/parts/report.h"

namespace wythe {
namespace {

constexpr double kPanel = 480, kCaption = 26, kTallest = 620;  // [px]

// The complete picture of the wall, put into a panel that keeps its proportions.
std::string panel(const std::string& svg, double x, double height) {
  constexpr std::string_view tag = "<svg ";
  const std::size_t at = svg.find(tag);
  return svg.substr(0, at) +
         fmt::format("<svg x=\"{:.0f}\" y=\"{:.0f}\" width=\"{:.0f}\" height=\"{:.0f}\" ", x,
                     kCaption, kPanel, height) +
         svg.substr(at + tag.size());
}

double panel_height(const Model& model) {
  const double ratio = model.anatomy.length > 0 ? model.anatomy.height / model.anatomy.length : 1;
  return std::clamp(kPanel * (0.95 * ratio + 0.12), 160.0, kTallest);
}

}  // namespace

std::string states_svg(const Model& model, const std::vector<Snapshot>& states, double scale,
                       const std::string& title) {
  if (scale <= 0) scale = states.empty() ? 1 : report::fitting_scale(model, states.back().state);
  const double height = panel_height(model);
  const double width = kPanel * static_cast<double>(std::max<std::size_t>(1, states.size()));
  std::string svg = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n" +
                    report::svg_begin(width, height + kCaption, "states", title) + "<style>" +
                    report::picture_style() + "svg.states{background:var(--paper)}</style>\n";
  double x = 0;
  for (const Snapshot& s : states) {
    const std::string caption =
        fmt::format("{:.1f} mm, {:.1f} kN", 1e3 * s.displacement, 1e-3 * s.reaction);
    svg += report::label({x + kPanel / 2, 18}, caption, "bold", "middle");
    svg += panel(report::draw_wall(model, s.state, scale).svg, x, height);
    x += kPanel;
  }
  if (states.empty()) svg += report::label({20, 60}, "no states are stored", "soft");
  return svg + "</svg>\n";
}

}  // namespace wythe
