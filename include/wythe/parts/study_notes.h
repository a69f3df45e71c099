// What is to be known of the values of a study: those that no masonry has, of its base model and of its samples.
#pragma once

#include <vector>

#include "wythe/parts/message.h"
#include "wythe/parts/study.h"

namespace wythe {

// The notes on values that a model has (wythe/parts/model.h), of the base model with each input at the median of its samples;
// and on inputs that scatter by their own mean and more, such as cov = 20 for 20 %.
[[nodiscard]] std::vector<Message> notes_of_values(const StudySpec& study,
                                                   const SampleTable& samples,
                                                   const ModelBuilder& build);

}  // namespace wythe
