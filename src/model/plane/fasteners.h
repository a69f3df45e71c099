// Anchors and wedges of frames, in their plane and in space (docs/theory/frames.md, "Anchors and wedges").
#pragma once

#include <functional>
#include <optional>

#include "geometry/wall/frames.h"
#include "model/parts.h"

namespace wythe {

// What fasteners need of the wall, at places in the frame's plane.
struct FastenerSite {
  std::function<std::optional<BlockId>(Vec2)> masonry_at;  // a moving block, not cut out by a stage
  std::function<std::optional<BlockId>(Vec2)> segment_at;  // of the frame
  std::function<Vec3(BlockId, Vec2)> arm;                  // of a place, from a block's centroid
  std::function<Vec3(Vec2)> turned;                        // a direction, in the axes of the wall
  std::optional<Vec3> across;                              // normal to the plane, in space
};
struct Fastened {
  const ModelSpec& spec;
  const FrameSpec& frame;
  const geometry::PlacedFrame& placed;
  const geometry::FrameSections& sections;
  std::string path;  // "frame.0"
  FastenerSite site;
};
void add_fasteners(const Fastened& fastened, Model& model, FaultList& faults);

}  // namespace wythe
