// Which blocks stand in which stage: openings that a stage cuts, and the parts it inserts (docs/theory/cutting.md).
#include <fmt/core.h>

#include <algorithm>
#include <limits>

#include "geometry/polygon.h"
#include "geometry/wall/cut_out.h"
#include "model/parts.h"

namespace wythe {
namespace {

constexpr std::int32_t kNever = std::numeric_limits<std::int32_t>::max();

class StandingCompiler {
 public:
  StandingCompiler(const ModelSpec& spec, const geometry::Assembly& assembly, const BlockMap& map,
                   Model& model, FaultList& faults)
      : spec_(spec), assembly_(assembly), map_(map), model_(model), faults_(faults) {}

  void run() {
    const std::size_t before = faults_.all().size();
    find_stages();
    check_wedges();
    if (!any_) return note_idle_stages();
    refuse_what_is_not_built();
    if (faults_.all().size() > before) return;
    note_idle_stages();
    model_.standing.from.assign(model_.n_block, 0);
    model_.standing.until.assign(model_.n_block, kNever);
    for (std::size_t b = 0; b < map_.size(); ++b) place(assembly_.blocks[b], map_[b]);
    refuse_zones_beside();
    for (std::size_t k = 0; k < cut_.size(); ++k)
      if (cut_[k] > 0) note_cut(k);
  }

 private:
  void fault(const std::string& path, const std::string& value, std::string problem,
             std::string cure) {
    faults_.add({"", path, value, std::move(problem), std::move(cure), 0});
  }

  // Finds the named stages; 0 stands for none, since the first stage can't be of kind cut.
  void find_stages() {
    for (std::size_t k = 0; k < spec_.wall.opening.size(); ++k)
      cut_.push_back(stage_named(fmt::format("wall.opening.{}.cut", k), spec_.wall.opening[k].cut));
    for (std::size_t k = 0; k < spec_.frame.size(); ++k) {
      const FrameSpec& frame = spec_.frame[k];
      int stage = stage_named(fmt::format("frame.{}.stage", k), frame.stage);
      for (std::size_t o = 0; frame.stage.empty() && o < cut_.size(); ++o)
        if (!frame.round.empty() && spec_.wall.opening[o].name == frame.round) stage = cut_[o];
      if (frame.stage.empty() && frame.round.empty()) stage = cut_where_it_stands(k);
      up_.push_back(stage);
    }
    const auto is_set = [](int stage) { return stage > 0; };
    any_ = std::any_of(cut_.begin(), cut_.end(), is_set) ||
           std::any_of(up_.begin(), up_.end(), is_set);
  }

  void check_wedges() {
    for (std::size_t k = 0; k < up_.size(); ++k)
      if (spec_.frame[k].wedges.force > 0 && up_[k] == 0)
        fault(fmt::format("frame.{}.wedges", k), "",
              "are driven in while a stage puts the frame up, and this one stands from the start",
              "write stage = \"the name of a stage of kind cut\", or cut in its opening");
  }

  // Stage of a frame along a line inside an opening that is cut: the stage of that opening.
  [[nodiscard]] int cut_where_it_stands(std::size_t frame) const {
    const auto box_of = [](const geometry::Block& block) {
      return geometry::bounds(block.outline);
    };
    constexpr double kTouch = 1e-6;  // [m]
    for (const geometry::Block& cut : assembly_.blocks) {
      if (cut.cut_from < 0) continue;
      for (const geometry::Block& segment : assembly_.blocks)
        if (segment.frame == static_cast<int>(frame) &&
            geometry::overlaps(box_of(segment), box_of(cut), kTouch))
          return cut_[cut.cut_from];
    }
    return 0;
  }

  int stage_named(const std::string& path, const std::string& name) {
    return geometry::find_cut_stage(spec_.stage, path, name, faults_);
  }

  void refuse_what_is_not_built() {
    for (std::size_t k = 0; k < cut_.size(); ++k) {
      const OpeningSpec& opening = spec_.wall.opening[k];
      const std::string path = fmt::format("wall.opening.{}", k);
      if (cut_[k] > 0 && opening.arch.kind != ArchKind::kNone)
        fault(path + ".cut", "\"" + opening.cut + "\"",
              "an arch cannot be laid into standing masonry",
              "give the opening a lintel or a frame, or leave cut out");
    }
    const auto refuse = [&](const char* path, bool is_there, const char* what) {
      if (is_there)
        fault(path, "", fmt::format("does not go with openings that a stage cuts: {}", what),
              "leave it out, or build the opening with the wall (no cut)");
    };
    refuse("solve.contacts", spec_.solve.contacts == Contacts::kFree, "contacts are joints there");
    for (std::size_t b = 0; b < map_.size(); ++b) {
      const geometry::Block& block = assembly_.blocks[b];
      if (!is_solid(map_[b]) || block.opening < 0 || cut_[block.opening] == 0) continue;
      fault(fmt::format("wall.opening.{}.lintel.model", block.opening), "\"zones\"",
            "is put in by a stage, and deformable blocks stand from the first stage on",
            "write model = \"segments\", or build the opening with the wall (no cut)");
    }
  }

  // Refuses cuts beside zones: their nodes are not held while a stage releases them.
  void refuse_zones_beside() {
    const Solids& solids = model_.solids;
    for (std::size_t c = 0; c < solids.contact_block.size(); ++c) {
      const std::size_t i = solids.contact_block[c];
      if (i >= model_.standing.from.size() ||
          (model_.standing.from[i] == 0 && model_.standing.until[i] == kNever))
        continue;
      const auto body = std::find_if(
          solids.bodies.begin(), solids.bodies.end(),
          [&](const SolidBody& one) { return solids.contact_p[c] < one.first_node + one.n_node; });
      return fault("wall.blocks." + body->id + ".zones", "",
                   "touches what a stage cuts out or puts in",
                   "leave its zones out, or move the opening away from it");
    }
  }

  void note_idle_stages() {
    std::vector<int> used = cut_;
    used.insert(used.end(), up_.begin(), up_.end());
    note_idle_cuts(spec_, used, model_);
  }

  void place(const geometry::Block& block, BlockId id) {
    if (id < 0) return;
    if (block.cut_from >= 0) {
      model_.standing.until[id] = cut_[block.cut_from];
    } else if (block.frame >= 0) {
      model_.standing.from[id] = up_[block.frame];
    } else if (block.opening >= 0) {  // lintel or sill
      model_.standing.from[id] = cut_[block.opening];
    }
  }

  void note_cut(std::size_t opening) {
    int blocks = 0;
    double weight = 0;
    for (std::size_t b = 0; b < map_.size(); ++b) {
      if (assembly_.blocks[b].cut_from != static_cast<int>(opening) || map_[b] < 0) continue;
      ++blocks;
      weight += model_.gravity_mass[map_[b]] * model_.solve.gravity;
    }
    const std::string& name = spec_.wall.opening[opening].name;
    model_.anatomy.notes.push_back({"cut.opening",
                                    {{"opening", name.empty() ? std::to_string(opening + 1) : name},
                                     {"stage", spec_.stage[cut_[opening]].name},
                                     {"blocks", blocks},
                                     {"weight_kN", 1e-3 * weight}}});
  }

  const ModelSpec& spec_;
  const geometry::Assembly& assembly_;
  const BlockMap& map_;
  Model& model_;
  FaultList& faults_;
  std::vector<int> cut_, up_;  // stage of each opening, of each frame; 0: none
  bool any_ = false;
};

}  // namespace

void compile_standing(const ModelSpec& spec, const geometry::Assembly& assembly,
                      const BlockMap& map, Model& model, FaultList& faults) {
  StandingCompiler(spec, assembly, map, model, faults).run();
}

void note_idle_cuts(const ModelSpec& spec, const std::vector<int>& used, Model& model) {
  for (std::size_t k = 0; k < spec.stage.size(); ++k)
    if (spec.stage[k].kind() == StageKind::kCut &&
        std::find(used.begin(), used.end(), static_cast<int>(k)) == used.end())
      model.anatomy.notes.push_back({"cut.nothing", {{"stage", spec.stage[k].name}}});
}

void check_standing(const Model& model, FaultList& faults) {
  if (!model.standing.any()) return;
  const auto goes = [&](BlockId block) {
    return block >= 0 && block < model.n_block &&
           model.anatomy.block_role[block] == BlockRole::kCutOut;
  };
  const auto refuse = [&](const std::string& path, BlockId block, const char* what) {
    faults.add({"", path, model.anatomy.block_id[block],
                fmt::format("{} masonry that a stage cuts out", what),
                "move it beside the opening, or build the opening with the wall (no cut)", 0});
  };
  for (std::size_t k = 0; k < model.stages.size(); ++k) {
    const Stage& stage = model.stages[k];
    const std::string path = fmt::format("stage.{}", k);
    for (const PointLoad& load : stage.loads)
      if (goes(load.block)) return refuse(path, load.block, "loads");
    for (const BlockId block : stage.driven)
      if (goes(block)) return refuse(path + ".at", block, "pushes");
    if (goes(stage.control)) return refuse(path + ".control", stage.control, "follows");
  }
  for (std::size_t k = 0; k < model.links.a.size(); ++k)
    for (const BlockId block : {model.links.a[k], model.links.b[k]})
      if (goes(block)) return refuse("tie", block, "a tie or spring ends on");
}

}  // namespace wythe
