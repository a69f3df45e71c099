// Two doubles at a time: every x86-64 processor.
#include "dynamics/executors/kernel_set.h"

namespace wythe::dynamics {

extern template struct PassesOf<ManyWalls<Pack<xsimd::sse2>>>;  // lane_kernels_sse2.cpp

const Kernels& sse2_kernels() {
  static constexpr Kernels kSet = kernels_of<Pack<xsimd::sse2>>("sse2");
  return kSet;
}

}  // namespace wythe::dynamics
