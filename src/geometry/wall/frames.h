// Frames: columns and beams as chains of rigid segments, around an opening or along a line of level and vertical parts.
//
//      +---+-----+-----+-----+---+      a corner is one segment. Sections lie at the ends of every segment, on the
//      | o---x-----x-----x-----o |      axis; those of a corner lie in its middle (o), so that the chain has the
//      +-x-+-----+-----+-----+-x-+      length of the axis (docs/theory/frames.md)
//      | | |                 | | |
//      +-x-+                 +-x-+      gap: outlines touch the masonry, segments start displaced by `moved`
//      | | |                 | | |
//      +-x-+                 +-x-+      a foot has a section on the ground, or none (resting)
//
// Called by assembly.cpp.
#pragma once

#include <optional>
#include <vector>

#include "geometry/wall/openings.h"
#include "geometry/wall/profiles.h"

namespace wythe::geometry {

// The surroundings of frames.
struct FrameSite {
  Rect wall;                 // bounds of the masonry [m]
  std::vector<Rect> ground;  // frames stand on top of these
};

// Sections of vertical and of level parts, for all pieces together; nothing after a fault.
struct FrameSections {
  Section column, beam;
};
[[nodiscard]] std::optional<FrameSections> sections_of(const FrameSpec& frame, std::size_t index,
                                                       FaultList& faults);

// Places one frame of the model. `opening`: the one around it, or none. Nothing after a fault.
[[nodiscard]] std::optional<PlacedFrame> place_frame(const FrameSpec& frame, std::size_t index,
                                                     const PlacedOpening* opening,
                                                     const FrameSite& site, FaultList& faults);

// Whether any number of the frame's hole is given.
[[nodiscard]] bool has_hole(const FrameSpec& frame);
// Refuses two frames with one name.
void check_frame_names(const std::vector<FrameSpec>& frames, FaultList& faults);

[[nodiscard]] std::vector<PlacedFrame> place_frames(const Shape& shape,
                                                    const std::vector<PlacedOpening>& openings,
                                                    const FrameSite& site, FaultList& faults);

// Refuses frames that overlap masonry or other frames, or touch nothing of the wall.
void check_frames(const Assembly& assembly, FaultList& faults);

}  // namespace wythe::geometry
