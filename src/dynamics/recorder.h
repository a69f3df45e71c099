// Turns steps into rows: averages of reaction, base shear and the meters over equal windows of the
// driven path, the states on the way, and when each joint first cracked through or slid off.
#pragma once

#include <vector>

#include "dynamics/executors/executor.h"
#include "wythe/reading.h"
#include "wythe/result.h"

namespace wythe::dynamics {

class Recorder {
 public:
  // `path` is the whole driven path of the stage [m] (or the whole ramp of a load factor).
  // Of the path, `frames` states are kept for moving pictures, closer where cracks begin; at
  // `read_at` [m] one for the failure mode.
  Recorder(const Model& model, const Stage& stage, double path, int frames, double read_at,
           Result& result);

  // Called after every step; `travelled` of the path so far, `displacement` along the push.
  void take(const Place& place, State& state, const Controls& controls, double reaction,
            double displacement, double load_factor, double travelled);
  // Closes the last window and adds the snapshot "end". `ran_away`: the load stood still while the
  // wall fell.
  void finish(const Place& place, State& state, const Controls& controls, bool ran_away = false);
  // True when the last rows, all beyond any displacement before on their side, lie below the stage's
  // stop_below share of the peak so far on that side.
  [[nodiscard]] bool fell_below() const;
  [[nodiscard]] bool row_closed() const { return row_closed_; }

 private:
  void sample(const Place& place, const State& state, const Controls& controls, bool all);
  void close_row(const State& state);
  void note_joints(const State& state, double displacement, double reaction);
  void note_slid_off(const std::vector<PointReading>& points, double displacement, double reaction);
  [[nodiscard]] std::string place_of(JointId joint, const PointReading& point) const;
  void begin_leg(std::size_t leg, double from, double travelled);
  void plan_close();
  [[nodiscard]] bool has_turned() const;
  void note_limits(const State& state, double displacement, double reaction);
  void take_snapshot(const std::string& label, const State& state);
  void take_states(const Place& place, State& state);
  void take_frame(const State& state, double travelled);
  void take_rise(double displacement, double travelled);
  void note_peak(const State& state);
  [[nodiscard]] double resisted_by_ground(const Place& place, const State& state) const;
  [[nodiscard]] double dead_along_push(const State& state) const;

  const Model& model_;
  const Stage& stage_;
  Result& result_;
  double path_, window_;
  double leg_target_ = 0, leg_end_ = 0,
         leg_window_;  // of a cyclic push: [m] along the push, of the path
  int leg_way_ = 0;    // 0: not a cyclic push
  int frames_, next_frame_ = 1;
  double start_time_;
  double work_at_start_, damping_at_start_ = 0;
  double next_close_;
  double displacement_ = 0, load_factor_ = 0;
  // Forces are means over the path: a step counts by its velocity, at the smooth start less than later.
  double weight_ = 1, weight_sum_ = 0, shear_weight_ = 0;
  double reaction_sum_ = 0, shear_sum_ = 0, unbalance_sum_ = 0, kinetic_sum_ = 0;
  long steps_ = 0, shear_samples_ = 0, unbalance_samples_ = 0;
  // On the two sides of the start, along the push and against it; forces and distances as of a push there.
  struct Side {
    double peak = 0;
    bool balanced = false;  // the peak
    State peak_state;
    double peak_displacement = 0;
    double furthest = 0;  // of a row so far [m]
  };
  Side side_[2];
  std::size_t next_state_ = 0;
  double next_reading_;  // [m]
  double read_at_;       // [m]; infinite once a state is kept there
  double due_;           // the next of states and readings [m]
  std::vector<double> state_at_;
  double farthest_ = 0;         // of any step, this way or that [m]
  bool grows_ = false;          // the last step went farther than any before
  std::vector<bool> slid_off_;  // joints (n_joint)
  bool row_closed_ = false;
  // The open window of `rise`: where it began, and its sums so far.
  double rise_from_ = 0, rise_weight_ = 0, rise_sum_ = 0;
  double rise_shear_weight_ = 0, rise_shear_sum_ = 0;
  double dead_ = 0;       // along the push, on blocks that are not driven [N]
  long full_window_ = 0;  // steps of the last window that was closed whole
  int low_rows_ = 0;      // rows below stop_below in a row
};

}  // namespace wythe::dynamics
