// Shapes for the free contacts of a wall: bevelled convex parts of blocks, supports and ground, and the material of
// each body in a contact (docs/theory/contacts.md).
#include "model/free_shapes.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "contact/parameters.h"
#include "core/elementary.h"
#include "geometry/polygon.h"
#include "model/parts.h"

namespace wythe {
namespace {

using geometry::Polygon;

// A thousandth of a block. Contacts are shorter by no more than that, and corners that meet at the start have room
// for elastic motion.
constexpr double kBevel = 1e-3;
// Limit of the motion of blocks, in sizes of the wall on each side of it.
constexpr double kWorld = 20;

class Shapes {
 public:
  explicit Shapes(FreeShapes& shapes) : s_(shapes) {
    s_.part_begin = {0};
    s_.corner_begin = {0};
  }
  void add_body(const Polygon& outline, Vec2 centre, double thickness) {
    for (const Polygon& part : geometry::convex_parts(outline)) add_part(part, centre);
    s_.part_begin.push_back(static_cast<std::int32_t>(s_.corner_begin.size()) - 1);
    s_.thickness.push_back(thickness);
  }

 private:
  void add_part(const Polygon& part, Vec2 centre) {
    for (const Vec2& v : geometry::bevelled(part, s_.bevel)) {
      s_.corner_x.push_back(contact::on_grid(v.x - centre.x));
      s_.corner_y.push_back(contact::on_grid(v.y - centre.y));
    }
    s_.corner_begin.push_back(static_cast<std::int32_t>(s_.corner_x.size()));
  }
  FreeShapes& s_;
};

Polygon outline_of(const std::vector<double>& x, const std::vector<double>& y, int from, int to) {
  Polygon outline;
  for (int i = from; i < to; ++i) outline.push_back({x[i], y[i]});
  return outline;
}

// Refuses ground that no block can reach, and blocks that begin below it.
void check_ground(const ModelSpec& spec, double lowest, FaultList& faults) {
  const double ground = spec.solve.ground;
  if (!std::isfinite(ground)) return;
  const auto fault = [&](const std::string& problem, const std::string& cure) {
    faults.add({"", "solve.ground", fmt::format("{:g} m", ground), problem, cure, 0});
  };
  if (spec.solve.contacts == Contacts::kJoints)
    return fault("has no effect: blocks meet it by free contacts alone",
                 "write contacts = \"free\" beside it, or leave it out");
  constexpr double kRoundOff = 1e-6;  // [m]
  if (lowest < ground - kRoundOff)
    fault(fmt::format("lies {:.4g} mm above the lowest block, which would begin inside the ground",
                      1e3 * (ground - lowest)),
          fmt::format("write ground = \"{:g} m\" or lower", lowest));
}

// Adds level ground where joints have no body below: the steps of a built wall extend without limit on both sides.
void add_ground(const ModelSpec& spec, const geometry::Assembly& assembly, Model& m,
                Shapes& shapes) {
  FreeShapes& f = m.free;
  const double depth = f.y1 - f.y0, no_end = std::numeric_limits<double>::infinity();
  const auto level = [&](double x0, double x1, double y) {
    shapes.add_body({{x0, y - depth}, {x1, y - depth}, {x1, y}, {x0, y}}, {}, no_end);
    ++f.n_fixed;
  };
  if (std::isfinite(spec.solve.ground)) {
    level(f.x0, f.x1, spec.solve.ground);
  } else if (!assembly.ground.empty()) {
    for (std::size_t k = 0; k < assembly.ground.size(); ++k)
      level(k == 0 ? f.x0 : assembly.ground[k].x0,
            k + 1 == assembly.ground.size() ? f.x1 : assembly.ground[k].x1, assembly.ground[k].y);
  } else if (m.n_pair < m.n_joint && m.anatomy.support_begin.size() < 2) {
    double lowest = no_end;
    for (const double y : m.anatomy.outline_y) lowest = std::min(lowest, y);
    level(f.x0, f.x1, lowest);
  }
}

// The material of a body is that of its largest joint that is no elastic chain; without one, the most
// frequent of the wall.
void choose_materials(Model& m) {
  FreeShapes& f = m.free;
  std::vector<double> largest(f.thickness.size(), 0.0);
  std::vector<double> common(m.materials.size(), 0.0);
  f.material.assign(f.thickness.size(), -1);
  for (std::size_t j = 0; j < m.joint_a.size(); ++j) {
    if (m.anatomy.joint_kind[j] == JointKind::kLintelChain) continue;
    common[m.joint_material[j]] += m.area[j];
    for (const BlockId side : {m.joint_a[j], m.joint_b[j]}) {
      if (side == kGroundBlock) continue;  // supports in space have numbers
      if (!(m.area[j] > largest[side])) continue;
      largest[side] = m.area[j];
      f.material[side] = m.joint_material[j];
    }
  }
  const auto most = std::max_element(common.begin(), common.end()) - common.begin();
  for (std::int32_t& material : f.material)
    if (material < 0) material = static_cast<std::int32_t>(most);
}

}  // namespace

void compile_free(const ModelSpec& spec, const geometry::Assembly& assembly, Model& m,
                  FaultList& faults) {
  double lowest = std::numeric_limits<double>::infinity();
  for (const double y : m.anatomy.outline_y) lowest = std::min(lowest, y);
  check_ground(spec, lowest, faults);
  if (spec.solve.contacts == Contacts::kJoints) return;
  if (!m.solids.bodies.empty()) {
    faults.add({"", "solve.contacts", "free",
                "free contacts know rigid blocks alone, and a block is cut into zones",
                "write contacts = \"joints\", or give the lintel model = \"segments\"", 0});
    return;
  }
  FreeShapes& f = m.free;
  const Anatomy& a = m.anatomy;
  double size = 0, x0 = 1e300, y0 = 1e300, x1 = -1e300, y1 = -1e300;
  const auto widen = [&](const std::vector<double>& x, const std::vector<double>& y) {
    for (const double v : x) x0 = std::min(x0, v), x1 = std::max(x1, v);
    for (const double v : y) y0 = std::min(y0, v), y1 = std::max(y1, v);
  };
  widen(a.outline_x, a.outline_y);
  widen(a.support_x, a.support_y);
  const double around = kWorld * std::max(x1 - x0, y1 - y0);
  f.x0 = x0 - around, f.x1 = x1 + around;
  f.y0 = y0 - around, f.y1 = y1 + around;
  std::vector<Polygon> outlines;
  for (std::size_t i = 0; i < static_cast<std::size_t>(m.n_block); ++i) {
    outlines.push_back(
        outline_of(a.outline_x, a.outline_y, a.outline_begin[i], a.outline_begin[i + 1]));
    size += std::sqrt(geometry::moments(outlines.back()).area);
  }
  f.bevel = kBevel * size / m.n_block;
  Shapes shapes(f);
  for (std::size_t i = 0; i < outlines.size(); ++i)
    shapes.add_body(outlines[i], {m.centroid_x[i], m.centroid_y[i]}, a.block_thickness[i]);
  for (std::size_t k = 0; k + 1 < a.support_begin.size(); ++k) {
    shapes.add_body(
        outline_of(a.support_x, a.support_y, a.support_begin[k], a.support_begin[k + 1]), {},
        std::numeric_limits<double>::infinity());
    ++f.n_fixed;
  }
  add_ground(spec, assembly, m, shapes);
  choose_materials(m);
}

std::int32_t support_of(const Model& m, JointId joint) {
  const FreeShapes& f = m.free;
  const auto j = static_cast<std::size_t>(joint), b = static_cast<std::size_t>(m.joint_b[j]);
  const double x = m.centroid_x[b] + m.arm_b_x[j] + f.bevel * m.tangent_y[j];
  const double y = m.centroid_y[b] + m.arm_b_y[j] - f.bevel * m.tangent_x[j];
  const auto holds = [&](std::int32_t part) {
    const auto first = static_cast<std::size_t>(f.corner_begin[part]),
               end = static_cast<std::size_t>(f.corner_begin[part + 1]);
    for (std::size_t i = first; i < end; ++i) {
      const std::size_t next = i + 1 == end ? first : i + 1;
      const double ex = f.corner_x[next] - f.corner_x[i], ey = f.corner_y[next] - f.corner_y[i];
      if (ex * (y - f.corner_y[i]) - ey * (x - f.corner_x[i]) < 0) return false;
    }
    return true;
  };
  for (std::int32_t body = m.n_block; body < m.n_block + f.n_fixed; ++body)
    for (auto part = f.part_begin[body]; part < f.part_begin[body + 1]; ++part)
      if (holds(part)) return body;
  return -1;
}

std::int32_t free_material_of(const Model& m, std::int32_t a, std::int32_t b) {
  const auto kn = [&](std::int32_t material) { return m.materials[material].normal_stiffness; };
  std::int32_t material = m.free.material[a];
  if (kn(m.free.material[b]) < kn(material)) material = m.free.material[b];
  double largest = 0;
  for (auto e = m.block_begin[a]; e < m.block_begin[a + 1]; ++e) {
    const JointId j = m.block_entry[e] >> 1;
    const BlockId other = m.joint_a[j] == a ? m.joint_b[j] : m.joint_a[j];
    if (!(m.area[j] > largest)) continue;
    if (other == kGroundBlock ? b < m.n_block || support_of(m, j) != b : other != b) continue;
    largest = m.area[j];
    material = m.joint_material[j];
  }
  return material;
}

contact::FreeLaw free_law_of(const Model& m, std::int32_t a, std::int32_t b) {
  return contact::free_law(contact::constants_of(m.materials[free_material_of(m, a, b)]),
                           std::min(m.free.thickness[a], m.free.thickness[b]));
}

// --- in space -------------------------------------------------------------------------------------------

namespace {

// Level ground as a body: y is its top; it is as wide as blocks may move.
Polyhedron ground_of(const FreeShapes& f, double y) {
  Polyhedron box;
  const double depth = f.y1 - f.y0;
  for (const double z : {f.z0, f.z1})
    for (const double h : {y - depth, y})
      for (const double x : {f.x0, f.x1}) box.vertex.push_back({x, h, z});
  box.face = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  return box;
}

}  // namespace

contact::SpaceParts free_parts(const Model& m) {
  contact::SpaceParts parts;
  for (std::size_t body = 0; body < m.space.body.size(); ++body)
    for (const Polyhedron& part : m.space.body[body].part)
      parts.add(part, m.space.centroid[body], m.free.bevel);
  if (m.free.n_fixed > m.space.n_support)
    parts.add(ground_of(m.free, m.solve.ground), {}, m.free.bevel);
  return parts;
}

void compile_free_in_space(const ModelSpec& spec, Model& m, FaultList& faults) {
  double lowest = std::numeric_limits<double>::infinity();
  for (std::size_t body = 0; body < static_cast<std::size_t>(m.n_block); ++body)
    for (const Polyhedron& part : m.space.body[body].part)
      for (const Vec3& v : part.vertex) lowest = std::fmin(lowest, v.y);
  check_ground(spec, lowest, faults);
  if (spec.solve.contacts == Contacts::kJoints) return;
  if (!m.space.solids.bodies.empty()) {
    faults.add({"", "solve.contacts", "free",
                "free contacts know rigid blocks alone, and a block is cut into zones",
                "write contacts = \"joints\", or leave zones out", 0});
    return;
  }
  FreeShapes& f = m.free;
  Vec3 low{1e300, 1e300, 1e300}, high{-1e300, -1e300, -1e300};
  double size = 0;
  f.part_begin = {0};
  for (std::size_t body = 0; body < m.space.body.size(); ++body) {
    f.part_begin.push_back(f.part_begin.back() +
                           static_cast<std::int32_t>(m.space.body[body].part.size()));
    Vec3 from{1e300, 1e300, 1e300}, to{-1e300, -1e300, -1e300};
    for (const Polyhedron& part : m.space.body[body].part)
      for (const Vec3& v : part.vertex) {
        from = {std::fmin(from.x, v.x), std::fmin(from.y, v.y), std::fmin(from.z, v.z)};
        to = {std::fmax(to.x, v.x), std::fmax(to.y, v.y), std::fmax(to.z, v.z)};
      }
    low = {std::fmin(from.x, low.x), std::fmin(from.y, low.y), std::fmin(from.z, low.z)};
    high = {std::fmax(to.x, high.x), std::fmax(to.y, high.y), std::fmax(to.z, high.z)};
    const Vec3 d = to - from;
    if (body < static_cast<std::size_t>(m.n_block)) size += elementary::cbrt(d.x * d.y * d.z);
  }
  f.bevel = kBevel * size / m.n_block;
  const double around = kWorld * std::max({high.x - low.x, high.y - low.y, high.z - low.z});
  f.x0 = low.x - around, f.x1 = high.x + around;
  f.y0 = low.y - around, f.y1 = high.y + around;
  f.z0 = low.z - around, f.z1 = high.z + around;
  f.n_fixed = m.space.n_support;
  if (std::isfinite(spec.solve.ground)) {
    ++f.n_fixed;
    f.part_begin.push_back(f.part_begin.back() + 1);
  }
  f.thickness.assign(m.n_block + f.n_fixed, 1.0);
  choose_materials(m);
}

}  // namespace wythe
