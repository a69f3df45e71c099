// Sorts the blocks of a model into walls, by the names of the builder or else by connected joints. A wall
// has a plane if it is thin in plan: the square of thickness over length is a tenth or less. A block of
// another wall also belongs to this one if it lies within its thickness, as teeth of corners do.
#include "judge/modes/elevations.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <utility>

#include "core/text.h"
#include "judge/modes/space_pieces.h"
#include "wythe/parts/reading.h"

namespace wythe::study {
namespace {

struct Range {
  double low = 1e300, high = -1e300;
  void take(double x) { low = std::fmin(low, x), high = std::fmax(high, x); }
  [[nodiscard]] double common(const Range& other) const {
    return std::fmin(high, other.high) - std::fmax(low, other.low);
  }
};

// Extent of blocks along a direction.
template <class Blocks>
Range range_of(const Model& model, const Blocks& blocks, Vec3 direction) {
  Range range;
  for (const BlockId b : blocks)
    for (const Vec3& corner : corners_of(model, b)) range.take(dot(corner, direction));
  return range;
}

// Direction of a wall. Head joints lie across it, so their normals give
// it exactly. Centroids alone would be shifted by slabs and teeth.
Vec3 direction_of(const Model& model, const std::vector<char>& of, Vec3 near) {
  constexpr double kParallel = 0.95;
  Vec3 sum;
  for (JointId j = 0; j < model.n_pair; ++j) {
    const JointShape joint = joint_shape(model, j);
    const auto is_own = [&](BlockId b) { return b >= 0 && of[b] != 0; };
    const double along = dot(joint.normal, near);
    if (!is_own(joint.a) || !is_own(joint.b) || std::fabs(along) < kParallel) continue;
    sum = sum + std::copysign(joint.area, along) * joint.normal;
  }
  sum.y = 0;  // inclined head joints do not tilt the wall
  return length(sum) > 0 ? sum / length(sum) : near;
}

const std::vector<Polyhedron>& solid_of(const Model& model, BlockId block) {
  const int body = block - model.n_block - model.space.n_support;
  return body < 0 ? model.space.body[block].part : model.space.solids.bodies[body].body.part;
}

// Turns a direction along a wall towards +x, or towards +z for a wall along z.
Vec3 rightwards(Vec3 along) {
  constexpr double kNone = 1e-9;
  const bool turns = std::fabs(along.x) > kNone ? along.x < 0 : along.z < 0;
  return turns ? -1.0 * along : along;
}

// The space of a block in a wall.
struct Taken {
  Range along, up, across;
  [[nodiscard]] bool holds(const Vec3& place) const {
    constexpr double kTouch = 1e-6;  // [m]
    const auto is_in = [](const Range& range, double x) {
      return range.low <= x + kTouch && x <= range.high + kTouch;
    };
    return is_in(along, place.x) && is_in(up, place.y);
  }
};

// Adds every block that lies within the wall's length, and by more than a hundredth of the wall's thickness within its thickness
// there: a region may be thicker or thinner than the rest.
void take_teeth(const Model& model, const std::vector<BlockId>& own, Elevation& wall) {
  constexpr double kTouch = 0.01;
  const auto place_of = [&](BlockId b) {
    const std::array<BlockId, 1> one{b};
    return Taken{range_of(model, one, wall.along), range_of(model, one, Vec3{0, 1, 0}),
                 range_of(model, one, wall.across)};
  };
  std::vector<Taken> places;
  for (const BlockId b : own) places.push_back(place_of(b));
  const Range thickness = range_of(model, own, wall.across),
              length = range_of(model, own, wall.along);
  const double least = kTouch * (thickness.high - thickness.low);
  // The wall's thickness beside a block: of its blocks at that height, else of all along that length.
  const auto thickness_at = [&](const Taken& block) {
    Range beside, along;
    const auto widen = [](Range& range, const Range& by) {
      range = {std::fmin(range.low, by.low), std::fmax(range.high, by.high)};
    };
    for (const Taken& place : places) {
      if (place.along.common(block.along) < 0) continue;
      widen(along, place.across);
      if (place.up.common(block.up) > 0) widen(beside, place.across);
    }
    return beside.low < beside.high ? beside : along.low < along.high ? along : thickness;
  };
  const auto lies_in = [&](BlockId b) {
    const Taken block = place_of(b);
    return block.across.common(thickness) > least && block.along.common(length) > least &&
           block.across.common(thickness_at(block)) > least;
  };
  for (BlockId b = 0; b < model.n_block; ++b) {
    if (wall.of[b] == 0 && model.anatomy.block_role[b] != BlockRole::kSlab && lies_in(b))
      wall.of[b] = 1;
  }
  for (std::size_t k = 0; k < model.space.solids.bodies.size(); ++k) {
    const BlockId body = model.n_block + model.space.n_support + static_cast<BlockId>(k);
    if (lies_in(body)) wall.bodies.push_back(body);
  }
}

Range common_of(const Range& a, const Range& b) {
  return {std::fmax(a.low, b.low), std::fmin(a.high, b.high)};
}

// Length of the union of ranges.
double covered_by(std::vector<Range> ranges) {
  std::sort(ranges.begin(), ranges.end(),
            [](const Range& a, const Range& b) { return a.low < b.low; });
  double all = 0, reached = -1e300;
  for (const Range& range : ranges) {
    all += std::fmax(0, range.high - std::fmax(range.low, reached));
    reached = std::fmax(reached, range.high);
  }
  return all;
}

// For each joint the share of the wall's thickness where both of its blocks meet, against all blocks at its place.
std::vector<double> shares_of(const Model& model, const std::vector<BlockId>& own,
                              const Elevation& wall) {
  constexpr double kAll = 1 - 1e-6;
  const Range thickness = range_of(model, own, wall.across);
  std::vector<Taken> taken(model.n_block);
  const auto of = [&](BlockId b) -> const Taken& { return taken[b]; };
  std::vector<BlockId> by_foot;
  double tallest = 0;
  for (BlockId b = 0; b < model.n_block; ++b) {
    if (!wall.holds(b)) continue;
    const std::array<BlockId, 1> one{b};
    Taken& block = taken[b];
    block = {range_of(model, one, wall.along), range_of(model, one, Vec3{0, 1, 0}),
             common_of(range_of(model, one, wall.across), thickness)};
    tallest = std::fmax(tallest, block.up.high - block.up.low);
    by_foot.push_back(b);
  }
  std::stable_sort(by_foot.begin(), by_foot.end(),
                   [&](BlockId a, BlockId b) { return of(a).up.low < of(b).up.low; });
  std::vector<double> shares(model.n_joint, 1.0);
  for (JointId j = 0; j < model.n_joint; ++j) {
    const JointShape joint = joint_shape(model, j);
    if (!wall.holds(joint.b)) continue;
    Range common = of(joint.b).across;
    if (wall.holds(joint.a)) common = common_of(common, of(joint.a).across);
    const Vec3 place = wall.place(joint.centre);
    std::vector<Range> there;
    constexpr double kTouch = 1e-6;  // [m]
    auto b = std::lower_bound(by_foot.begin(), by_foot.end(), place.y - tallest - kTouch,
                              [&](BlockId block, double y) { return of(block).up.low < y; });
    for (; b != by_foot.end() && of(*b).up.low <= place.y + kTouch; ++b)
      if (of(*b).holds(place)) there.push_back(of(*b).across);
    const double all = covered_by(std::move(there));
    const double share = all > 0 ? std::fmax(0, common.high - common.low) / all : 1;
    if (share < kAll) shares[j] = share;
  }
  return shares;
}

std::vector<Elevation> walls_in_space(const Model& model) {
  constexpr double kThin = 0.1;
  std::vector<Elevation> walls;
  for (const WallBlocks& group : groups_of(model)) {
    const Plan plan = plan_of(group.blocks);
    if (plan.thin > kThin) continue;
    Elevation wall{.wall = group.name,
                   .of = std::vector<char>(static_cast<std::size_t>(model.n_block))};
    std::vector<BlockId> own;
    for (const Moved& b : group.blocks) {
      own.push_back(b.id);
      wall.of[b.id] = 1;
    }
    wall.along = rightwards(direction_of(model, wall.of, cross(Vec3{0, 1, 0}, plan.normal)));
    wall.across = cross(wall.along, Vec3{0, 1, 0});
    take_teeth(model, own, wall);
    wall.share = shares_of(model, own, wall);
    walls.push_back(std::move(wall));
  }
  for (std::size_t k = 0; k < walls.size(); ++k)
    if (walls.size() == 1)
      walls[k].wall.clear();
    else if (walls[k].wall.empty())
      walls[k].wall = std::to_string(k + 1);
  return walls;
}

// Convex hull of points in a plane, anticlockwise (Andrew's chain).
std::vector<Vec3> hull_round(std::vector<Vec3> points) {
  std::sort(points.begin(), points.end(),
            [](const Vec3& a, const Vec3& b) { return a.x < b.x || (a.x == b.x && a.y < b.y); });
  std::vector<Vec3> hull;
  const auto take = [&](const Vec3& p, std::size_t fixed) {
    const auto turns_left = [&] {
      const Vec3 a = hull[hull.size() - 2], b = hull.back();
      return cross(b - a, p - a).z > 0;
    };
    while (hull.size() >= fixed + 2 && !turns_left()) hull.pop_back();
    hull.push_back(p);
  };
  for (const Vec3& p : points) take(p, 0);
  const std::size_t lower = hull.size() - 1;
  for (auto p = points.rbegin() + 1; p < points.rend(); ++p) take(*p, lower);
  hull.pop_back();
  return hull;
}

}  // namespace

std::vector<Elevation> elevations_of(const Model& model) {
  if (dimension_of(model) == 2) return {Elevation{}};
  return walls_in_space(model);
}

std::vector<std::vector<Vec3>> outlines_of(const Model& model, const Elevation& seen,
                                           BlockId block) {
  if (seen.of.empty()) return {outline_of(model, block)};
  std::vector<std::vector<Vec3>> outlines;
  for (const Polyhedron& part : solid_of(model, block)) {
    std::vector<Vec3> corners;
    for (const Vec3& corner : part.vertex) corners.push_back(seen.place(corner));
    outlines.push_back(hull_round(std::move(corners)));
  }
  return outlines;
}

Reach reach_of(const Elevation& seen, const Vec3& half, const Vec3& half_2) {
  const Vec3 one = seen.seen(half), two = seen.seen(half_2);
  return {std::fabs(one.x) + std::fabs(two.x), std::fabs(one.y) + std::fabs(two.y)};
}

double inertia_of(const Model& model, const Elevation& seen, BlockId block) {
  if (seen.of.empty()) return model.inertia[block];
  const Space& s = model.space;
  const auto share = [&](const Vec3& axis) {
    return dot(axis, seen.across) * dot(axis, seen.across);
  };
  return share(s.axis_1[block]) * s.inertia[block].x + share(s.axis_2[block]) * s.inertia[block].y +
         share(s.axis_3[block]) * s.inertia[block].z;
}

std::vector<WallBlocks> groups_of(const Model& model) {
  std::vector<WallBlocks> groups;
  std::vector<Moved> unnamed;
  for (const Moved& b : evaluate_blocks(model, initial_state(model))) {
    if (!makes_walls(model, b.id)) continue;
    const std::string name = wall_of(b.body->id);
    if (name.empty()) {
      unnamed.push_back(b);
      continue;
    }
    auto group = std::find_if(groups.begin(), groups.end(),
                              [&](const WallBlocks& known) { return known.name == name; });
    if (group == groups.end()) group = groups.insert(group, {name, {}});
    group->blocks.push_back(b);
  }
  for (std::vector<Moved>& cluster : clusters_of(model, unnamed))
    groups.push_back({"", std::move(cluster)});
  return groups;
}

bool makes_walls(const Model& model, BlockId block) {
  const BlockRole role = model.anatomy.block_role[block];
  return role != BlockRole::kSlab && role != BlockRole::kFrame && role != BlockRole::kCutOut &&
         role != BlockRole::kRingBeam;
}

std::string wall_of(const std::string& id) {
  for (std::size_t dot = id.find('.'); dot != std::string::npos; dot = id.find('.', dot + 1)) {
    const std::string_view rest = std::string_view(id).substr(dot + 1);
    const bool unit = rest.size() > 1 && rest[0] == 'c' && is_digit(rest[1]);
    if (unit || rest.starts_with("lintel") || rest.starts_with("sill") || rest.starts_with("arch"))
      return id.substr(0, dot);
  }
  return "";
}

}  // namespace wythe::study
