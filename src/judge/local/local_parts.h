// What these files share; the doors are in wythe/parts/local_check.h.
#pragma once

#include <vector>

#include "wythe/parts/limit.h"
#include "wythe/parts/local_check.h"

namespace wythe::study {

// A part that the file names or that rules find, as a strip of masonry with what lies on it. Throws InputError with
// where, and a cure, where it can't be.
[[nodiscard]] LocalCheck check_of_part(const ModelSpec& spec, const Model& model,
                                       const PartSpec& part, const std::string& path);
// Each storey from its foot up to the top of the wall, and what stands above the highest floor.
[[nodiscard]] std::vector<PartSpec> found_parts(const ModelSpec& spec, const Model& model);
// The mechanism of a body force. Throws InputError where it explains no multiplier.
[[nodiscard]] LocalCheck check_of_limit(const ModelSpec& spec, const Model& model,
                                        const NamedLimit& limit);
// Factor, demand, verdict and sentence, by what `check` holds of the mechanism. `crushes`: the line it turns about lies
// where the masonry bears the load.
void conclude(const ModelSpec& spec, const Model& model, bool crushes, LocalCheck& check);

}  // namespace wythe::study
