// Four doubles at a time (as kernels_avx2.cpp).
#include "dynamics/passes/pressing.h"

namespace wythe::dynamics {

void press_avx2(const PressTables& tables, PressGroup& group) {
  press<Pack<xsimd::avx2>>(tables, group);
}

}  // namespace wythe::dynamics
