// Many walls, solved side by side in SIMD lanes; a lane that ends is free for the next wall at once.
//
//   LaneSolver solver(width);
//   while (walls left or solver.running() > 0) {
//     while (solver.has_room()) solver.add_wall(ticket, model, state, options);
//     LaneSolver::Ended ended = solver.next();     // steps all until one ends
//   }
//
// When half of the lanes are empty, each wall goes on in a step of its own (its joints
// fill the lanes of packs). A wall that does not fit the others (fit_together) is
// stepped alone beside them. No wall's bits depend on this (docs/theory/determinism.md).
#pragma once

#include <memory>
#include <vector>

#include "dynamics/executors/processor.h"
#include "dynamics/stages/wall_run.h"

namespace wythe::dynamics {

// How many walls should be stepped side by side: the width of the widest pack in use. WYTHE_LANES=1|2|4|8
// in the environment forces a number (for tests). Throws InputError for any other value.
[[nodiscard]] int lanes_in_use();

class LaneSolver {
 public:
  explicit LaneSolver(int width);

  [[nodiscard]] int running() const { return static_cast<int>(walls_.size()); }
  [[nodiscard]] bool has_room() const { return running() < width_; }
  // Takes a wall; model, state and what options refer to have to live until it has ended.
  void add_wall(int ticket, const Model& model, State& state, const SolveOptions& options);

  struct Ended {
    int ticket = 0;
    Result result;
  };
  // Steps all walls until one has ended. At least one has to be running.
  [[nodiscard]] Ended next();

 private:
  struct RunningWall {
    int ticket;
    const Model& model;
    State& state;
    int lane = -1;                    // -1: alone
    std::unique_ptr<Executor> alone;  // where lane is -1
    std::unique_ptr<WallRun> run;
  };

  void arrange();
  void settle_in(RunningWall& wall, int lane);
  void step();
  [[nodiscard]] bool fits(const RunningWall& wall) const;

  [[nodiscard]] int lanes_for(int fitting) const;

  int width_;
  std::unique_ptr<Executor> together_;
  std::vector<std::unique_ptr<RunningWall>> walls_;
  bool changed_ = false;  // walls came or went since the last arrange()
};

}  // namespace wythe::dynamics
