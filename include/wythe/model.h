// The compiled wall: Model, flat arrays that never change, and State, all that a restart needs.
//
//   ModelSpec ──► compile() ──► Model ──► initial_state() ──► State
#pragma once

#include "wythe/parts/field_notes.h"
#include "wythe/parts/hexahedron_shape.h"
#include "wythe/parts/model.h"
#include "wythe/parts/zone_shape.h"
