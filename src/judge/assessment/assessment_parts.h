// Functions that several files of the assessment share; the public ones are in wythe/parts/assessment.h.
#pragma once

#include <vector>

#include "wythe/parts/assessment.h"

namespace wythe::study {

// The stage whose curve is judged; null: the model has no push.
[[nodiscard]] const Stage* push_of(const Model& model);
// Blocks that move, deformable ones included, numbered as in read_block().
[[nodiscard]] std::vector<BlockId> moving_blocks(const Model& model);
// Lowest and highest point of a block at the start [m].
struct Extent {
  double low = 0, high = 0;
};
[[nodiscard]] Extent extent_of(const Model& model, BlockId block);
// Lowest point of the moving blocks [m]; heights count from it.
[[nodiscard]] double foot_of(const Model& model);
// KeptStates::readings of a push, each farther than all before it: the point that is followed may swing back when
// the wall falls, and that state is none of its way there. A peak before the first of them, or beyond the last, has its state too.
// They depend neither on the requested states nor on frames, so a sample is judged like a run.
[[nodiscard]] std::vector<const Snapshot*> states_by_displacement(const Result& result);
// Displacement of each block along the push, ascending: at the displacements of Result::rise_shapes, and at those
// states. A yield displacement often lies within the first millimetre of the rise, so that has shapes of its own.
[[nodiscard]] std::vector<MovedBlocks> shapes_of(const Model& model, const Result& result);
// Displacement of each block along the push from its start to this state, by its number; supports 0 [m].
[[nodiscard]] std::vector<double> moved_at(const Model& model, const Result& result,
                                           const Snapshot& state);
// The sums of PushedWall::moved. `masses` returns the masses of blocks, of loads and of additions.
[[nodiscard]] std::vector<MovedMass> moved_masses(const AssessmentSpec& spec, const Model& model,
                                                  const Result& result, MassAndShape& masses);

// The data of a push that follow from its model alone; curve and responses are empty.
[[nodiscard]] JudgedPush judged_push(const Model& model);
// The assessment of a push of this model (a run or a stored sample), with its pushed wall where that is known.
[[nodiscard]] CodeAssessment judged(const ModelSpec& spec, const Model& model, JudgedPush push,
                                    const FailureMode& mode, const PushedWall& wall);
// The model's own push and the opposite one, without need of [assessment]. Throws InputError as ways_of() does.
[[nodiscard]] PushWays both_directions(const ModelSpec& spec, const Model& model);
// Notes on parts of the model file that the masses of the assessment do not include.
[[nodiscard]] std::vector<Message> notes_of_masses(const ModelSpec& spec, const Model& model);
[[nodiscard]] Message words_of_state(LimitState state);
// Damping correction (A.3) of both codes.
[[nodiscard]] double eta_of(double damping);
// Inputs that make the result unsafe: values that are probably errors of unit, mass of floors that is counted nowhere.
[[nodiscard]] std::vector<Message> cautions_of_inputs(const ModelSpec& spec, const Model& model);
// Values that codes do not have, or that count less than codes count: of spectra, and the share of masonry.
[[nodiscard]] std::vector<Message> cautions_of_demand(const AssessmentSpec& spec);
// "shear" where any pier shows it, "flexure" where piers show only that, "" where nothing is known; of one pier
// if it is named. In space it follows from the name of the mode; kOutOfPlane where the wall leaves its plane.
inline constexpr const char* kOutOfPlane = "out of plane";
[[nodiscard]] std::string mechanism_of(const FailureMode& mode, const std::string& pier = "");

}  // namespace wythe::study
