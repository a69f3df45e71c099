// Frames: columns and beams as chains of rigid segments, round an opening or along a line of level and upright parts.
//
//      +---+-----+-----+-----+---+      a corner is one segment; sections stand at the ends of every segment on
//      | o---x-----x-----x-----o |      the axis, those of a corner in its middle (o), so that the length of the
//      +-x-+-----+-----+-----+-x-+      chain is that of the axis (docs/theory/frames.md)
//      | | |                 | | |
//      +-x-+                 +-x-+      gap: the outlines touch the masonry, the segments start `moved` from them
//      | | |                 | | |
//      +-x-+                 +-x-+      a foot ends in a section on the ground, or has none (resting)
//
// Called by assembly.cpp.
#pragma once

#include <optional>
#include <vector>

#include "geometry/wall/openings.h"
#include "geometry/wall/profiles.h"

namespace wythe::geometry {

// What frames stand in and on.
struct FrameSite {
  Rect wall;                 // bounds of the masonry [m]
  std::vector<Rect> ground;  // a frame stands on their tops
};

// Sections of upright and of level parts, all pieces together; nothing after a fault.
struct FrameSections {
  Section column, beam;
};
[[nodiscard]] std::optional<FrameSections> sections_of(const FrameSpec& frame, std::size_t index,
                                                       FaultList& faults);

// One frame of the model; `opening`: that in which it stands, or none. Nothing after a fault.
[[nodiscard]] std::optional<PlacedFrame> place_frame(const FrameSpec& frame, std::size_t index,
                                                     const PlacedOpening* opening,
                                                     const FrameSite& site, FaultList& faults);

// Whether any number of its hole is given.
[[nodiscard]] bool has_hole(const FrameSpec& frame);
// Two frames of one name.
void check_frame_names(const std::vector<FrameSpec>& frames, FaultList& faults);

[[nodiscard]] std::vector<PlacedFrame> place_frames(const Shape& shape,
                                                    const std::vector<PlacedOpening>& openings,
                                                    const FrameSite& site, FaultList& faults);

// Frames that reach into masonry or into each other, or touch nothing of the wall's box.
void check_frames(const Assembly& assembly, FaultList& faults);

}  // namespace wythe::geometry
