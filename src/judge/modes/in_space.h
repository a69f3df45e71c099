// The failure of a wall in space in words, by what moved (docs/theory/failure_modes.md, "In space").
#pragma once

#include "judge/modes/elevations.h"
#include "wythe/parts/failure_mode.h"

namespace wythe::study {

// "overturning", "sliding", "turning", "bending", "none", or "unclear".
[[nodiscard]] FailureMode name_in_space(const Model& model, const State& state);

// Names of walls that leave their planes, "part breaking away" among them.
[[nodiscard]] bool leaves_plane(const std::string& name);
// Names of failures in the plane of walls. Blocks that slide do so in it or out of it: the name does not say.
[[nodiscard]] bool stays_in_plane(const std::string& name);

// The walls that take part in what a state shows, and move in their planes.
struct WallsMoved {
  std::vector<std::size_t> of;  // into elevations_of()
  bool is_all = false;          // they are nearly all that takes part, by mass
  Evidence told;                // the same, for the mode
};
[[nodiscard]] WallsMoved moved_in_plane(const Model& model, const State& state,
                                        const std::vector<Elevation>& elevations);
[[nodiscard]] bool tells_of_planes(const Evidence& evidence);
// Whether all that takes part in a mode moves in the planes of its walls, by that evidence: names that plane walls have
// too do not say.
[[nodiscard]] bool stays_in_planes(const FailureMode& mode);
// Whether a wall stands along a push.
[[nodiscard]] bool is_along(const Elevation& wall, const Vec3& push);

// Walls by their planes as they were built: what a push does to them does not depend on how they fail.
struct WallsByPush {
  int walls = 0;              // by the builder's names, else what hangs together
  int along = 0, across = 0;  // of them, by their planes; the others have none
  [[nodiscard]] bool all_along() const { return along == walls; }
  [[nodiscard]] bool all_across() const { return across > 0 && across == walls; }
};
[[nodiscard]] WallsByPush walls_by_push(const Model& model, const Vec3& push);

}  // namespace wythe::study
