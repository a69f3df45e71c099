// What a state says, block by block, joint by joint, point by point, of walls in the plane and in space alike.
#pragma once

#include "wythe/parts/reading.h"
