// Makes the Kernels of one Real; included by one source file per instruction set (kernels_*.cpp).
#pragma once

#include "contact/parameters.h"
#include "dynamics/blocks.h"
#include "dynamics/forces.h"
#include "dynamics/zones.h"

namespace wythe::dynamics {

template <class Access>
void joints_of(const JointArrays& v, Access access, const contact::LawConstants<double>* law,
               bool on_ground, std::size_t begin, std::size_t end, const JointEnergy& energy) {
  contact::with_variant(law->choice, [&](auto chosen) {
    using V = decltype(chosen);
    if (on_ground) return joint_run<V, true, 0>(v, access, law, begin, end, energy);
    if constexpr (Access::any_points)
      if (v.n_face_point != 2) return joint_run<V, false, 0>(v, access, law, begin, end, energy);
    joint_run<V, false, 2>(v, access, law, begin, end, energy);
  });
}

template <class Access>
void edges_of(const EdgeArrays& v, Access access, const contact::LawConstants<double>* law,
              std::size_t begin, std::size_t end, const JointEnergy& energy) {
  contact::with_variant(law->choice, [&](auto chosen) {
    edge_run<decltype(chosen)>(v, access, law, begin, end, energy);
  });
}

template <class Real>
struct KernelsOf {
  using Side = Neighbours<Real>;
  using Wall = Walls<Real>;

  static void joints(const JointArrays& v, const contact::LawConstants<double>* law, bool on_ground,
                     std::size_t begin, std::size_t end, const JointEnergy& energy) {
    joints_of(v, Side{}, law, on_ground, begin, end, energy);
  }
  static void move(const BlockArrays& v, const MoveControls& controls, std::size_t begin,
                   std::size_t end, const BlockEnergy& energy) {
    move_run(v, Side{}, controls, begin, end, energy);
  }
  static void turn(const BlockArrays& v, std::size_t begin, std::size_t end) {
    turn_run(v, Side{}, begin, end);
  }
  static void wall_joints(const JointArrays& v, std::ptrdiff_t stride,
                          const contact::LawConstants<double>* law, bool on_ground,
                          std::size_t begin, std::size_t end, const JointEnergy& energy) {
    joints_of(v, Wall{stride}, law, on_ground, begin, end, energy);
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

  static void zones(const ZoneArrays& v, const ZoneShape& shape, std::size_t begin,
                    std::size_t end) {
    zone_run(v, Side{}, shape, begin, end);
  }
  static void edges(const EdgeArrays& v, const contact::LawConstants<double>* law,
                    std::size_t begin, std::size_t end, const JointEnergy& energy) {
    edges_of(v, Side{}, law, begin, end, energy);
  }
  static void nodes(const NodeArrays& v, const MoveControls& controls, std::size_t begin,
                    std::size_t end, const BlockEnergy& energy) {
    node_run(v, Side{}, controls, begin, end, energy);
  }
  static void wall_zones(const ZoneArrays& v, std::ptrdiff_t stride, const ZoneShape& shape,
                         std::size_t begin, std::size_t end) {
    zone_run(v, Wall{stride}, shape, begin, end);
  }
  static void wall_edges(const EdgeArrays& v, std::ptrdiff_t stride,
                         const contact::LawConstants<double>* law, std::size_t begin,
                         std::size_t end, const JointEnergy& energy) {
    edges_of(v, Wall{stride}, law, begin, end, energy);
  }
  static void wall_nodes(const NodeArrays& v, std::ptrdiff_t stride, const MoveControls& controls,
                         std::size_t begin, std::size_t end, const BlockEnergy& energy) {
    node_run(v, Wall{stride}, controls, begin, end, energy);
  }

  [[nodiscard]] static constexpr Kernels named(const char* name) {
    return {
        name,      Lanes<Real>::width, joints,      move,      turn,      zones,      edges,
        nodes,     wall_joints,        wall_gather, wall_move, wall_turn, wall_zones, wall_edges,
        wall_nodes};
  }
};

}  // namespace wythe::dynamics
