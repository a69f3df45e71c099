// The start of a stage that cuts openings and puts up what goes into them (docs/theory/cutting.md).
//
//   what is put up     stands where it fits its neighbours, and has no force
//   what is cut out    has no force any more; what its neighbours lack of balance acts on them as a load, which fades
//                      over the stage's ramp
#pragma once

#include "dynamics/stages/stage_run.h"

namespace wythe::dynamics {

// Once, before the first step of the stage; of a stage that goes on from a checkpoint nothing is left to do.
void begin_cut(StageContext& wall);

}  // namespace wythe::dynamics
