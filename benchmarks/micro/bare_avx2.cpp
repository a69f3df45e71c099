// Four doubles at a time. Compiled with -mavx2; the fused peak needs FMA, which came with AVX2.
#include <immintrin.h>

#include "bare_space.h"

namespace wythe::bench {
namespace {

[[gnu::target("avx2,fma")]] double fused(std::int64_t rounds) {
  __m256d x[kChains];
  for (int k = 0; k < kChains; ++k) x[k] = _mm256_set1_pd(1.0 + k);
  const __m256d factor = _mm256_set1_pd(0.999999), term = _mm256_set1_pd(1e-6);
  for (std::int64_t r = 0; r < rounds; ++r)
#pragma GCC unroll 12
    for (int k = 0; k < kChains; ++k) x[k] = _mm256_fmadd_pd(x[k], factor, term);
  double sum = 0;
  for (int k = 0; k < kChains; ++k) sum += x[k][0];
  return sum;
}

}  // namespace

const BareKernels& bare_avx2() {
  static constexpr BareKernels kSet = bare_kernels<Pack<xsimd::avx2>>("avx2", fused);
  return kSet;
}

const SpaceKernels& bare_space_avx2() {
  static constexpr SpaceKernels kSet = space_kernels<Pack<xsimd::avx2>>("avx2");
  return kSet;
}

}  // namespace wythe::bench
