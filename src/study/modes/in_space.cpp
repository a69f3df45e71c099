#include "study/modes/in_space.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "wythe/reading.h"

namespace wythe::study {
namespace {

constexpr double kMoved = 0.005;  // of a joint's size: an opening or slip that counts
constexpr double kTakesPart =
    0.25;                        // of the furthest block's way: what takes part in the mechanism
constexpr double kRigid = 0.15;  // of the motion: what one rigid piece may leave unexplained
constexpr double kTurns = 0.5;   // of the motion: its share by rotation, from which a piece turns

struct Moved {
  Vec3 start, moved, turned;
  double mass;
  double radius;  // of gyration, for its own turn [m]
};

// What moves as one: t at the centre c, and a small turn; how much of the motion that leaves out.
struct Piece {
  std::vector<Moved> blocks;
  Vec3 centre, shift, turn;
  double residual = 1, by_turn = 0;
};

// The solution of a symmetric 3 x 3 system; 0 where it has none.
Vec3 solve(const std::array<Vec3, 3>& row, Vec3 right) {
  const double det = dot(row[0], cross(row[1], row[2]));
  if (!(std::fabs(det) > 0)) return {};
  const Vec3 a = cross(row[1], row[2]), b = cross(row[2], row[0]), c = cross(row[0], row[1]);
  return (right.x * a + right.y * b + right.z * c) / det;
}

void fit(Piece& piece) {
  double mass = 0;
  Vec3 centre, shift;
  for (const Moved& b : piece.blocks) {
    mass += b.mass;
    centre = centre + b.mass * b.start;
    shift = shift + b.mass * b.moved;
  }
  piece.centre = centre / mass;
  piece.shift = shift / mass;
  std::array<Vec3, 3> row{};
  Vec3 right;
  for (const Moved& b : piece.blocks) {
    const Vec3 r = b.start - piece.centre;
    const double own = b.mass * (dot(r, r) + b.radius * b.radius);
    row[0] = row[0] + Vec3{own - b.mass * r.x * r.x, -b.mass * r.x * r.y, -b.mass * r.x * r.z};
    row[1] = row[1] + Vec3{-b.mass * r.x * r.y, own - b.mass * r.y * r.y, -b.mass * r.y * r.z};
    row[2] = row[2] + Vec3{-b.mass * r.x * r.z, -b.mass * r.y * r.z, own - b.mass * r.z * r.z};
    right = right + b.mass * (cross(r, b.moved) + b.radius * b.radius * b.turned);
  }
  piece.turn = solve(row, right);
  double all = 0, missed = 0, turned = 0;
  for (const Moved& b : piece.blocks) {
    const Vec3 by_turn = cross(piece.turn, b.start - piece.centre);
    const Vec3 off = b.moved - piece.shift - by_turn, twist = b.turned - piece.turn;
    all += b.mass * (dot(b.moved, b.moved) + b.radius * b.radius * dot(b.turned, b.turned));
    missed += b.mass * (dot(off, off) + b.radius * b.radius * dot(twist, twist));
    turned += b.mass * (dot(by_turn, by_turn) + b.radius * b.radius * dot(piece.turn, piece.turn));
  }
  piece.residual = all > 0 ? std::sqrt(missed / all) : 0;
  piece.by_turn = all > 0 ? std::sqrt(turned / all) : 0;
}

std::vector<Moved> read_blocks(const Model& model, const State& state) {
  std::vector<Moved> blocks;
  double most = 0;
  for (BlockId b = 0; b < model.n_block; ++b) {
    const BlockReading now = read_block(model, state, b);
    const Vec3& i = model.space.inertia[static_cast<std::size_t>(b)];
    const double mass = model.mass[static_cast<std::size_t>(b)];
    blocks.push_back(
        {now.start, now.moved, now.turned.by, mass, std::sqrt((i.x + i.y + i.z) / (3 * mass))});
    most = std::fmax(most, length(now.moved));
  }
  std::erase_if(blocks, [&](const Moved& b) { return length(b.moved) < kTakesPart * most; });
  return blocks;
}

// The largest movement of a joint over its size.
double largest_movement(const Model& model, const State& state) {
  double most = 0;
  for (const JointReading& joint : read_wall(model, state).joints)
    most = std::fmax(most, std::fmax(joint.opening, joint.slip) / std::sqrt(joint.shape.area));
  return most;
}

bool is_level(Vec3 turn) { return std::fabs(turn.y) < 0.5 * length(turn); }

// How high a piece's axis of rotation passes: where it moves least.
Vec3 hinge_of(const Piece& piece) {
  return piece.centre + cross(piece.turn, piece.shift) / dot(piece.turn, piece.turn);
}

// The best cut into a lower and an upper piece by height.
std::array<Piece, 2> cut_in_two(const std::vector<Moved>& blocks) {
  std::vector<Moved> sorted = blocks;
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const Moved& a, const Moved& b) { return a.start.y < b.start.y; });
  std::array<Piece, 2> best;
  double least = 1e300;
  for (std::size_t k = 1; k < sorted.size(); ++k) {
    if (!(sorted[k].start.y > sorted[k - 1].start.y)) continue;
    std::array<Piece, 2> now;
    now[0].blocks.assign(sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(k));
    now[1].blocks.assign(sorted.begin() + static_cast<std::ptrdiff_t>(k), sorted.end());
    for (Piece& piece : now) fit(piece);
    const double worst = std::fmax(now[0].residual, now[1].residual);
    if (worst < least) least = worst, best = now;
  }
  return best;
}

Message one_piece(const Piece& piece, FailureMode& mode) {
  const double share = static_cast<double>(piece.blocks.size());
  if (piece.by_turn < kTurns) {
    mode.name = "sliding";
    return {"space.sliding", {{"blocks", share}, {"mm", 1e3 * length(piece.shift)}}};
  }
  if (!is_level(piece.turn)) {
    mode.name = "turning";
    return {"space.turning", {{"blocks", share}}};
  }
  const Vec3 hinge = hinge_of(piece);
  mode.name = "overturning";
  return {"space.overturning",
          {{"blocks", share},
           {"y_m", hinge.y},
           {"x_m", hinge.x},
           {"z_m", hinge.z},
           {"degrees", length(piece.turn) * 180 / M_PI}}};
}

}  // namespace

FailureMode name_in_space(const Model& model, const State& state) {
  FailureMode mode;
  const double movement = largest_movement(model, state);
  mode.evidence.push_back(
      {"joints", "largest movement over the joint's size", movement, kMoved, "-"});
  if (movement < kMoved) {
    mode.name = "none";
    mode.sentence = {"mode.none_here"};
    return mode;
  }
  Piece whole;
  whole.blocks = read_blocks(model, state);
  fit(whole);
  mode.evidence.push_back({"moving blocks", "motion that one rigid piece explains",
                           1 - whole.residual, 1 - kRigid, "-"});
  mode.scores["one piece"] = 1 - whole.residual;
  if (whole.residual <= kRigid) {
    mode.sentence = one_piece(whole, mode);
    return mode;
  }
  const std::array<Piece, 2> two = cut_in_two(whole.blocks);
  if (!two[0].blocks.empty()) {
    const double worst = std::fmax(two[0].residual, two[1].residual);
    mode.scores["two pieces"] = 1 - worst;
    mode.evidence.push_back({"moving blocks", "motion that a lower and an upper piece explain",
                             1 - worst, 1 - kRigid, "-"});
    const double against = dot(two[0].turn, two[1].turn);
    if (worst <= kRigid && against < 0 && is_level(two[0].turn) && is_level(two[1].turn)) {
      mode.name = "bending";
      double low = 1e300;
      for (const Moved& b : two[1].blocks) low = std::fmin(low, b.start.y);
      mode.sentence = {"space.bending", {{"y_m", low}}};
      return mode;
    }
  }
  mode.sentence = {"space.unclear", {{"percent", 100 * (1 - whole.residual)}}};
  return mode;
}

}  // namespace wythe::study
