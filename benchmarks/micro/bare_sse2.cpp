// Two doubles at a time: every x86-64 processor.
#include "bare_packs.h"

namespace wythe::bench {

const BareKernels& bare_sse2() {
  static constexpr BareKernels kSet = bare_kernels<Pack<xsimd::sse2>>("sse2");
  return kSet;
}

}  // namespace wythe::bench
