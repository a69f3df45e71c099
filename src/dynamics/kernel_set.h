// Makes the Kernels of one Real; included by one source file per instruction set (kernels_*.cpp).
#pragma once

#include "contact/parameters.h"
#include "dynamics/blocks.h"
#include "dynamics/forces.h"
#include "dynamics/zones.h"

namespace wythe::dynamics {

template <class Real>
void joints_of(const JointArrays& v, const JointMaterial& variant,
               const contact::LawConstants<double>& law, bool on_ground, std::size_t begin,
               std::size_t end, JointLanes& lanes) {
  contact::with_variant(variant, [&](auto chosen) {
    using V = decltype(chosen);
    if (on_ground) return joint_run<V, true, 0, Real>(v, law, begin, end, lanes);
    if (v.n_face_point == 2) return joint_run<V, false, 2, Real>(v, law, begin, end, lanes);
    return joint_run<V, false, 0, Real>(v, law, begin, end, lanes);
  });
}

template <class Real>
void edges_of(const EdgeArrays& v, const JointMaterial& variant,
              const contact::LawConstants<double>& law, std::size_t begin, std::size_t end,
              JointLanes& lanes) {
  contact::with_variant(
      variant, [&](auto chosen) { edge_run<decltype(chosen), Real>(v, law, begin, end, lanes); });
}

template <class Real>
[[nodiscard]] constexpr Kernels kernel_set(const char* name) {
  return {name,           joints_of<Real>, move_run<Real>, turn_run<Real>,
          zone_run<Real>, edges_of<Real>,  node_run<Real>};
}

}  // namespace wythe::dynamics
