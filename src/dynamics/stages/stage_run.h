// One stage under way, a step at a time, so that any number of walls can be stepped together.
//
//   prepare()       controls, ramps and loads of the next step
//   after_step(R)   rows, settling, stop criteria, collapse
//
//   gravity, load   ramp with a smooth start, then settle below settle_ratio
//   push            smooth start to the velocity, along one or several target displacements
//   body force      lambda grows only while the unbalance is below settle_ratio; the result is the largest carried
//   tilt            the same with the direction of gravity
//   hold            no new action for a duration
//   shake           the base moves by its records (shake.cpp)
//
// A stage keeps all data that later steps need in State and Recording. If it
// is created again from them in the middle, it goes on with the same bits.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "dynamics/executors/executor.h"
#include "wythe/parts/recording.h"
#include "wythe/parts/solve.h"

namespace wythe::dynamics {

// How a stage ended.
struct StageEnd {
  SolveStatus status = SolveStatus::kCompleted;
  Message reason;
  bool finished = true;  // false: the run ends here
};

inline constexpr int kCheckEvery = 500;  // steps between checks for collapse and for a stop

// Data that all stages of a run share.
struct StageContext {
  const Model& model;
  State& state;
  const SolveOptions& options;
  RunRecord& record;
  std::unique_ptr<WallAccess> access;
  Controls controls;
};

class StageRun {
 public:
  static std::unique_ptr<StageRun> start(StageContext& wall, const Stage& stage);
  virtual ~StageRun() = default;
  StageRun(const StageRun&) = delete;
  StageRun& operator=(const StageRun&) = delete;

  virtual void prepare() = 0;
  virtual void after_step(double reaction) = 0;
  [[nodiscard]] bool ended() const { return ended_; }
  // Ends the stage. Only the first call counts, also within one step.
  void end(StageEnd how);
  // Closes rows and writes the stage's report. Call once, after the last step.
  StageEnd close();
  // Blocks that the drive moves. They are marked anew when the wall changes its executor.
  [[nodiscard]] const std::vector<BlockId>& driven() const { return *driven_; }

 protected:
  StageRun(StageContext& wall, const Stage& stage);
  virtual void finish(StageEnd&) {}
  void drive(const Stage& push);
  // Every few hundred steps: reports progress and checks for instability and collapse.
  void check_run(double share);
  void check_motion(double share);  // progress and instability alone
  void check_falls();
  void check_world_bounds();
  [[nodiscard]] StageEnd fallen(const Furthest& furthest) const;
  [[nodiscard]] std::string name_of(BlockId block) const;

  StageContext& wall_;
  const Model& model_;
  const Stage& stage_;
  State& state_;
  StageProgress& progress_;  // of the state
  Controls& controls_;

 private:
  [[nodiscard]] StageEnd runs_away() const;
  [[nodiscard]] bool is_overloaded() const;
  [[nodiscard]] std::optional<Message> crushed() const;
  [[nodiscard]] int pulled_by(BlockId block, double& force) const;
  [[nodiscard]] bool pulled_away(BlockId block) const;
  [[nodiscard]] const Stage* last_push() const;
  [[nodiscard]] bool carries_its_push() const;
  [[nodiscard]] bool turns_with_push(const Furthest& furthest) const;

  const std::vector<BlockId>* driven_;
  bool ended_ = false;
  StageEnd end_;
};

// Smooth start: 0 at 0, 1 at 1, no slope at either end; 3 x^2 - 2 x^3.
[[nodiscard]] double smooth_step(double x);

// Time step of a stage [s]. Mass scaling applies to gravity, load and cut stages.
[[nodiscard]] double stage_time_step(const Model& model, const Stage& stage);
[[nodiscard]] double stage_mass_scaling(const Model& model, const Stage& stage);
// Length of the driven path of a push, all targets included [m].
[[nodiscard]] double driven_path(const Stage& stage);

}  // namespace wythe::dynamics
