// The content of a model file as plain data in SI units: wall, materials, stages, settings, and for walls in space blocks and
// the builder's input. Physical values are NaN until they are given.
//
//   ModelSpec spec;  ──► compile(spec) (model.h)          lay_bodies(BuilderSpec, spec) for walls in space
#pragma once

#include "wythe/parts/body.h"
#include "wythe/parts/builder.h"
#include "wythe/parts/contact_law.h"
#include "wythe/parts/field.h"
#include "wythe/parts/free_contacts.h"
#include "wythe/parts/ground_motion.h"
#include "wythe/parts/masonry.h"
#include "wythe/parts/units.h"
#include "wythe/parts/vector.h"
#include "wythe/parts/wall_spec.h"
#include "wythe/parts/words.h"
#include "wythe/parts/zone_spec.h"
