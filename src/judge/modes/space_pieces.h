// Motion in space as rigid pieces, fitted by displacement and turn together,
// for any size of turn (docs/theory/failure_modes.md, "In space").
#pragma once

#include <cmath>
#include <vector>

#include "core/rotation.h"
#include "wythe/parts/model.h"

namespace wythe::study {

constexpr double kRigid = 0.15;  // of the motion: the most that rigid pieces may leave out

using Turn = Quaternion<double>;

struct Moved {
  BlockId id;
  Vec3 start, moved;
  Turn turned;
  double mass;
  double radius;  // of gyration, for its own turn [m]
  Vec3 longest;   // direction of its longest side if that is horizontal; else 0
  const BodySpec* body = nullptr;
};

// All rigid blocks in a state.
[[nodiscard]] std::vector<Moved> evaluate_blocks(const Model& model, const State& state);

// Blocks that move as one rigid body: centre, shift and turn, and the part of the motion that this misses.
struct Piece {
  std::vector<Moved> blocks;
  Vec3 centre, shift;
  Turn turned{1, {0, 0, 0}};
  Vec3 turn;  // the same as a vector [rad]
  double mass = 0, all = 0, missed = 0;
  bool turns = false;  // its axis is near: it does not only shift
  [[nodiscard]] double residual() const { return all > 0 ? std::sqrt(missed / all) : 0; }
  [[nodiscard]] Vec3 displacement_of(Vec3 point) const;  // displacement of a point of it [m]
};

// Fits shift and turn of a piece to its blocks.
void fit(Piece& piece);
[[nodiscard]] double residual(const std::vector<Piece>& pieces);
// The fewest rigid pieces that explain the motion, sorted upwards: at most four, and four where none are enough.
[[nodiscard]] std::vector<Piece> pieces_of(const Piece& whole);

// The plan of blocks: the direction across their length, and the square of thickness over length.
struct Plan {
  Vec3 normal;
  double thin = 1;
};
[[nodiscard]] Plan plan_of(const std::vector<Moved>& blocks);

// Clusters of blocks that are connected by joints, in the order of their first blocks.
[[nodiscard]] std::vector<std::vector<Moved>> clusters_of(const Model& model,
                                                          const std::vector<Moved>& blocks);

}  // namespace wythe::study
