// Stages of the model file -> loads on bodies and driven bodies, in space.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>
#include <utility>

#include "model/parts.h"
#include "model/shaking.h"
#include "model/size.h"
#include "model/space/space.h"
#include "model/space/space_places.h"

namespace wythe {
namespace {

using geometry::OuterFace;
using geometry::SpaceAssembly;

constexpr double kLoadRamp = 0.1;  // default smooth start of a load, as documented [s]

class SpaceStages {
 public:
  SpaceStages(const ModelSpec& spec, const SpaceAssembly& assembly, const std::vector<BlockId>& id,
              const std::vector<PointLoad>& floors, Model& model, FaultList& faults)
      : spec_(spec),
        assembly_(assembly),
        id_(id),
        floors_(floors),
        model_(model),
        faults_(faults),
        places_(spec, assembly) {
    for (std::size_t k = 0; k < assembly.body.size(); ++k)
      if (!assembly.body[k].fixed) lowest_ = std::fmin(lowest_, places_.box(k).low.y);
  }

  void run() {
    const std::size_t sets_floors = stage_of_floors(spec_, faults_);
    for (std::size_t k = 0; k < spec_.stage.size(); ++k) {
      path_ = fmt::format("stage.{}", k);
      Stage stage;
      stage.spec = spec_.stage[k];
      StageSpec& s = stage.spec;
      set_manner(s);
      if (std::isnan(s.damping))
        s.damping = s.kind() == StageKind::kShake ? 0.0 : spec_.solve.damping;
      set_direction(stage);
      if (const auto* load = std::get_if<LoadStage>(&s.action)) set_loads(*load, stage);
      if (auto* push = std::get_if<PushStage>(&s.action)) {
        *push = with_velocity(std::move(*push));
        set_driven(*push, stage);
        set_targets(path_, *push, stage, faults_);
      } else if (std::isnan(s.ramp)) {
        s.ramp = kLoadRamp;
      }
      if (s.kind() == StageKind::kShake) compile_shake(path_, places(), model_, stage, faults_);
      refuse_second_factor(s);
      refuse_zones(stage);
      if (k == sets_floors) stage.loads.insert(stage.loads.end(), floors_.begin(), floors_.end());
      floors_lie_ = floors_lie_ || k == sets_floors;
      model_.stages.push_back(std::move(stage));
    }
    compile_watched(spec_.history, places(), model_, faults_);
  }

 private:
  void fault(const std::string& key, std::string value, std::string problem, std::string cure) {
    faults_.add({"", path_ + "." + key, std::move(value), std::move(problem), std::move(cure), 0});
  }

  // Refuses loads and pushes on bodies with zones: they act on rigid blocks.
  void refuse_zones(const Stage& stage) {
    std::set<BlockId> solids;
    for (const PointLoad& load : stage.loads)
      if (is_solid(load.block)) solids.insert(load.block);
    for (const BlockId block : stage.driven)
      if (is_solid(block)) solids.insert(block);
    if (is_solid(stage.control)) solids.insert(stage.control);
    const auto* load = std::get_if<LoadStage>(&stage.spec.action);
    const char* key = load == nullptr || std::isfinite(load->force) ? "at"
                      : std::isfinite(load->line_load)              ? "line_load"
                                                                    : "on";
    for (const BlockId block : solids)
      fault(key, model_.space.solids.bodies[solid_of(block)].body.id,
            "is a block of zones; loads and pushes act on rigid blocks",
            "name rigid blocks beside it, or leave the block's zones out");
  }

  void set_direction(Stage& stage) {
    const DriveSpec drive = drive_of(stage.spec);
    const auto* load = std::get_if<LoadStage>(&stage.spec.action);
    const std::vector<double>& along = load != nullptr ? load->along : drive.along;
    Vec3 d = places_.in_wall(vector_of(drive.direction));
    if (!along.empty()) {
      if (along.size() != 3 || !(geometry::norm({along[0], along[1], along[2]}) > 0))
        return fault("along", "", "must be three numbers that are not all 0",
                     "write e.g. along = [1, 0, 0.5]");
      d = places_.in_wall(geometry::unit({along[0], along[1], along[2]}));
    }
    stage.drive_x = d.x, stage.drive_y = d.y, stage.drive_z = d.z;
    const StageKind kind = stage.spec.kind();
    const bool tilts = kind == StageKind::kBodyForce || kind == StageKind::kTilt;
    if (tilts && std::fabs(d.y) > 1e-12)
      fault("direction", "", "a body force or tilt acts sideways",
            "write a direction without a part upwards");
  }

  // Places for shakes and histories.
  [[nodiscard]] WallPlaces places() const {
    WallPlaces places;
    places.axis = [this](Direction direction) { return places_.in_wall(vector_of(direction)); };
    places.blocks = [this](const PlaceSpec& place) {
      std::vector<BlockId> ids;
      for (const std::size_t k : places_.find(place))
        if (!is_solid(id_[k])) ids.push_back(id_[k]);
      return ids;
    };
    places.point = [this](const PlaceSpec& p, BlockId block) {
      const Vec3 c = places_.in_file(model_.space.centroid[block]);
      return places_.in_wall({std::isfinite(p.x) && !std::isfinite(p.width) ? p.x : c.x,
                              std::isfinite(p.y) && !std::isfinite(p.height) ? p.y : c.y,
                              std::isfinite(p.z) && !std::isfinite(p.depth) ? p.z : c.z});
    };
    places.lowest = 1e300;  // of moving blocks: supports are the base
    for (std::size_t k = 0; k < assembly_.body.size(); ++k)
      if (!assembly_.body[k].fixed) places.lowest = std::fmin(places.lowest, places_.box(k).low.y);
    return places;
  }

  // The load factor of a body force continues from stage to stage, so a second one is refused.
  void refuse_second_factor(const StageSpec& s) {
    if (s.kind() != StageKind::kBodyForce && s.kind() != StageKind::kTilt) return;
    if (has_factor_) fault("kind", "", "is a second body force or tilt", "keep one of them");
    has_factor_ = true;
  }

  // Whether a body stands in the current stage.
  [[nodiscard]] bool stands(std::size_t k) const {
    const geometry::StageSpan& span = assembly_.span[k];
    const int now = static_cast<int>(model_.stages.size());
    return span.from <= now && now < span.until;
  }

  // --- loads ------------------------------------------------------------------------------------------

  // Area and centroid of what of a face has no standing body before it. The face is taken in two triangles to
  // each edge, whose centroids lie off its axes of symmetry; each is open where nothing stands before its centroid.
  [[nodiscard]] std::pair<double, Vec3> open_part(const geometry::OuterFace& face, Vec3 middle,
                                                  Vec3 looks,
                                                  const std::vector<bool>& standing) const {
    double open = 0;
    bool all = true;
    Vec3 moment{};
    const std::size_t corners = face.polygon.size();
    for (std::size_t i = 0; i < 2 * corners; ++i) {
      const Vec3 from = face.polygon[i / 2], to = face.polygon[(i / 2 + 1) % corners];
      const Vec3 half = 0.5 * (from + to), other = i % 2 == 0 ? from : to;
      const Vec3 centroid = (1 / 3.0) * (middle + half + other);
      if (places_.is_covered(centroid, looks, standing)) {
        all = false;
        continue;
      }
      const double area = 0.5 * length(cross(half - middle, other - middle));
      open += area;
      moment = moment + area * centroid;
    }
    if (all) return {face.area, middle};
    return {open, open > 0 ? (1 / open) * moment : middle};
  }

  void set_loads(const LoadStage& s, Stage& stage) {
    for (const auto& [key, load] :
         {std::pair("pier_load", s.pier_load), {"beam_load", s.beam_load}})
      if (std::isfinite(load))
        fault(key, "", "is for walls in their plane; this one is in space",
              "write pressure, and face and on for where it acts");
    if (std::isfinite(s.force) || std::isfinite(s.line_load))
      stage.loads = stated_loads(s, places_, assembly_, id_, path_, faults_);
    if (!std::isfinite(s.pressure)) return;
    Vec3 looks{0, 1, 0};
    if (!s.face.empty()) {
      const auto* word =
          std::find_if(std::begin(kDirectionWords), std::end(kDirectionWords),
                       [&](const auto& candidate) { return s.face == candidate.word; });
      if (word == std::end(kDirectionWords))
        return fault("face", s.face, "is no direction", "write +x, -x, +y, -y, +z or -z");
      looks = places_.in_wall(vector_of(word->value));
    }
    const std::vector<std::size_t> bodies = places_.find(s.on);
    std::vector<bool> standing(assembly_.body.size());
    for (std::size_t k = 0; k < standing.size(); ++k) standing[k] = stands(k);
    for (const OuterFace& face : assembly_.outer) {
      const std::size_t k = face.body;
      if (assembly_.body[k].fixed || dot(face.normal, looks) < kFacing || !stands(k)) continue;
      if (!std::binary_search(bodies.begin(), bodies.end(), k)) continue;
      const geometry::Facet facet = geometry::measured(face.polygon);
      double area = face.area;
      Vec3 centre = facet.centre;
      if (!is_stated(s.on)) std::tie(area, centre) = open_part(face, facet.centre, looks, standing);
      if (!(area > 0)) continue;
      const Vec3 arm = centre - assembly_.moments[k].centroid;
      const Vec3 f = -s.pressure * area * face.normal;
      stage.loads.push_back({id_[k], arm.x, arm.y, f.x, f.y, arm.z, f.z});
    }
    if (stage.loads.empty())
      fault(s.face.empty() ? "pressure" : "face", s.face, "finds no free face to press on",
            "name another face or other blocks in `on`");
  }

  // --- pushes -----------------------------------------------------------------------------------------

  void set_driven(PushStage& s, Stage& stage) {
    const bool patterned = s.pattern != Pattern::kNone;
    if (patterned && s.pattern != Pattern::kMass && s.pattern != Pattern::kArea)
      return fault("pattern", "", "is for walls in their plane",
                   "in space write pattern = \"mass\" or \"area\", or `at`");
    const std::vector<std::size_t> found = places_.find(patterned ? s.on : s.at);
    const bool fixed = !found.empty() && std::all_of(found.begin(), found.end(), [&](auto k) {
      return assembly_.body[k].fixed;
    });
    double height = 0, total = 0;
    const auto names_it = [&](std::size_t k) {
      return !patterned && s.at.block == assembly_.body[k].id;
    };
    for (const std::size_t k : found) {
      if (assembly_.body[k].fixed != fixed) continue;
      if ((!assembly_.body[k].cut.empty() || !stands(k)) && !names_it(k)) continue;
      const double share = s.pattern == Pattern::kMass   ? mass_on(k)
                           : s.pattern == Pattern::kArea ? facing_area(k, stage)
                                                         : 1.0;
      if (!(share > 0)) continue;
      stage.driven.push_back(id_[k]);
      stage.driven_share.push_back(share);
      height += share * (assembly_.moments[k].centroid.y - lowest_);
      total += share;
    }
    if (stage.driven.empty())
      return fault(patterned ? "pattern" : "at", "", "finds no block to push",
                   "name blocks by id, a point in a block, or a box round their centres");
    for (double& share : stage.driven_share)
      share *= static_cast<double>(stage.driven.size()) / total;
    stage.load_height = height / total;
    if (fixed) s.as = Manner::kEach;
    set_control(s.control, stage, fixed);
  }

  // Loads and pushes act on rigid blocks. So the mass of a body of zones goes to the blocks in contact, by the
  // areas of the contacts that transfer its force (as in stages.cpp) [kg].
  [[nodiscard]] double zone_mass_beside(BlockId block) const {
    const SpaceSolids& s = model_.space.solids;
    double sum = 0;
    for (std::size_t b = 0; b < s.bodies.size(); ++b) {
      double area = 0, own = 0, mass = 0;
      for (std::size_t c = 0; c < s.contact_body.size(); ++c) {
        if (static_cast<std::size_t>(s.contact_body[c]) != b) continue;
        area += s.contact_area[c];
        if (s.contact_block[c] == block) own += s.contact_area[c];
      }
      if (!(own > 0)) continue;
      for (int k = s.bodies[b].first_node; k < s.bodies[b].first_node + s.bodies[b].n_node; ++k)
        mass += s.node_gravity_mass[k];
      sum += mass * own / area;
    }
    return sum;
  }

  // Mass of a body, of zones beside it and of floors already on it [kg].
  [[nodiscard]] double mass_on(std::size_t k) const {
    if (assembly_.body[k].fixed || is_solid(id_[k])) return 0;
    double weight = 0;
    if (floors_lie_)
      for (const PointLoad& load : floors_) weight -= load.block == id_[k] ? load.fy : 0.0;
    const double g = model_.solve.gravity;
    return model_.gravity_mass[id_[k]] + zone_mass_beside(id_[k]) + (g > 0 ? weight / g : 0.0);
  }

  // Area of a body's free faces towards the push, projected normal to it [m^2].
  [[nodiscard]] double facing_area(std::size_t k, const Stage& stage) const {
    const Vec3 d{stage.drive_x, stage.drive_y, stage.drive_z};
    double area = 0;
    for (const OuterFace& face : assembly_.outer)
      if (static_cast<std::size_t>(face.body) == k && -dot(face.normal, d) > kFacing)
        area -= face.area * dot(face.normal, d);
    return area;
  }

  void set_control(const PlaceSpec& c, Stage& stage, bool fixed) {
    if (c.block.empty() && !std::isfinite(c.x) && !std::isfinite(c.y) && !std::isfinite(c.z))
      return;
    const std::vector<std::size_t> found = places_.find(c);
    if (found.empty() || fixed || assembly_.body[found.front()].fixed)
      return fault("control", "", fixed ? "cannot steer a support" : "finds no block that moves",
                   "name a point in a block, or its id; supports are driven as they are");
    stage.control = id_[found.front()];
    stage.load_height = assembly_.moments[found.front()].centroid.y - lowest_;
  }

  const ModelSpec& spec_;
  const SpaceAssembly& assembly_;
  const std::vector<BlockId>& id_;
  const std::vector<PointLoad>& floors_;
  Model& model_;
  FaultList& faults_;
  SpacePlaces places_;
  double lowest_ = 1e300;
  std::string path_;
  bool has_factor_ = false, floors_lie_ = false;
};

}  // namespace

void compile_space_stages(const ModelSpec& spec, const SpaceAssembly& assembly,
                          const std::vector<BlockId>& id, const std::vector<PointLoad>& floors,
                          Model& model, FaultList& faults) {
  SpaceStages(spec, assembly, id, floors, model, faults).run();
}

}  // namespace wythe
