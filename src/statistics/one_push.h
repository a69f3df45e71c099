// What one push cannot tell of its drift or its failure, and when the scatter of many pushes tells it.
#pragma once

#include <vector>

#include "wythe/parts/message.h"
#include "wythe/parts/model.h"

namespace wythe::study {

// Whether pushes of this model are like those of docs/evidence/rate.md that adapted: a single one promised its
// displacement in 7 of 13, and all 13 gave the answer of a slow push. Of 39 at one speed 13 went another way, 7 of 7
// with more damping among them. All of these walls were in their plane, without free contacts.
[[nodiscard]] bool waits_at_cracks(const Model& model);
// Whether a caution is about what one push cannot tell, and many that wait can. Not where the push is not slow enough
// for its force: that error has one sign, however many pushes there are.
[[nodiscard]] bool is_left_to_the_scatter(const Message& caution, bool waits);
// Drops such cautions of a push of `model`. What is left of their kind is cured by another push, not by more walls: those
// are here already.
void leave_to_the_scatter(const Model& model, std::vector<Message>& cautions);

}  // namespace wythe::study
