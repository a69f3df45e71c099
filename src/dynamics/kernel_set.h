// Makes the Kernels of one Real; included by one source file per instruction set (kernels_*.cpp).
#pragma once

#include "contact/parameters.h"
#include "dynamics/blocks.h"
#include "dynamics/forces.h"

namespace wythe::dynamics {

template <class Access>
void joints_of(const JointArrays& v, Access access, const JointMaterial& variant,
               const contact::LawConstants<double>* law, bool on_ground, std::size_t begin,
               std::size_t end, const JointEnergy& energy) {
  contact::with_variant(variant, [&](auto chosen) {
    using V = decltype(chosen);
    if (on_ground) return joint_run<V, true, 0>(v, access, law, begin, end, energy);
    if constexpr (Access::any_points)
      if (v.n_face_point != 2) return joint_run<V, false, 0>(v, access, law, begin, end, energy);
    joint_run<V, false, 2>(v, access, law, begin, end, energy);
  });
}

template <class Real>
struct KernelsOf {
  using Side = Neighbours<Real>;
  using Wall = Walls<Real>;

  static void joints(const JointArrays& v, const JointMaterial& variant,
                     const contact::LawConstants<double>* law, bool on_ground, std::size_t begin,
                     std::size_t end, const JointEnergy& energy) {
    joints_of(v, Side{}, variant, law, on_ground, begin, end, energy);
  }
  static void move(const BlockArrays& v, const MoveControls& controls, std::size_t begin,
                   std::size_t end, const BlockEnergy& energy) {
    move_run(v, Side{}, controls, begin, end, energy);
  }
  static void turn(const BlockArrays& v, std::size_t begin, std::size_t end) {
    turn_run(v, Side{}, begin, end);
  }
  static void wall_joints(const JointArrays& v, std::ptrdiff_t stride, const JointMaterial& variant,
                          const contact::LawConstants<double>* law, bool on_ground,
                          std::size_t begin, std::size_t end, const JointEnergy& energy) {
    joints_of(v, Wall{stride}, variant, law, on_ground, begin, end, energy);
  }
  static void wall_gather(const GatherArrays& v, std::ptrdiff_t stride, std::size_t begin,
                          std::size_t end) {
    gather_run(v, Wall{stride}, begin, end);
  }
  static void wall_move(const BlockArrays& v, std::ptrdiff_t stride, const MoveControls& controls,
                        std::size_t begin, std::size_t end, const BlockEnergy& energy) {
    move_run(v, Wall{stride}, controls, begin, end, energy);
  }
  static void wall_turn(const BlockArrays& v, std::ptrdiff_t stride, std::size_t begin,
                        std::size_t end) {
    turn_run(v, Wall{stride}, begin, end);
  }

  [[nodiscard]] static constexpr Kernels named(const char* name) {
    return {name,        Lanes<Real>::width, joints,    move,     turn,
            wall_joints, wall_gather,        wall_move, wall_turn};
  }
};

}  // namespace wythe::dynamics
