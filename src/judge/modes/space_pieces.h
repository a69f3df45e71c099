// What moved in space as rigid pieces: fitted by displacement and turn together, however far they turned
// (docs/theory/failure_modes.md, "In space").
#pragma once

#include <cmath>
#include <vector>

#include "core/rotation.h"
#include "wythe/parts/model.h"

namespace wythe::study {

constexpr double kRigid = 0.15;  // of the motion: what rigid pieces may leave unexplained

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

// All rigid blocks in a state.
[[nodiscard]] std::vector<Moved> evaluate_blocks(const Model& model, const State& state);

// What moves as one: its centre, a shift and a turn; how much of the motion that leaves out.
struct Piece {
  std::vector<Moved> blocks;
  Vec3 centre, shift;
  Turn turned{1, {0, 0, 0}};
  Vec3 turn;  // the same as a vector [rad]
  double mass = 0, all = 0, missed = 0;
  bool turns = false;  // its axis passes near by: it does more than shift
  [[nodiscard]] double residual() const { return all > 0 ? std::sqrt(missed / all) : 0; }
  [[nodiscard]] Vec3 way_of(Vec3 point) const;  // of a point of it [m]
};

// The piece of its blocks.
void fit(Piece& piece);
[[nodiscard]] double residual(const std::vector<Piece>& pieces);
// As few rigid pieces as explain the motion, up to four, from the lowest up; four where none do.
[[nodiscard]] std::vector<Piece> pieces_of(const Piece& whole);

// Seen from above: which way blocks lie across their length, and how thick that is over how long, squared.
struct Plan {
  Vec3 normal;
  double thin = 1;
};
[[nodiscard]] Plan plan_of(const std::vector<Moved>& blocks);

// Blocks that joints between them hold together, from the first block on.
[[nodiscard]] std::vector<std::vector<Moved>> clusters_of(const Model& model,
                                                          const std::vector<Moved>& blocks);

}  // namespace wythe::study
