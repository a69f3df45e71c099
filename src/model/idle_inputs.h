// Notes on inputs that have no effect in this model. They are notes and no faults where --set, a study or a variant may put
// one value over another and so leave an input idle.
#pragma once

#include "wythe/parts/model.h"
#include "wythe/parts/wall_spec.h"

namespace wythe {

// Adds the notes to model.anatomy; needs joints, materials and stages.
void note_idle_inputs(const ModelSpec& spec, Model& model);

}  // namespace wythe
