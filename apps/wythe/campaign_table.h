// Short tables of a campaign for stdout.
#pragma once

#include "wythe/study.h"

namespace wythe::app {

// How many samples ran and how they ended, then strength and displacement by failure mode.
void print_table(const Campaign& campaign, const Statistics& statistics);
// A line where pushes were not slow enough; it comes before any number.
void print_rate_warning(const Statistics& statistics);
// Every input with the mean and CoV of its samples, and what truncation cut off.
void print_inputs(const SampleTable& samples);

}  // namespace wythe::app
