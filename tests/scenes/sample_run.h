// An artificial run for tests of files and reports: no solver, every number known.
//
//        +---------+
//        | upper   |   slid 3 mm to the right, head up 1 mrad
//        +---------+   joint 0 (bed): open 0.3 mm at one end, crushed at the other
//        | lower   |
//        +---------+   joint 1 (foundation): sound
//        ///////////
#pragma once

#include "wythe/parts/model.h"
#include "wythe/parts/result.h"
#include "wythe/parts/wall_spec.h"

namespace wythe::scenes {

[[nodiscard]] ModelSpec sample_spec();
[[nodiscard]] Model sample_model();
[[nodiscard]] State sample_state();
// Curve up to 10 kN at 2 mm, softening to 6 kN at 10 mm; 80 % is crossed at 6 mm.
[[nodiscard]] Result sample_result();

}  // namespace wythe::scenes
