// Notes on the values of a study, of its base model and its samples, that no masonry has.
#pragma once

#include <vector>

#include "wythe/parts/message.h"
#include "wythe/parts/study.h"

namespace wythe {

// Notes on the values of the base model with each input at its sample median (src/model/densities.h). Also notes on inputs whose
// scatter reaches their mean, such as cov = 20 in place of 20 %.
[[nodiscard]] std::vector<Message> notes_of_values(const StudySpec& study,
                                                   const SampleTable& samples,
                                                   const ModelBuilder& build);

}  // namespace wythe
