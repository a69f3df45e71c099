// Cautions about the drift or failure mode of a single push, and when the scatter of many pushes replaces them.
#pragma once

#include <vector>

#include "wythe/parts/message.h"
#include "wythe/parts/model.h"

namespace wythe::study {

// Whether pushes of this model are like the adapting ones of docs/evidence/rate.md. There a single push was reliable
// for its displacement in 7 of 13 walls, and all 13 gave the answer of a slow push. Of 39 walls at one speed, 13
// differed, among them all 7 with more damping. All of these walls were in their plane, without free contacts.
[[nodiscard]] bool waits_at_cracks(const Model& model);
// Whether a caution is about a single push only, and many adapting pushes answer it. Not
// for a push that is too fast for its force, because that error always has the same sign.
[[nodiscard]] bool is_left_to_the_scatter(const Message& caution, bool waits);
// Drops such cautions of a push of `model`. The remaining ones of their
// kind need another push as a cure, because more walls are already there.
void leave_to_the_scatter(const Model& model, std::vector<Message>& cautions);

}  // namespace wythe::study
