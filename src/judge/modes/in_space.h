// The failure of a wall in space in words, by what moved (docs/theory/failure_modes.md, "In space").
#pragma once

#include "judge/modes/elevations.h"
#include "wythe/parts/failure_mode.h"

namespace wythe::study {

// Share of a joint's size (the root of its area): an opening or slip that counts.
inline constexpr double kLeastMovement = 0.005;
// The same where the run shows that the wall falls, so that its motion is no elastic one. A wall
// that just does not stand may have moved little when the run ends.
inline constexpr double kLeastMovementOfFall = 0.1 * kLeastMovement;

// "overturning", "sliding", "turning", "bending", "none", or "unclear". `least`: joints that move less do not count.
[[nodiscard]] FailureMode name_in_space(const Model& model, const State& state,
                                        double least = kLeastMovement);

// Whether a name says that walls leave their planes; "part breaking away" is such a name.
[[nodiscard]] bool leaves_plane(const std::string& name);
// Whether a name says that walls fail in their planes. "sliding" may be in plane or out of plane, so it is none.
[[nodiscard]] bool stays_in_plane(const std::string& name);

// The walls that take part in the motion of a state, and move in their planes.
struct WallsMoved {
  std::vector<std::size_t> of;  // indices into elevations_of()
  bool is_all = false;          // they are nearly all of the mass that takes part
  Evidence told;                // that share, for the mode
};
[[nodiscard]] WallsMoved moved_in_plane(const Model& model, const State& state,
                                        const std::vector<Elevation>& elevations);
[[nodiscard]] bool tells_of_planes(const Evidence& evidence);
// Whether all that takes part in a mode moves in the planes of its walls,
// from that evidence. Names that plane walls have too do not say so.
[[nodiscard]] bool stays_in_planes(const FailureMode& mode);
// Whether a wall stands along a push.
[[nodiscard]] bool is_along(const Elevation& wall, const Vec3& push);

// Walls by their planes as built, whatever way they fail.
struct WallsByPush {
  int walls = 0;              // by the builder's names, else by connection
  int along = 0, across = 0;  // of them, by their planes; other walls have no plane
  [[nodiscard]] bool all_along() const { return along == walls; }
  [[nodiscard]] bool all_across() const { return across > 0 && across == walls; }
};
[[nodiscard]] WallsByPush walls_by_push(const Model& model, const Vec3& push);

}  // namespace wythe::study
