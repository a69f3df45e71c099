// Eight doubles at a time. Compiled with -mavx512f.
#include <immintrin.h>

#include "bare_space.h"

namespace wythe::bench {
namespace {

double fused(std::int64_t rounds) {
  __m512d x[kChains];
  for (int k = 0; k < kChains; ++k) x[k] = _mm512_set1_pd(1.0 + k);
  const __m512d factor = _mm512_set1_pd(0.999999), term = _mm512_set1_pd(1e-6);
  for (std::int64_t r = 0; r < rounds; ++r)
#pragma GCC unroll 12
    for (int k = 0; k < kChains; ++k) x[k] = _mm512_fmadd_pd(x[k], factor, term);
  double sum = 0;
  for (int k = 0; k < kChains; ++k) sum += x[k][0];
  return sum;
}

}  // namespace

const BareKernels& bare_avx512() {
  static constexpr BareKernels kSet = bare_kernels<Pack<xsimd::avx512f>>("avx512", fused);
  return kSet;
}

const SpaceKernels& bare_space_avx512() {
  static constexpr SpaceKernels kSet = space_kernels<Pack<xsimd::avx512f>>("avx512");
  return kSet;
}

}  // namespace wythe::bench
