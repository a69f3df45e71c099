// Makes the kernels of one Real; included by one source file per instruction set.
#pragma once

#include "dynamics/executors/kernel_set.h"
#include "dynamics/space/blocks.h"
#include "dynamics/space/joint_dashpots.h"
#include "dynamics/space/kernels.h"

namespace wythe::dynamics::space {

template <class Access>
void run_joints(const Tables& t, const Chunk& chunk, double* works) {
  contact::with_variant(chunk.choice, [&](auto chosen) {
    using V = decltype(chosen);
    if (chunk.on_ground) return run_pass<Joints<V, true, Access>, Tables>(t, chunk, works);
    run_pass<Joints<V, false, Access>, Tables>(t, chunk, works);
  });
}

template <class Real>
[[nodiscard]] constexpr KernelSet kernels_of(const char* name) {
  using One = EntityLanes<Real>;
  using Many = WallLanes<Real, Lanes<Real>::width>;
  return {name,
          Lanes<Real>::width,
          {run_joints<One>, run_joints<Many>},
          {run_pass<JointDashpots<One>, Tables>, run_pass<JointDashpots<Many>, Tables>},
          {run_pass<Blocks<One>, Tables>, run_pass<Blocks<Many>, Tables>}};
}

}  // namespace wythe::dynamics::space
