// The scalar kernels, and the choice that matches that of the plane.
#include "dynamics/space/kernels.h"

#include <cstring>

#include "dynamics/space/kernel_set.h"

namespace wythe::dynamics::space {

const KernelSet& scalar_kernels() {
  static constexpr KernelSet kSet = kernels_of<double>("scalar");
  return kSet;
}

const std::vector<const KernelSet*>& kernels_here() {
  static const std::vector<const KernelSet*> sets = [] {
    std::vector<const KernelSet*> here{&scalar_kernels()};
    [[maybe_unused]] const auto add = [&](const KernelSet& set) {
      for (const Kernels* plane : dynamics::kernels_here())
        if (std::strcmp(set.name, plane->name) == 0) here.push_back(&set);
    };
#if defined(WYTHE_AVX2_KERNELS)
    add(avx2_kernels());
#endif
#if defined(WYTHE_AVX512_KERNELS)
    add(avx512_kernels());
#endif
    return here;
  }();
  return sets;
}

}  // namespace wythe::dynamics::space
