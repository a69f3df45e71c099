// What a spec asks of the machine, told before anything is built: blocks, memory, steps, time.
//
// compile() refuses what the machine can't hold or nobody can wait for; a study asks the same of its
// samples. Orders of magnitude, from lengths and counts alone; nothing here depends on the wall's size.
#pragma once

#include <string>

#include "wythe/parts/error.h"
#include "wythe/parts/wall_spec.h"

namespace wythe {

// A push that says no velocity adapts it (kWaitingVelocity, kAdaptedVelocity); all other stages as they are.
[[nodiscard]] StageSpec with_velocity(StageSpec stage);

// How a stage goes: its path [m] or load factor, which its rows divide; the time it will probably take [s];
// and the key by which it takes longer.
struct Pace {
  double path = 0, seconds = 0;
  const char* key = "";
};
[[nodiscard]] Pace pace_of(const StageSpec& stage);

struct Size {
  double blocks = 0;
  double bytes = 0;    // of a run: model, state, and the states kept on the way
  double steps = 0;    // of all stages
  double seconds = 0;  // on one core
};
[[nodiscard]] Size size_of(const ModelSpec& spec);

// Faults for more blocks than memory holds, more rows than a curve may have, and runs without end.
void check_size(const ModelSpec& spec, FaultList& faults);

// The same for `samples` runs of one spec, whose records are read together; "" where they fit.
struct SizeProblem {
  std::string problem, cure;
};
[[nodiscard]] SizeProblem check_samples(const ModelSpec& spec, double samples);

// What the program may plan with [bytes]: WYTHE_MEMORY, e.g. "64 GB", else what the machine has.
// Throws InputError where WYTHE_MEMORY is no size.
[[nodiscard]] double memory_limit();

}  // namespace wythe
