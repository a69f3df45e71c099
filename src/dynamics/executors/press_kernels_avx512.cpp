// Eight doubles at a time (as kernels_avx512.cpp).
#include "dynamics/passes/pressing.h"

namespace wythe::dynamics {

void press_avx512(const PressTables& tables, PressGroup& group) {
  press<Pack<xsimd::avx512f>>(tables, group);
}

}  // namespace wythe::dynamics
