// Runs the stages of a model:  solve(Model, State&) ──► Result.
#pragma once

#include "wythe/parts/checkpoint.h"
#include "wythe/parts/lanes.h"
#include "wythe/parts/recording.h"
#include "wythe/parts/solve.h"
