// Functions that these files share; the public ones are in wythe/parts/local_check.h.
#pragma once

#include <vector>

#include "wythe/parts/limit.h"
#include "wythe/parts/local_check.h"

namespace wythe::study {

// A part from the file or found by rules, as a strip of masonry with its
// loads. Throws InputError with place and cure where that is impossible.
[[nodiscard]] LocalCheck check_of_part(const ModelSpec& spec, const Model& model,
                                       const PartSpec& part, const std::string& path);
// Each storey from its foot up to the top of the wall, and the parts above the highest floor; less those for which `named`
// parts stand.
[[nodiscard]] std::vector<PartSpec> found_parts(const ModelSpec& spec, const Model& model,
                                                const std::vector<PartSpec>& named);
// The mechanism of a body force. Throws InputError where it does not give the multiplier of the limit load.
[[nodiscard]] LocalCheck check_of_limit(const ModelSpec& spec, const Model& model,
                                        const NamedLimit& limit);
// Tells in a check that is done of a part between its holds with less reserve. One that fails is a caution.
void add_weaker(Message weaker, double reserve, bool holds, LocalCheck& part);
// Adds capacity, factor, demand, verdict and sentence to `check`, by the best of the curves, each of which is on the safe side.
// `crushes`: the line of rotation takes account of the strength of masonry.
void conclude(const ModelSpec& spec, const Model& model, bool crushes,
              const std::vector<LocalCapacity>& curves, LocalCheck& check);

}  // namespace wythe::study
