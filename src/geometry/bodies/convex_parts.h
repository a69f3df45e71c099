// Bodies as files give them -> closed, turned outside out, in convex parts with as few faces as they have.
//
//   faces as listed ─► closed and turned alike ─► volume > 0 ─► convex? ──yes──► flat neighbours joined
//                                                                 └─no─► cut (mesh_cut.h), again
//
// Called by prepare_bodies (body_checks.cpp). A body with nothing to mend keeps its bits.
#pragma once

#include <string>
#include <vector>

#include "wythe/parts/body.h"
#include "wythe/parts/error.h"
#include "wythe/parts/message.h"

namespace wythe::geometry {

// A face counts as flat while its corners lie this near to its mean plane, as a share of its size (square root of
// its area). Vaults are full of slightly warped quadrilaterals: flattened, they keep the points of a quadrilateral
// and one joint each. What is bent more is cut into triangles, and flat neighbours are joined again.
inline constexpr double kFlatFace = 1e-2;
inline constexpr double kFlatEdge = 2e-3;    // sine between two faces that count as one
inline constexpr double kConvexPart = 5e-3;  // a corner this far above a face, of the part's size
inline constexpr std::size_t kMostParts = 100;  // of one body that is cut

// Takes bodies one by one and says at the end what it did to them.
class Preparation {
 public:
  // Mends `body`, or adds faults at "wall.blocks.<id>" and leaves it as it is.
  void take(BodySpec& body, FaultList& faults);
  void say(std::vector<Message>& notes) const;

 private:
  struct Count {
    int bodies = 0;
    std::string first;  // id
    void add(const std::string& id) {
      if (bodies++ == 0) first = id;
    }
  };
  friend class BodyMender;
  Count repeated_, turned_, cut_, bent_, flattened_;
  int parts_ = 0;          // of all bodies that were cut
  double worst_warp_ = 0;  // [m]
  double worst_bend_ = 0;  // [m]
  std::string worst_warped_, worst_bent_;
};

}  // namespace wythe::geometry
