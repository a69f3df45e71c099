// What the console says of studies with records: before the runs, and of their results.
#pragma once

#include <string>
#include <vector>

#include "wythe/study.h"

namespace wythe::app {

// Records, intensities, numbers of shakes and their time; returns the time at most, on one core [s].
double print_shakes_asked(const StudySpec& study, const SampleTable& samples,
                          const ModelBuilder& build);
// Adds what a model notes of its records and their damping, each text once.
void add_record_notes(const Model& model, std::vector<Message>& notes);
// Shakes and limit states.
void print_shaking(const ShakingStatistics& statistics);

// "2.5 m/s^2"
[[nodiscard]] std::string intensity_text(const ShakingSpec& shaking, double intensity);

}  // namespace wythe::app
