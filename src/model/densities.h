// What is told of values that no masonry has, and of blocks that take the unit's density because no table knows the name
// of their material.
#pragma once

#include <string>
#include <vector>

#include "wythe/parts/message.h"
#include "wythe/parts/model.h"
#include "wythe/parts/wall_spec.h"

namespace wythe {

// A coefficient of variation of 1 and more: 20 for 20 %.
[[nodiscard]] bool is_scatter_odd(double cov);
[[nodiscard]] Message note_of_scatter(const std::string& key, double cov);

// Values that masonry does not have, by their key; of a spec alone, such as that of a study's medians.
[[nodiscard]] std::vector<Message> notes_of_values(const ModelSpec& spec);

// Adds these and the other notes to model.anatomy.
void note_densities(const ModelSpec& spec, Model& model);

}  // namespace wythe
