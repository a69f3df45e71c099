// Each wall begins with a step of its own. When walls came or ended, walls that fit the first are
// moved into as few lanes as possible. Lanes that are no more than half full cost more than walls
// alone, so they are given up. Without shared lanes, walls run to their end one after the other.
#include "dynamics/executors/lane_solver.h"

#include <fmt/core.h>

#include <algorithm>
#include <cstdlib>
#include <string>

#include "wythe/parts/error.h"
#include "wythe/parts/lanes.h"
#include "wythe/parts/solve.h"

namespace wythe {
namespace dynamics {

int lanes_in_use() {
  const char* forced = std::getenv("WYTHE_LANES");
  if (forced == nullptr || *forced == '\0') return kernels_in_use().width;
  const std::string text = forced;
  for (const int lanes : {1, 2, 4, 8})
    if (text == std::to_string(lanes)) return lanes;
  throw InputError({{.file = "WYTHE_LANES",
                     .value = text,
                     .problem = "is not a number of walls that can be stepped side by side",
                     .cure = "write 1, 2, 4 or 8, or leave it out for this processor's best"}});
}

}  // namespace dynamics

int lanes_for(int walls) { return std::min(dynamics::lanes_in_use(), walls); }

std::string instruction_set() {
  const int lanes = dynamics::lanes_in_use();
  return fmt::format("{}, {} wall{} side by side", dynamics::kernels_in_use().name, lanes,
                     lanes == 1 ? "" : "s");
}

namespace dynamics {

LaneSolver::LaneSolver(int width) : width_(width) {}

void LaneSolver::add_wall(int ticket, const Model& model, State& state,
                          const SolveOptions& options) {
  auto wall =
      std::make_unique<RunningWall>(RunningWall{ticket, model, state, -1, nullptr, nullptr});
  wall->alone = processor_for(model, 1);
  wall->alone->load_wall(0, model, state);
  wall->run = std::make_unique<WallRun>(model, state, options, wall->alone->access(0));
  walls_.push_back(std::move(wall));
  changed_ = true;
}

bool LaneSolver::fits(const RunningWall& wall) const {
  return together_ && fit_together(wall.model, together_->model());
}

// Moves the wall from its present place into `lane` (-1: a step of its own).
void LaneSolver::settle_in(RunningWall& wall, int lane) {
  if (lane >= 0) {
    if (wall.alone) wall.alone->unload_wall(0);
    together_->load_wall(lane, wall.model, wall.state);
    wall.run->move_to(together_->access(lane));
    wall.alone.reset();
  } else if (!wall.alone) {
    wall.alone = processor_for(wall.model, 1);
    wall.alone->load_wall(0, wall.model, wall.state);
    wall.run->move_to(wall.alone->access(0));
  }
  wall.lane = lane;
}

int LaneSolver::lanes_for(int fitting) const {
  int lanes = 1;
  while (lanes < fitting) lanes *= 2;
  // Few walls in wide lanes cost more than walls alone, whose joints fill packs of the same width. Measured with
  // wythe_bench: 4 walls in 8 lanes cost 1.2 times that, 5 in 8 lanes 0.97; 2 in 4 lanes 1.2, 3 in 4 lanes 0.8.
  return lanes < std::min(width_, kernels_in_use().width) ? 1 : lanes;
}

// Opens as few lanes as the running walls need, and moves every wall that fits into one of them.
void LaneSolver::arrange() {
  changed_ = false;
  const Model& first = together_ && !walls_.empty() ? together_->model() : walls_.front()->model;
  int fitting = 0;
  for (const auto& wall : walls_) fitting += fit_together(wall->model, first) ? 1 : 0;
  const int lanes = lanes_for(fitting);
  if (together_ && together_->lanes() != lanes) {
    for (const auto& wall : walls_)
      if (wall->lane >= 0) {
        together_->unload_wall(wall->lane);
        wall->lane = -1;
        settle_in(*wall, -1);
      }
    if (lanes < 2) {
      together_.reset();
      if (fitting == 0 && running() > 1) arrange();  // the remaining walls may fit each other
      return;
    }
    together_ = processor_for(together_->model(), lanes);
  } else if (!together_) {
    if (lanes < 2) return;
    together_ = processor_for(first, lanes);
  }
  std::vector<bool> taken(lanes, false);
  for (const auto& wall : walls_)
    if (wall->lane >= 0) taken[wall->lane] = true;
  for (const auto& wall : walls_) {
    if (wall->lane >= 0 || !fits(*wall)) continue;
    const auto free = std::find(taken.begin(), taken.end(), false);
    *free = true;
    settle_in(*wall, static_cast<int>(free - taken.begin()));
  }
}

void LaneSolver::step() {
  for (const auto& wall : walls_) {
    const Controls& controls = wall->run->next();
    if (wall->lane >= 0) {
      together_->set(wall->lane, controls);
      continue;
    }
    wall->alone->set(0, controls);
    wall->alone->step();
    wall->run->after_step(wall->alone->reaction(0));
    if (!together_) return;  // walls that share nothing run one after the other
  }
  together_->step();
  for (const auto& wall : walls_)
    if (wall->lane >= 0) wall->run->after_step(together_->reaction(wall->lane));
}

LaneSolver::Ended LaneSolver::next() {
  if (changed_) arrange();
  const auto ended = [](const auto& wall) { return wall->run->ended(); };
  auto found = std::find_if(walls_.begin(), walls_.end(), ended);
  while (found == walls_.end()) {
    step();
    found = std::find_if(walls_.begin(), walls_.end(), ended);
  }
  const std::unique_ptr<RunningWall> wall = std::move(*found);
  walls_.erase(found);
  changed_ = true;
  if (wall->lane >= 0)
    together_->unload_wall(wall->lane);
  else
    wall->alone->unload_wall(0);
  return {wall->ticket, wall->run->finish()};
}

}  // namespace dynamics
}  // namespace wythe
