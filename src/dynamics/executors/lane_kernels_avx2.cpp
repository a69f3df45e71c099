// The joints of four walls side by side, as kernels_avx2.cpp. Of their own, so that both compile at once.
#include "dynamics/executors/kernel_set.h"

namespace wythe::dynamics {

template struct PassesOf<ManyWalls<Pack<xsimd::avx2>>>;

}  // namespace wythe::dynamics
