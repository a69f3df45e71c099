// One wall's arrays as they lie in the step: its own (stride 1), or one lane of walls side by side.
//
// What looks at a wall between steps (drive, loads, recorder, residual) reads it through a view and
// needs not know which. A wall in a lane brings its State up to date only when somebody asks for it.
#pragma once

#include <cstddef>

#include "core/real.h"
#include "wythe/model.h"

namespace wythe::dynamics {

template <class T>
struct StridedOf {
  T* first = nullptr;
  std::ptrdiff_t stride = 1;
  template <class Index>
  WYTHE_INLINE T& operator[](Index i) const {
    return first[static_cast<std::ptrdiff_t>(i) * stride];
  }
};
using Strided = StridedOf<double>;
using ConstStrided = StridedOf<const double>;

struct WallView {
  Strided ux, uy, theta, vx, vy, omega;     // motion (n_block)
  Strided contact_x, contact_y, contact_m;  // sums of the joints' forces (n_block) [N], [N m]
  Strided load_x, load_y, load_m;           // applied point loads (n_block)
  Strided total_x, total_y, total_m;        // with gravity and body force (n_block)
  Strided is_free;                          // 0: moved by drive_pass (n_block)
  Strided pose;                             // rows ux, uy, cos, sin of half the angle (n_block, 4)
  Strided force;                            // rows fx, fy, ma, mb (n_joint, 4)

  Strided node_ux, node_uy, node_vx, node_vy;  // nodes of zones (n_node)
  Strided node_total_x, node_total_y;          // forces on them with gravity (n_node)
  Strided contact_block_force;                 // rows fx, fy, m on the rigid block (n_contact, 4)
};

}  // namespace wythe::dynamics
