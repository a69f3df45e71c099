// The joints of eight walls side by side, as kernels_avx512.cpp. Of their own, so that both compile at once.
#include "dynamics/executors/kernel_set.h"

namespace wythe::dynamics {

template struct PassesOf<ManyWalls<Pack<xsimd::avx512f>>>;

}  // namespace wythe::dynamics
