// The scalar kernels, and the choice between the sets.
#include "dynamics/executors/kernels.h"

#include <cstdlib>
#include <cstring>
#include <string>

#include "dynamics/executors/kernel_set.h"
#include "wythe/parts/error.h"

namespace wythe::dynamics {
namespace {

// The sets that this build and this processor support (cmake/kernels.cmake), narrowest first.
std::vector<const Kernels*> available() {
  std::vector<const Kernels*> sets{&scalar_kernels()};
#if defined(WYTHE_SSE2_KERNELS)
  sets.push_back(&sse2_kernels());
#endif
#if defined(WYTHE_AVX2_KERNELS)
  if (__builtin_cpu_supports("avx2")) sets.push_back(&avx2_kernels());
#endif
#if defined(WYTHE_AVX512_KERNELS)
  if (__builtin_cpu_supports("avx512f")) sets.push_back(&avx512_kernels());
#endif
  return sets;
}

// The sets up to the one that WYTHE_SIMD names.
std::vector<const Kernels*> choose() {
  std::vector<const Kernels*> sets = available();
  const char* forced = std::getenv("WYTHE_SIMD");
  if (forced == nullptr || *forced == '\0') return sets;
  std::string names;
  for (std::size_t k = 0; k < sets.size(); ++k) {
    if (std::strcmp(sets[k]->name, forced) == 0) {
      sets.resize(k + 1);
      return sets;
    }
    names += (k > 0 ? ", " : "") + std::string(sets[k]->name);
  }
  throw InputError({{.file = "WYTHE_SIMD",
                     .value = forced,
                     .problem = "is not an instruction set that this build and this processor have",
                     .cure = "write one of " + names +
                             ", leave it out for the widest, or build with WYTHE_KERNELS=all"}});
}

}  // namespace

const Kernels& scalar_kernels() {
  static constexpr Kernels kSet = kernels_of<double>("scalar");
  return kSet;
}

const std::vector<const Kernels*>& kernels_here() {
  static const std::vector<const Kernels*> sets = choose();
  return sets;
}

const Kernels& kernels_in_use() { return *kernels_here().back(); }

}  // namespace wythe::dynamics
