// What the console says of studies with records: before the runs, and of their results.
#pragma once

#include <set>
#include <string>

#include "wythe/campaign.h"
#include "wythe/statistics.h"

namespace wythe::app {

// Records, intensities, numbers of shakes and their time; returns the time at most, on one core [s].
double print_shakes_asked(const StudySpec& study, const SampleTable& samples,
                          const ModelBuilder& build);
// What a model notes of its records and their damping, each text once.
void print_record_notes(const Model& model, std::set<std::string>& said);
// Shakes and limit states.
void print_shaking(const ShakingStatistics& statistics);

// "2.5 m/s^2"
[[nodiscard]] std::string intensity_text(const ShakingSpec& shaking, double intensity);

}  // namespace wythe::app
