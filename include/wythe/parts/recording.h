// What a restart needs besides the State: the memory of the recorder and the result so far.
//
//   State      all that the next step needs                    (model.h)
//   Recording  all that the next row, stored state or event needs
//   Result     rows, stored states and events so far        (result.h)
//
// A run that continues from a copy of the three gives the same bits (solve.h).
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "wythe/parts/model.h"
#include "wythe/parts/result.h"

namespace wythe {

// Numbers of the recorder between steps. Each has eight bytes, so that a checkpoint
// writes them as one block.
struct RecordingNumbers {
  // Start of the stage.
  std::int64_t under_way = 0;                      // 1: a stage is being recorded
  double start_time = -1;                          // [s], -1 before the first step
  double work_at_start = 0, damping_at_start = 0;  // [J]
  double dead = 0;  // dead load along the push on blocks that are not driven [N]

  // Sums of the open row. Forces are averaged over the path: a step has its velocity as weight, so those of the
  // smooth start count less.
  double next_close = 0;  // path at which the row closes [m]
  double weight_sum = 0, shear_weight = 0;
  double reaction_sum = 0, shear_sum = 0, unbalance_sum = 0, kinetic_sum = 0;
  std::int64_t steps = 0, shear_samples = 0, unbalance_samples = 0;
  std::int64_t full_window = 0;  // number of steps of the last complete window
  double stop_asked = 0;         // displacement at the last check of stop_below [m]

  // Current leg of a cyclic push.
  double leg_way = 0;                  // 1 or -1 along the push; 0: not a cyclic push
  double leg_target = 0;               // [m] along the push
  double leg_end = 0, leg_window = 0;  // [m] of the path

  // States to store.
  std::int64_t next_frame = 1;
  std::int64_t next_state = 0;  // index into output.states, sorted
  double next_reading = 0;      // [m]
  double read_at = 0;           // [m]; infinite once that state is stored
  double due = 0;               // displacement of the next state or reading [m]
  double next_shape = 0;        // next of Result::rise_shapes [m]; infinite: none left
  double farthest = 0;          // largest |displacement| of any step [m]
  std::int64_t grows = 0;       // 1: the last step went farther than all before

  // The open window of Result::rise.
  double rise_from = 0, rise_weight = 0, rise_sum = 0;
  double rise_shear_weight = 0, rise_shear_sum = 0;

  // Of a shake: time of its first step [s], -1 before it; the open row.
  double shake_start = -1;
  double base_x = 0, base_y = 0, base_z = 0;  // sums of the ground's force on the wall [N]
  std::int64_t base_samples = 0;
  std::int64_t shake_rows = 0, shake_frames = 0;

  // Detection of a fall in a stage that should settle. fall_way and fall_kinetic: displacement of the furthest block [m] and kinetic
  // energy [J] when that displacement last doubled; fall_faster: successive doublings in which the energy grew more. fall_most: largest
  // displacement; fall_then, _work, _elastic: its value and energies at the last doubling of time; fall_steady: steady doublings.
  double fall_way = 0, fall_kinetic = 0;
  std::int64_t fall_faster = 0;
  double fall_most = 0, fall_then = 0, fall_work = 0, fall_elastic = 0;
  std::int64_t fall_steady = 0;
};

// One direction of a push; forces and distances are positive in that direction.
struct RecordedSide {
  double peak = 0;               // [N]
  double peak_displacement = 0;  // [m]
  double furthest = 0;           // largest of a row so far [m]
  bool balanced = false;         // whether the row of the peak was in balance
  State peak_state;              // empty without a peak
};

struct Recording {
  RecordingNumbers numbers;
  std::array<RecordedSide, 2> side;
  std::vector<std::uint8_t> slid_off;  // 1: the joint has slid off (n_joint)
};

struct RunRecord {
  Recording recording;
  Result result;  // without values that are derived from the curve at the end
};

}  // namespace wythe
