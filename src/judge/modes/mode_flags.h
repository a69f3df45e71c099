// Severity flags beside a failure mode's name; raised where the value reaches its threshold.
// Called by failure_mode.cpp.
#pragma once

#include <vector>

#include "judge/modes/joint_motion.h"
#include "judge/modes/wall_parts.h"
#include "wythe/parts/failure_mode.h"

namespace wythe::study {

// Growth of each pier's width, pure sliding band in each spandrel, sliding of the loaded node.
[[nodiscard]] std::vector<Evidence> state_flags(const Model& model, const WallParts& parts,
                                                const std::vector<JointMotion>& joints,
                                                const ModeRules& rules);
// Largest fall of the reaction while the push advances by one crack width, against the peak.
[[nodiscard]] Evidence drop_flag(const std::vector<CurveRow>& curve, const ModeRules& rules);

}  // namespace wythe::study
