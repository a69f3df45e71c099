// Draws the wall. From back to front: supports and ground, blocks by role (one path for
// each tint), sound joints (one path for all), cracked joints (one line each, with its
// numbers as a tooltip), crushed points, links, tops of storeys, push arrow, scale bar.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <map>

#include "report/html.h"
#include "report/style.h"
#include "report/svg.h"
#include "report/wall_picture.h"
#include "wythe/parts/reading.h"
#include "wythe/parts/report.h"

namespace wythe {
namespace report {
namespace {

constexpr double kWidth = 640;        // of the wall in the picture [px]
constexpr double kTallest = 560;      // of the wall in the picture [px]
constexpr double kMarginOfWall = 46;  // around it: arrow, ground, scale bar [px]
constexpr double kVisible = 0.05e-3;  // smaller openings and slips are drawn as closed [m]
constexpr double kCrushMark = 0.05;   // crushing above which a point is marked [-]
constexpr int kTints = 4;

struct Canvas {
  Axis x, y;
  double width = 0, height = 0;
  [[nodiscard]] Pixel operator()(Vec3 p) const { return {x(p.x), y(p.y)}; }
};

struct Bounds {
  double x0 = std::numeric_limits<double>::infinity(), x1 = -x0, y0 = x0, y1 = -x0;
  void add(Vec3 p) {
    if (!std::isfinite(p.x) || !std::isfinite(p.y)) return;
    x0 = std::min(x0, p.x), x1 = std::max(x1, p.x);
    y0 = std::min(y0, p.y), y1 = std::max(y1, p.y);
  }
};

// Blocks that fell far away would shrink the wall to a dot, so the view ends half a wall away from it.
Bounds bounds_of(const Model& model, const State& state, double scale) {
  Bounds rest, now;
  const Anatomy& a = model.anatomy;
  for (std::size_t i = 0; i < a.outline_x.size(); ++i) rest.add({a.outline_x[i], a.outline_y[i]});
  for (std::size_t i = 0; i < a.support_x.size(); ++i) rest.add({a.support_x[i], a.support_y[i]});
  if (!(rest.x1 > rest.x0)) rest = {.x0 = 0, .x1 = 1, .y0 = 0, .y1 = 1};
  now = rest;
  for (BlockId b = 0; b < block_count(model); ++b)
    for (const Vec3& p : outline_now(model, state, b, scale)) now.add(p);
  const double reach = 0.5 * std::max(rest.x1 - rest.x0, rest.y1 - rest.y0);
  return {.x0 = std::max(now.x0, rest.x0 - reach),
          .x1 = std::min(now.x1, rest.x1 + reach),
          .y0 = std::max(now.y0, rest.y0 - reach),
          .y1 = std::min(now.y1, rest.y1 + reach)};
}

Canvas canvas_of(const Bounds& bounds) {
  const double wide = bounds.x1 - bounds.x0;
  const double high = bounds.y1 - bounds.y0;
  const double pixels = std::min(kWidth / wide, kTallest / high);  // for each metre
  Canvas canvas;
  canvas.width = kWidth + 2 * kMarginOfWall;
  canvas.height = high * pixels + 2 * kMarginOfWall;
  const double left = (canvas.width - wide * pixels) / 2;
  canvas.x = {.offset = left - bounds.x0 * pixels, .factor = pixels};
  canvas.y = {.offset = kMarginOfWall + bounds.y1 * pixels, .factor = -pixels};
  return canvas;
}

// A tint that differs between neighbours and is the same in all pictures.
int tint_of(const Model& model, BlockId block) {
  const auto u = static_cast<std::uint32_t>(block) * 2654435761u;
  const auto course = static_cast<std::uint32_t>(model.anatomy.block_course[block] + 1);
  return static_cast<int>(((u >> 13) + course) % kTints);
}

// Blocks by their roles, one path for each tint.
struct BlockPaths {
  std::array<std::string, kTints> stones;
  std::string timber, plates;
  std::string& of(BlockRole role, int tint) {
    const bool is_timber = role == BlockRole::kLintel || role == BlockRole::kSill;
    return role == BlockRole::kMasonry ? stones[tint] : is_timber ? timber : plates;
  }
  [[nodiscard]] std::string drawn() const {
    std::string out;
    for (std::size_t i = 0; i < stones.size(); ++i)
      out += path(stones[i], fmt::format("stone{}", i));
    if (!timber.empty()) out += path(timber, "timber");
    if (!plates.empty()) out += path(plates, "plate");
    return out;
  }
};

std::string draw_blocks(const Model& model, const State& state, double scale,
                        const Canvas& canvas) {
  BlockPaths paths;
  for (BlockId b = 0; b < block_count(model); ++b) {
    if (!model.standing.holds(b, state.stage)) continue;
    std::vector<Pixel> outline;
    for (const Vec3& p : outline_now(model, state, b, scale)) outline.push_back(canvas(p));
    const BlockRole role = read_block(model, state, b).role;
    paths.of(role, b < model.n_block ? tint_of(model, b) : 0) += path_data(outline, true);
  }
  return paths.drawn();
}

// Blocks of a wall in space as they stand at the start, `shift` to the right.
std::string draw_seen(const Model& model, const study::Elevation& wall, double shift,
                      const Canvas& canvas) {
  BlockPaths paths;
  const auto add = [&](BlockId b, std::string& group) {
    for (const std::vector<Vec3>& part : study::outlines_of(model, wall, b)) {
      std::vector<Pixel> outline;
      for (const Vec3& p : part) outline.push_back(canvas(p + Vec3{shift, 0, 0}));
      group += path_data(outline, true);
    }
  };
  for (BlockId b = 0; b < model.n_block; ++b)
    if (wall.holds(b) && model.standing.holds(b, 0))
      add(b, paths.of(model.anatomy.block_role[b], tint_of(model, b)));
  for (const BlockId body : wall.bodies) add(body, paths.timber);
  return paths.drawn();
}

std::string draw_zones(const Model& model, const State& state, double scale, const Canvas& canvas) {
  std::string edges;
  for (std::size_t z = 0; z < model.solids.zone_shape.size(); ++z) {
    std::vector<Pixel> outline;
    for (const auto& corner : model.solids.corner)
      outline.push_back(canvas(node_now(model, state, corner[z], scale)));
    edges += path_data(outline, true);
  }
  return edges.empty() ? "" : path(edges, "zone");
}

// Fixed blocks, and a hatched line below each group of ground joints.
std::string draw_supports(const Model& model, const Canvas& canvas) {
  const Anatomy& a = model.anatomy;
  std::string fixed;
  for (std::size_t s = 0; s + 1 < a.support_begin.size(); ++s) {
    std::vector<Pixel> outline;
    for (int i = a.support_begin[s]; i < a.support_begin[s + 1]; ++i)
      outline.push_back(canvas({a.support_x[i], a.support_y[i]}));
    fixed += path_data(outline, true);
  }
  std::string out = fixed.empty() ? "" : path(fixed, "support");
  std::string ground, hatch;
  for (JointId j = model.n_pair; j < model.n_joint && fixed.empty(); ++j) {
    const JointShape joint = joint_shape(model, j);
    const Pixel from = canvas(joint.centre - joint.half), to = canvas(joint.centre + joint.half);
    ground += path_data({from, to}, false);
    const double low = std::min(from.x, to.x);
    for (double x = std::ceil(low / 9) * 9; x < std::max(from.x, to.x); x += 9)
      hatch += path_data({{x, from.y}, {x - 7, from.y + 8}}, false);
  }
  if (!ground.empty()) out += path(hatch, "hatch") + path(ground, "ground");
  return out;
}

// Outline of the masonry at the start. A blocks file may have any shape, so it has no such frame.
std::string draw_rest(const Model& model, const Canvas& canvas) {
  const Anatomy& a = model.anatomy;
  if (a.courses == 0) return "";
  return path(path_data({canvas({0, 0}), canvas({0, a.height}), canvas({a.length, a.height}),
                         canvas({a.length, 0})},
                        false),
              "rest");
}

// Chooses the style of a cracked joint and counts it; the width grows with the square root of the movement.
const char* crack_class(const JointReading& joint, WallPicture& picture) {
  const double slip = std::fabs(joint.slip);
  if (std::max(joint.opening, slip) < kVisible || joint.damage < 0.999) {
    int& count = joint.damage < 0.999 ? picture.softening : picture.closed;
    ++count;
    return joint.damage < 0.999 ? "crack softening" : "crack closed";
  }
  ++(joint.opening >= slip ? picture.open : picture.slipped);
  return joint.opening >= slip ? "crack open" : "crack slip";
}

std::string draw_crack(const JointReading& joint, Pixel from, Pixel to, WallPicture& picture) {
  const double slip = std::fabs(joint.slip);
  const double movement = std::max({joint.opening, slip, 0.0});
  const std::string css = crack_class(joint, picture);
  const bool is_softening = joint.damage < 0.999;
  // a softening joint is fainter, the less strength it has lost
  const double width = is_softening ? 0.5 + 0.7 * joint.damage
                                    : 1.1 + 2.9 * std::sqrt(std::min(1.0, movement / 5e-3));
  picture.widest = std::max(picture.widest, joint.opening);
  picture.longest = std::max(picture.longest, slip);
  return fmt::format(
      "<line class=\"{}\" stroke-width=\"{:.1f}\" opacity=\"{:.2f}\" x1=\"{:.1f}\" y1=\"{:.1f}\" "
      "x2=\"{:.1f}\" "
      "y2=\"{:.1f}\"><title>{}: open {} mm, slip {} mm, damage {}</title></line>\n",
      css, width, is_softening ? 0.25 + 0.65 * joint.damage : 1.0, from.x, from.y, to.x, to.y,
      text_of({word_of(kJointKindCodes, joint.shape.kind)}),
      rounded(std::max(0.0, joint.opening) * 1e3, 2), rounded(slip * 1e3, 2),
      rounded(joint.damage, 2));
}

// Both ends of a joint in the picture [m].
using Ends = std::function<std::array<Vec3, 2>(const JointReading&)>;

// Sound joints as mortar lines, damaged ones by the kind of damage.
std::string draw_joints(const WallReading& wall, const Ends& ends_of, const Canvas& canvas,
                        WallPicture& picture) {
  std::string mortar, split, cracks;
  for (const JointReading& joint : wall.joints) {
    if (joint.handed_over) continue;  // between separated blocks
    const auto ends = ends_of(joint);
    const Pixel from = canvas(ends[0]), to = canvas(ends[1]);
    if (joint.damage > 0.01)
      cracks += draw_crack(joint, from, to, picture);
    else if (joint.shape.kind == JointKind::kSplit)
      split += path_data({from, to}, false);
    else if (joint.shape.kind != JointKind::kLintelChain)
      mortar += path_data({from, to}, false);
  }
  return path(split, "split") + path(mortar, "mortar") + cracks;
}

std::string draw_crushed(const WallReading& wall, const Ends& ends_of, const Canvas& canvas,
                         WallPicture& picture) {
  std::string out;
  for (const JointReading& joint : wall.joints) {
    for (const PointReading& point : wall.points_of(joint)) {
      if (joint.handed_over || !(point.crushing >= kCrushMark)) continue;
      const auto ends = ends_of(joint);
      const double share = 0.5 + 0.46 * point.place;  // slightly inside the end of the face
      out += circle(canvas(ends[0] + share * (ends[1] - ends[0])),
                    2.6 + 2.4 * std::min(1.0, point.crushing), "crushed");
      ++picture.crushed;
    }
  }
  return out;
}

// The stage with the push in the picture: the present one, else the first push.
const Stage* pushing_stage(const Model& model, const State& state) {
  const std::size_t now = state.stage;
  if (now < model.stages.size() && !model.stages[now].driven.empty()) return &model.stages[now];
  for (const Stage& stage : model.stages)
    if (!stage.driven.empty()) return &stage;
  return nullptr;
}

// An arrow that ends at the pushed blocks, on the side from which the push comes.
std::string draw_arrow(const Model& model, const State& state, double scale, const Canvas& canvas,
                       const Stage& stage, const PushPart& part) {
  Bounds box;
  for (BlockId b : part.blocks)
    for (const Vec3& p : outline_now(model, state, b, scale)) box.add(p);
  const double dx = stage.drive_x;
  const double dy = -stage.drive_y;  // pixels count downwards
  const Pixel tip = canvas({dx > 0.5    ? box.x0
                            : dx < -0.5 ? box.x1
                                        : (box.x0 + box.x1) / 2,
                            dy < -0.5  ? box.y0
                            : dy > 0.5 ? box.y1
                                       : (box.y0 + box.y1) / 2});
  const Pixel head = {tip.x - 3 * dx, tip.y - 3 * dy};
  const double length = 12 + 20 * part.length;
  const Pixel tail = {head.x - length * dx, head.y - length * dy};
  const Pixel barb1 = {head.x - 9 * dx - 6 * dy, head.y - 9 * dy + 6 * dx};
  const Pixel barb2 = {head.x - 9 * dx + 6 * dy, head.y - 9 * dy - 6 * dx};
  return path(path_data({tail, head}, false) + path_data({barb1, head, barb2}, false), "arrow");
}

std::string draw_arrows(const Model& model, const State& state, double scale,
                        const Canvas& canvas) {
  const Stage* stage = pushing_stage(model, state);
  if (stage == nullptr) return "";
  std::string out;
  for (const PushPart& part : push_parts(model, *stage))
    out += draw_arrow(model, state, scale, canvas, *stage, part);
  return out;
}

// A cross wall as a coil between the point and a short vertical line for the neighbour.
std::string coil(Pixel end, double dx, double dy) {
  constexpr double kStep = 5, kHalf = 5;
  std::vector<Pixel> points{end};
  for (int k = 1; k <= 6; ++k) {
    const double off = k == 6 ? 0 : (k % 2 == 0 ? -kHalf : kHalf);
    points.push_back({end.x + kStep * k * dx - off * dy, end.y + kStep * k * dy + off * dx});
  }
  const Pixel foot = points.back();
  const Pixel from{foot.x - 9 * dy, foot.y + 9 * dx}, to{foot.x + 9 * dy, foot.y - 9 * dx};
  return path_data(points, false) + path_data({from, to}, false);
}

// Ties, diaphragms and springs with their forces as tooltips; slack ones are dashed.
std::string draw_links(const Model& model, const State& state, double scale, const Canvas& canvas) {
  if (model.links.n == 0) return "";
  const Links& l = model.links;
  const std::vector<LinkReading> rest = read_links(model, initial_state(model)),
                                 now = read_links(model, state);
  std::string out;
  for (std::size_t k = 0; k < now.size(); ++k) {
    const auto at = [&](int end) {
      return canvas(rest[k].ends[end] + scale * (now[k].ends[end] - rest[k].ends[end]));
    };
    // a dowel is drawn as its anchor
    if (l.kind[k] == LinkKind::kDowel || !model.standing.joins(l.a[k], l.b[k], state.stage))
      continue;
    const bool is_spring = l.kind[k] == LinkKind::kSpring;
    const std::string shape =
        is_spring ? coil(at(1), -l.span_x[k], l.span_y[k]) : path_data({at(0), at(1)}, false);
    std::string css = "link " + std::string(word_of(kLinkKindWords, l.kind[k]));
    if (l.kind[k] == LinkKind::kTie && !(now[k].force > 0)) css += " slack";
    out += fmt::format("<path class=\"{}\" d=\"{}\"><title>{}: {:+.1f} kN</title></path>", css,
                       shape, escaped(l.name[k]), 1e-3 * now[k].force);
    if (is_spring) continue;
    out += circle(at(0), 3, "link-end") + circle(at(1), 3, "link-end");
  }
  return out;
}

// Tops of storeys, at the wall's right end.
std::string draw_storeys(const Model& model, const Canvas& canvas) {
  std::string out;
  for (std::size_t k = 0; k < model.anatomy.storey_top.size(); ++k) {
    const Pixel at = canvas({model.anatomy.length, model.anatomy.storey_top[k], 0});
    out += path(path_data({{at.x + 2, at.y}, {at.x + 30, at.y}}, false), "level") +
           label({canvas.width - 3, at.y - 3}, fmt::format("{:.2f} m", model.anatomy.storey_top[k]),
                 "small", "end");
  }
  return out;
}

std::string draw_marks(const std::vector<WallMark>& marks, const Canvas& canvas) {
  std::string out;
  for (const WallMark& mark : marks) {
    const Pixel low = canvas({mark.x0, mark.y0}), high = canvas({mark.x1, mark.y1});
    out += path(path_data({low, {high.x, low.y}, high, {low.x, high.y}}, true),
                mark.is_hit ? "part hit" : "part") +
           label({(low.x + high.x) / 2, (low.y + high.y) / 2 + 5}, mark.name, "part-name halo",
                 "middle");
  }
  return out;
}

std::string draw_scale_bar(const Canvas& canvas) {
  // a round length of a tenth to a quarter of the wall
  const double metres = ticks(0, 0.25 * kWidth / canvas.x.factor, 3)[1];
  const double right = canvas.width - 10;
  const double left = right - metres * canvas.x.factor;
  const double y = canvas.height - 12;
  const std::string bar = path_data({{left, y - 4}, {left, y}, {right, y}, {right, y - 4}}, false);
  const std::string text =
      metres >= 1 ? fmt::format("{:g} m", metres) : fmt::format("{:g} mm", metres * 1e3);
  return path(bar, "scale") + label({(left + right) / 2, y - 5}, text, "small", "middle");
}

}  // namespace

double fitting_scale(const Model& model, const State& state) {
  double largest = 0;
  for (BlockId b = 0; b < model.n_block; ++b)
    largest = std::fmax(largest, length(read_block(model, state, b).moved));
  const double wanted = 0.05 * std::hypot(model.anatomy.length, model.anatomy.height);
  double scale = 1;
  for (double decade : {1.0, 10.0, 100.0})
    for (double step : {1.0, 2.0, 5.0})
      if (largest * decade * step <= wanted) scale = decade * step;
  return scale;
}

WallPicture draw_wall(const Model& model, const State& state, double scale,
                      const std::vector<WallMark>& marks) {
  WallPicture picture;
  const WallReading wall = read_wall(model, state);
  const Canvas canvas = canvas_of(bounds_of(model, state, scale));
  picture.svg = svg_begin(canvas.width, canvas.height, "wall", "The wall, displacements magnified");
  picture.svg += draw_rest(model, canvas) + draw_supports(model, canvas) +
                 draw_blocks(model, state, scale, canvas) + draw_zones(model, state, scale, canvas);
  const auto ends = [&](const JointReading& joint) {
    return ends_now(model, state, joint.shape.id, scale);
  };
  picture.svg += draw_joints(wall, ends, canvas, picture);
  picture.svg += draw_crushed(wall, ends, canvas, picture);
  picture.svg += draw_links(model, state, scale, canvas) + draw_storeys(model, canvas) +
                 draw_arrows(model, state, scale, canvas) + draw_marks(marks, canvas) +
                 draw_scale_bar(canvas) + "</svg>\n";
  return picture;
}

std::string draw_elevations(const Model& model, const std::vector<study::Elevation>& walls,
                            const std::vector<std::vector<WallMark>>& marks) {
  constexpr double kApart = 0.08;  // of the longest wall
  std::vector<Bounds> bounds(walls.size());
  double longest = 0;
  for (std::size_t k = 0; k < walls.size(); ++k) {
    for (BlockId b = 0; b < model.n_block; ++b)
      if (walls[k].holds(b))
        for (const auto& part : study::outlines_of(model, walls[k], b))
          for (const Vec3& p : part) bounds[k].add(p);
    longest = std::max(longest, bounds[k].x1 - bounds[k].x0);
  }
  Bounds all;
  std::vector<double> shift;
  double right = 0;
  for (const Bounds& of : bounds) {
    shift.push_back(right - of.x0);
    all.add({right, of.y0}), all.add({right + of.x1 - of.x0, of.y1});
    right += of.x1 - of.x0 + kApart * longest;
  }
  const Canvas canvas = canvas_of(all);
  std::string svg =
      svg_begin(canvas.width, canvas.height, "wall", "The walls, each seen across its plane");
  for (std::size_t k = 0; k < walls.size(); ++k) {
    std::vector<WallMark> moved = marks[k];
    for (WallMark& mark : moved) mark.x0 += shift[k], mark.x1 += shift[k];
    const Pixel head = canvas({shift[k] + 0.5 * (bounds[k].x0 + bounds[k].x1), bounds[k].y1});
    svg += draw_seen(model, walls[k], shift[k], canvas) + draw_marks(moved, canvas) +
           label({head.x, head.y - 8}, walls[k].wall, "small", "middle");
  }
  return svg + draw_scale_bar(canvas) + "</svg>\n";
}

std::vector<PushPart> push_parts(const Model& model, const Stage& push) {
  if (!push.has_pattern()) return {{push.driven}};
  constexpr double kThirds = 3;  // of all blocks
  const std::vector<double>& levels = push.push()->levels;
  const auto y_of = [&](BlockId b) { return model.centroid_y[b]; };
  std::map<long, std::pair<PushPart, double>> parts;  // by level or third, with the sum of shares
  double bottom = std::numeric_limits<double>::infinity();
  for (const double y : model.anatomy.outline_y) bottom = std::min(bottom, y);
  for (std::size_t k = 0; k < push.driven.size(); ++k) {
    const double height = y_of(push.driven[k]) - bottom;
    long part = static_cast<long>(kThirds * height / model.anatomy.height);
    if (!levels.empty()) {
      const auto nearest = std::min_element(levels.begin(), levels.end(), [&](double a, double b) {
        return std::fabs(a - height) < std::fabs(b - height);
      });
      part = nearest - levels.begin();
    }
    auto& [of, share] = parts[part];
    of.blocks.push_back(push.driven[k]);
    share += push.driven_share[k];
  }
  double most = 0;
  for (const auto& [part, of] : parts) most = std::max(most, std::fabs(of.second));
  std::vector<PushPart> out;
  for (auto& [part, of] : parts) {
    of.first.length = most > 0 ? std::fabs(of.second) / most : 1;
    out.push_back(std::move(of.first));
  }
  return out;
}

}  // namespace report

std::string wall_svg(const Model& model, const State& state, double scale) {
  std::string svg = report::draw_wall(model, state, scale).svg;
  const std::size_t head = svg.find(">\n") + 2;
  svg.insert(head, "<style>" + report::picture_style() + "</style>\n");
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n" + svg;
}

}  // namespace wythe
