// The start of a stage that cuts openings and puts up what goes into them (docs/theory/cutting.md).
//
//   put up     is placed where it fits its neighbours, and starts without force
//   cut out    has no force any more. The unbalanced forces of its neighbours act on them as loads, which fade
//              over the stage's ramp
#pragma once

#include "dynamics/stages/stage_run.h"

namespace wythe::dynamics {

// Called once, before the first step of the stage. Does nothing for a stage that goes on from a checkpoint.
void begin_cut(StageContext& wall);

}  // namespace wythe::dynamics
