// Cuts the wall at the ends of each pier and spandrel and sums the forces of the joints that the cut separates; see
// wythe/parts/element_forces.h.
//
// A cut follows the joints between blocks whose centroids lie on either side of a straight line, so it
// works for any bond. A pier's cut reaches half way over the openings beside it, where the haunches of
// an arch may carry. A spandrel's cut reaches down to the springing of an arch for the same reason.
#include "wythe/parts/element_forces.h"

#include <fmt/format.h>

#include <algorithm>

#include "judge/modes/joint_motion.h"
#include "judge/modes/wall_parts.h"
#include "wythe/parts/reading.h"

namespace wythe {
namespace {

using study::Box;
using study::Elevation;
using study::RigidMotion;

enum class Across { kPier, kSpandrel };

// One end of an element: the joints that it cuts and the blocks beyond.
struct Cut {
  Across across = Across::kPier;
  Vec3 middle;
  std::vector<std::pair<JointId, double>> joints;  // 1: a is the lower or left side, -1: b is
  std::vector<BlockId> beyond;                     // empty: the ground
};

// Position of a cut: at `at` along the element's axis, from `from` to `to` across it.
struct CutLine {
  Across across = Across::kPier;
  Vec3 middle;
  double from = 0, to = 0;        // joints of the cut
  double width0 = 0, width1 = 0;  // blocks beyond, whose motion is that of the end
  bool is_second = false;         // the element lies below it, or on its left
};

class Cutter {
 public:
  Cutter(const Model& model, const Elevation& seen, double course)
      : model_(model), seen_(seen), course_(course) {
    for (BlockId b = 0; b < block_count(model); ++b) {
      at_.push_back(b < model.n_block ? seen.place(centroid_of(model, b)) : middle_of(b));
    }
    for (std::size_t k = 0; k < model.space.solids.bodies.size(); ++k) {
      at_.resize(static_cast<std::size_t>(model.n_block + model.space.n_support) + k);
      at_.push_back(middle_of(static_cast<BlockId>(at_.size())));
    }
    for (JointId j = 0; j < joint_count(model); ++j) {
      const JointShape shape = joint_shape(model, j);
      if (is_of_wall(shape.a) && is_of_wall(shape.b)) shapes_.push_back(shape);
    }
  }

  [[nodiscard]] Cut at(const CutLine& line) const {
    constexpr double kTouch = 1e-6;  // [m]
    Cut cut{line.across, line.middle, {}, {}};
    std::vector<BlockId> beyond;
    for (const JointShape& shape : shapes_) {
      const Vec3 centre = seen_.place(shape.centre);
      const double place = line.across == Across::kPier ? centre.x : centre.y;
      if (place < line.from - kTouch || place > line.to + kTouch) continue;
      if (line.across == Across::kSpandrel && shape.a == kGroundBlock) continue;
      const bool a = is_beyond(shape.a, line), b = is_beyond(shape.b, line);
      if (a == b) continue;
      // the force on the near side, for either end
      const bool a_is_high = a == line.is_second;
      cut.joints.emplace_back(shape.id, a_is_high ? -1.0 : 1.0);
      if (const BlockId out = a ? shape.a : shape.b; out != kGroundBlock) beyond.push_back(out);
    }
    std::sort(beyond.begin(), beyond.end());
    beyond.erase(std::unique(beyond.begin(), beyond.end()), beyond.end());
    cut.beyond = in_line(beyond, line);
    if (cut.joints.empty()) cut.beyond = last_of(line);
    return cut;
  }

 private:
  // The middle of a deformable block's bounds.
  [[nodiscard]] Vec3 middle_of(BlockId block) const {
    Box box{1e300, -1e300, 1e300, -1e300};
    for (const Vec3& corner : corners_of(model_, block)) {
      const Vec3 p = seen_.place(corner);
      box = {std::min(box.x0, p.x), std::max(box.x1, p.x), std::min(box.y0, p.y),
             std::max(box.y1, p.y)};
    }
    return {0.5 * (box.x0 + box.x1), 0.5 * (box.y0 + box.y1)};
  }
  [[nodiscard]] bool is_of_wall(BlockId block) const {
    return block == kGroundBlock || block >= model_.n_block || seen_.holds(block);
  }
  [[nodiscard]] bool is_beyond(BlockId block, const CutLine& line) const {
    if (block == kGroundBlock) return !line.is_second;  // below every level
    const Vec3& at = at_[block];
    const bool high = line.across == Across::kPier ? at.y >= line.middle.y : at.x >= line.middle.x;
    return high == line.is_second;
  }
  // The rigid blocks in line with the element, or all if there are
  // none: a lintel beside a pier's head moves with its own opening.
  [[nodiscard]] std::vector<BlockId> in_line(const std::vector<BlockId>& blocks,
                                             const CutLine& line) const {
    std::vector<BlockId> rigid, inside;
    for (const BlockId b : blocks) {
      if (b >= model_.n_block) continue;
      rigid.push_back(b);
      const Vec3& at = at_[b];
      const double place = line.across == Across::kPier ? at.x : at.y;
      if (place > line.width0 && place < line.width1) inside.push_back(b);
    }
    return inside.empty() ? rigid : inside;
  }
  // With no blocks beyond, the element's own last course.
  [[nodiscard]] std::vector<BlockId> last_of(const CutLine& line) const {
    std::vector<BlockId> last;
    for (BlockId b = 0; b < model_.n_block; ++b) {
      if (!seen_.holds(b)) continue;
      const Vec3& at = at_[b];
      const bool pier = line.across == Across::kPier;
      const double along = pier ? at.y - line.middle.y : at.x - line.middle.x;
      const double place = pier ? at.x : at.y;
      if (place > line.width0 && place < line.width1 && std::abs(along) < course_)
        last.push_back(b);
    }
    return last;
  }

  const Model& model_;
  const Elevation& seen_;
  double course_;
  std::vector<Vec3> at_;  // centroids
  std::vector<JointShape> shapes_;
};

struct Element {
  std::array<Cut, 2> end;
  const Elevation* seen = nullptr;
};

Element cut_pier(const Cutter& cutter, const study::Pier& p) {
  Element e;
  const double middle = 0.5 * (p.box.x0 + p.box.x1);
  for (const int end : {0, 1})
    e.end[end] = cutter.at({.across = Across::kPier,
                            .middle = {middle, end == 0 ? p.clear_y0 : p.clear_y1},
                            .from = p.reach_x0,
                            .to = p.reach_x1,
                            .width0 = p.box.x0,
                            .width1 = p.box.x1,
                            .is_second = end == 1});
  return e;
}

Element cut_spandrel(const Cutter& cutter, const study::Spandrel& s) {
  Element e;
  const double middle = 0.5 * (s.box.y0 + s.box.y1);
  for (const int end : {0, 1})
    e.end[end] = cutter.at({.across = Across::kSpandrel,
                            .middle = {end == 0 ? s.box.x0 : s.box.x1, middle},
                            .from = s.box.y0 - 0.5 * s.opening,
                            .to = s.box.y1,
                            .width0 = s.box.y0,
                            .width1 = s.box.y1,
                            .is_second = end == 1});
  return e;
}

// Moment of the compression on b about the centre, in the plane of the wall.
double moment_of(const Elevation& seen, const JointReading& joint) {
  return seen.of.empty() ? joint.moment : -dot(joint.moment_vector, seen.across);
}

// Force of the upper side on the lower one, or of the right side on the left one.
ElementEnd forces_at(const Model& model, const Elevation& seen, const Cut& cut,
                     const WallReading& wall) {
  Vec3 force;
  double moment = 0;
  for (const auto& [id, side] : cut.joints) {
    const JointReading& joint = wall.joints[id];
    const Vec3 on = -side * seen.in_plane(force_of(model, joint, wall));
    force = force + on;
    moment +=
        cross(seen.place(joint.shape.centre) - cut.middle, on).z - side * moment_of(seen, joint);
  }
  ElementEnd end;
  const bool pier = cut.across == Across::kPier;
  end.axial = 0.0 - (pier ? force.y : force.x);  // 0, not -0
  end.shear = pier ? force.x : force.y;
  end.moment = moment;
  return end;
}

RigidMotion motion_of(const Model& model, const Elevation& seen, const Cut& cut,
                      const WallReading& wall) {
  std::vector<study::BlockMotion> blocks;
  for (const BlockId b : cut.beyond) {
    const BlockReading& now = wall.blocks[b];
    blocks.push_back({{seen.place(now.start), seen.in_plane(now.moved), seen.turn(now.turned.by)},
                      now.role,
                      model.mass[b],
                      study::inertia_of(model, seen, b)});
  }
  RigidMotion m = study::fitted(blocks, [](const study::BlockMotion&) { return true; });
  m.moved = m.moved + cross(m.turn, cut.middle - m.at);
  m.at = cut.middle;
  return m;
}

ElementForces::Row row_of(const Model& model, const Element& element, const WallReading& wall,
                          double displacement, double length) {
  ElementForces::Row row;
  row.displacement = displacement;
  std::array<RigidMotion, 2> motion;
  for (const std::size_t end : {0, 1}) {
    row.end[end] = forces_at(model, *element.seen, element.end[end], wall);
    motion[end] = motion_of(model, *element.seen, element.end[end], wall);
    row.end[end].turn = motion[end].turn.z;
  }
  const bool pier = element.end[0].across == Across::kPier;
  const Vec3 way = motion[1].moved - motion[0].moved;
  const double turn = 0.5 * (row.end[0].turn + row.end[1].turn);
  row.drift = (pier ? way.x : way.y) / length;
  row.distortion = row.drift + (pier ? turn : -turn);
  return row;
}

}  // namespace

std::vector<ElementForces> read_element_forces(const Model& model, const Result& result) {
  std::vector<const Snapshot*> states;
  if (!result.states.snapshots.empty() && !result.states.readings.empty() &&
      result.states.snapshots.front().label == "start")
    states.push_back(&result.states.snapshots.front());
  for (const Snapshot& s : result.states.readings)  // the end may be one of the readings
    if (states.empty() || states.back()->state.step != s.state.step) states.push_back(&s);
  return read_element_forces(model, states);
}

std::vector<ElementForces> read_element_forces(const Model& model,
                                               const std::vector<const Snapshot*>& states) {
  const std::vector<Elevation> elevations = study::elevations_of(model);
  const std::vector<study::WallParts> each = study::find_parts(model, elevations);
  std::vector<ElementForces> all;
  std::vector<Element> elements;
  std::vector<Cutter> cutters;
  for (std::size_t k = 0; k < elevations.size(); ++k)
    cutters.emplace_back(model, elevations[k], each[k].course);
  const auto add = [&](ElementForces of, Element element, std::size_t wall) {
    of.along = elevations[wall].along;
    all.push_back(std::move(of));
    element.seen = &elevations[wall];
    elements.push_back(std::move(element));
  };
  for (std::size_t k = 0; k < elevations.size(); ++k)
    for (const study::Pier& p : each[k].piers)
      add({p.name, "pier", p.mark, p.storey, p.clear_y1 - p.clear_y0}, cut_pier(cutters[k], p), k);
  for (std::size_t k = 0; k < elevations.size(); ++k)
    for (const study::Spandrel& s : each[k].spandrels)
      if (!s.is_sill)
        add({s.name, "spandrel", s.mark, s.storey, s.box.width()}, cut_spandrel(cutters[k], s), k);
  for (const Snapshot* s : states) {
    const WallReading wall = read_wall(model, s->state);
    for (std::size_t e = 0; e < all.size(); ++e)
      all[e].rows.push_back(row_of(model, elements[e], wall, s->displacement, all[e].length));
  }
  return all;
}

std::string element_forces_csv(const std::vector<ElementForces>& elements) {
  std::string text =
      "displacement_mm,mark,element,kind,storey,axial_1_kN,shear_1_kN,moment_1_kNm,axial_2_kN,"
      "shear_2_kN,moment_2_kNm,turn_1_mrad,turn_2_mrad,drift_percent,distortion_percent\n";
  const std::size_t rows = elements.empty() ? 0 : elements.front().rows.size();
  for (std::size_t r = 0; r < rows; ++r) {
    for (const ElementForces& e : elements) {
      const ElementForces::Row& row = e.rows[r];
      text += fmt::format("{:.6g},{},{},{},{}", 1e3 * row.displacement, e.mark, e.element, e.kind,
                          e.storey);
      for (const ElementEnd& end : row.end)
        text += fmt::format(",{:.6g},{:.6g},{:.6g}", 1e-3 * end.axial, 1e-3 * end.shear,
                            1e-3 * end.moment);
      text += fmt::format(",{:.6g},{:.6g},{:.6g},{:.6g}\n", 1e3 * row.end[0].turn,
                          1e3 * row.end[1].turn, 1e2 * row.drift, 1e2 * row.distortion);
    }
  }
  return text;
}

}  // namespace wythe
