// Notes on values that masonry does not have, and on blocks that get the unit's density because the name of their material
// is unknown.
#pragma once

#include <string>
#include <vector>

#include "wythe/parts/message.h"
#include "wythe/parts/model.h"
#include "wythe/parts/wall_spec.h"

namespace wythe {

// Whether a coefficient of variation is 1 or more, such as 20 for 20 %.
[[nodiscard]] bool is_scatter_odd(double cov);
[[nodiscard]] Message note_of_scatter(const std::string& key, double cov);

// Notes on values that masonry does not have, by key. Needs only a spec, such as that of a study's medians.
[[nodiscard]] std::vector<Message> notes_of_values(const ModelSpec& spec);

// Adds these notes and the others to model.anatomy.
void note_densities(const ModelSpec& spec, Model& model);

}  // namespace wythe
