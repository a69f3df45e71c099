// What happened to each part of the wall in one state, sign by sign.
//
//   sign                  part        measure                                        threshold
//   flexural crack        pier        widest bed joint at foot or head               crack
//                         spandrel,   widest crack summed along a level line         crack
//                         connection
//   rocking               pier        share of a section at the foot that is open,   rocking
//                                     or of its motion that turns about a toe (dry)
//   diagonal shear crack  pier        height over which the shaft is parted; where   pier_crossed
//                                     it is dry, but for what turning explains
//                         spandrel    length over which the depth is parted          spandrel_crossed
//   sliding               pier, wall  slip all across a bed section, or all of them  sliding
//                         spandrel,   slip all down a vertical section               sliding
//                         connection
//   sliding at the base   pier, wall  slip all across the foundation                 sliding
//   sliding               top joint   slip all along plates or beam                  sliding
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

// rules_for() a wall with these parts.
[[nodiscard]] ModeRules rules_of(const WallParts& parts);
// Piers, spandrels, connections, toes, in the order of WallParts; then the whole wall where it has
// openings, and the top joint where it has plates or a beam.
[[nodiscard]] ElementStates element_states(const WallParts& parts, const WallMotion& motion,
                                           const ModeRules& rules);
// The part of a pier a diagonal crack is looked for in: a quarter of the width off foot and head,
// where the cracks of rocking and of the connections are.
[[nodiscard]] Box shaft_of(const Pier& pier);
// Growth of a pier's width at its most parted course, now [m].
[[nodiscard]] double width_growth(const Pier& pier, const WallParts& parts,
                                  const std::vector<JointMotion>& joints);

// Pieces that have left the rest of the wall by `sliding`, along a crack for half of their outline at least:
// what bends away along many small ones has not broken off. No loose stones: each is broken_off of the masonry or
// more, as far as `doubt`. The heaviest first.
[[nodiscard]] std::vector<PieceOff> broken_off(const WallMotion& motion, const ModeRules& rules);

// How surely each sign holds, from 0 to 1: the mean over crack widths from half to twice the rule's
// of a ramp from `doubt` below the threshold to as much above. By element, then sign, as in
// element_states.
using Truths = std::vector<std::vector<double>>;
[[nodiscard]] Truths truths_of(const WallParts& parts, const WallMotion& motion,
                               const ModeRules& rules);
// Truth of one measure with the rules as they are.
[[nodiscard]] double ramp(double value, double threshold, const ModeRules& rules);
// The truth of one sign of one element; 0 where the element has no such sign.
[[nodiscard]] double truth(const ElementStates& elements, const Truths& truths,
                           const std::string& element, const std::string& state);

}  // namespace wythe::study
