// What is to be known of the random fields of a model (wythe/parts/field.h): the scatter that bounds leave them.
#pragma once

#include <vector>

#include "wythe/parts/message.h"
#include "wythe/parts/wall_spec.h"

namespace wythe {

// The coefficient of variation that its bounds leave a field; `cov` is of the distribution before they cut it.
// NaN of one that follows others.
[[nodiscard]] double cov_of(const FieldSpec& field);

// One for each field whose scatter a cut makes smaller by more than one per cent of it, and for each that takes the place
// of a strength of [scatter] and leaves the energies alone that would follow.
[[nodiscard]] std::vector<Message> notes_of_fields(const ModelSpec& spec);

}  // namespace wythe
