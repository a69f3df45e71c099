// The joints of two walls side by side, as kernels_sse2.cpp. Of their own, so that both compile at once.
#include "dynamics/executors/kernel_set.h"

namespace wythe::dynamics {

template struct PassesOf<ManyWalls<Pack<xsimd::sse2>>>;

}  // namespace wythe::dynamics
