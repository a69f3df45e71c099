// The hot loops of the step behind plain pointers, compiled once for each instruction set.
//
//   joints   a run of joints of one material: stresses, history, own force        (forces.h)
//   move     central differences with local damping for a run of blocks           (blocks.h)
//   turn     poses (displacement, half-angle cosine and sine) of a run of blocks   (blocks.h)
//
// All sets give the same bits: packs take kGroup neighbours, what is left over goes through the
// scalar kernels, and energies are summed in kGroup lanes by everybody. WYTHE_SIMD=scalar|sse2|avx2
// in the environment forces one (tests); otherwise the widest the processor has.
#pragma once

#include <cstddef>

#include "contact/law.h"
#include "wythe/model.h"

namespace wythe::dynamics {

inline constexpr int kGroup =
    8;  // lanes of the widest pack; runs of joints and blocks are cut by it

// What the joint pass reads and writes.
struct JointArrays {
  const BlockId *a, *b;
  const double *arm_a_x, *arm_a_y, *arm_b_x, *arm_b_y;
  const double *half_x, *half_y, *tangent_x, *tangent_y, *area;
  const double *xi, *weight;
  int n_face_point;
  const double* pose;  // rows ux, uy, cos, sin
  double *kappa, *crush, *plastic_slip, *slip, *shear_damage, *tension_set;
  double* force;  // rows fx, fy, ma, mb
};

// What the block passes read and write.
struct BlockArrays {
  const double *mass, *heavy_mass, *inertia, *turn_freedom, *is_free;
  const double *contact_x, *contact_y, *contact_m, *load_x, *load_y, *load_m;
  double *total_x, *total_y, *total_m;
  double *ux, *uy, *theta, *vx, *vy, *omega;
  double* pose;
};

struct MoveControls {
  double dt, damping, mass_scaling, gravity_x, gravity_y;
};

// Work of a run, lane by lane; lane = place in the run modulo kGroup [J].
struct JointLanes {
  double friction[kGroup] = {}, fracture[kGroup] = {}, crushing[kGroup] = {};
};
struct BlockLanes {
  double loads[kGroup] = {}, damping[kGroup] = {};
};

struct Kernels {
  const char* name;
  void (*joints)(const JointArrays&, const JointMaterial& variant,
                 const contact::LawConstants<double>&, bool on_ground, std::size_t begin,
                 std::size_t end, JointLanes&);
  void (*move)(const BlockArrays&, const MoveControls&, std::size_t begin, std::size_t end,
               BlockLanes&);
  void (*turn)(const BlockArrays&, std::size_t begin, std::size_t end);
};

[[nodiscard]] const Kernels& scalar_kernels();
// The set in use: WYTHE_SIMD, else the widest this processor has.
[[nodiscard]] const Kernels& kernels_in_use();

#if defined(__x86_64__)
[[nodiscard]] const Kernels& sse2_kernels();
[[nodiscard]] const Kernels& avx2_kernels();
#endif

}  // namespace wythe::dynamics
