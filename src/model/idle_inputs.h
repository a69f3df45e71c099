// Notes on inputs without effect in this model. They are notes, not faults, since --set, a study or a variant may replace
// another value and so make an input idle.
#pragma once

#include "wythe/parts/model.h"
#include "wythe/parts/wall_spec.h"

namespace wythe {

// Adds the notes to model.anatomy; needs joints, materials and stages.
void note_idle_inputs(const ModelSpec& spec, Model& model);

}  // namespace wythe
