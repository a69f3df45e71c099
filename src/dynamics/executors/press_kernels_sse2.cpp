// Two doubles at a time (as kernels_sse2.cpp).
#include "dynamics/passes/pressing.h"

namespace wythe::dynamics {

void press_sse2(const PressTables& tables, PressGroup& group) {
  press<Pack<xsimd::sse2>>(tables, group);
}

}  // namespace wythe::dynamics
