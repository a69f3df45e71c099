// Reads the motion of each joint and block in a state, and sums it along straight lines (5.1) and
// along beds. Plates and the beam are kept apart as the top. Frames and coats are left out, because
// names describe the masonry. For pieces that came off, a rigid motion is fitted repeatedly to the
// rest of the wall. Blocks that left it by `parted` are then joined across joints that moved less.
#include "judge/modes/joint_motion.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>

#include "wythe/parts/reading.h"

namespace wythe::study {
namespace {

constexpr double kNowhere = 1e300;  // place of blocks of other walls

bool is_masonry(JointKind kind) {
  return kind != JointKind::kLintelChain && kind != JointKind::kLintelBond;
}

// The slip of a point: the upper side against the lower along the wall, or the right against the left upwards.
double slip_of(const Elevation& seen, const JointMotion& j, const Vec3& normal, double slip,
               const Vec3& slip_vector) {
  if (seen.of.empty()) return slip;
  // n points to b, which is above, below, right or left of a; the face may have turned since the start
  const Vec3 way = seen.seen(slip_vector), to_b = seen.seen(normal);
  const double along =
      j.is_bed ? std::copysign(1.0, to_b.y) * way.x : -std::copysign(1.0, to_b.x) * way.y;
  return std::copysign(std::hypot(way.x, way.y), along);
}

JointMotion motion_of(const Model& m, const WallReading& wall, const JointReading& joint,
                      const Elevation& seen) {
  const JointShape& shape = joint.shape;
  JointMotion j;
  j.kind = shape.kind;
  j.a = shape.a;
  j.b = shape.b;
  const Vec3 normal = seen.seen(shape.normal), centre = seen.place(shape.centre);
  const Reach reach = reach_of(seen, shape.half, shape.half_2);
  j.is_bed = std::fabs(normal.y) >= std::fabs(normal.x);
  j.on_ground = shape.a == kGroundBlock;
  j.x = centre.x;
  j.y = centre.y;
  j.reach_x = reach.along;
  j.reach_y = reach.up;
  for (const PointReading& point : wall.points_of(joint)) {
    const double most = std::max({0.0, point.opening, point.opened});
    j.opening += point.share * std::max(0.0, point.opening);
    j.opened += point.share * most;
    j.widest = std::max(j.widest, most);
    const double slip = slip_of(seen, j, shape.normal, point.slip, point.slip_vector);
    j.slip += point.share * slip;
    j.slid += point.share * (seen.of.empty() ? point.slid : std::copysign(point.slid, slip));
    j.crushed += point.share * point.crushed;
  }
  j.crushing = joint.crushing;
  j.force = joint.compression;
  const JointMaterial& law = m.materials[shape.material];
  j.bond = shape.area * std::max(law.tensile_strength, law.cohesion);
  j.has_slid_off = has_slid_off(m, wall.points, shape.id);
  if (!seen.share.empty()) j.share = seen.share[shape.id];
  return j;
}

// Whether a joint belongs to the wall, and lies neither between its leaves nor beside a wall that it meets.
bool is_seen(const Elevation& seen, const JointShape& shape) {
  constexpr double kAcross = 0.7;
  return seen.of.empty() ||
         ((shape.a == kGroundBlock || seen.holds(shape.a)) && seen.holds(shape.b) &&
          std::fabs(dot(shape.normal, seen.across)) < kAcross);
}

}  // namespace

WallMotion evaluate_motion(const Model& m, const State& state, const Elevation& seen) {
  return evaluate_motion(m, read_wall(m, state), seen);
}

WallMotion evaluate_motion(const Model& m, const WallReading& now, const Elevation& seen) {
  WallMotion wall;
  for (JointId j = 0; j < m.n_joint; ++j) {  // contacts of deformable blocks do not count in modes
    const JointShape& shape = now.joints[j].shape;
    if (!is_seen(seen, shape)) continue;
    const JointMotion joint = motion_of(m, now, now.joints[j], seen);
    // a name describes the masonry
    if (joint.kind == JointKind::kFrame || joint.kind == JointKind::kCoat) continue;
    const bool is_top = joint.kind == JointKind::kPlate || joint.kind == JointKind::kBeam;
    (is_top ? wall.top : wall.joints).push_back(joint);
  }
  for (BlockId b = 0; b < m.n_block; ++b) {
    const BlockReading& block = now.blocks[b];
    if (!seen.holds(b)) {
      wall.blocks.push_back({{{kNowhere, kNowhere, 0}, {}, {}}, BlockRole::kCutOut, 0, 0});
      continue;
    }
    wall.blocks.push_back(
        {{seen.place(block.start), seen.in_plane(block.moved), seen.turn(block.turned.by)},
         block.role,
         m.mass[b],
         inertia_of(m, seen, b)});
  }
  return wall;
}

RigidMotion fitted(const std::vector<BlockMotion>& blocks, const Chosen& chosen) {
  RigidMotion fit;
  Vec3 turn;
  double mass = 0, inertia = 0;
  for (const BlockMotion& b : blocks) {
    if (!chosen(b)) continue;
    mass += b.mass;
    fit.at = fit.at + b.mass * b.at;
    fit.moved = fit.moved + b.mass * b.moved;
  }
  if (!(mass > 0)) return fit;
  fit.at = fit.at / mass;
  fit.moved = fit.moved / mass;
  for (const BlockMotion& b : blocks) {
    if (!chosen(b)) continue;
    const Vec3 arm = b.at - fit.at;
    turn = turn + (b.mass * cross(arm, b.moved - fit.moved) + b.inertia * b.turn);
    inertia += b.mass * dot(arm, arm) + b.inertia;
  }
  if (inertia > 0) fit.turn = turn / inertia;
  return fit;
}

namespace {

bool is_masonry(const BlockMotion& b) {
  return b.role != BlockRole::kPlate && b.role != BlockRole::kBeam && b.role != BlockRole::kFrame &&
         b.role != BlockRole::kCutOut;
}

// Displacement of all blocks relative to the rigid motion of the main part of the wall, at least half of
// it. The motion is fitted repeatedly to the blocks within `parted` of the last fit, or to the nearer half.
std::vector<double> ways_against_the_rest(const std::vector<BlockMotion>& blocks, double parted) {
  constexpr int kFits = 30;
  std::vector<double> ways(blocks.size(), 0.0), before;
  double within = std::numeric_limits<double>::infinity();
  for (int fit = 0; fit < kFits && ways != before; ++fit) {
    before = ways;
    const RigidMotion rest = fitted(blocks, [&](const BlockMotion& b) {
      return is_masonry(b) && before[&b - blocks.data()] <= within;
    });
    std::vector<double> masonry;
    for (std::size_t b = 0; b < blocks.size(); ++b) {
      const BlockMotion& m = blocks[b];
      ways[b] = length(m.moved - rest.moved - cross(rest.turn, m.at - rest.at));
      if (is_masonry(m)) masonry.push_back(ways[b]);
    }
    if (masonry.empty()) break;
    const auto middle = masonry.begin() + static_cast<std::ptrdiff_t>(masonry.size() / 2);
    std::nth_element(masonry.begin(), middle, masonry.end());
    within = std::max(parted, *middle);
  }
  return ways;
}

}  // namespace

std::vector<PieceOff> pieces_off(const WallMotion& motion, double crack, double parted) {
  const std::vector<BlockMotion>& blocks = motion.blocks;
  const std::vector<double> ways = ways_against_the_rest(blocks, parted);
  std::vector<std::size_t> root(blocks.size());
  std::iota(root.begin(), root.end(), std::size_t{0});
  const auto root_of = [&](std::size_t b) {
    while (root[b] != b) b = root[b] = root[root[b]];
    return b;
  };
  const auto is_off = [&](BlockId b) {
    return b >= 0 && is_masonry(blocks[b]) && ways[b] >= parted;
  };
  for (const JointMotion& j : motion.joints) {
    if (!is_off(j.a) || !is_off(j.b) || std::hypot(j.opening, j.slip) >= parted) continue;
    const std::size_t a = root_of(static_cast<std::size_t>(j.a)),
                      b = root_of(static_cast<std::size_t>(j.b));
    root[std::max(a, b)] = std::min(a, b);
  }
  std::map<std::size_t, PieceOff> by_root;
  double all = 0;
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    if (!is_masonry(blocks[b])) continue;
    all += blocks[b].mass;
    if (!is_off(static_cast<BlockId>(b))) continue;
    PieceOff& piece = by_root[root_of(b)];
    piece.blocks.push_back(b);
    piece.share += blocks[b].mass;
    piece.way += blocks[b].mass * ways[b];
  }
  std::map<std::size_t, double> around;
  for (const JointMotion& j : motion.joints) {
    const auto side = [&](BlockId b) {
      return is_off(b) ? by_root.find(root_of(static_cast<std::size_t>(b))) : by_root.end();
    };
    const auto a = side(j.a), b = side(j.b);
    if (a == b) continue;
    for (const auto& piece : {a, b}) {
      if (piece == by_root.end()) continue;
      around[piece->first] += j.length();
      if (std::hypot(j.widest, j.slip) >= crack) piece->second.torn += j.length();
    }
  }
  std::vector<PieceOff> pieces;
  for (auto& [of, piece] : by_root) {
    piece.torn = around[of] > 0 ? piece.torn / around[of] : 0.0;
    piece.way /= piece.share;
    piece.share /= all;
    pieces.push_back(std::move(piece));
  }
  std::stable_sort(pieces.begin(), pieces.end(),
                   [](const PieceOff& a, const PieceOff& b) { return a.share > b.share; });
  return pieces;
}

double LineSum::movement() const { return std::hypot(opened, slip); }

std::vector<LineSum> scan(const std::vector<JointMotion>& joints, const Box& box, Lines lines,
                          double pitch) {
  const bool level = lines == Lines::kLevel;
  const double start = level ? box.y0 : box.x0, length = level ? box.height() : box.width();
  constexpr double kTouch = 1e-6;  // [m]
  constexpr long kMost = 100'000;  // pitches: far more than the raster of a wall has cells
  const int n = 4 * static_cast<int>(std::clamp(std::lround(length / pitch), 1L, kMost));
  const double step = length / n;
  std::vector<LineSum> sums(n);
  for (int i = 0; i < n; ++i) sums[i].at = start + (i + 0.5) * step;
  for (const JointMotion& j : joints) {
    if (j.is_bed == level || !is_masonry(j.kind)) continue;
    const double across = level ? j.x : j.y;
    const double lo = level ? box.x0 : box.y0, hi = level ? box.x1 : box.y1;
    if (!(across > lo + kTouch && across < hi - kTouch)) continue;
    const double centre = level ? j.y : j.x, reach = level ? j.reach_y : j.reach_x;
    for (LineSum& line : sums) {
      if (std::fabs(line.at - centre) > reach) continue;
      line.opening += j.share * j.opening;
      line.opened += j.share * j.opened;
      line.slip += j.share * j.slip;
    }
  }
  return sums;
}

std::vector<BedSection> bed_sections(const std::vector<JointMotion>& joints, const Box& box,
                                     double course) {
  std::vector<const JointMotion*> beds;
  for (const JointMotion& j : joints)
    if (j.is_bed && box.holds(j.x, j.y)) beds.push_back(&j);
  std::stable_sort(beds.begin(), beds.end(),
                   [](const JointMotion* a, const JointMotion* b) { return a->y < b->y; });
  std::vector<BedSection> sections;
  for (const JointMotion* bed : beds) {
    if (sections.empty() || bed->y > sections.back().y + 0.25 * course)
      sections.push_back({bed->y, {}});
    sections.back().joints.push_back(bed);
  }
  return sections;
}

namespace {

constexpr double kAll = 0.9;  // of a section's width: a corner may still hang on

// Cuts the place of the joints into lengths within which the same joints lie one above the other; calls with each length.
template <class Look>
void each_length(const std::vector<const JointMotion*>& joints, const Look& look) {
  std::vector<double> ends;
  for (const JointMotion* j : joints) {
    ends.push_back(j->x - j->reach_x);
    ends.push_back(j->x + j->reach_x);
  }
  std::sort(ends.begin(), ends.end());
  for (std::size_t k = 1; k < ends.size(); ++k)
    if (ends[k] > ends[k - 1]) look(0.5 * (ends[k] + ends[k - 1]), ends[k] - ends[k - 1]);
}
bool lies_at(const JointMotion& j, double x) { return std::fabs(j.x - x) < j.reach_x; }

}  // namespace

double open_share(const BedSection& section, double width, double crack) {
  double open = 0;
  for (const JointMotion* j : section.joints)
    if (j->widest >= crack) open += j->length();
  return std::min(1.0, open / width);
}

double open_share_in_steps(const std::vector<BedSection>& sections, const Box& box, double crack) {
  std::vector<const JointMotion*> open;
  for (const BedSection& section : sections)
    for (const JointMotion* j : section.joints)
      if (j->widest >= crack && j->share >= 1) open.push_back(j);  // through all leaves
  const double gap = 1e-3 * box.width();
  double left = box.x0, right = box.x1;
  std::sort(open.begin(), open.end(), [](const JointMotion* a, const JointMotion* b) {
    return a->x - a->reach_x < b->x - b->reach_x;
  });
  for (const JointMotion* j : open)
    if (j->x - j->reach_x <= left + gap) left = std::max(left, j->x + j->reach_x);
  std::sort(open.begin(), open.end(), [](const JointMotion* a, const JointMotion* b) {
    return a->x + a->reach_x > b->x + b->reach_x;
  });
  for (const JointMotion* j : open)
    if (j->x + j->reach_x >= right - gap) right = std::min(right, j->x - j->reach_x);
  return std::min(1.0, std::max(left - box.x0, box.x1 - right) / box.width());
}

SteppedSlip slip_in_steps(const BedSection& first, const BedSection& second, double width) {
  std::vector<const JointMotion*> joints = first.joints;
  joints.insert(joints.end(), second.joints.begin(), second.joints.end());
  SteppedSlip most;
  for (const double sense : {1.0, -1.0}) {
    struct Length {
      double slip, in_first, length;
    };
    std::vector<Length> lengths;
    each_length(joints, [&](double x, double piece) {
      double below = 0, above = 0;
      for (const JointMotion* j : first.joints)
        if (lies_at(*j, x)) below += j->share * sense * j->slip;
      for (const JointMotion* j : second.joints)
        if (lies_at(*j, x)) above += j->share * sense * j->slip;
      if (below + above > 0) lengths.push_back({below + above, below, piece});
    });
    std::sort(lengths.begin(), lengths.end(),
              [](const Length& a, const Length& b) { return a.slip > b.slip; });
    double covered = 0, all = 0, of_first = 0;
    for (const Length& l : lengths) {
      covered += l.length, all += l.length * l.slip, of_first += l.length * l.in_first;
      if (covered < kAll * width) continue;
      if (l.slip > most.slip) most = {l.slip, of_first / all};
      break;
    }
  }
  return most;
}

double slip_all_across(const BedSection& section, double width) {
  std::vector<const JointMotion*> sorted = section.joints;
  std::sort(sorted.begin(), sorted.end(), [](const JointMotion* a, const JointMotion* b) {
    return std::fabs(a->slip) > std::fabs(b->slip);
  });
  double covered = 0;
  for (const JointMotion* j : sorted) {
    covered += j->length();
    if (covered >= kAll * width) return std::fabs(j->slip);
  }
  return 0;
}

double slid_all_across(const BedSection& section, double width) {
  const auto one_way = [&](double sense) {
    BedSection slid = section;
    std::vector<JointMotion> joints;
    joints.reserve(section.joints.size());
    for (std::size_t j = 0; j < slid.joints.size(); ++j) {
      joints.push_back(*section.joints[j]);
      joints.back().slip = std::max(0.0, sense * joints.back().slid);
      slid.joints[j] = &joints.back();
    }
    return sense * slip_all_across(slid, width);
  };
  return one_way(1) + one_way(-1);  // 0.9 of the width cannot go both ways
}

}  // namespace wythe::study
