// Short tables of a campaign for stdout.
#pragma once

#include "wythe/study.h"

namespace wythe::app {

// Number of samples and how they ended, then strength and displacement by failure mode.
void print_table(const Campaign& campaign, const Statistics& statistics);
// A warning about pushes that were not slow enough, before all numbers.
void print_rate_warning(const Statistics& statistics);
// Every input with mean and CoV of its samples, and the share that truncation cut off.
void print_inputs(const SampleTable& samples);

}  // namespace wythe::app
