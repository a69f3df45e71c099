// Blocks in space as free contacts see them (passes/free_contacts.h): their poses, pressure and friction
// between two parts, and the failure of their joints. The counterpart of passes/plane_bodies.h.
#pragma once

#include <vector>

#include "contact/convex_contact_in_space.h"
#include "dynamics/passes/free_contacts.h"
#include "dynamics/space/wall.h"

namespace wythe::dynamics::space {

class SpaceBodies {
 public:
  using View = WallView;
  using Layout = space::Layout;
  using Overlap = contact::SpaceOverlap;
  // Two parts and their bodies' axes.
  struct PairGeometry {
    contact::SpacePart a, b;
    contact::SpaceFrame frame_a, frame_b;
  };

  // `width` of the packs in which the joints lie.
  SpaceBodies(const Model& model, const Layout& layout, int width);

  [[nodiscard]] double margin() const { return margin_; }  // of boxes [m]
  [[nodiscard]] contact::FreeLaw law_of(std::int32_t a, std::int32_t b) const;
  [[nodiscard]] Box box_of(std::int32_t body, const WallView& wall) const;
  [[nodiscard]] double speed_of(std::int32_t body, const WallView& wall) const;
  // Calls each(body, place of its centroid, upper bound of the motion of its points by rotation in the last step).
  template <class Each>
  void for_each_travel(double dt, const WallView& wall, Each each) const {
    for (std::int32_t i = 0; i < m_.n_block + m_.free.n_fixed; ++i)
      each(i, place_of(i, wall), turned_in(dt, i, wall));
  }
  [[nodiscard]] static double at_most(const Vector<double>& way) {
    return square_root(dot(way, way));
  }
  [[nodiscard]] double size_of(BlockId block) const { return 2 * reach_[block]; }
  [[nodiscard]] double height_of(BlockId block) const { return height_[block]; }
  [[nodiscard]] double fallen_height(BlockId block, const WallView& wall) const;
  [[nodiscard]] Vec place_of(std::int32_t body, const WallView& wall) const;
  [[nodiscard]] ForceMoment rates_of(std::int32_t body, const WallView& wall) const;
  // Turns a vector to a body's own axes, and back.
  [[nodiscard]] Vec to_body_axes(std::int32_t body, const Vec& v, const WallView& wall) const;
  [[nodiscard]] Vec to_wall_axes(std::int32_t body, const Vec& v, const WallView& wall) const;

  // Stores pose and velocity of a body for all later calls of the step.
  void cache_motion(std::int32_t body, const WallView& wall);
  [[nodiscard]] PairGeometry pair_geometry(const FreeContact& contact) const;
  // The overlap less `rest`, the crushed part: this presses.
  [[nodiscard]] static Overlap overlap(const PairGeometry& pair_geometry, std::int32_t feature,
                                       double rest);
  [[nodiscard]] contact::Face face(const PairGeometry& pair_geometry, std::int32_t last) const;
  [[nodiscard]] static double stiffness(const contact::FreeLaw& law) { return law.kn; }
  [[nodiscard]] static double pressing(const Overlap& overlap) { return overlap.force.z; }
  // Normal of a face, from a to b.
  [[nodiscard]] static Vec normal_of(const PairGeometry& pair_geometry, std::int32_t feature);
  // Turns the slip to another face; returns the energy that is lost by this.
  [[nodiscard]] static double turn_slip(FreePair& pair, const PairGeometry& pair_geometry,
                                        std::int32_t to);
  // Data of a contact for its dashpots, as in the plane.
  struct SlipUpdate {
    double opened;            // [m]
    Vec slid, held;           // along x, y and the twist times `radius` [m], [N]
    Vec ref, other, x, y, z;  // centre of pressure from both centroids; axes
    double radius;            // [m]
  };
  // Friction of a step, then forces and moments.
  SlipUpdate update_slip(FreePair& pair, const PairGeometry& pair_geometry, const Overlap& overlap,
                         double dt) const;
  // Contacts in space are taken one by one.
  struct Packed {
    int n = 0;
    std::size_t number[kGroup];
  };
  [[nodiscard]] static bool add_to(Packed&, const FreePair&) { return false; }
  static void press(Packed&, double) {}
  [[nodiscard]] static bool take(const Packed&, int, FreePair&) { return false; }
  [[nodiscard]] double inverse_mass(std::int32_t body) const {
    return body < m_.n_block ? 1 / m_.mass[body] : 0.0;
  }
  [[nodiscard]] double mobility(const FreeContact& contact, const SlipUpdate& slip_update) const;
  static void spread(const ViscousForce& force, const SlipUpdate& slip_update, bool of_a,
                     ForceMoment& on_a, ForceMoment& on_b);
  // Velocities stored by cache_motion().
  [[nodiscard]] const ForceMoment& rates_now(std::int32_t body) const { return now_[body].rates; }
  // Gives the contact a slip whose force equals the joints' force on a along the face, up to friction.
  void take_over_shear(FreePair& pair, const Vec& on_a) const;

  void clear_rows(const WallView& wall) const;
  void add(std::int32_t a, std::int32_t b, const ForceMoment& on_a, const ForceMoment& on_b,
           const WallView& wall) const;

  // The two bodies of a joint, sorted.
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
  // Upper bound of the motion of a body's points by rotation in the last step [m].
  [[nodiscard]] double turned_in(double dt, std::int32_t body, const WallView& wall) const;
  // The gap of a joint, and the rotation of its sides against each other.
  struct Jump {
    contact::FaceGap<double> gap;
    double tilt;  // sine of half the angle
  };
  [[nodiscard]] Jump jump_of(JointId joint, const WallView& wall) const;
  [[nodiscard]] static bool is_tilted(const Jump& jump);
  // An entry of a point's history by its row; the gap at a point.
  [[nodiscard]] double& history_number(JointId joint, int point, int row,
                                       const WallView& wall) const;
  [[nodiscard]] int rows_of(JointId joint) const;
  [[nodiscard]] contact::History<double> history_of(JointId joint, int point,
                                                    const WallView& wall) const;
  [[nodiscard]] Vec gap_at(JointId joint, int point, const Jump& jump) const;
  [[nodiscard]] contact::SpaceFrame frame_of(std::int32_t body, const WallView& wall) const;
  [[nodiscard]] int points_of_face(JointId joint) const;

  // A body in this step.
  struct Now {
    contact::SpaceFrame frame;
    ForceMoment rates;
  };

  const Model& m_;
  const Layout& layout_;
  const int width_;
  contact::SpaceParts parts_;
  std::vector<contact::FreeLaw> law_;          // of each material, for a thickness of 1 m
  std::vector<Now> now_;                       // of each body that cache_motion() has seen
  std::vector<double> reach_, height_;         // of each moving block [m]
  std::vector<std::pair<int, int>> chunk_of_;  // of each joint, and its number there
  double margin_ = 0;
};

}  // namespace wythe::dynamics::space
