// Parts of the masonry with other materials: a storey, a pier of it, a box or a polygon.
//
// A block lies in a region when its centroid does, edge included; of several regions the one listed last
// has it. faces.h defines the material of a joint between two regions.
// Called by assembly.cpp and by the builder once the masonry is laid; writes Block::region, and the thickness that a region states.
#pragma once

#include <string>
#include <vector>

#include "geometry/assembly.h"
#include "geometry/wall/openings.h"
#include "geometry/wall/storeys.h"

namespace wythe::geometry {

// Data of the wall for the places of its regions.
struct RegionSite {
  const std::vector<Storey>& storeys;
  const std::vector<PlacedOpening>& openings;
  double length, height;  // [m]
};

// The place of one region, and how messages call it.
struct NamedRegion {
  RegionPlace place;
  std::string path;  // "region.0", "plan_wall.1.region.0"
  int index;
  std::string name;
  double thickness = kUnset;  // of its blocks [m]; unset: what they have
  bool in_storeys = true;     // whether its place may name a storey
  [[nodiscard]] std::string at(const std::string& key = "") const {
    return key.empty() ? path : path + "." + key;
  }
  [[nodiscard]] std::string called() const {
    return "region " + std::to_string(index) + (name.empty() ? "" : " (" + name + ")");
  }
};

// Marks each block of masonry with the last region that holds its centroid, gives it the thickness, and notes what a region takes from another.
// Refuses a region without a place, with several places or without blocks.
void mark_regions(const std::vector<NamedRegion>& regions, const RegionSite& site,
                  std::vector<Block>& blocks, std::vector<Message>& notes, FaultList& faults);

// Regions of a wall in its plane; they may have a thickness. Refuses also one that changes nothing.
void assign_regions(const Shape& shape, const std::vector<Storey>& storeys,
                    const std::vector<PlacedOpening>& openings, Assembly& assembly,
                    FaultList& faults);

}  // namespace wythe::geometry
