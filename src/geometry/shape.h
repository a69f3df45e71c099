// The part of a model that shapes its wall: build_assembly() sees nothing else.
//
// Walls with one shape_key have the same blocks, faces and notes. Samples of a study differ in materials,
// loads and stages, so they share one assembly (model/compiler.h).
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "wythe/parts/wall_spec.h"

namespace wythe::geometry {

// A stage that loads the piers through plates.
struct PlateStage {
  std::string name, joint;
};

struct Shape {
  Shape(const ModelSpec& spec);  // every spec has one; it must not outlive the spec
  const WallSpec& wall;
  const std::vector<StoreySpec>& storey;
  const std::vector<RegionSpec>& region;
  const std::vector<RingBeamSpec>& ring_beam;
  const std::vector<FrameSpec>& frame;
  const std::vector<BlockSpec>& block;
  const std::vector<BodySpec>& body;
  const std::vector<ContactRule>& contact;
  std::map<std::string, double>
      material;  // names, densities [kg/m^3]; no other number of materials
  std::vector<PlateStage> plates;
  std::vector<std::string> stages;  // all names, where bodies or frames in space refer to stages
};

// A hash over all bits of the shape. Of a density it contains only whether it is valid, since blocks hold none.
[[nodiscard]] std::uint64_t shape_key(const Shape& shape);

}  // namespace wythe::geometry
