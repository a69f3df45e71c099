// Values of a state for each block, joint and contact point, for walls in the plane and in space alike.
#pragma once

#include "wythe/parts/reading.h"
