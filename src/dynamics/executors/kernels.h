// The loops of the step, compiled once for each instruction set, and the choice between the sets.
//
// A kernel runs one pass (passes/*.h) over one chunk: over groups of kGroup neighbours of one
// wall, or over `width` walls side by side. All sets give the same bits, because each sums works
// in kGroup lanes of entities. WYTHE_SIMD=scalar|sse2|avx2|avx512 in the environment forces a
// set (for tests). Otherwise the widest set that this build and the processor support is used.
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
// The set in use: the one that WYTHE_SIMD names, else the widest. Throws InputError where
// WYTHE_SIMD names a set that is unknown, or that this build or this processor lacks.
[[nodiscard]] const Kernels& kernels_in_use();
// All sets that this build and this processor support, narrowest first.
[[nodiscard]] const std::vector<const Kernels*>& kernels_here();

[[nodiscard]] const Kernels& sse2_kernels();
[[nodiscard]] const Kernels& avx2_kernels();
[[nodiscard]] const Kernels& avx512_kernels();

}  // namespace wythe::dynamics
