// Eight doubles at a time. Compiled with -mavx512f: every function here is a template over the
// instruction set, none is shared with code for older processors (tests/cli/kernels_test.sh).
#include "dynamics/executors/kernel_set.h"

namespace wythe::dynamics {

extern template struct PassesOf<ManyWalls<Pack<xsimd::avx512f>>>;  // lane_kernels_avx512.cpp

const Kernels& avx512_kernels() {
  static constexpr Kernels kSet = kernels_of<Pack<xsimd::avx512f>>("avx512");
  return kSet;
}

}  // namespace wythe::dynamics
