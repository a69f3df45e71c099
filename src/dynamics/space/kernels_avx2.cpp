// Four doubles at a time (as executors/kernels_avx2.cpp).
#include "dynamics/space/kernel_set.h"

namespace wythe::dynamics::space {

const KernelSet& avx2_kernels() {
  static constexpr KernelSet kSet = kernels_of<Pack<xsimd::avx2>>("avx2");
  return kSet;
}

}  // namespace wythe::dynamics::space
