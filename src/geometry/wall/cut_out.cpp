// Lays all courses with everything outside a box as a hole: the pieces are those of the bond, cut at the box.
#include "geometry/wall/cut_out.h"

#include <fmt/format.h>

#include "core/text.h"
#include "geometry/wall/courses.h"

namespace wythe::geometry {

std::vector<Block> masonry_cut_out(const PlacedOpening& opening,
                                   const std::vector<Storey>& storeys) {
  const Rect wall{0, 0, storeys.front().lattice.columns.extent, storeys.back().top()};
  std::vector<Rect> boxes{opening.hole};
  for (const std::vector<Rect>* chain : {&opening.segment, &opening.sill})
    if (!chain->empty()) boxes.push_back(join(chain->front(), chain->back()));
  std::vector<Block> blocks;
  for (const Rect& box : boxes) {
    const std::vector<Rect> around{{wall.x0, wall.y0, box.x0, wall.y1},
                                   {box.x1, wall.y0, wall.x1, wall.y1},
                                   {box.x0, wall.y0, box.x1, box.y0},
                                   {box.x0, box.y1, box.x1, wall.y1}};
    for (Block& block : lay_masonry(storeys, around).blocks) {
      block.cut_from = opening.index;
      blocks.push_back(std::move(block));
    }
  }
  return blocks;
}

int find_cut_stage(const std::vector<StageSpec>& stages, const std::string& path,
                   const std::string& name, FaultList& faults) {
  if (name.empty()) return 0;
  const auto fault = [&](std::string problem, std::string cure) {
    faults.add({"", path, "\"" + name + "\"", std::move(problem), std::move(cure), 0});
  };
  std::vector<std::string> names;
  bool stands = false;  // a gravity stage came before
  for (std::size_t k = 0; k < stages.size(); ++k) {
    const StageSpec& stage = stages[k];
    names.push_back(stage.name);
    if (stage.name == name) {
      if (stage.kind() != StageKind::kCut)
        fault(fmt::format("is a {} stage", word_of(kStageKindWords, stage.kind())),
              "write kind = \"cut\" in a stage of its own, after gravity");
      else if (!stands)
        fault("comes before gravity: nothing stands there yet", "put a stage of gravity before it");
      return static_cast<int>(k);
    }
    stands = stands || stage.kind() == StageKind::kGravity;
  }
  fault("no stage has this name",
        names.empty()
            ? "add [[stage]] with this name and kind = \"cut\""
            : name_advice(name, names) + " Or add [[stage]] with this name and kind = \"cut\"");
  return 0;
}

}  // namespace wythe::geometry
