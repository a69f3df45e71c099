// A macro-block mechanism as a picture: the blocks at rest, the moved bodies, hinges and load.
#include <fmt/format.h>

#include <algorithm>

#include "report/style.h"
#include "report/svg.h"
#include "report/wall_picture.h"
#include "wythe/parts/reading.h"
#include "wythe/parts/report.h"

namespace wythe {
namespace {

using namespace report;

constexpr double kMostDrawn = 0.08;  // largest displacement in the picture, over the wall's height

std::string style() {
  return R"css(
.body0,.body1,.body2{stroke:var(--ink);stroke-width:1.6;fill-opacity:.45}
.body0{fill:#0072b2}.body1{fill:#e69f00}.body2{fill:#009e73}
.before{fill:none;stroke:var(--soft);stroke-width:1.2;stroke-dasharray:5 4}
.hinge{fill:var(--paper);stroke:var(--crush);stroke-width:2.4}
svg.mechanism{display:block;width:100%;height:auto;font:13px system-ui,sans-serif}
svg.mechanism{max-width:520px;background:var(--paper)}
)css";
}

constexpr Word<Hypothesis> kTitles[] = {{"infinite strength", Hypothesis::kInfinite},
                                        {"Macro-Block 1", Hypothesis::kMacroBlock1},
                                        {"Macro-Block 2", Hypothesis::kMacroBlock2}};
static_assert(names_all(kTitles));

// --- pictures of mechanisms

struct MechanismCanvas {
  Axis x, y;
  double width = 0, height = 0;
  [[nodiscard]] Pixel operator()(Vec2 p) const { return {x(p.x), y(p.y)}; }
};

MechanismCanvas canvas_of(const Model& model) {
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

// The state for the picture: up to `kMostDrawn` of the height, and at most half of the path.
const ChainState& shown_state(const Model& model, const Mechanism& m) {
  const auto& states = m.curve.states;
  const double wanted =
      std::min(kMostDrawn * model.anatomy.height, 0.5 * states.back().displacement);
  for (const ChainState& s : states)
    if (s.displacement >= wanted) return s;
  return states.back();
}

std::string blocks_at_rest(const Model& model, const MechanismCanvas& canvas) {
  std::string data;
  for (BlockId b = 0; b < model.n_block; ++b) {
    std::vector<Pixel> outline;
    for (const Vec3& corner : outline_of(model, b)) outline.push_back(canvas({corner.x, corner.y}));
    data += path_data(outline, true);
  }
  return path(data, "mortar");
}

std::string bodies(const Mechanism& m, const ChainState& now, const MechanismCanvas& canvas) {
  std::string before, after;
  for (std::size_t i = 0; i < m.chain.bodies.size(); ++i) {
    std::vector<Pixel> rest, moved;
    for (const Vec2& p : m.chain.bodies[i].outline) {
      rest.push_back(canvas(p));
      moved.push_back(canvas(placed(m.chain, now, i, p)));
    }
    before += path(path_data(rest, true), "before");
    after += path(path_data(moved, true), fmt::format("body{}", i));
  }
  return before + after;
}

std::string hinges(const ChainState& now, const MechanismCanvas& canvas) {
  constexpr const char* kNames[] = {"C1", "C12", "C23", "C3"};
  std::string out;
  for (std::size_t i = 0; i < now.hinges.size(); ++i) {
    const Pixel at = canvas(now.hinges[i]);
    out += circle(at, 5.5, "hinge");
    out += label({at.x + 9, at.y + (i == 1 ? -8 : 17)}, kNames[i], "bold halo");
  }
  return out;
}

std::string arrow(const Mechanism& m, const ChainState& now, const MechanismCanvas& canvas) {
  const std::size_t body = m.chain.loaded_body;
  const Pixel tip = canvas(placed(m.chain, now, body, m.chain.load_point));
  const double back = -m.chain.direction;
  return path(
      path_data({{tip.x + 46 * back, tip.y}, tip}, false) +
          path_data({{tip.x + 9 * back, tip.y - 6}, tip, {tip.x + 9 * back, tip.y + 6}}, false),
      "arrow");
}

std::string title_of(const Mechanism& m) { return m.mode + ", " + word_of(kTitles, m.hypothesis); }

}  // namespace

std::string mechanism_svg(const Model& model, const Mechanism& mechanism) {
  const MechanismCanvas canvas = canvas_of(model);
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

}  // namespace wythe
