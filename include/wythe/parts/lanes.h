// Number of walls of a campaign that a core steps side by side.
#pragma once

namespace wythe {

// Lanes for a core with `walls` walls: at most `walls`. The environment variables WYTHE_SIMD and WYTHE_LANES override this
// processor's best choice; throws InputError where the machine does not have them.
[[nodiscard]] int lanes_for(int walls);

}  // namespace wythe
