// The wall in space that the benchmarks step: two leaves with headers, cracked by a push out of their plane, and
// its bare kernels (bare_space.h) checked against the engine.
#pragma once

#include <string>
#include <vector>

#include "bare_space.h"
#include "wythe/parts/model.h"

namespace wythe::bench {

struct SpaceWall {
  // A wall of `columns` x `courses` places, pushed to `until` [m].
  SpaceWall(int columns, int courses, double until);
  [[nodiscard]] const Stage& push() const { return model.stages.back(); }
  [[nodiscard]] int points() const { return static_cast<int>(model.space.point_r1.size()); }

  Model model;
  State state, held;  // cracked; the same with its driven blocks at rest
  std::string hash;
  double dt = 0;
};
// About 200 blocks and 5 000 points: fits the cache.
[[nodiscard]] const SpaceWall& space_wall();
// The same, whole: nothing has cracked. What a step costs there beside large_wall() is what the memory costs.
[[nodiscard]] const SpaceWall& still_wall();
// About 5 000 polyhedra, whole: does not.
[[nodiscard]] const SpaceWall& large_wall();

[[nodiscard]] std::vector<const SpaceKernels*> bare_space_here();

class BareSpaceRun {
 public:
  // One wall, or as many as the set has lanes.
  BareSpaceRun(const SpaceWall& wall, const SpaceKernels& kernels, bool many);
  void step() { kernels_.step[many_ ? 1 : 0](view_); }
  [[nodiscard]] State state() const;
  [[nodiscard]] double bytes_per_point() const;  // of one wall

 private:
  void fill_faces();
  void fill_blocks();
  // Number of row r of entity e: a pack holds as many entities as lanes, a place of many walls one.
  [[nodiscard]] std::size_t at(std::size_t e, std::size_t rows, std::size_t r) const;

  const SpaceWall& wall_;
  const SpaceKernels& kernels_;
  bool many_;
  std::size_t lanes_;
  std::vector<std::size_t> face_at_;  // of joint j
  std::vector<std::int32_t> a_, b_, begin_, middle_, entry_;
  dynamics::Lines<double> face_, point_, axes_, law_, hot_, cold_, block_, wall_rows_, shift_,
      turn_, force_, moment_a_, moment_b_;
  std::vector<unsigned char> busy_;
  BareSpace view_{};
};

// Throws std::runtime_error where a kernel computes something else than the engine.
void check_bare_space();

}  // namespace wythe::bench
