#include "study/modes/in_space.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/rotation.h"
#include "wythe/reading.h"

namespace wythe::study {
namespace {

constexpr double kMoved = 0.005;  // of a joint's size: an opening or slip that counts
constexpr double kTakesPart =
    0.25;  // of the furthest block's way: what takes part in the mechanism
constexpr double kStandsFor =
    1.0 / 3;                        // of what moved, by mass: what a mechanism of the wall holds
constexpr double kSomeWall = 0.02;  // of the wall, by mass: what is more than a loose stone
constexpr double kRigid = 0.15;     // of the motion: what rigid pieces may leave unexplained
constexpr double kTurns =
    0.5;  // of the shift: what the turn moves the furthest corner, from which a piece turns
constexpr double kMain = 2.0 / 3;   // of what moves, by mass: a piece that drags the others along
constexpr double kOffPlane = 0.15;  // of the motion: what may leave the wall's plane
constexpr double kThin = 0.1;       // thickness over length, squared: what has a plane
constexpr double kOblique = 0.3;    // cosine from which on a turn is about an axis as well
constexpr double kSlidOff = 0.25;   // of the joints that moved, by area: no name is vouched for
constexpr std::size_t kMostPieces = 4;

using Turn = Quaternion<double>;

struct Moved {
  BlockId id;
  Vec3 start, moved;
  Turn turned;
  double mass;
  double radius;  // of gyration, for its own turn [m]
  Vec3 longest;   // its longest side's direction where that lies level; 0 where none does
  const BodySpec* body = nullptr;
};

// What moves as one: its centre, a shift and a turn; how much of the motion that leaves out.
struct Piece {
  std::vector<Moved> blocks;
  Vec3 centre, shift;
  Turn turned{1, {0, 0, 0}};
  Vec3 turn;  // the same as a vector [rad]
  double mass = 0, all = 0, missed = 0;
  bool turns = false;  // its axis passes near by: it does more than shift
  [[nodiscard]] double residual() const { return all > 0 ? std::sqrt(missed / all) : 0; }
};

Vector<double> vec(Vec3 v) { return {v.x, v.y, v.z}; }
Vec3 vec3(const Vector<double>& v) { return {v.x, v.y, v.z}; }

Turn turn_by(Vec3 by) {
  const double angle = length(by);
  if (angle == 0) return {1, {0, 0, 0}};
  return {std::cos(angle / 2), std::sin(angle / 2) / angle * vec(by)};
}
Vec3 vector_of(Turn q) {
  if (q.w < 0) q = {-q.w, -1.0 * q.v};
  const double sine = length(vec3(q.v));
  return sine > 0 ? 2 * std::atan2(sine, q.w) / sine * vec3(q.v) : Vec3{};
}
Turn back(const Turn& q) { return {q.w, -1.0 * q.v}; }

// The solution of a symmetric 3 x 3 system; 0 where it has none.
Vec3 solve(const std::array<Vec3, 3>& row, Vec3 right) {
  const double det = dot(row[0], cross(row[1], row[2]));
  if (!(std::fabs(det) > 0)) return {};
  const Vec3 a = cross(row[1], row[2]), b = cross(row[2], row[0]), c = cross(row[0], row[1]);
  return (right.x * a + right.y * b + right.z * c) / det;
}

// What a piece says of a block: by its turn, what it leaves of its way and of its own turn.
struct Told {
  Vec3 arm, by_turn, off, twist;
};
Told told(const Piece& piece, const Moved& b) {
  const Vec3 r = b.start - piece.centre, by_turn = vec3(swing(piece.turned, vec(r)));
  return {r + by_turn, by_turn, b.moved - piece.shift - by_turn,
          vector_of(b.turned * back(piece.turned))};
}
double missed(const Piece& piece, const Moved& b) {
  const Told t = told(piece, b);
  return b.mass * (dot(t.off, t.off) + b.radius * b.radius * dot(t.twist, t.twist));
}

// One step of Gauss and Newton to the turn that explains most.
Vec3 turn_further(const Piece& piece) {
  std::array<Vec3, 3> row{};
  Vec3 right;
  for (const Moved& b : piece.blocks) {
    const Told t = told(piece, b);
    const Vec3 r = t.arm;
    const double own = b.mass * (dot(r, r) + b.radius * b.radius);
    row[0] = row[0] + Vec3{own - b.mass * r.x * r.x, -b.mass * r.x * r.y, -b.mass * r.x * r.z};
    row[1] = row[1] + Vec3{-b.mass * r.x * r.y, own - b.mass * r.y * r.y, -b.mass * r.y * r.z};
    row[2] = row[2] + Vec3{-b.mass * r.x * r.z, -b.mass * r.y * r.z, own - b.mass * r.z * r.z};
    right = right + b.mass * (cross(r, t.off) + b.radius * b.radius * t.twist);
  }
  return solve(row, right);
}

void fit(Piece& piece) {
  piece.mass = piece.all = piece.missed = 0;
  Vec3 centre, shift;
  for (const Moved& b : piece.blocks) {
    piece.mass += b.mass;
    centre = centre + b.mass * b.start;
    shift = shift + b.mass * b.moved;
  }
  piece.centre = centre / piece.mass;
  piece.shift = shift / piece.mass;
  piece.turned = {1, {0, 0, 0}};
  for (int k = 0; k < 4; ++k) piece.turned = turn_by(turn_further(piece)) * piece.turned;
  piece.turn = vector_of(piece.turned);
  double furthest = 0;
  for (const Moved& b : piece.blocks) {
    const Vec3 own = vector_of(b.turned);
    piece.all += b.mass * (dot(b.moved, b.moved) + b.radius * b.radius * dot(own, own));
    piece.missed += missed(piece, b);
    for (const Polyhedron& part : b.body->part)
      for (const Vec3& corner : part.vertex)
        furthest =
            std::fmax(furthest, length(vec3(swing(piece.turned, vec(corner - piece.centre)))));
  }
  piece.turns = furthest >= kTurns * length(piece.shift) && furthest > 0;
}

double residual(const std::vector<Piece>& pieces) {
  double all = 0, left = 0;
  for (const Piece& piece : pieces) all += piece.all, left += piece.missed;
  return all > 0 ? std::sqrt(left / all) : 0;
}

std::vector<Moved> read_blocks(const Model& model, const State& state) {
  std::vector<Moved> blocks;
  const Space& space = model.space;
  for (BlockId b = 0; b < model.n_block; ++b) {
    const auto k = static_cast<std::size_t>(b);
    const BlockReading now = read_block(model, state, b);
    const Vec3& i = space.inertia[k];
    const double mass = model.mass[k], least = std::fmin(i.x, std::fmin(i.y, i.z));
    // the longest side has the least inertia about it
    const Vec3 axis = least == i.x   ? space.axis_1[k]
                      : least == i.y ? space.axis_2[k]
                                     : space.axis_3[k];
    const double others = i.x + i.y + i.z - least;
    const bool is_long = 2 * least < 0.8 * others && std::fabs(axis.y) < 0.3;
    blocks.push_back({b,
                      now.start,
                      now.moved,
                      {state.qw[k], {state.qx[k], state.qy[k], state.qz[k]}},
                      mass,
                      std::sqrt((i.x + i.y + i.z) / (3 * mass)),
                      is_long ? axis : Vec3{},
                      &space.body[k]});
  }
  return blocks;
}

double mass_of(const std::vector<Moved>& blocks) {
  double mass = 0;
  for (const Moved& b : blocks) mass += b.mass;
  return mass;
}

// What the joints tell: the largest movement over a joint's size; sums of area times opening and slip, and how
// much of the area that moved is pressed where there is no face left.
struct Joints {
  double movement = 0, size = 0, opened = 0, slid = 0, slid_off = 0;
};
Joints read_joints(const Model& model, const State& state) {
  Joints sum;
  const WallReading wall = read_wall(model, state);
  double moved = 0, off = 0, all = 0;
  for (const JointReading& joint : wall.joints) {
    const double area = joint.shape.area, size = std::sqrt(area);
    const double opening = std::fmax(0, joint.opening);
    const double way = std::fmax(opening, joint.slip) / size;
    sum.movement = std::fmax(sum.movement, way);
    sum.size += area * size;
    all += area;
    if (way < kMoved) continue;
    sum.opened += area * opening;
    sum.slid += area * joint.slip;
    moved += area;
    if (has_slid_off(model, wall.points, joint.shape.id)) off += area;
  }
  if (all > 0) sum.size /= all;
  if (moved > 0) sum.slid_off = off / moved;
  return sum;
}

// --- pieces -----------------------------------------------------------------------------------------------

// Seen from above: which way blocks lie across their length, and how thick that is over how long, squared.
struct Plan {
  Vec3 normal;
  double thin = 1;
};
Plan plan_of(const std::vector<Moved>& blocks) {
  double mass = 0, xx = 0, xz = 0, zz = 0;
  Vec3 mean;
  for (const Moved& b : blocks) mass += b.mass, mean = mean + b.mass * b.start;
  mean = mean / mass;
  for (const Moved& b : blocks) {
    const Vec3 r = b.start - mean;
    xx += b.mass * r.x * r.x, xz += b.mass * r.x * r.z, zz += b.mass * r.z * r.z;
  }
  const double half = 0.5 * (xx - zz), root = std::hypot(half, xz), middle = 0.5 * (xx + zz);
  const double angle = 0.5 * std::atan2(xz, half);  // of the long way
  return {{-std::sin(angle), 0, std::cos(angle)},
          middle > 0 ? (middle - root) / (middle + root) : 1.0};
}

// The cut of a piece in two, by height, along or across, that explains most.
std::array<Piece, 2> cut_in_two(const Piece& piece) {
  std::array<Piece, 2> best;
  double least = 1e300;
  const Vec3 up{0, 1, 0}, normal = plan_of(piece.blocks).normal;
  for (const Vec3& along : {up, cross(up, normal), normal}) {
    const auto place = [&](const Moved& b) { return dot(b.start, along); };
    std::vector<Moved> sorted = piece.blocks;
    std::stable_sort(sorted.begin(), sorted.end(),
                     [&](const Moved& a, const Moved& b) { return place(a) < place(b); });
    const std::size_t every = sorted.size() / 64;
    std::size_t since = every;
    for (std::size_t k = 1; k < sorted.size(); ++k) {
      const bool at_once = place(sorted[k]) - place(sorted[k - 1]) < 0.1 * sorted[k].radius;
      if (at_once || ++since <= every) continue;
      since = 0;
      std::array<Piece, 2> now;
      const auto cut = sorted.begin() + static_cast<std::ptrdiff_t>(k);
      now[0].blocks.assign(sorted.begin(), cut);
      now[1].blocks.assign(cut, sorted.end());
      for (Piece& part : now) fit(part);
      const double left = now[0].missed + now[1].missed;
      if (left < least) least = left, best = now;
    }
  }
  return best;
}

// Each block goes to the piece that explains it best, until none changes.
void sort_out(std::vector<Piece>& pieces) {
  for (int round = 0; round < 10; ++round) {
    std::vector<Piece> next(pieces.size());
    bool changed = false;
    for (std::size_t p = 0; p < pieces.size(); ++p)
      for (const Moved& b : pieces[p].blocks) {
        std::size_t best = p;
        for (std::size_t q = 0; q < pieces.size(); ++q)
          if (missed(pieces[q], b) < missed(pieces[best], b)) best = q;
        changed = changed || best != p;
        next[best].blocks.push_back(b);
      }
    if (!changed || std::any_of(next.begin(), next.end(),
                                [](const Piece& piece) { return piece.blocks.empty(); }))
      return;
    for (Piece& piece : next) fit(piece);
    if (residual(next) > residual(pieces)) return;
    pieces = std::move(next);
  }
}

// As few rigid pieces as explain the motion; as many as there may be where none do.
std::vector<Piece> pieces_of(const Piece& whole) {
  std::vector<Piece> pieces{whole};
  while (pieces.size() < kMostPieces && residual(pieces) > kRigid) {
    const auto worst =
        std::max_element(pieces.begin(), pieces.end(),
                         [](const Piece& a, const Piece& b) { return a.missed < b.missed; });
    const std::array<Piece, 2> two = cut_in_two(*worst);
    if (two[0].blocks.empty()) break;
    *worst = two[0];
    pieces.push_back(two[1]);
    sort_out(pieces);
  }
  std::sort(pieces.begin(), pieces.end(),
            [](const Piece& a, const Piece& b) { return a.centre.y < b.centre.y; });
  return pieces;
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

// How high a piece's axis of rotation passes: where it moves least.
Vec3 hinge_of(const Piece& piece) {
  return piece.centre + cross(piece.turn, piece.shift) / dot(piece.turn, piece.turn);
}

// Whether a piece holds units of two walls that meet, and tilts away from both.
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

// Pieces that turn against each other about level axes, one above the other: a wall that spans upwards.
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

// Two pieces side by side that turn against each other about upright axes, wholly or in part.
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
      // both lean the same way as well, or another piece does
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

Message some_pieces(const std::vector<Piece>& pieces, Vec3 normal, FailureMode& mode) {
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
  const auto main = std::max_element(
      pieces.begin(), pieces.end(), [](const Piece& a, const Piece& b) { return a.mass < b.mass; });
  double all = 0;
  for (const Piece& piece : pieces) all += piece.mass;
  note(mode, "mass of the heaviest piece", main->mass / all, kMain);
  if (main->mass >= kMain * all) {
    Message shows = one_piece(*main, normal, mode);
    return {"space.drags",
            {{"shows", std::move(shows)}, {"percent", 100 * (1 - main->mass / all)}}};
  }
  return {"space.pieces", {{"pieces", count}}};
}

// Parts that rock as rigid pieces, or joints that slip; where neither decides, what the joints did more.
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

// The mechanism of the blocks that take part.
Message mechanism_of(const std::vector<Moved>& part, const Joints& joints, FailureMode& mode) {
  Piece whole;
  whole.blocks = part;
  fit(whole);
  note(mode, "motion that one rigid piece explains", 1 - whole.residual(), 1 - kRigid);
  mode.scores["one piece"] = 1 - whole.residual();
  const Plan plan = plan_of(part);
  const Vec3 normal = plan.thin <= kThin ? plan.normal : Vec3{};
  if (whole.residual() <= kRigid) return one_piece(whole, normal, mode);
  if (length(normal) > 0) {
    const double off = off_plane(part, normal);
    note(mode, "motion that stays in the wall's plane", 1 - off, 1 - kOffPlane);
    if (off <= kOffPlane) return in_its_plane(pieces_of(whole), joints, mode);
  }
  const std::vector<Piece> pieces = pieces_of(whole);
  mode.scores["pieces"] = 1 - residual(pieces);
  note(mode, "motion that up to four rigid pieces explain", 1 - residual(pieces), 1 - kRigid);
  if (residual(pieces) <= kRigid) return some_pieces(pieces, normal, mode);
  return {"space.unclear",
          {{"percent", 100 * (1 - whole.residual())},
           {"pieces_percent", 100 * (1 - residual(pieces))}}};
}

// A slab outweighs many stones, and a mode is of walls: it counts only where nothing else moves.
void leave_slabs_out(const Model& model, double least, std::vector<Moved>& blocks) {
  const auto is_slab = [&](const Moved& b) {
    return model.anatomy.block_role[static_cast<std::size_t>(b.id)] == BlockRole::kSlab;
  };
  if (std::any_of(blocks.begin(), blocks.end(),
                  [&](const Moved& b) { return !is_slab(b) && length(b.moved) >= least; }))
    std::erase_if(blocks, is_slab);
}

}  // namespace

FailureMode name_in_space(const Model& model, const State& state) {
  FailureMode mode;
  const Joints joints = read_joints(model, state);
  mode.evidence.push_back(
      {"joints", "largest movement over the joint's size", joints.movement, kMoved, "-"});
  if (joints.movement < kMoved) {
    mode.name = "none";
    mode.sentence = {"mode.none_here"};
    return mode;
  }
  std::vector<Moved> part = read_blocks(model, state);
  leave_slabs_out(model, kMoved * joints.size, part);
  const double all = mass_of(part);
  double most = 0;
  for (const Moved& b : part) most = std::fmax(most, length(b.moved));
  std::erase_if(part, [&](const Moved& b) { return length(b.moved) < kMoved * joints.size; });
  const double moved = mass_of(part);
  std::erase_if(part, [&](const Moved& b) { return length(b.moved) < kTakesPart * most; });
  const double taking = mass_of(part);
  const auto count = static_cast<double>(part.size());
  note(mode, "mass of the wall that takes part", taking / all, kSomeWall);
  if (taking < kStandsFor * moved || taking < kSomeWall * all) {
    // few stones that went far tell nothing of the wall behind them
    mode.sentence = {"space.loose",
                     {{"blocks", count}, {"percent", 100 * taking / all}, {"mm", 1e3 * most}}};
    return mode;
  }
  mode.sentence = mechanism_of(part, joints, mode);
  if (joints.slid_off >= kSlidOff) {
    note(mode, "area of moved joints that is pressed beyond its face", joints.slid_off, kSlidOff);
    mode.sentence = {"mode.slid_off", {{"shows", std::move(mode.sentence)}}};
    mode.name = "unclear";
  }
  return mode;
}

}  // namespace wythe::study
