// What the files of the assessment share; the doors are in wythe/assessment.h.
#pragma once

#include <vector>

#include "wythe/assessment.h"

namespace wythe::study {

// The stage whose curve is judged; null: the model has no push.
[[nodiscard]] const Stage* push_of(const Model& model);
// Lowest point of the moving blocks [m]; heights count from it.
[[nodiscard]] double foot_of(const Model& model);
// States kept of a push, each displacement once, ascending, beyond its start.
[[nodiscard]] std::vector<const Snapshot*> states_by_displacement(const Result& result);
// How far each block went along the push since its start, when the curve's displacement was
// `displacement`: straight between the states kept [m]. Empty: no state reaches so far.
[[nodiscard]] std::vector<double> moved_at(const Model& model, const Result& result,
                                           double displacement);

// What a push is by its model alone: its curve and responses are those of none.
[[nodiscard]] JudgedPush judged_push(const Model& model);
// What the model file says that the masses of the assessment do not follow.
[[nodiscard]] std::vector<Message> notes_of_masses(const ModelSpec& spec, const Model& model);
[[nodiscard]] Message words_of_state(LimitState state);
// Of these, what makes its numbers unsafe: mass of floors that nothing counts.
[[nodiscard]] std::vector<Message> cautions_of_masses(const ModelSpec& spec, const Model& model);
// "shear" where any pier shows it, "flexure" where piers show that alone, "" where nothing is known; of
// one pier where it is named.
[[nodiscard]] std::string mechanism_of(const FailureMode& mode, const std::string& pier = "");

}  // namespace wythe::study
