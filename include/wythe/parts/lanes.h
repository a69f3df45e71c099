// How many walls of a campaign a core steps side by side.
#pragma once

namespace wythe {

// Of `walls` that the core is given. The environment variables WYTHE_SIMD and WYTHE_LANES choose others than this
// processor's best; throws InputError where the machine does not have them.
[[nodiscard]] int lanes_for(int walls);

}  // namespace wythe
