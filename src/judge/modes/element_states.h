// What happened to each part of the wall in one state, sign by sign.
//
//   sign                  part        measure                                        threshold
//   flexural crack        pier        widest bed joint at foot or head               crack
//                         spandrel,   widest crack summed along a level line         crack
//                         connection
//   rocking               pier        share of a section at the foot that is open,   rocking
//                                     or of its motion that rotates about a toe (dry)
//   diagonal shear crack  pier        height over which the shaft is parted; in a    pier_crossed
//                                     dry pier less the share of rotation
//                         spandrel    length over which the depth is parted          spandrel_crossed
//   sliding               pier, wall  slip of 90 % of a bed section, or of all       sliding
//                         spandrel,   slip of 90 % of a vertical section             sliding
//                         connection
//   sliding at the base   pier, wall  slip of 90 % of the foundation                 sliding
//   sliding               top joint   slip of 90 % along plates or beam              sliding
//   breaking away         wall        share of the largest piece that came off       broken_off
//   toe crushing          toe         strength lost by a joint                       crushing
//
// Called by failure_mode.cpp; the reasons are in docs/theory/failure_modes.md.
#pragma once

#include <string>
#include <vector>

#include "judge/modes/joint_motion.h"
#include "judge/modes/wall_parts.h"
#include "wythe/parts/failure_mode.h"

namespace wythe::study {

inline constexpr const char* kDiagonal = "diagonal shear crack";
inline constexpr const char* kSliding = "sliding";
inline constexpr const char* kBaseSliding = "sliding at the base";
inline constexpr const char* kRocking = "rocking";
inline constexpr const char* kCrushing = "toe crushing";
inline constexpr const char* kFlexural = "flexural crack";
inline constexpr const char* kBreaking = "breaking away";

// Names of the elements that lie outside WallParts.
inline constexpr const char* kWholeWall = "whole wall";
inline constexpr const char* kTopJoint = "top joint";

// rules_for() for a wall with these parts.
[[nodiscard]] ModeRules rules_of(const WallParts& parts);
// Piers, spandrels, connections, toes, in the order of WallParts; then the whole wall where it has
// openings, and the top joint where it has plates or a beam.
[[nodiscard]] ElementStates element_states(const WallParts& parts, const WallMotion& motion,
                                           const ModeRules& rules);
// The part of a pier that is searched for a diagonal crack. It leaves out a quarter
// of the width at foot and head, where cracks of rocking and of connections lie.
[[nodiscard]] Box shaft_of(const Pier& pier);
// Present growth of a pier's width at its most parted course [m].
[[nodiscard]] double width_growth(const Pier& pier, const WallParts& parts,
                                  const std::vector<JointMotion>& joints);

// Pieces that moved away from the rest of the wall by `sliding`, along a crack over at least half of
// their outline. A part that bends away along many small cracks has not broken off. Each piece has a
// mass of at least broken_off, less `doubt`, so loose stones do not count. The heaviest first.
[[nodiscard]] std::vector<PieceOff> broken_off(const WallMotion& motion, const ModeRules& rules);

// The truth of each sign, from 0 to 1: the mean over crack widths from half to
// twice the rule's. At each width it is a ramp from `doubt` below the threshold
// to as much above. Ordered by element, then sign, as in element_states.
using Truths = std::vector<std::vector<double>>;
[[nodiscard]] Truths truths_of(const WallParts& parts, const WallMotion& motion,
                               const ModeRules& rules);
// Truth of one measure under the given rules.
[[nodiscard]] double ramp(double value, double threshold, const ModeRules& rules);
// The truth of one sign of one element; 0 where the element has no such sign.
[[nodiscard]] double truth(const ElementStates& elements, const Truths& truths,
                           const std::string& element, const std::string& state);

}  // namespace wythe::study
