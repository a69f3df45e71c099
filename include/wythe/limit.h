// Limit analysis and macro-blocks: the load that a wall of rigid blocks carries, and the mechanism in which it fails.
#pragma once

#include "wythe/parts/limit.h"
#include "wythe/parts/quick_limit.h"
#include "wythe/parts/second_opinion.h"
