// What the files of the assessment share; the doors are in wythe/parts/assessment.h.
#pragma once

#include <vector>

#include "wythe/parts/assessment.h"

namespace wythe::study {

// The stage whose curve is judged; null: the model has no push.
[[nodiscard]] const Stage* push_of(const Model& model);
// Blocks that move, deformable ones too, as read_block() numbers them.
[[nodiscard]] std::vector<BlockId> moving_blocks(const Model& model);
// Lowest and highest point of a block at the start [m].
struct Extent {
  double low = 0, high = 0;
};
[[nodiscard]] Extent extent_of(const Model& model, BlockId block);
// Lowest point of the moving blocks [m]; heights count from it.
[[nodiscard]] double foot_of(const Model& model);
// Result::readings of a push, each displacement once, ascending, beyond its start: they depend neither on
// the states asked for nor on frames, so that a sample is judged as a run of it.
[[nodiscard]] std::vector<const Snapshot*> states_by_displacement(const Result& result);
// How far each block went along the push, at the displacements of Result::rise_shapes and of those states,
// ascending: a number is told of the displacement it is stated for, which on the rise lies within the first millimetre.
[[nodiscard]] std::vector<MovedBlocks> shapes_of(const Model& model, const Result& result);
// How far each block went along the push from its start to this state, by its number; supports 0 [m].
[[nodiscard]] std::vector<double> moved_at(const Model& model, const Result& result,
                                           const Snapshot& state);
// The sums of PushedWall::moved; `masses` takes blocks, loads and added.
[[nodiscard]] std::vector<MovedMass> moved_masses(const AssessmentSpec& spec, const Model& model,
                                                  const Result& result, MassAndShape& masses);

// What a push is by its model alone: its curve and responses are those of none.
[[nodiscard]] JudgedPush judged_push(const Model& model);
// A push of this model, a run or a stored sample, and its pushed wall, where that is known.
[[nodiscard]] CodeAssessment judged(const ModelSpec& spec, const Model& model, JudgedPush push,
                                    const FailureMode& mode, const PushedWall& wall);
// The model's own push and the one the other way, which need no [assessment]. Throws InputError as ways_of().
[[nodiscard]] PushWays both_directions(const ModelSpec& spec, const Model& model);
// What the model file says that the masses of the assessment do not follow.
[[nodiscard]] std::vector<Message> notes_of_masses(const ModelSpec& spec, const Model& model);
[[nodiscard]] Message words_of_state(LimitState state);
// (A.3), of both codes.
[[nodiscard]] double eta_of(double damping);
// Of these, what makes its numbers unsafe: mass of floors that nothing counts.
[[nodiscard]] std::vector<Message> cautions_of_masses(const ModelSpec& spec, const Model& model);
// "shear" where any pier shows it, "flexure" where piers show that alone, "" where nothing is known; of
// one pier where it is named. In space by the name of the mode; kOutOfPlane where the wall leaves its plane.
inline constexpr const char* kOutOfPlane = "out of plane";
[[nodiscard]] std::string mechanism_of(const FailureMode& mode, const std::string& pier = "");

}  // namespace wythe::study
