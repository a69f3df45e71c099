// Walls side by side on a graphics processor, where the program was built for one (WYTHE_CUDA).
#pragma once

#include <string>

#include "dynamics/executors/executor.h"

namespace wythe::dynamics {

// "" or ", gpu": what --version says of it.
[[nodiscard]] const char* gpu_build();
// How many walls like this one are worth stepping at once, of `most` there are. Throws InputError
// where the build or the machine has no graphics processor, or its memory holds fewer than two walls.
[[nodiscard]] int gpu_walls(const Model& model, int most);
[[nodiscard]] std::unique_ptr<Executor> gpu_stepper(const Model& model, int walls);

}  // namespace wythe::dynamics
