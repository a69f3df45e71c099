// The wall in a state: blocks, open, slipped and crushed joints, ground, push arrow.
#pragma once

#include <string>

#include "judge/modes/elevations.h"
#include "wythe/parts/model.h"

namespace wythe::report {

struct WallPicture {
  std::string svg;     // without a style sheet
  int open = 0;        // joints drawn as open cracks
  int slipped = 0;     // as slipped
  int closed = 0;      // cracked, closed again
  int softening = 0;   // damage begun, not complete
  int crushed = 0;     // points marked as crushed
  double widest = 0;   // opening [m]
  double longest = 0;  // slip [m]
};

// A named part of the wall in the picture.
struct WallMark {
  double x0 = 0, x1 = 0, y0 = 0, y1 = 0;  // [m]
  std::string name;
  bool is_hit = false;  // shaded
};

[[nodiscard]] WallPicture draw_wall(const Model& model, const State& state, double scale,
                                    const std::vector<WallMark>& marks = {});

// Walls of a building at the start, side by side, each as it is seen across its
// plane. The boxes of `marks` come from find_parts(): one list for each wall.
[[nodiscard]] std::string draw_elevations(const Model& model,
                                          const std::vector<study::Elevation>& walls,
                                          const std::vector<std::vector<WallMark>>& marks);

// A round magnification with which the largest displacement is about 5 % of the wall.
[[nodiscard]] double fitting_scale(const Model& model, const State& state);

// Pushed blocks with one common arrow, and its length relative to the longest. There is one for each level
// of a pattern, for each third of the wall if all blocks are pushed, or a single one without a pattern.
struct PushPart {
  std::vector<BlockId> blocks;
  double length = 1;
};
[[nodiscard]] std::vector<PushPart> push_parts(const Model& model, const Stage& push);

}  // namespace wythe::report
