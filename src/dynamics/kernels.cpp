// The scalar kernels, and the choice between the sets.
#include "dynamics/kernels.h"

#include <cstdlib>
#include <cstring>

#include "dynamics/kernel_set.h"

namespace wythe::dynamics {
namespace {

const Kernels& choose() {
#if defined(__x86_64__)
  const char* forced = std::getenv("WYTHE_SIMD");
  const auto is = [&](const char* name) {
    return forced != nullptr && std::strcmp(forced, name) == 0;
  };
  if (is("scalar")) return scalar_kernels();
  if (is("sse2")) return sse2_kernels();
  return __builtin_cpu_supports("avx2") ? avx2_kernels() : sse2_kernels();
#else
  return scalar_kernels();
#endif
}

}  // namespace

const Kernels& scalar_kernels() {
  static constexpr Kernels kSet = kernel_set<double>("scalar");
  return kSet;
}

const Kernels& kernels_in_use() {
  static const Kernels& chosen = choose();
  return chosen;
}

}  // namespace wythe::dynamics
