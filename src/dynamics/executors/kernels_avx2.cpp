// Four doubles at a time. Compiled with -mavx2: every function here is a template over the
// instruction set, none is shared with code for older processors (tests/cli/kernels_test.sh).
#include "dynamics/executors/kernel_set.h"

namespace wythe::dynamics {

extern template struct PassesOf<ManyWalls<Pack<xsimd::avx2>>>;  // lane_kernels_avx2.cpp

const Kernels& avx2_kernels() {
  static constexpr Kernels kSet = kernels_of<Pack<xsimd::avx2>>("avx2");
  return kSet;
}

}  // namespace wythe::dynamics
