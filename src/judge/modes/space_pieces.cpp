// Fits rigid pieces to blocks that moved in space, by least squares over displacement and turn, weighted by
// mass. Four Gauss-Newton steps find the turn of a piece. While too much stays unexplained, the worst piece
// is cut in two by height, along or across the wall. Then each block goes to the piece that explains it best.
#include "judge/modes/space_pieces.h"

#include <algorithm>
#include <array>
#include <map>
#include <numeric>

#include "wythe/parts/reading.h"

namespace wythe::study {
namespace {

constexpr double kTurns =
    0.5;  // of the shift: a piece turns if its turn moves the furthest corner by more
constexpr std::size_t kMostPieces = 4;

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

// The solution of a symmetric 3 x 3 system; 0 where it is singular.
Vec3 solve(const std::array<Vec3, 3>& row, Vec3 right) {
  const double det = dot(row[0], cross(row[1], row[2]));
  if (!(std::fabs(det) > 0)) return {};
  const Vec3 a = cross(row[1], row[2]), b = cross(row[2], row[0]), c = cross(row[0], row[1]);
  return (right.x * a + right.y * b + right.z * c) / det;
}

// The motion of a block by its piece: arm, displacement by the turn, and the rest of its displacement and turn.
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

// One Gauss-Newton step towards the turn that explains most.
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

}  // namespace

std::vector<Moved> evaluate_blocks(const Model& model, const State& state) {
  std::vector<Moved> blocks;
  const Space& space = model.space;
  for (BlockId b = 0; b < model.n_block; ++b) {
    const BlockReading now = read_block(model, state, b);
    const Vec3& i = space.inertia[b];
    const double mass = model.mass[b], least = std::fmin(i.x, std::fmin(i.y, i.z));
    // the inertia about the longest side is least
    const Vec3 axis = least == i.x   ? space.axis_1[b]
                      : least == i.y ? space.axis_2[b]
                                     : space.axis_3[b];
    const double others = i.x + i.y + i.z - least;
    const bool is_long = 2 * least < 0.8 * others && std::fabs(axis.y) < 0.3;
    blocks.push_back({b,
                      now.start,
                      now.moved,
                      {state.qw[b], {state.qx[b], state.qy[b], state.qz[b]}},
                      mass,
                      std::sqrt((i.x + i.y + i.z) / (3 * mass)),
                      is_long ? axis : Vec3{},
                      &space.body[b]});
  }
  return blocks;
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

Plan plan_of(const std::vector<Moved>& blocks) {
  double mass = 0, xx = 0, xz = 0, zz = 0, size = 0;
  Vec3 mean;
  for (const Moved& b : blocks) mass += b.mass, mean = mean + b.mass * b.start;
  mean = mean / mass;
  for (const Moved& b : blocks) {
    const Vec3 r = b.start - mean;
    xx += b.mass * r.x * r.x, xz += b.mass * r.x * r.z, zz += b.mass * r.z * r.z;
    size += b.mass * b.radius * b.radius;
  }
  if (xx + zz < 1e-6 * size) {  // one above the other: their corners give the plan
    for (const Moved& b : blocks)
      for (const Polyhedron& part : b.body->part)
        for (const Vec3& corner : part.vertex) {
          const Vec3 r = corner - mean;
          xx += r.x * r.x, xz += r.x * r.z, zz += r.z * r.z;
        }
  }
  const double half = 0.5 * (xx - zz), root = std::hypot(half, xz), middle = 0.5 * (xx + zz);
  const double angle = 0.5 * std::atan2(xz, half);  // direction of the longer side
  return {{-std::sin(angle), 0, std::cos(angle)},
          middle > 0 ? (middle - root) / (middle + root) : 1.0};
}

namespace {

// The cut of a piece in two, by height, along or across, that explains most of the motion.
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

// Moves each block to the piece that explains it best, until none changes.
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

}  // namespace

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

Vec3 Piece::displacement_of(Vec3 point) const {
  return shift + vec3(swing(turned, vec(point - centre)));
}

std::vector<std::vector<Moved>> clusters_of(const Model& model, const std::vector<Moved>& blocks) {
  std::vector<std::size_t> first(model.n_block, SIZE_MAX);
  for (std::size_t k = 0; k < blocks.size(); ++k) first[blocks[k].id] = k;
  std::vector<std::size_t> of(blocks.size());  // an earlier block of the same cluster, or itself
  std::iota(of.begin(), of.end(), std::size_t{0});
  const auto root = [&](std::size_t k) {
    while (of[k] != k) k = of[k] = of[of[k]];
    return k;
  };
  for (JointId j = 0; j < model.n_pair; ++j) {
    const std::size_t a = first[model.joint_a[j]], b = first[model.joint_b[j]];
    if (a == SIZE_MAX || b == SIZE_MAX) continue;
    const std::size_t low = std::min(root(a), root(b)), high = std::max(root(a), root(b));
    of[high] = low;
  }
  std::map<std::size_t, std::vector<Moved>> cluster;
  for (std::size_t k = 0; k < blocks.size(); ++k) cluster[root(k)].push_back(blocks[k]);
  std::vector<std::vector<Moved>> all;
  for (auto& [at, members] : cluster) all.push_back(std::move(members));
  return all;
}

}  // namespace wythe::study
