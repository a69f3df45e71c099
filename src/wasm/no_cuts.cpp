// Cuts of outlines need Clipper, which the engine for browsers has not.
#include "geometry/wall/clip.h"
#include "wythe/error.h"

namespace wythe::geometry {
namespace {

[[noreturn]] void refuse() {
  throw InputError({{.file = "",
                     .path = "arch",
                     .value = "",
                     .problem = "masonry cannot be cut to an arch by the engine for browsers",
                     .cure = "run this model with the program wythe"}});
}

}  // namespace

std::vector<Polygon> difference(const Polygon&, const Polygon&) { refuse(); }
Polygon joined_outline(const Polygon&, const Polygon&) { refuse(); }

}  // namespace wythe::geometry
