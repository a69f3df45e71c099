// The hot loops of the step behind plain pointers, compiled once for each instruction set.
//
//   joints   a run of joints of one material: stresses, history, own force        (forces.h)
//   gather   contact forces on a run of blocks                                     (blocks.h)
//   move     central differences with local damping for a run of blocks           (blocks.h)
//   turn     poses (displacement, half-angle cosine and sine) of a run of blocks   (blocks.h)
//   zones    a run of zones of one shape: forces on their corners                  (zones.h)
//   edges    a run of zone contacts of one material                               (zones.h)
//   nodes    central differences with local damping for a run of nodes of zones   (zones.h)
//
// Each twice: for neighbours in one wall (in whole groups of kGroup; what is left over goes through
// the scalar set), and for walls side by side, `width` of `stride` at a time. All give the same bits:
// energies are summed in kGroup lanes of entities by everybody. WYTHE_SIMD=scalar|sse2|avx2|avx512 in
// the environment forces a set (tests); otherwise it is the widest the processor has.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "contact/law.h"
#include "wythe/model.h"

namespace wythe::dynamics {

inline constexpr int kGroup =
    8;  // lanes of the widest pack; runs of joints and blocks are cut by it

// What the joint pass reads and writes.
struct JointArrays {
  const BlockId *a, *b;
  const double *arm_a_x, *arm_a_y, *arm_b_x, *arm_b_y;
  const double *tangent_x, *tangent_y, *half_length, *area;
  const double *xi, *weight;
  int n_face_point;
  const double* pose;  // rows ux, uy, cos, sin
  double *kappa, *crush, *plastic_slip, *slip, *shear_damage, *tension_set;
  std::uint8_t* busy;  // of a pack's first joint: a point was not at rest in the last step
  double* force;       // rows fx, fy, ma, mb
};

// What the gather reads and writes: entries of block i are begin[i] .. begin[i + 1], side b from
// middle[i] on.
struct GatherArrays {
  const std::int32_t *begin, *middle, *entry;
  const double* force;
  double *contact_x, *contact_y, *contact_m;
};

// What the block passes read and write.
struct BlockArrays {
  const double *mass, *heavy_mass, *inertia, *turn_freedom, *is_free;
  const double *contact_x, *contact_y, *contact_m, *load_x, *load_y, *load_m;
  double *total_x, *total_y, *total_m;
  double *ux, *uy, *theta, *vx, *vy, *omega;
  double* pose;
};

// What the passes over deformable blocks read and write.
struct ZoneArrays {
  const std::int32_t* corner[4];
  const double *ux, *uy;           // of nodes
  double *low_force, *high_force;  // rows x0, y0, x1, y1 and x2, y2, x3, y3 on the corners
};
struct EdgeArrays {
  JointArrays joint;  // pose, area, history and two points, seen from the first contact
  const BlockId* block;
  const std::int32_t *p, *q;
  const double *share_0, *share_1, *arm_0_x, *arm_0_y, *arm_1_x, *arm_1_y;
  const double *tangent_x, *tangent_y;
  const double *ux, *uy;  // of nodes
  double* block_force;    // rows fx, fy, m on the rigid block, 0
  double* edge_force;     // rows px, py, qx, qy on the nodes
};
struct NodeArrays {
  const double *mass, *heavy_mass, *free_x, *free_y;
  double *total_x, *total_y;  // in: forces of zones and contacts; out: with gravity, 0 where held
  double *ux, *uy, *vx, *vy;
};

// One number a wall.
struct MoveControls {
  const double *dt, *damping, *mass_scaling, *gravity_x, *gravity_y;
};

// Work of a run [J]: kGroup sums (of each wall), lane = place in the run modulo kGroup.
struct JointEnergy {
  double *friction, *fracture, *crushing;
};
struct BlockEnergy {
  double *loads, *damping;
};

struct Kernels {
  const char* name;
  int width;

  void (*joints)(const JointArrays&, const contact::LawConstants<double>*, bool on_ground,
                 std::size_t begin, std::size_t end, const JointEnergy&);
  void (*move)(const BlockArrays&, const MoveControls&, std::size_t begin, std::size_t end,
               const BlockEnergy&);
  void (*turn)(const BlockArrays&, std::size_t begin, std::size_t end);
  void (*zones)(const ZoneArrays&, const ZoneShape&, std::size_t begin, std::size_t end);
  void (*edges)(const EdgeArrays&, const contact::LawConstants<double>*, std::size_t begin,
                std::size_t end, const JointEnergy&);
  void (*nodes)(const NodeArrays&, const MoveControls&, std::size_t begin, std::size_t end,
                const BlockEnergy&);

  // the same for `width` walls; law: one a wall
  void (*wall_joints)(const JointArrays&, std::ptrdiff_t stride,
                      const contact::LawConstants<double>*, bool on_ground, std::size_t begin,
                      std::size_t end, const JointEnergy&);
  void (*wall_gather)(const GatherArrays&, std::ptrdiff_t stride, std::size_t begin,
                      std::size_t end);
  void (*wall_move)(const BlockArrays&, std::ptrdiff_t stride, const MoveControls&,
                    std::size_t begin, std::size_t end, const BlockEnergy&);
  void (*wall_turn)(const BlockArrays&, std::ptrdiff_t stride, std::size_t begin, std::size_t end);
  void (*wall_zones)(const ZoneArrays&, std::ptrdiff_t stride, const ZoneShape&, std::size_t begin,
                     std::size_t end);
  void (*wall_edges)(const EdgeArrays&, std::ptrdiff_t stride, const contact::LawConstants<double>*,
                     std::size_t begin, std::size_t end, const JointEnergy&);
  void (*wall_nodes)(const NodeArrays&, std::ptrdiff_t stride, const MoveControls&,
                     std::size_t begin, std::size_t end, const BlockEnergy&);
};

[[nodiscard]] const Kernels& scalar_kernels();
// The set in use: WYTHE_SIMD, else the widest this processor has. Throws InputError where the
// environment asks for a set that is unknown or that this processor lacks.
[[nodiscard]] const Kernels& kernels_in_use();
// All this processor has, narrowest first.
[[nodiscard]] const std::vector<const Kernels*>& kernels_here();

#if defined(__x86_64__)
[[nodiscard]] const Kernels& sse2_kernels();
[[nodiscard]] const Kernels& avx2_kernels();
[[nodiscard]] const Kernels& avx512_kernels();
#endif

}  // namespace wythe::dynamics
