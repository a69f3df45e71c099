// What is told of densities: those that no masonry has, and blocks that take the unit's because no table knows the name
// of their material.
#pragma once

#include "wythe/model.h"
#include "wythe/wall_spec.h"

namespace wythe {

void note_densities(const ModelSpec& spec, Model& model);

}  // namespace wythe
