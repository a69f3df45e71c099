// The scalar kernels, and those that go with the plane's choice.
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
#if defined(__x86_64__)
    for (const Kernels* plane : dynamics::kernels_here())
      for (const KernelSet* set : {&avx2_kernels(), &avx512_kernels()})
        if (std::strcmp(set->name, plane->name) == 0) here.push_back(set);
#endif
    return here;
  }();
  return sets;
}

}  // namespace wythe::dynamics::space
