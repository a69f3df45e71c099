// Names the failure of a wall in space: first the blocks that take part, then the rigid pieces that explain their motion. The
// order is loose stones, one piece, motion in the plane of thin walls, up to four pieces. The first rule that holds gives the
// name. The name is "unclear" where a slab slips on the walls, or where moved joints are pressed beyond their faces.
#include "judge/modes/in_space.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "judge/modes/elevations.h"
#include "judge/modes/space_pieces.h"
#include "wythe/parts/reading.h"

namespace wythe::study {
namespace {

constexpr double kTakesPart =
    0.25;  // of the largest displacement: a block with more takes part in the mechanism
constexpr double kStandsFor =
    1.0 / 3;                        // of the moved mass: the least share of a mechanism of the wall
constexpr double kSomeWall = 0.02;  // of the wall's mass: more than loose stones
constexpr double kMain = 2.0 / 3;   // of the moving mass: a piece that drags the others along
constexpr double kOffPlane = 0.15;  // of the motion: largest part out of the wall's plane
constexpr double kThin = 0.1;       // thickness over length, squared: a wall below it has a plane
constexpr double kParallel = 0.95;  // cosine above which two walls are parallel
constexpr double kOblique = 0.3;    // cosine above which a turn is also about an axis
constexpr double kSlidOff = 0.25;   // of the area of moved joints: above it no name is reliable

constexpr const char* kInPlanes = "mass of walls that move in their planes";
constexpr const char* kBreakingAway = "part breaking away";  // plane walls use this name too

double mass_of(const std::vector<Moved>& blocks) {
  double mass = 0;
  for (const Moved& b : blocks) mass += b.mass;
  return mass;
}

// Sums over the joints: the largest movement over a joint's size; area times opening and
// times slip; and the share of the moved area that is pressed where faces no longer overlap.
struct Joints {
  double movement = 0, size = 0, opened = 0, slid = 0, slid_off = 0;
};
Joints evaluate_joints(const Model& model, const WallReading& wall, double least) {
  Joints sum;
  double moved = 0, off = 0, all = 0;
  for (const JointReading& joint : wall.joints) {
    const double area = joint.shape.area, size = std::sqrt(area);
    const double opening = std::fmax(0, joint.opening);
    const double way = std::fmax(opening, joint.slip) / size;
    sum.movement = std::fmax(sum.movement, way);
    sum.size += area * size;
    all += area;
    if (way < least) continue;
    sum.opened += area * opening;
    sum.slid += area * joint.slip;
    moved += area;
    if (has_slid_off(model, wall.points, joint.shape.id)) off += area;
  }
  if (all > 0) sum.size /= all;
  if (moved > 0) sum.slid_off = off / moved;
  return sum;
}

// --- names ------------------------------------------------------------------------------------------------

double off_plane(const std::vector<Moved>& blocks, Vec3 normal) {
  double off = 0, all = 0;
  for (const Moved& b : blocks) {
    off += b.mass * dot(b.moved, normal) * dot(b.moved, normal);
    all += b.mass * dot(b.moved, b.moved);
  }
  return all > 0 ? std::sqrt(off / all) : 0;
}

double level_part(Vec3 turn) { return std::hypot(turn.x, turn.z); }
bool is_level(Vec3 turn) { return std::fabs(turn.y) < 0.5 * length(turn); }

// A place on a piece's axis of rotation, where the piece moves least.
Vec3 hinge_of(const Piece& piece) {
  return piece.centre + cross(piece.turn, piece.shift) / dot(piece.turn, piece.turn);
}

// Whether a piece contains units of two walls that meet, and tilts away from both.
bool is_wedge(const Piece& piece) {
  Vec3 first, along_two[2];
  double mass[2] = {0, 0};
  for (const Moved& b : piece.blocks) {
    if (length(b.longest) == 0) continue;
    if (length(first) == 0) first = b.longest;
    const bool as_first = std::fabs(dot(first, b.longest)) > 0.7;
    mass[as_first ? 0 : 1] += b.mass;
    along_two[as_first ? 0 : 1] = b.longest;
  }
  if (std::fmin(mass[0], mass[1]) < 0.2 * piece.mass) return false;
  const Vec3 axis = piece.turn / length(piece.turn);
  return std::fabs(dot(axis, along_two[0])) > kOblique &&
         std::fabs(dot(axis, along_two[1])) > kOblique;
}

Message one_piece(const Piece& piece, Vec3 normal, FailureMode& mode) {
  const double share = static_cast<double>(piece.blocks.size());
  const double degrees = length(piece.turn) * 180 / M_PI;
  if (!piece.turns) {
    if (std::fabs(piece.shift.y) > 0.7 * length(piece.shift))
      return {piece.shift.y < 0 ? "space.falls" : "space.rises",
              {{"blocks", share}, {"mm", 1e3 * length(piece.shift)}}};
    mode.name = "sliding";
    return {"space.sliding", {{"blocks", share}, {"mm", 1e3 * length(piece.shift)}}};
  }
  if (!is_level(piece.turn)) {
    mode.name = "turning";
    return {"space.turning", {{"blocks", share}}};
  }
  if (std::fabs(dot(piece.turn, normal)) > 0.8 * length(piece.turn)) {
    mode.name = "rocking";
    return {"space.rocking", {{"blocks", share}, {"degrees", degrees}}};
  }
  const Vec3 hinge = hinge_of(piece);
  mode.name = is_wedge(piece) ? "corner wedge" : "overturning";
  return {is_wedge(piece) ? "space.wedge" : "space.overturning",
          {{"blocks", share},
           {"y_m", hinge.y},
           {"x_m", hinge.x},
           {"z_m", hinge.z},
           {"degrees", degrees}}};
}

void note(FailureMode& mode, const char* what, double value, double threshold) {
  mode.evidence.push_back({"moving blocks", what, value, threshold, "-"});
}

// Pieces one above the other that turn against each other about horizontal axes: the wall spans vertically.
bool bends_upwards(const std::vector<Piece>& pieces) {
  bool against = false;
  for (const Piece& a : pieces) {
    if (!is_level(a.turn)) return false;
    for (const Piece& b : pieces) {
      const Vec3 to = b.centre - a.centre;
      if (std::fabs(to.y) < std::hypot(to.x, to.z)) return false;  // side by side
      against = against || dot(a.turn, b.turn) < -0.5 * length(a.turn) * length(b.turn);
    }
  }
  return against;
}

// Two pieces side by side that turn against each other about vertical axes, alone or together with a tilt.
struct Sideways {
  bool bends = false, oblique = false;
};
Sideways bends_sideways(const std::vector<Piece>& pieces) {
  Sideways found;
  for (const Piece& a : pieces)
    for (const Piece& b : pieces) {
      const bool upright = std::fabs(a.turn.y) > kOblique * length(a.turn) &&
                           std::fabs(b.turn.y) > kOblique * length(b.turn);
      if (!upright || !a.turns || !b.turns || !(a.turn.y * b.turn.y < 0)) continue;
      found.bends = true;
      // both tilt the same way as well, or another piece tilts
      const double lean = a.turn.x * b.turn.x + a.turn.z * b.turn.z;
      found.oblique = found.oblique ||
                      (lean > 0 && level_part(a.turn) > kOblique * length(a.turn) &&
                       level_part(b.turn) > kOblique * length(b.turn)) ||
                      std::any_of(pieces.begin(), pieces.end(), [](const Piece& c) {
                        return c.turns && level_part(c.turn) > 0.9 * length(c.turn);
                      });
    }
  return found;
}

// --- walls that move together ---------------------------------------------------------------------------------

// Masonry connected by joints, and its blocks that take part.
struct Wall {
  std::vector<Moved> all, part;
};

// "walls left, right", or the number of blocks where they have no names of walls.
Message walls_of(const std::vector<Moved>& blocks) {
  constexpr std::size_t kMostNames = 6;
  std::vector<std::string> names;
  for (const Moved& b : blocks) {
    const std::string name = wall_of(b.body->id);
    if (name.empty()) return {"space.blocks", {{"blocks", blocks.size()}}};
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  }
  std::string list;
  for (std::size_t k = 0; k < std::min(names.size(), kMostNames); ++k)
    list += (k > 0 ? ", " : "") + names[k];
  if (names.size() > kMostNames) list += ", ...";
  return {names.size() == 1 ? "space.wall" : "space.walls", {{"names", list}}};
}

// Whether a piece turns about a line at the foot of its walls: some corner of the
// walls below its centre hardly moves with it. The lowest stones need not take part.
bool stands_on_its_hinge(const Piece& piece, const std::vector<Wall>& walls) {
  const auto is_of = [&](const Wall& wall) {
    return std::any_of(wall.part.begin(), wall.part.end(), [&](const Moved& b) {
      return std::any_of(piece.blocks.begin(), piece.blocks.end(),
                         [&](const Moved& own) { return own.id == b.id; });
    });
  };
  double least = 1e300, most = 0, foot = 0;
  for (const Wall& wall : walls) {
    if (!is_of(wall)) continue;
    for (const Moved& b : wall.all)
      for (const Polyhedron& part : b.body->part)
        for (const Vec3& corner : part.vertex) {
          const double moved = length(piece.displacement_of(corner));
          if (moved < least) least = moved, foot = corner.y;
          most = std::fmax(most, moved);
        }
  }
  return least <= kRigid * most && foot < piece.centre.y;
}

// The pieces that turn like the heaviest one, each about a horizontal line at its own foot; and their mass.
struct Alike {
  std::vector<const Piece*> pieces;
  double mass = 0, all = 0;
};
Alike turn_alike(const std::vector<Piece>& pieces, const std::vector<Wall>& walls) {
  const Piece& main = *std::max_element(
      pieces.begin(), pieces.end(), [](const Piece& a, const Piece& b) { return a.mass < b.mass; });
  Alike found;
  for (const Piece& piece : pieces) {
    found.all += piece.mass;
    const bool alike = length(piece.turn - main.turn) <= kRigid * length(main.turn);
    if (!alike || !piece.turns || !is_level(piece.turn) || !stands_on_its_hinge(piece, walls))
      continue;
    found.mass += piece.mass;
    found.pieces.push_back(&piece);
  }
  return found;
}

// Walls that overturn by equal turns about parallel lines, for example below a common slab; empty where they do not.
Message overturn_together(const std::vector<Piece>& pieces, const std::vector<Wall>& walls,
                          FailureMode& mode) {
  const Alike alike = turn_alike(pieces, walls);
  note(mode, "mass of pieces that turn alike about their feet", alike.mass / alike.all, 1 - kRigid);
  if (alike.pieces.size() < 2 || alike.mass < (1 - kRigid) * alike.all) return {};
  mode.name = "overturning";
  std::vector<Message> lines;
  double degrees = 0;
  for (const Piece* piece : alike.pieces) {
    const Vec3 hinge = hinge_of(*piece);
    degrees += piece->mass / alike.mass * length(piece->turn) * 180 / M_PI;
    lines.push_back({"space.line",
                     {{"walls", walls_of(piece->blocks)},
                      {"y_m", hinge.y},
                      {"x_m", hinge.x},
                      {"z_m", hinge.z}}});
  }
  return {"space.together",
          {{"pieces", alike.pieces.size()}, {"degrees", degrees}, {"lines", std::move(lines)}}};
}

Message some_pieces(const std::vector<Piece>& pieces, const std::vector<Wall>& walls, Vec3 normal,
                    FailureMode& mode) {
  const double count = static_cast<double>(pieces.size());
  if (bends_upwards(pieces)) {
    mode.name = "bending";
    double low = 1e300;
    for (const Moved& b : pieces.back().blocks) low = std::fmin(low, b.start.y);
    return {"space.bending", {{"y_m", low}}};
  }
  const Sideways sideways = bends_sideways(pieces);
  if (sideways.bends) {
    mode.name = sideways.oblique ? "two-way bending" : "horizontal bending";
    return {sideways.oblique ? "space.two_way" : "space.sideways", {{"pieces", count}}};
  }
  if (Message together = overturn_together(pieces, walls, mode); !together.empty()) return together;
  const auto main = std::max_element(
      pieces.begin(), pieces.end(), [](const Piece& a, const Piece& b) { return a.mass < b.mass; });
  double all = 0;
  for (const Piece& piece : pieces) all += piece.mass;
  note(mode, "mass of the heaviest piece", main->mass / all, kMain);
  if (main->mass >= kMain * all) {
    Message shows = one_piece(*main, normal, mode);
    if (walls.size() > 1)
      shows = {"space.of_walls", {{"walls", walls_of(main->blocks)}, {"shows", std::move(shows)}}};
    return {"space.drags",
            {{"shows", std::move(shows)}, {"percent", 100 * (1 - main->mass / all)}}};
  }
  return {"space.pieces", {{"pieces", count}}};
}

// Parts that rock as rigid pieces, or joints that slip. Where neither decides, the larger motion of the joints counts.
Message in_its_plane(const std::vector<Piece>& pieces, const Joints& joints, FailureMode& mode) {
  double rocking = 0, all = 0;
  for (const Piece& piece : pieces) {
    all += piece.mass;
    if (piece.turns && residual(pieces) <= kRigid) rocking += piece.mass;
  }
  const double slip = joints.slid / (joints.slid + joints.opened);
  note(mode, "mass that rocks in rigid pieces", rocking / all, 0.5);
  note(mode, "share of slip in what the joints moved", slip, 0.5);
  const bool rocks = rocking >= 0.5 * all || slip < 0.5;
  mode.name = rocks ? "in-plane rocking" : "in-plane shear";
  return {rocks ? "space.in_plane_rocking" : "space.in_plane_shear",
          {{"percent", 100 * (rocks ? rocking / all : slip)}, {"slip_percent", 100 * slip}}};
}

// Normal of the walls that take part, if they are thin and parallel; else 0. Each wall is a set of
// connected blocks, because the plan of two separate walls shows their distance, not their planes.
Vec3 normal_of(const std::vector<Wall>& walls) {
  double all = 0, parallel = 0, heaviest = 0;
  Vec3 normal;
  for (const Wall& wall : walls) {
    const double mass = mass_of(wall.part);
    if (mass > heaviest) heaviest = mass, normal = plan_of(wall.part).normal;
  }
  for (const Wall& wall : walls) {
    const Plan plan = plan_of(wall.part);
    const bool counts = plan.thin <= kThin && std::fabs(dot(plan.normal, normal)) > kParallel;
    all += mass_of(wall.part);
    if (counts) parallel += mass_of(wall.part);
  }
  return parallel >= (1 - kRigid) * all ? normal : Vec3{};
}

// The mechanism of the blocks that take part, from each of their walls.
Message mechanism_of(const std::vector<Wall>& walls, const Joints& joints, FailureMode& mode) {
  Piece whole;
  for (const Wall& wall : walls)
    whole.blocks.insert(whole.blocks.end(), wall.part.begin(), wall.part.end());
  const std::vector<Moved>& part = whole.blocks;
  fit(whole);
  note(mode, "motion that one rigid piece explains", 1 - whole.residual(), 1 - kRigid);
  mode.scores["one piece"] = 1 - whole.residual();
  const Vec3 normal = normal_of(walls);
  if (whole.residual() <= kRigid) return one_piece(whole, normal, mode);
  if (length(normal) > 0) {
    const double off = off_plane(part, normal);
    note(mode, "motion that stays in the wall's plane", 1 - off, 1 - kOffPlane);
    if (off <= kOffPlane) return in_its_plane(pieces_of(whole), joints, mode);
  }
  const std::vector<Piece> pieces = pieces_of(whole);
  mode.scores["pieces"] = 1 - residual(pieces);
  note(mode, "motion that up to four rigid pieces explain", 1 - residual(pieces), 1 - kRigid);
  if (residual(pieces) <= kRigid) return some_pieces(pieces, walls, normal, mode);
  return {"space.unclear",
          {{"percent", 100 * (1 - whole.residual())},
           {"pieces_percent", 100 * (1 - residual(pieces))}}};
}

bool is_slab(const Model& model, BlockId block) {
  return block >= 0 && block < model.n_block && model.anatomy.block_role[block] == BlockRole::kSlab;
}

// Removes slabs, which outweigh many stones, because a mode is about walls. They stay only where they move far more than the walls.
void leave_slabs_out(const Model& model, double least, std::vector<Moved>& blocks) {
  double most = 0;
  for (const Moved& b : blocks) most = std::fmax(most, length(b.moved));
  least = std::fmax(least, kTakesPart * most);
  if (std::any_of(blocks.begin(), blocks.end(), [&](const Moved& b) {
        return !is_slab(model, b.id) && length(b.moved) >= least;
      }))
    std::erase_if(blocks, [&](const Moved& b) { return is_slab(model, b.id); });
}

// Slabs that move differently from the walls that take part: the largest slip on the walls,
// and its share of the slab's displacement. The name of the walls does not include it.
struct Slip {
  double share = 0, way = 0;
};
Slip slip_of_slabs(const Model& model, const WallReading& wall, const std::vector<Moved>& part,
                   double most) {
  std::vector<bool> takes(model.n_block);
  for (const Moved& b : part) takes[b.id] = true;
  const auto takes_part = [&](BlockId b) { return b >= 0 && b < model.n_block && takes[b]; };
  Slip slip;
  for (const JointReading& joint : wall.joints) {
    const BlockId a = joint.shape.a, b = joint.shape.b;
    const BlockId slab = is_slab(model, a) ? a : b, other = slab == a ? b : a;
    if (!is_slab(model, slab) || !takes_part(other)) continue;
    const double way = length(wall.blocks[slab].moved);
    if (way < kTakesPart * most || joint.slip <= slip.share * way) continue;
    slip = {joint.slip / way, joint.slip};
  }
  return slip;
}

// The walls with blocks that take part. A wall is a connected part of `masonry`.
std::vector<Wall> walls_with(const Model& model, const std::vector<Moved>& masonry,
                             const std::vector<Moved>& part) {
  std::vector<bool> takes(model.n_block);
  for (const Moved& b : part) takes[b.id] = true;
  std::vector<Wall> walls;
  for (std::vector<Moved>& all : clusters_of(model, masonry)) {
    Wall wall;
    for (const Moved& b : all)
      if (takes[b.id]) wall.part.push_back(b);
    wall.all = std::move(all);
    if (!wall.part.empty()) walls.push_back(std::move(wall));
  }
  return walls;
}

}  // namespace

FailureMode name_in_space(const Model& model, const State& state, double least) {
  FailureMode mode;
  const WallReading wall = read_wall(model, state);
  const Joints joints = evaluate_joints(model, wall, least);
  mode.evidence.push_back(
      {"joints", "largest movement over the joint's size", joints.movement, least, "-"});
  if (joints.movement < least) {
    mode.name = "none";
    mode.sentence = {"mode.none_here"};
    return mode;
  }
  std::vector<Moved> part = evaluate_blocks(model, state);
  leave_slabs_out(model, least * joints.size, part);
  const std::vector<Moved> masonry = part;
  const double all = mass_of(part);
  double most = 0;
  for (const Moved& b : part) most = std::fmax(most, length(b.moved));
  std::erase_if(part, [&](const Moved& b) { return length(b.moved) < least * joints.size; });
  const double moved = mass_of(part);
  std::erase_if(part, [&](const Moved& b) { return length(b.moved) < kTakesPart * most; });
  const double taking = mass_of(part);
  const auto count = static_cast<double>(part.size());
  note(mode, "mass of the wall that takes part", taking / all, kSomeWall);
  if (taking < kStandsFor * moved || taking < kSomeWall * all) {
    // a few stones that moved far show nothing about the wall behind them
    mode.sentence = {"space.loose",
                     {{"blocks", count}, {"percent", 100 * taking / all}, {"mm", 1e3 * most}}};
    return mode;
  }
  const std::vector<Wall> walls = walls_with(model, masonry, part);
  mode.sentence = mechanism_of(walls, joints, mode);
  const bool names_its_walls =
      mode.sentence.code == "space.together" || mode.sentence.code == "space.drags";
  if (walls.size() > 1 && mode.name != "unclear" && !names_its_walls)
    mode.sentence = {"space.of_walls",
                     {{"walls", walls_of(part)}, {"shows", std::move(mode.sentence)}}};
  const Slip slip = slip_of_slabs(model, wall, part, most);
  if (slip.share >= kTakesPart && mode.name != "unclear") {
    note(mode, "slip of a slab on what takes part, over its own way", slip.share, kTakesPart);
    mode.sentence = {"space.slab_slips",
                     {{"mm", 1e3 * slip.way}, {"shows", std::move(mode.sentence)}}};
    mode.name = "unclear";
  }
  if (joints.slid_off >= kSlidOff) {
    note(mode, "area of moved joints that is pressed beyond its face", joints.slid_off, kSlidOff);
    mode.sentence = {"mode.slid_off", {{"shows", std::move(mode.sentence)}}};
    mode.name = "unclear";
  }
  return mode;
}

bool leaves_plane(const std::string& name) {
  constexpr const char* kNames[] = {"overturning",        "turning",         "bending",
                                    "horizontal bending", "two-way bending", "corner wedge",
                                    kBreakingAway};
  return std::find(std::begin(kNames), std::end(kNames), name) != std::end(kNames);
}

bool tells_of_planes(const Evidence& evidence) { return evidence.measure == kInPlanes; }

bool stays_in_planes(const FailureMode& mode) {
  return std::any_of(mode.evidence.begin(), mode.evidence.end(),
                     [](const Evidence& e) { return tells_of_planes(e) && e.holds(); });
}

bool stays_in_plane(const std::string& name) {
  return !name.empty() && name != "unclear" && name != "none" && name != "sliding" &&
         !leaves_plane(name);
}

bool is_along(const Elevation& wall, const Vec3& push) {
  return std::fabs(dot(wall.across, push)) < kOblique * length(push);
}

WallsMoved moved_in_plane(const Model& model, const State& state,
                          const std::vector<Elevation>& elevations) {
  std::vector<Moved> blocks = evaluate_blocks(model, state);
  std::erase_if(blocks, [&](const Moved& b) { return is_slab(model, b.id); });
  double most = 0, all = 0, of_walls = 0;
  for (const Moved& b : blocks) most = std::fmax(most, length(b.moved));
  std::erase_if(blocks, [&](const Moved& b) { return length(b.moved) < kTakesPart * most; });
  WallsMoved found;
  for (std::size_t k = 0; k < elevations.size(); ++k) {
    std::vector<Moved> own = blocks;
    std::erase_if(own, [&](const Moved& b) { return !elevations[k].holds(b.id); });
    if (!own.empty() && off_plane(own, elevations[k].across) <= kOffPlane) found.of.push_back(k);
  }
  for (const Moved& b : blocks) {
    all += b.mass;
    const bool is_of_wall = std::any_of(found.of.begin(), found.of.end(),
                                        [&](std::size_t k) { return elevations[k].holds(b.id); });
    if (is_of_wall) of_walls += b.mass;
  }
  found.is_all = of_walls >= (1 - kRigid) * all;
  found.told = {"moving blocks", kInPlanes, all > 0 ? of_walls / all : 0, 1 - kRigid, "-"};
  return found;
}

WallsByPush walls_by_push(const Model& model, const Vec3& push) {
  WallsByPush found;
  for (const WallBlocks& group : groups_of(model)) {
    const Plan plan = plan_of(group.blocks);
    const double off = std::fabs(dot(plan.normal, push));
    ++found.walls;
    if (plan.thin > kThin) continue;
    ++(off < kOblique ? found.along : found.across);
  }
  return found;
}

}  // namespace wythe::study
