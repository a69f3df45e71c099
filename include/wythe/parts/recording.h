// What a restart needs beside the State: the recorder's memory and the result so far.
//
//   State      all that the next step needs                    (model.h)
//   Recording  all that the next row, kept state or event needs
//   Result     rows, kept states and events so far             (result.h)
//
// A run can go on from a copy of the three, and gives the same bits (solve.h).
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "wythe/parts/model.h"
#include "wythe/parts/result.h"

namespace wythe {

// The numbers that the recorder keeps from step to step. Each has eight bytes, so that a checkpoint can
// write them as one piece.
struct RecordingNumbers {
  // Where it began.
  std::int64_t under_way = 0;                      // 1: a stage is being recorded
  double start_time = -1;                          // [s], -1 before the first step
  double work_at_start = 0, damping_at_start = 0;  // [J]
  double dead = 0;  // along the push, on blocks that are not driven [N]

  // Sums of the open row. Forces are means over the path: a step counts by its velocity, at the smooth
  // start less than later.
  double next_close = 0;  // of the path [m]
  double weight_sum = 0, shear_weight = 0;
  double reaction_sum = 0, shear_sum = 0, unbalance_sum = 0, kinetic_sum = 0;
  std::int64_t steps = 0, shear_samples = 0, unbalance_samples = 0;
  std::int64_t full_window = 0;  // steps of the last window that was closed whole
  double stop_asked = 0;         // where stop_below was asked last, of the displacement [m]

  // Of a cyclic push: the leg under way.
  double leg_way = 0;                  // 1 or -1 along the push; 0: not a cyclic push
  double leg_target = 0;               // [m] along the push
  double leg_end = 0, leg_window = 0;  // [m] of the path

  // States to keep.
  std::int64_t next_frame = 1;
  std::int64_t next_state = 0;  // of output.states, sorted
  double next_reading = 0;      // [m]
  double read_at = 0;           // [m]; infinite once a state is kept there
  double due = 0;               // the next of states and readings [m]
  double next_shape = 0;        // of Result::rise_shapes [m]; infinite: no more
  double farthest = 0;          // of any step, this way or that [m]
  std::int64_t grows = 0;       // 1: the last step went farther than any before

  // The open window of Result::rise.
  double rise_from = 0, rise_weight = 0, rise_sum = 0;
  double rise_shear_weight = 0, rise_shear_sum = 0;

  // Of a shake: when its first step began [s], -1 before it; the open row.
  double shake_start = -1;
  double base_x = 0, base_y = 0, base_z = 0;  // sums of the ground's force on the wall [N]
  std::int64_t base_samples = 0;
  std::int64_t shake_rows = 0, shake_frames = 0;

  // Of a stage that shall settle: the furthest block's way [m] and the kinetic energy [J] when the way had last doubled,
  // and how often in succession the energy grew more than the way. The farthest way so far; the same, the work of loads and
  // the elastic energy [J] when the time had last doubled, and how often in succession the way grew nearly as the time.
  double fall_way = 0, fall_kinetic = 0;
  std::int64_t fall_faster = 0;
  double fall_most = 0, fall_then = 0, fall_work = 0, fall_elastic = 0;
  std::int64_t fall_steady = 0;
};

// One side of the start, along the push or against it; forces and distances as of a push there.
struct RecordedSide {
  double peak = 0;               // [N]
  double peak_displacement = 0;  // [m]
  double furthest = 0;           // of a row so far [m]
  bool balanced = false;         // the peak
  State peak_state;              // empty before there is a peak
};

struct Recording {
  RecordingNumbers numbers;
  std::array<RecordedSide, 2> side;
  std::vector<std::uint8_t> slid_off;  // joints that have (n_joint)
};

struct RunRecord {
  Recording recording;
  Result result;  // without what is read off the curve at the end
};

}  // namespace wythe
