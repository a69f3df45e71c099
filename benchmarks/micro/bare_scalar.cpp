// One double at a time: every processor.
#include "bare_packs.h"

namespace wythe::bench {

const BareKernels& bare_scalar() {
  static constexpr BareKernels kSet = bare_kernels<double>("scalar");
  return kSet;
}

}  // namespace wythe::bench
