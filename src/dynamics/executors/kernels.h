// The loops of the step, compiled once for each instruction set, and the choice between the sets.
//
// A kernel runs one pass (passes/*.h) over one chunk: of neighbours in one wall, in groups of kGroup, or
// of walls side by side, `width` of them. All give the same bits: works are summed in kGroup lanes of
// entities by everybody. WYTHE_SIMD=scalar|sse2|avx2|avx512 in the environment forces a set (tests);
// otherwise it is the widest that this build and the processor have.
#pragma once

#include <vector>

#include "dynamics/passes/tables.h"

namespace wythe::dynamics {

// Adds the works of the chunk to `works`: kTerms x kGroup sums of each wall.
using Kernel = void (*)(const Tables&, const Chunk&, double* works);

struct Kernels {
  const char* name;
  int width;
  Kernel neighbours[kPasses];
  Kernel walls[kPasses];
};

[[nodiscard]] const Kernels& scalar_kernels();
// The set in use: WYTHE_SIMD, else the widest this processor has. Throws InputError where the
// environment asks for a set that is unknown, or that this build or this processor lacks.
[[nodiscard]] const Kernels& kernels_in_use();
// All that this build and this processor have, narrowest first.
[[nodiscard]] const std::vector<const Kernels*>& kernels_here();

[[nodiscard]] const Kernels& sse2_kernels();
[[nodiscard]] const Kernels& avx2_kernels();
[[nodiscard]] const Kernels& avx512_kernels();

}  // namespace wythe::dynamics
