// One double at a time: every processor.
#include "bare_space.h"

namespace wythe::bench {

const BareKernels& bare_scalar() {
  static constexpr BareKernels kSet = bare_kernels<double>("scalar");
  return kSet;
}

const SpaceKernels& bare_space_scalar() {
  static constexpr SpaceKernels kSet = space_kernels<double>("scalar");
  return kSet;
}

}  // namespace wythe::bench
