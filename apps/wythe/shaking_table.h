// Console output for studies with records: before the runs, and their results.
#pragma once

#include <string>
#include <vector>

#include "wythe/study.h"

namespace wythe::app {

// Prints records, intensities, numbers of shakes and their time; returns the longest time on one core [s].
double print_shakes_asked(const StudySpec& study, const SampleTable& samples,
                          const ModelBuilder& build);
// Adds a model's notes on records and their damping, each text once.
void add_record_notes(const Model& model, std::vector<Message>& notes);
// Shakes and limit states.
void print_shaking(const ShakingStatistics& statistics);

// "2.5 m/s^2"
[[nodiscard]] std::string intensity_text(const ShakingSpec& shaking, double intensity);

}  // namespace wythe::app
