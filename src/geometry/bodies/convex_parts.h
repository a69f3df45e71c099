// Converts bodies of a file to closed, outward-oriented, convex parts with as few faces as possible.
//
//   faces as listed ─► closed and oriented ─► volume > 0 ─► convex? ──yes──► coplanar neighbours joined
//                                                                 └─no─► cut (mesh_cut.h), again
//
// Called by prepare_bodies (body_checks.cpp). A body that needs no repair keeps its bits.
#pragma once

#include <string>
#include <vector>

#include "wythe/parts/body.h"
#include "wythe/parts/error.h"
#include "wythe/parts/message.h"

namespace wythe::geometry {

// A face counts as plane while its corners lie this near to its mean plane, as a share of its size (square root of
// its area). Vaults have many slightly warped quadrilaterals: flattened, they keep the points of a quadrilateral
// and one joint each. A face with more warp is cut into triangles, and coplanar neighbours are joined again.
inline constexpr double kFlatFace = 1e-2;
inline constexpr double kFlatEdge = 2e-3;    // sine between two faces that count as coplanar
inline constexpr double kConvexPart = 5e-3;  // height of a corner above a face, of the part's size
inline constexpr std::size_t kMostParts = 100;  // of one body that is cut

// Repairs bodies one by one and reports all repairs at the end.
class Preparation {
 public:
  // Repairs `body`, or adds faults at "wall.blocks.<id>" and leaves it unchanged.
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
