// Deformable blocks of one wall in space: zones, their contacts with rigid blocks and supports, nodes
// (docs/theory/zones.md, "Zones in space").
//
// A contact's points stand on a face of a rigid block a and on a side of a zone. The frame turns with a, and both
// forces act where the side's point is now, as in the plane (passes/solids.h):
//
//   j = x_side - x_face,  w = j . n,  s = (j . t1, j . t2)     with n, t1, t2 turned by a
//   f = area share (sigma n + tau1 t1 + tau2 t2) on a at x_side, -f share_k on the side's nodes
//
// One wall at a time, alone or in a lane, so no bit depends on other
// walls. Chunks are fixed, so no bit depends on threads either.
#pragma once

#include <vector>

#include "contact/law_constants.h"
#include "core/parallel.h"
#include "dynamics/space/wall.h"

namespace wythe::dynamics::space {

class ZoneRun {
 public:
  ZoneRun(const Model& model, const State& state);
  void store_state(State& state) const;

  // The passes of a step, in their order; `workers`: null for one thread.
  void deform(Workers* workers);                       // forces of the zones on their nodes
  void press(const WallView& wall, Workers* workers);  // the law between zones and rigid blocks
  void move(const WallView& wall, double dt, double mass_scaling, Workers* workers);
  // Adds the works of the last step to the ledger.
  void tell(State& state) const;

  // The meters, as for blocks (wall.h).
  [[nodiscard]] double unbalanced() const;  // sum of the unbalanced forces of nodes [N]
  [[nodiscard]] double pressed(
      const WallView& wall) const;  // sum of the forces of contacts, on both sides [N]
  [[nodiscard]] double kinetic(double mass_scaling) const;
  [[nodiscard]] double shear(const WallView& wall,
                             const Vec3& along) const;  // of supports not driven
  [[nodiscard]] int runaway() const;                    // a node; -1: none
  [[nodiscard]] Furthest furthest() const;              // node [m]

 private:
  struct Point {
    contact::History<double> history;
    double plastic_2 = 0;
  };
  struct ContactGeometry;
  struct ContactMotion {
    Vec arm, gap;  // gap along t1, t2 and n
  };
  // Geometry with the nodes in their place of a time `back` ago.
  [[nodiscard]] ContactGeometry contact_geometry(std::size_t contact,
                                                 const contact::Pose<double>& pose,
                                                 double back) const;
  [[nodiscard]] ContactGeometry contact_geometry_before(std::size_t contact,
                                                        const WallView& wall) const;
  [[nodiscard]] ContactMotion contact_motion(std::size_t contact, std::size_t point,
                                             const ContactGeometry& m) const;
  template <class V>
  void ask(std::size_t contact, const WallView& wall, JointWork<double>& work);

  const Model& m_;
  const SpaceSolids& s_;
  std::vector<Vec> u_, v_, total_;                  // of nodes
  std::vector<Point> point_;                        // of contacts
  std::vector<contact::LawConstants<double>> law_;  // of the materials
  std::vector<Vec> corner_force_, side_force_;      // eight a zone, four a contact
  std::vector<JointWork<double>> joint_work_;       // of chunks
  std::vector<BlockWork<double>> node_work_;
};

}  // namespace wythe::dynamics::space
