// Which blocks stand in which stage, in space: bodies name the stages that cut and insert them (docs/theory/cutting.md).
#include <fmt/core.h>

#include <map>

#include "geometry/wall/cut_out.h"
#include "model/parts.h"
#include "model/space/space.h"

namespace wythe {
namespace {

class SpaceStanding {
 public:
  SpaceStanding(const ModelSpec& spec, const geometry::SpaceAssembly& assembly,
                const std::vector<BlockId>& id, Model& model, FaultList& faults)
      : spec_(spec), assembly_(assembly), id_(id), model_(model), faults_(faults) {}

  void run() {
    const std::size_t before = faults_.all().size();
    for (std::size_t k = 0; k < assembly_.body.size(); ++k) check(assembly_.body[k], frame_at(k));
    std::vector<int> used;
    for (const auto& [name, path] : named_)
      used.push_back(geometry::find_cut_stage(spec_.stage, path, name, faults_));
    if (faults_.all().size() > before) return;
    note_idle_cuts(spec_, used, model_);
    if (named_.empty()) return;
    refuse_what_is_not_built();
    for (std::size_t k = 0; k < id_.size(); ++k) {
      if (assembly_.body[k].fixed || is_solid(id_[k])) continue;
      model_.standing.from.push_back(assembly_.span[k].from);
      model_.standing.until.push_back(assembly_.span[k].until);
    }
    for (const auto& [name, path] : named_) note_cut(name);
  }

 private:
  void fault(const BodySpec& body, const char* key, std::string problem, std::string cure) {
    faults_.add(
        {"", "wall.blocks." + body.id + "." + key, "", std::move(problem), std::move(cure), 0});
  }

  // Index of the frame of which the body is a segment, or -1.
  [[nodiscard]] int frame_at(std::size_t body) const {
    const int k = geometry::frame_of(assembly_, static_cast<int>(body));
    return k < 0 ? k : assembly_.frames[k].placed.index;
  }

  void check(const BodySpec& body, int frame) {
    for (const auto& [key, name] : {std::pair("cut", body.cut), {"put_in", body.put_in}}) {
      if (name.empty()) continue;
      named_.emplace(name, frame >= 0 ? fmt::format("frame.{}.stage", frame)
                                      : "wall.blocks." + body.id + "." + key);
      if (body.fixed)
        fault(body, key, "is of a support, which stands always",
              "leave it out, or let the block rest on a support");
      else if (body.zone.zones > 0)
        fault(body, key, "is of a deformable block, and those stand always",
              "leave its zones out, or its " + std::string(key));
    }
    if (!body.cut.empty() && body.cut == body.put_in)
      fault(body, "cut", "is the stage that puts the block in",
            "name a later stage, or leave one of both out");
  }

  void refuse_what_is_not_built() {
    if (spec_.solve.contacts == Contacts::kFree)
      faults_.add({"", "solve.contacts", "free",
                   "does not go with blocks that a stage cuts out: contacts are joints there",
                   "leave it out, or leave cut and put_in out of the blocks", 0});
    for (std::size_t k = 0; k < id_.size(); ++k) {
      const BodySpec& body = assembly_.body[k];
      if (assembly_.span[k].from >= assembly_.span[k].until)
        fault(body, "cut", "comes before the stage that puts the block in",
              "let a later stage cut it out");
    }
    for (const geometry::JointFace& face : assembly_.faces) {
      const BodySpec &a = assembly_.body[face.a], &b = assembly_.body[face.b];
      const auto changes = [](const BodySpec& body) {
        return !body.cut.empty() || !body.put_in.empty();
      };
      if ((a.zone.zones > 0 && changes(b)) || (b.zone.zones > 0 && changes(a)))
        return fault(a.zone.zones > 0 ? a : b, "zones",
                     "touches a block that a stage cuts out or puts in, and holds no balance then",
                     "leave its zones out");
    }
  }

  void note_cut(const std::string& stage) {
    int blocks = 0;
    double weight = 0;
    for (std::size_t k = 0; k < id_.size(); ++k) {
      if (assembly_.body[k].cut != stage) continue;
      ++blocks;
      weight += model_.gravity_mass[id_[k]] * model_.solve.gravity;
    }
    if (blocks > 0)
      model_.anatomy.notes.push_back(
          {"cut.blocks", {{"stage", stage}, {"blocks", blocks}, {"weight_kN", 1e-3 * weight}}});
  }

  const ModelSpec& spec_;
  const geometry::SpaceAssembly& assembly_;
  const std::vector<BlockId>& id_;
  Model& model_;
  FaultList& faults_;
  std::map<std::string, std::string> named_;  // stages, each with the first place that names it
};

}  // namespace

void compile_space_standing(const ModelSpec& spec, const geometry::SpaceAssembly& assembly,
                            const std::vector<BlockId>& id, Model& model, FaultList& faults) {
  SpaceStanding(spec, assembly, id, model, faults).run();
}

}  // namespace wythe
