// Blocks in their plane as free contacts see them (free_contacts.h): their poses,
// pressure and friction between two parts, and the failure of their joints.
#pragma once

#include <vector>

#include "dynamics/passes/free_contacts.h"
#include "dynamics/passes/pressing.h"
#include "dynamics/passes/wall.h"

namespace wythe::dynamics {

class PlaneBodies {
 public:
  using View = WallView;
  using Layout = dynamics::Layout;
  using Overlap = contact::Overlap;
  // Two parts and their bodies' axes.
  struct PairGeometry {
    contact::Part a, b;
    contact::BodyFrame frame_a, frame_b;
  };

  // `width` of the packs in which the joints lie.
  PlaneBodies(const Model& model, const Layout& layout, int width);

  [[nodiscard]] double margin() const { return margin_; }  // of boxes [m]
  [[nodiscard]] contact::FreeLaw law_of(std::int32_t a, std::int32_t b) const;
  [[nodiscard]] Box box_of(std::int32_t body, const WallView& wall) const;
  [[nodiscard]] double speed_of(BlockId block,
                                const WallView& wall) const;  // of any point, at most
  // Calls each(body, place of its centroid, upper bound of the motion of its points by rotation in the last step).
  template <class Each>
  void for_each_travel(double dt, const WallView& wall, Each each) const {
    constexpr double kMore = 1.05;  // damping by mass may have slowed blocks since they turned
    for (BlockId i = 0; i < m_.n_block; ++i)
      each(i, Vector<double>{m_.centroid_x[i] + wall.ux(i), m_.centroid_y[i] + wall.uy(i), 0},
           kMore * dt * reach_[i] * magnitude(wall.block(i, kOmega)));
  }
  [[nodiscard]] static double at_most(const Vector<double>& way) {
    return magnitude(way.x) + magnitude(way.y);
  }
  [[nodiscard]] double size_of(BlockId block) const { return 2 * reach_[block]; }
  [[nodiscard]] double height_of(BlockId block) const { return height_[block]; }
  [[nodiscard]] double fallen_height(BlockId block, const WallView& wall) const;
  [[nodiscard]] Vector<double> place_of(std::int32_t body, const WallView& wall) const;
  [[nodiscard]] ForceMoment rates_of(std::int32_t body, const WallView& wall) const;
  // Turns a vector to a body's own axes, and back.
  [[nodiscard]] Vector<double> to_body_axes(std::int32_t body, const Vector<double>& v,
                                            const WallView& wall) const;
  [[nodiscard]] Vector<double> to_wall_axes(std::int32_t body, const Vector<double>& v,
                                            const WallView& wall) const;

  // Stores pose and velocity of a body for all later calls of the step.
  void cache_motion(std::int32_t body, const WallView& wall);
  [[nodiscard]] PairGeometry pair_geometry(const FreeContact& contact) const;
  // The overlap less `rest`, the crushed part: this presses.
  [[nodiscard]] static Overlap overlap(const PairGeometry& pair_geometry, std::int32_t feature,
                                       double rest);
  [[nodiscard]] contact::Face face(const PairGeometry& pair_geometry, std::int32_t last) const;
  [[nodiscard]] static double stiffness(const contact::FreeLaw& law) {
    return law.kn * law.thickness;
  }
  [[nodiscard]] static double pressing(const Overlap& overlap) { return overlap.area; }
  // Normal of a face, from a to b.
  [[nodiscard]] static Vector<double> normal_of(const PairGeometry& pair_geometry,
                                                std::int32_t feature);
  // Turns the slip to another face; returns the energy that is lost by this.
  [[nodiscard]] static double turn_slip(FreePair& pair, const PairGeometry& pair_geometry,
                                        std::int32_t to);
  // Data of a contact for its dashpots: motion in the step, friction along the slip, arms from both centroids to the
  // centre of pressure, normal and slip direction. All are of the body `other` against the body that has the face.
  struct SlipUpdate {
    double opened;              // [m]
    Vector<double> slid, held;  // [m], [N]
    double ref_x, ref_y, other_x, other_y, nx, ny, tx, ty;
  };
  // Friction of a step, then forces and moments.
  SlipUpdate update_slip(FreePair& pair, const PairGeometry& pair_geometry, const Overlap& overlap,
                         double dt) const;
  // Up to eight contacts that stay on their faces, taken together (pressing.h).
  struct Packed {
    int n = 0;
    std::size_t number[kGroup];  // numbers that the caller gave them
    PressGroup group;
  };
  // Adds a pair to the pack; false where a part has too many corners.
  [[nodiscard]] bool add_to(Packed& packed, const FreePair& pair) const;
  void press(Packed& packed, double dt) const;
  // Takes the results of contact k of a pack; false where nothing presses along its face any more.
  [[nodiscard]] static bool take(const Packed& packed, int k, FreePair& pair);
  [[nodiscard]] double inverse_mass(std::int32_t body) const {
    return body < m_.n_block ? 1 / m_.mass[body] : 0.0;
  }
  // Inverse of the mass that feels a force at the centre of pressure, along any direction [1/kg].
  [[nodiscard]] double mobility(const FreeContact& contact, const SlipUpdate& slip_update) const;
  // A viscous force on both bodies; `of_a`: body a has the face.
  static void spread(const ViscousForce& force, const SlipUpdate& slip_update, bool of_a,
                     ForceMoment& on_a, ForceMoment& on_b);
  // Velocities stored by cache_motion().
  [[nodiscard]] ForceMoment rates_now(std::int32_t body) const {
    const Now& now = now_[body];
    return {{now.vx, now.vy, 0}, {0, 0, now.spin}};
  }
  // Gives the contact a slip whose force equals the joints' force on a along the face, up to friction.
  void take_over_shear(FreePair& pair, const Vector<double>& on_a) const;

  void clear_rows(const WallView& wall) const;
  void add(std::int32_t a, std::int32_t b, const ForceMoment& on_a, const ForceMoment& on_b,
           const WallView& wall) const;

  // The two bodies of a joint, sorted; {-1, -1} for a joint on ground without a body.
  [[nodiscard]] std::pair<std::int32_t, std::int32_t> sides_of(JointId joint) const;
  // has_failed(): the displacement is so large that the joint fails if no point holds. holds(): a point holds.
  [[nodiscard]] bool has_failed(JointId joint, const WallView& wall) const;
  [[nodiscard]] bool holds(JointId joint, const WallView& wall) const;
  [[nodiscard]] ForceMoment joint_force(JointId joint, std::int32_t on, const WallView& wall) const;
  [[nodiscard]] double elastic_energy(JointId joint, const WallView& wall) const;
  void restore(const WallView& wall) const;                 // all joints
  void release(JointId joint, const WallView& wall) const;  // no force from now on
  void end_release(const WallView& wall) const;

 private:
  // Position of the two faces of a joint to each other.
  struct Jump {
    double normal, along, growth;  // of the face's centre, and from there to its end [m]
    double tilt;                   // [rad]
  };
  [[nodiscard]] Jump jump_of(JointId joint, const WallView& wall) const;
  // The same in the wall's axes.
  struct Gap {
    double x, y, tilt;
  };
  [[nodiscard]] Gap gap_of(JointId joint, const WallView& wall) const;
  [[nodiscard]] contact::History<double> history_of(JointId joint, int point,
                                                    const WallView& wall) const;
  [[nodiscard]] contact::BodyFrame frame_of(std::int32_t body, const WallView& wall) const;

  // A body in this step: two rows of four for pressing.h.
  struct alignas(64) Now {
    contact::BodyFrame frame;
    double vx, vy, spin, unused;
  };

  const Model& m_;
  const Layout& layout_;
  const int width_;
  contact::PartEdges edges_;
  std::vector<contact::FreeLaw> law_;  // of each material, for a thickness of 1 m
  std::vector<Now> now_;               // of each body that cache_motion() has seen
  std::vector<double> corner_rows_;    // of each shape (pressing.h)
  PressKernel press_;
  std::vector<double> reach_, height_;         // of each moving block [m]
  std::vector<std::pair<int, int>> chunk_of_;  // of each joint, and its number there
  double margin_ = 0;
};

}  // namespace wythe::dynamics
