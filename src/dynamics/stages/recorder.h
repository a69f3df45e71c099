// Turns steps into rows: means of reaction, base shear and meters over equal windows of the driven
// path. It also keeps the states on the way, and when each joint first cracked through or slid off.
// Data needed from step to step lie in a Recording, so that a run can be cut and continued anywhere.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "dynamics/executors/executor.h"
#include "wythe/parts/reading.h"
#include "wythe/parts/recording.h"

namespace wythe::dynamics {

// A fall, and its side in a cyclic push: 1 along it, -1 against it, 0 for a push in one direction.
struct LastingFall {
  FallTo fall;
  std::int64_t sense = 0;
};

class Recorder {
 public:
  // `path` is the whole driven path of the stage [m], or the whole ramp of a
  // load factor. `frames` states of it are kept for films, closer where cracks
  // begin, and one at `read_at` [m] for the failure mode. If `record` holds a
  // stage under way, the recorder continues it; if not, it begins anew.
  Recorder(const Model& model, const Stage& stage, double path, int frames, double read_at,
           RunRecord& record);

  // Called after every step; `travelled` of the path so far, `displacement` along the push.
  void take(const WallAccess& access, State& state, const Controls& controls, double reaction,
            double displacement, double load_factor, double travelled);
  // Closes the last window and adds the snapshot "end".
  // `ran_away`: the wall fell while the load was constant.
  void finish(const WallAccess& access, State& state, const Controls& controls,
              bool ran_away = false);
  // The fall below the stage's stop_below share of the peak, as soon as the curve shows that it lasts.
  [[nodiscard]] std::optional<LastingFall> lasting_fall();
  [[nodiscard]] bool row_closed() const { return row_closed_; }

 private:
  void begin(double read_at);
  void sample(const WallAccess& access, const State& state, const Controls& controls, bool all);
  void close_row(const State& state);
  void note_joints(const State& state, double displacement, double reaction);
  void note_slid_off(const std::vector<PointReading>& points, double displacement, double reaction);
  [[nodiscard]] Message place_of(JointId joint, const PointReading& point) const;
  void begin_leg(std::size_t leg, double from, double travelled);
  void plan_close();
  [[nodiscard]] bool has_turned() const;
  [[nodiscard]] double next_state_at() const { return state_at_[n_.next_state]; }
  void note_links(const State& state, double displacement, double reaction);
  void note_frames(const State& state, double displacement, double reaction);
  void note_layers(const State& state, double displacement, double reaction);
  void note_limits(const State& state, double displacement, double reaction);
  void take_snapshot(const std::string& label, const State& state);
  void take_states(const WallAccess& access, State& state);
  void take_shape(const WallAccess& access, State& state);
  void take_frame(const State& state, double travelled);
  void take_rise(double displacement, double travelled);
  void note_peak(const State& state);
  [[nodiscard]] double resisted_by_ground(const WallAccess& access, const State& state) const;
  [[nodiscard]] double dead_along_push(const State& state) const;
  [[nodiscard]] double head_axial(const State& state) const;

  const Model& model_;
  const Stage& stage_;
  Result& result_;
  Recording& recording_;
  RecordingNumbers& n_;  // of recording_
  double path_, window_;
  int frames_;
  std::vector<double> state_at_;
  // values of the last step
  double displacement_ = 0, load_factor_ = 0, weight_ = 1;
  bool row_closed_ = false;
};

}  // namespace wythe::dynamics
