// Makes the Kernels of one Real; included by one source file per instruction set (kernels_*.cpp).
#pragma once

#include "contact/parameters.h"
#include "dynamics/executors/kernels.h"
#include "dynamics/passes/blocks.h"
#include "dynamics/passes/joint_dashpots.h"
#include "dynamics/passes/joints.h"
#include "dynamics/passes/solids.h"

namespace wythe::dynamics {

// Loads the sums of a chunk's works for Real number k.
template <class Access, class Real>
WYTHE_INLINE void load_work(Access access, const double* works, int k, JointWork<Real>& work) {
  const auto term = [&](int q) { return works + q * kGroup * access.walls(); };
  work = {access.sum(term(kFriction), k), access.sum(term(kFracture), k),
          access.sum(term(kCrushing), k)};
}
template <class Access, class Real>
WYTHE_INLINE void keep_work(Access access, const JointWork<Real>& work, double* works, int k) {
  const auto term = [&](int q) { return works + q * kGroup * access.walls(); };
  access.store_sum(work.friction, term(kFriction), k);
  access.store_sum(work.fracture, term(kFracture), k);
  access.store_sum(work.crushing, term(kCrushing), k);
}
template <class Access, class Real>
WYTHE_INLINE void load_work(Access access, const double* works, int k, BlockWork<Real>& work) {
  const auto term = [&](int q) { return works + q * kGroup * access.walls(); };
  work = {access.sum(term(kLoads), k), access.sum(term(kDamped), k)};
}
template <class Access, class Real>
WYTHE_INLINE void keep_work(Access access, const BlockWork<Real>& work, double* works, int k) {
  const auto term = [&](int q) { return works + q * kGroup * access.walls(); };
  access.store_sum(work.loads, term(kLoads), k);
  access.store_sum(work.damping, term(kDamped), k);
}
template <class Access>
WYTHE_INLINE void load_work(Access, const double*, int, NoWork&) {}
template <class Access>
WYTHE_INLINE void keep_work(Access, const NoWork&, double*, int) {}

// The loop of a pass over a chunk.
template <class P, class Numbers = Tables>
void run_pass(const Numbers& t, const Chunk& chunk, double* works) {
  using Access = typename P::Access;
  const Access access{};
  P pass(t, access, chunk);
  typename P::Work work[Access::sums];
  for (int k = 0; k < Access::sums; ++k) load_work(access, works, k, work[k]);
  int k = 0;
  for (std::ptrdiff_t item = chunk.begin; item < chunk.end; ++item) {
    for (int part = 0; part < Access::parts; ++part) {
      pass.select_part(part);
      pass.at(item, work[k]);
      k = (k + 1) % Access::sums;
    }
  }
  for (int n = 0; n < Access::sums; ++n) keep_work(access, work[n], works, n);
}

template <class Access>
struct PassesOf {
  // Two points at the ends of a face, three points, or any number. Faces on the ground are rare: one kernel.
  static void joints(const Tables& t, const Chunk& chunk, double* works) {
    contact::with_variant(chunk.choice, [&](auto chosen) {
      using V = decltype(chosen);
      if (chunk.on_ground) return run_pass<Joints<V, true, 0, Access>>(t, chunk, works);
      if (chunk.at_ends) return run_pass<Joints<V, false, 2, Access>>(t, chunk, works);
      if (chunk.points == 3) return run_pass<Joints<V, false, 3, Access>>(t, chunk, works);
      run_pass<Joints<V, false, 0, Access>>(t, chunk, works);
    });
  }
  static void edges(const Tables& t, const Chunk& chunk, double* works) {
    contact::with_variant(chunk.choice, [&](auto chosen) {
      run_pass<Edges<decltype(chosen), Access>>(t, chunk, works);
    });
  }
};

template <class Real>
using ManyWalls = WallLanes<Real, Lanes<Real>::width>;

template <class Real>
[[nodiscard]] constexpr Kernels kernels_of(const char* name) {
  using One = EntityLanes<Real>;
  using Many = ManyWalls<Real>;
  return {name,
          Lanes<Real>::width,
          {PassesOf<One>::joints, run_pass<Zones<One>>, PassesOf<One>::edges,
           run_pass<JointDashpots<One>>, run_pass<Blocks<One>>, run_pass<Nodes<One>>},
          {PassesOf<Many>::joints, run_pass<Zones<Many>>, PassesOf<Many>::edges,
           run_pass<JointDashpots<Many>>, run_pass<Blocks<Many>>, run_pass<Nodes<Many>>}};
}

}  // namespace wythe::dynamics
