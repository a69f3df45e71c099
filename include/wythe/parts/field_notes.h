// Notes on the random fields of a model (wythe/parts/field.h), such as the scatter that remains within bounds.
#pragma once

#include <vector>

#include "wythe/parts/message.h"
#include "wythe/parts/wall_spec.h"

namespace wythe {

// Coefficient of variation of a field after truncation [-]; `cov` is that of the distribution before.
// NaN for a field that follows others.
[[nodiscard]] double cov_of(const FieldSpec& field);

// A note for each field whose cov truncation changes by more than 1 %. Also one for each field that replaces a strength
// of [scatter] without the fracture energies that would follow it.
[[nodiscard]] std::vector<Message> notes_of_fields(const ModelSpec& spec);

}  // namespace wythe
