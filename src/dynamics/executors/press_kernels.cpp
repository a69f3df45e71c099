// The scalar kernel for pairs of parts that press on each other, and the choice between the sets.
#include <algorithm>

#include "contact/convex_contact.h"
#include "dynamics/passes/pressing.h"

namespace wythe::dynamics {

void press_sse2(const PressTables& tables, PressGroup& group);
void press_avx2(const PressTables& tables, PressGroup& group);
void press_avx512(const PressTables& tables, PressGroup& group);

std::vector<double> rows_of_corners(const contact::PartEdges& edges) {
  std::vector<double> rows;
  for (const contact::PartEdges::Range& shape : edges.shape)
    for (int k = 0; k < kMostCorners; ++k) {
      const std::size_t corner = shape.first + std::min(k, shape.corners - 1);
      rows.push_back(edges.corner[2 * corner]);
      rows.push_back(edges.corner[2 * corner + 1]);
    }
  return rows;
}

PressKernel press_kernel(int width) {
#if defined(WYTHE_AVX512_KERNELS)
  if (width == 8) return press_avx512;
#endif
#if defined(WYTHE_AVX2_KERNELS)
  if (width == 4) return press_avx2;
#endif
#if defined(WYTHE_SSE2_KERNELS)
  if (width == 2) return press_sse2;
#endif
  return press<double>;
}

}  // namespace wythe::dynamics
