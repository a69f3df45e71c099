// Two doubles at a time: every x86-64 processor.
#include "dynamics/kernel_set.h"

namespace wythe::dynamics {

const Kernels& sse2_kernels() {
  static constexpr Kernels kSet = KernelsOf<Pack<xsimd::sse2>>::named("sse2");
  return kSet;
}

}  // namespace wythe::dynamics
