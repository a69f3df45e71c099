// The loops of a step in space, compiled once for each instruction set (as executors/kernels.h in the plane).
#pragma once

#include <vector>

#include "dynamics/space/tables.h"

namespace wythe::dynamics::space {

// Adds the works of the chunk to `works`: kTerms x kGroup sums of each wall.
using Kernel = void (*)(const Tables&, const Chunk&, double* works);

struct KernelSet {
  const char* name;
  int width;
  Kernel joints[2], dashpots[2], blocks[2];  // over neighbours of one wall, over walls side by side
};

[[nodiscard]] const KernelSet& scalar_kernels();
// All sets that this processor supports, narrowest first, as far as WYTHE_SIMD allows (executors/kernels.h).
[[nodiscard]] const std::vector<const KernelSet*>& kernels_here();

[[nodiscard]] const KernelSet& avx2_kernels();
[[nodiscard]] const KernelSet& avx512_kernels();

}  // namespace wythe::dynamics::space
