// Eight doubles at a time (as executors/kernels_avx512.cpp).
#include "dynamics/space/kernel_set.h"

namespace wythe::dynamics::space {

const KernelSet& avx512_kernels() {
  static constexpr KernelSet kSet = kernels_of<Pack<xsimd::avx512f>>("avx512");
  return kSet;
}

}  // namespace wythe::dynamics::space
