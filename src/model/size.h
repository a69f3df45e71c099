// Demands of a spec on the machine, estimated before anything is built: blocks, memory, steps, time.
//
// compile() refuses what the machine can't hold and runs of excessive length; a study asks the same of its
// samples. Orders of magnitude from lengths and counts; the cost does not depend on the wall's size.
#pragma once

#include <string>

#include "wythe/parts/error.h"
#include "wythe/parts/wall_spec.h"

namespace wythe {

// Default velocities (kWaitingVelocity, kAdaptedVelocity) for a push that states none.
[[nodiscard]] PushStage with_velocity(PushStage push);

// Course of a stage: path [m] or load factor, which its rows divide; probable duration [s];
// and the key that makes it longer.
struct Pace {
  double path = 0, seconds = 0;
  const char* key = "";
};
[[nodiscard]] Pace pace_of(const StageSpec& stage);

struct Size {
  double blocks = 0;
  double bytes = 0;    // of a run: model, state and stored states
  double steps = 0;    // of all stages
  double seconds = 0;  // on one core
};
[[nodiscard]] Size size_of(const ModelSpec& spec);

// Adds faults for more blocks than memory holds, more rows than a curve may have, and endless runs.
void check_size(const ModelSpec& spec, FaultList& faults);

// The problem of `samples` runs of one spec, whose records are read together; "" where they fit.
struct SizeProblem {
  std::string problem, cure;
};
[[nodiscard]] SizeProblem check_samples(const ModelSpec& spec, double samples);

// Memory available to the program [bytes]: WYTHE_MEMORY, such as "64 GB", else that of the machine.
// Throws InputError where WYTHE_MEMORY is no size.
[[nodiscard]] double memory_limit();

}  // namespace wythe
