// Stages of the model file -> loads on blocks and driven blocks.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "core/elementary.h"
#include "model/parts.h"
#include "model/protocol.h"
#include "model/shaking.h"
#include "model/size.h"

namespace wythe {
namespace {

using geometry::Assembly;
using geometry::Role;

// Default smooth start of a load, as documented [s]; docs/theory/integration.md gives the reason.
constexpr double kLoadRamp = 0.1;

bool drives(StageKind kind) {
  return kind == StageKind::kPush || kind == StageKind::kBodyForce || kind == StageKind::kTilt;
}

class StageCompiler {
 public:
  StageCompiler(const ModelSpec& spec, const Assembly& assembly, const BlockMap& map,
                const std::vector<PointLoad>& floors, Model& model, FaultList& faults)
      : spec_(spec),
        assembly_(assembly),
        map_(map),
        floors_(floors),
        model_(model),
        faults_(faults) {}

  void run() {
    const std::size_t sets_floors = stage_of_floors(spec_, faults_);
    for (std::size_t k = 0; k < spec_.stage.size(); ++k) {
      path_ = fmt::format("stage.{}", k);
      Stage stage;
      stage.spec = spec_.stage[k];
      set_defaults(stage.spec);
      set_direction(stage);
      refuse_space(stage);
      if (const auto* load = std::get_if<LoadStage>(&stage.spec.action)) set_loads(*load, stage);
      if (auto* push = std::get_if<PushStage>(&stage.spec.action)) {
        set_driven(*push, stage);
        set_targets(path_, *push, stage, faults_);
      }
      if (stage.spec.kind() == StageKind::kShake)
        compile_shake(path_, places(), model_, stage, faults_);
      refuse_second_factor(stage);
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

  // Refuses a second body force or tilt: it would have to remove the first one while it grows.
  void refuse_second_factor(const Stage& stage) {
    const bool factor =
        stage.spec.kind() == StageKind::kBodyForce || stage.spec.kind() == StageKind::kTilt;
    if (factor && has_factor_)
      fault("kind", "", "a model holds one body_force or tilt stage only",
            "run the second one on a model of its own");
    has_factor_ = has_factor_ || factor;
  }

  void set_defaults(StageSpec& s) const {
    set_manner(s);
    if (std::isnan(s.damping))
      s.damping = s.kind() == StageKind::kShake ? 0.0 : model_.solve.damping;
    if (auto* push = std::get_if<PushStage>(&s.action))
      *push = with_velocity(std::move(*push));
    else if (std::isnan(s.ramp))
      s.ramp = kLoadRamp;  // pushes: set_push_ramps
  }

  // Refuses keys for walls in space.
  void refuse_space(const Stage& stage) {
    const StageKind kind = stage.spec.kind();
    const DriveSpec drive = drive_of(stage.spec);
    const bool tilts = kind == StageKind::kBodyForce || kind == StageKind::kTilt;
    if (tilts && stage.drive_x == 0)
      fault("direction", std::string(word_of(kDirectionWords, drive.direction)),
            fmt::format("a {} stage acts sideways", word_of(kStageKindWords, kind)),
            "write direction = \"+x\" or \"-x\"");
    else if (stage.drive_z != 0)
      fault("direction", std::string(word_of(kDirectionWords, drive.direction)),
            "is out of the wall's plane, and this wall is no wall in space",
            "write +x, -x, +y or -y, or give its blocks a third dimension");
    const auto refuse = [&](const char* key, bool is_there) {
      if (is_there)
        fault(key, "", "is for walls in space, and this one is in its plane",
              "leave it out, or give the blocks a third dimension");
    };
    const auto is_deep = [](const PlaceSpec& p) {
      return std::isfinite(p.z) || std::isfinite(p.depth) || !p.role.empty();
    };
    refuse("along", !drive.along.empty());
    if (const auto* push = std::get_if<PushStage>(&stage.spec.action)) {
      refuse("pattern", push->pattern == Pattern::kArea);
      refuse("at", is_deep(push->at));
      refuse("control", is_deep(push->control));
    }
    if (const auto* load = std::get_if<LoadStage>(&stage.spec.action)) {
      const PlaceSpec& on = load->on;
      refuse("along", !load->along.empty());
      refuse("face", !load->face.empty());
      refuse("at", is_deep(load->at));
      refuse("force", std::isfinite(load->force));
      refuse("line_load", std::isfinite(load->line_load));
      refuse("on", !on.block.empty() || std::isfinite(on.x) || std::isfinite(on.y) || is_deep(on));
    }
  }

  static void set_direction(Stage& stage) {
    const Vec3 d = vector_of(drive_of(stage.spec).direction);
    stage.drive_x = d.x, stage.drive_y = d.y, stage.drive_z = d.z;
  }

  // Places for shakes and histories.
  [[nodiscard]] WallPlaces places() {
    WallPlaces places;
    places.axis = vector_of;
    places.blocks = [this](const PlaceSpec& at) {
      std::vector<BlockId> ids;
      for (const std::size_t b : blocks_at(at))
        if (map_[b] >= 0) ids.push_back(map_[b]);
      return ids;
    };
    places.point = [this](const PlaceSpec& at, BlockId block) {
      const std::size_t i = block;
      const bool point = std::isfinite(at.x) && std::isfinite(at.y) && !std::isfinite(at.width);
      return point ? Vec3{at.x, at.y, 0} : Vec3{model_.centroid_x[i], model_.centroid_y[i], 0};
    };
    places.lowest = lowest(&Vec2::y);
    return places;
  }
  std::vector<std::size_t> blocks_at(const PlaceSpec& at) {
    if (at.beam || !at.block.empty()) return named_blocks(at);
    if (std::isfinite(at.width) && std::isfinite(at.height)) return blocks_in_box(at);
    return blocks_at_point(at);
  }

  void set_loads(const LoadStage& s, Stage& stage) {
    if (std::isfinite(s.beam_load)) load_role(stage, Role::kBeam, s.beam_load, "beam_load");
    if (std::isfinite(s.pressure))
      press(stage, lowest(&Vec2::x), lowest(&Vec2::x) + assembly_.length,
            s.pressure * assembly_.top_thickness, "pressure");
    if (!std::isfinite(s.pier_load)) return;
    if (s.as == Manner::kPlate) {
      load_role(stage, Role::kPlate, s.pier_load, "pier_load");
      return;
    }
    say_strips(s, stage);
    for (const geometry::Pier& pier : assembly_.piers)
      press(stage, pier.x0, pier.x1, s.pier_load / (pier.x1 - pier.x0), "pier_load");
  }

  // Notes the load of each strip of full height. Openings at different places above each other leave narrower
  // strips than the piers of any storey.
  void say_strips(const LoadStage& load, const Stage& stage) {
    if (assembly_.piers.empty())
      fault("pier_load", "", "the openings leave no strip of full height to load",
            "load the wall's top (pressure = ...), or lay [[floor]]s on the storeys");
    if (assembly_.storeys.size() < 2 || assembly_.piers.empty()) return;
    std::string strips;
    for (const geometry::Pier& pier : assembly_.piers)
      strips += fmt::format("{}{:.3g} to {:.3g} m", strips.empty() ? "" : ", ", pier.x0, pier.x1);
    model_.anatomy.notes.push_back({"load.strips",
                                    {{"stage", stage.spec.name},
                                     {"load_kN", 1e-3 * load.pier_load},
                                     {"count", assembly_.piers.size()},
                                     {"strips", strips}}});
  }

  // A load acts downwards at the top centre of every block with that role.
  void load_role(Stage& stage, Role role, double load, const char* key) {
    const std::size_t before = stage.loads.size();
    for (std::size_t b = 0; b < assembly_.blocks.size(); ++b) {
      if (assembly_.blocks[b].role != role) continue;
      const std::size_t i = map_[b];
      stage.loads.push_back({map_[b], 0.0, top_of(b) - model_.centroid_y[i], 0.0, -load});
    }
    if (stage.loads.size() == before)
      fault(key, "", "finds no beam or plate to act on",
            "add [wall.beam], or use pier_load with as = \"pressure\"");
  }

  [[nodiscard]] double top_of(std::size_t block) const {
    double top = -1e300;
    for (const Vec2& v : assembly_.blocks[block].outline) top = std::max(top, v.y);
    return top;
  }

  void refuse_zones(std::size_t block, const char* key) {
    fault(key, assembly_.blocks[block].id,
          "would act on a block of zones; loads and pushes act on "
          "rigid blocks",
          "put a rigid block between, or leave the block's zones out");
  }

  // Adds the dead line load `q` [N/m] on upper edges of the masonry between x0 and x1.
  void press(Stage& stage, double x0, double x1, double q, const char* key) {
    double pressed = 0;
    const double tolerance = 1e-6 * assembly_.height, top = top_of_wall();
    for (std::size_t b = 0; b < assembly_.blocks.size(); ++b) {
      if (map_[b] == kGroundBlock || assembly_.blocks[b].role == Role::kPlate) continue;
      const auto& outline = assembly_.blocks[b].outline;
      for (std::size_t v = 0; v < outline.size(); ++v) {
        const Vec2 p = outline[v], n = outline[(v + 1) % outline.size()];
        if (std::fabs(p.y - top) > tolerance || std::fabs(n.y - top) > tolerance) continue;
        const double from = std::max(std::min(p.x, n.x), x0), to = std::min(std::max(p.x, n.x), x1);
        if (to - from <= tolerance) continue;
        if (is_solid(map_[b])) return refuse_zones(b, key);
        const std::size_t i = map_[b];
        stage.loads.push_back({map_[b], 0.5 * (from + to) - model_.centroid_x[i],
                               top - model_.centroid_y[i], 0.0, -q * (to - from)});
        pressed += to - from;
      }
    }
    if (pressed < 0.999 * (x1 - x0))
      fault(key, "",
            fmt::format("the flat top between {:.3f} and {:.3f} m is only {:.3f} m long", x0, x1,
                        pressed),
            "load the wall through a beam: [wall.beam] and beam_load");
  }

  // Least x or y of the moving blocks: a blocks file may start away from the origin.
  [[nodiscard]] double lowest(double Vec2::*axis) const {
    double least = 1e300;
    for (std::size_t b = 0; b < assembly_.blocks.size(); ++b) {
      if (map_[b] == kGroundBlock) continue;
      for (const Vec2& v : assembly_.blocks[b].outline) least = std::min(least, v.*axis);
    }
    return least;
  }

  [[nodiscard]] double top_of_wall() const {
    double top = -1e300;
    for (std::size_t b = 0; b < assembly_.blocks.size(); ++b)
      if (assembly_.blocks[b].role != Role::kPlate && assembly_.blocks[b].role != Role::kFrame)
        top = std::max(top, top_of(b));
    return top;
  }

  void set_driven(const PushStage& push, Stage& stage) {
    const PlaceSpec& at = push.at;
    const std::vector<double>& targets = push.targets;
    const bool moves = goes_to_and_fro(push)
                           ? targets.empty() || std::any_of(targets.begin(), targets.end(),
                                                            [](double t) { return t != 0; })
                           : push.until > 0;
    if (!moves)
      fault("until", "", "the displacement of a push cannot be zero",
            "write e.g. until = \"50 mm\"");
    if (push.pattern != Pattern::kNone) {
      set_pattern(push, stage);
      set_control(push.control, stage);
      return;
    }
    const std::vector<std::size_t> found = blocks_at(at);
    double height = 0;
    for (const std::size_t b : found) {
      if (map_[b] == kGroundBlock) continue;
      if (is_solid(map_[b])) return refuse_zones(b, "at");
      stage.driven.push_back(map_[b]);
      height += model_.centroid_y[map_[b]];
    }
    if (stage.driven.empty()) {
      fault("at", "", "finds no moving block to push",
            "name a point or box inside the wall, e.g. at = { x = \"0 m\", y = \"3.12 m\", courses "
            "= 3 }");
      return;
    }
    stage.driven_share.assign(stage.driven.size(), 1.0);
    stage.load_height = height / static_cast<double>(stage.driven.size()) - lowest(&Vec2::y);
    if (std::isfinite(push.contraflexure)) set_contraflexure(push.contraflexure, stage);
    set_control(push.control, stage);
  }

  // Sets the line of the push. Rows follow the displacement of the head, since the end of its arm is no point of the wall.
  void set_contraflexure(double point, Stage& stage) {
    const std::size_t head = stage.driven.front();
    const std::string value = fmt::format("{:g}", point);
    if (stage.driven.size() > 1)
      return fault("contraflexure", value,
                   fmt::format("needs one head, and {} blocks are pushed", stage.driven.size()),
                   "push a loading beam: [wall.beam], at = { beam = true }; or name one block");
    if (model_.turn_freedom[head] == 0)
      return fault("contraflexure", value, "needs a head that turns, and the beam is held level",
                   "leave wall.beam.rotation = \"blocked\" out");
    const double height = point * assembly_.height;
    stage.drive_arm = lowest(&Vec2::y) + height - model_.centroid_y[head];
    stage.control = stage.driven.front();
  }

  // --- a pattern of forces: shares of blocks, with mean 1 -------------------------------------------

  struct Level {
    double height = 0;                // above the lowest point of the wall [m]
    std::vector<std::size_t> blocks;  // on which the force acts
    double mass = 0;                  // nearest to this level [kg]
    double share = 0;
  };

  void set_pattern(const PushStage& push, Stage& stage) {
    const bool all = push.pattern == Pattern::kMass;
    std::vector<Level> levels = all ? every_block() : levels_of(push);
    const std::vector<double> zones = zone_mass_on_blocks();
    const auto weighs = [&](std::size_t b) {
      if (!all) return mass_of(b);
      return mass_of(b) + floor_mass_on(b) + zones[map_[b]];
    };
    std::vector<double> force;  // on each driven block
    double total = 0, height = 0;
    for (const Level& level : levels) {
      double mass = 0;
      for (const std::size_t b : level.blocks) mass += weighs(b);
      for (const std::size_t b : level.blocks) {
        if (is_solid(map_[b])) return refuse_zones(b, "levels");
        stage.driven.push_back(map_[b]);
        force.push_back(level.share * weighs(b) / mass);
        total += force.back();
        height += force.back() * (centroid_of(b).y - lowest(&Vec2::y));
      }
    }
    if (stage.driven.empty()) return;  // a fault was reported
    if (!(total > 0))
      return fault("shares", "", "add up to nothing, or less",
                   "write shares whose sum is above 0; direction says which way they push");
    for (const double f : force)
      stage.driven_share.push_back(f * static_cast<double>(force.size()) / total);
    stage.load_height = height / total;
  }

  // Mass of floors already on the block [kg].
  [[nodiscard]] double floor_mass_on(std::size_t b) const {
    double weight = 0;
    for (const PointLoad& load : floors_) weight -= load.block == map_[b] ? load.fy : 0.0;
    return floors_lie_ && model_.solve.gravity > 0 ? weight / model_.solve.gravity : 0.0;
  }

  // Loads and pushes act on rigid blocks. So the mass of a body of zones goes to the blocks in contact, by
  // the areas of the contacts that transfer its force [kg] (n_block).
  [[nodiscard]] std::vector<double> zone_mass_on_blocks() const {
    const Solids& s = model_.solids;
    std::vector<double> on(static_cast<std::size_t>(model_.n_block) + 1, 0.0);  // last: the ground
    for (const SolidBody& body : s.bodies) {
      const auto is_of = [&](std::int32_t node) {
        return node >= body.first_node && node < body.first_node + body.n_node;
      };
      double area = 0;
      for (std::size_t c = 0; c < s.contact_p.size(); ++c)
        if (is_of(s.contact_p[c])) area += s.contact_area[c];
      for (std::size_t c = 0; c < s.contact_p.size(); ++c)
        if (is_of(s.contact_p[c]) && s.contact_block[c] <= model_.n_block)  // else a reported fault
          on[s.contact_block[c]] += mass_of_zones(body) * s.contact_area[c] / area;
    }
    return on;
  }
  [[nodiscard]] double mass_of_zones(const SolidBody& body) const {
    double mass = 0;
    for (int node = body.first_node; node < body.first_node + body.n_node; ++node)
      mass += model_.solids.node_gravity_mass[node];
    return mass;
  }

  // All rigid blocks as one level, with forces by the mass of each block, of floors on it and of zones
  // beside it.
  [[nodiscard]] std::vector<Level> every_block() const {
    Level all;
    all.share = 1;
    for (std::size_t b = 0; b < assembly_.blocks.size(); ++b)
      if (map_[b] != kGroundBlock && !is_solid(map_[b]) && mass_of(b) > 0 &&
          assembly_.blocks[b].cut_from < 0)
        all.blocks.push_back(b);
    return {all};
  }

  std::vector<Level> levels_of(const PushStage& s) {
    const double bottom = lowest(&Vec2::y);
    std::vector<Level> levels;
    if (s.pattern == Pattern::kGiven && s.shares.size() != s.levels.size()) {
      fault("shares", "", fmt::format("are {} for {} levels", s.shares.size(), s.levels.size()),
            "write one share for each level");
      return {};
    }
    for (std::size_t k = 0; k < s.levels.size(); ++k) {
      Level level;
      level.height = s.levels[k];
      for (std::size_t b = 0; b < assembly_.blocks.size(); ++b)
        if (is_pushed_at(b, bottom + level.height) && assembly_.blocks[b].cut_from < 0)
          level.blocks.push_back(b);
      if (level.blocks.empty()) {
        fault(fmt::format("levels.{}", k), fmt::format("{:g} m", level.height),
              "no moving block stands at this height",
              fmt::format("write heights above 0 and up to {:g} m", top_of_wall() - bottom));
        return {};
      }
      for (const Level& other : levels)
        if (std::find(other.blocks.begin(), other.blocks.end(), level.blocks.front()) !=
            other.blocks.end()) {
          fault(fmt::format("levels.{}", k), fmt::format("{:g} m", level.height),
                fmt::format("lies in the same course as {:g} m", other.height),
                "write each course once, with its whole share");
          return {};
        }
      levels.push_back(std::move(level));
    }
    lump_masses(levels);
    for (std::size_t k = 0; k < levels.size(); ++k) {
      Level& level = levels[k];
      if (s.pattern == Pattern::kGiven) level.share = s.shares[k];
      if (s.pattern == Pattern::kUniform) level.share = level.mass;
      if (s.pattern == Pattern::kMassHeight) level.share = level.mass * level.height;
    }
    return levels;
  }

  // Whether the block's box contains the height; a block that starts there belongs to the next course.
  [[nodiscard]] bool is_pushed_at(std::size_t b, double y) const {
    if (map_[b] == kGroundBlock || !(mass_of(b) > 0)) return false;
    double low = 1e300;
    for (const Vec2& v : assembly_.blocks[b].outline) low = std::min(low, v.y);
    const double tolerance = 1e-6 * assembly_.height;
    return y > low + tolerance && y <= top_of(b) + tolerance;
  }

  // Assigns the mass of every block, and of loads on blocks before the push, to the nearest
  // level; mass nearer to the ground than to the lowest level goes to the ground.
  void lump_masses(std::vector<Level>& levels) const {
    const double bottom = lowest(&Vec2::y);
    const auto add = [&](double mass, double height) {
      Level* nearest = nullptr;
      double least = std::fabs(height);
      for (Level& level : levels)
        if (std::fabs(level.height - height) < least)
          least = std::fabs(level.height - height), nearest = &level;
      if (nearest != nullptr) nearest->mass += mass;
    };
    for (std::size_t b = 0; b < assembly_.blocks.size(); ++b)
      if (map_[b] != kGroundBlock) add(mass_of(b), centroid_of(b).y - bottom);
    for (const SolidBody& body : model_.solids.bodies)
      add(mass_of_zones(body), 0.5 * (body.y0 + body.y1) - bottom);
    if (!(model_.solve.gravity > 0)) return;
    for (const Stage& before : model_.stages)
      for (const PointLoad& load : before.loads)
        add(-load.fy / model_.solve.gravity, model_.centroid_y[load.block] + load.arm_y - bottom);
  }

  [[nodiscard]] double mass_of(std::size_t b) const {
    return is_solid(map_[b]) ? 0.0 : model_.gravity_mass[map_[b]];
  }

  // Finds the block whose displacement the push follows.
  void set_control(const PlaceSpec& at, Stage& stage) {
    if (!std::isfinite(at.x) && at.block.empty()) return;
    const std::size_t none = assembly_.blocks.size();
    std::size_t found = none;
    if (at.block.empty()) {
      found = nearest_block(at.x, at.y, -1);
      if (found < none && distance(found, at.x, at.y) > 0.05 * assembly_.height) found = none;
    } else if (const auto named = named_blocks(at); !named.empty()) {
      found = named.front();
    }
    if (found == none || map_[found] == kGroundBlock)
      return fault("control", at.block, "finds no moving block",
                   "name a point inside the wall, e.g. control = { x = \"0 m\", y = \"6.2 m\" }");
    if (is_solid(map_[found])) return refuse_zones(found, "control");
    stage.control = map_[found];
    stage.load_height = centroid_of(found).y - lowest(&Vec2::y);
  }

  [[nodiscard]] std::vector<std::size_t> named_blocks(const PlaceSpec& at) const {
    std::vector<std::size_t> found;
    for (std::size_t b = 0; b < assembly_.blocks.size(); ++b) {
      const geometry::Block& block = assembly_.blocks[b];
      if (at.beam ? block.role == Role::kBeam : block.id == at.block) found.push_back(b);
    }
    return found;
  }

  [[nodiscard]] Vec2 centroid_of(std::size_t b) const {
    return geometry::moments(assembly_.blocks[b].outline).centroid;
  }

  [[nodiscard]] std::vector<std::size_t> blocks_in_box(const PlaceSpec& at) const {
    std::vector<std::size_t> found;
    for (std::size_t b = 0; b < assembly_.blocks.size(); ++b) {
      const Vec2 c = centroid_of(b);
      if (c.x >= at.x && c.x <= at.x + at.width && c.y >= at.y && c.y <= at.y + at.height)
        found.push_back(b);
    }
    return found;
  }

  // The block nearest to the point, and in the courses around it the blocks nearest in x.
  std::vector<std::size_t> blocks_at_point(const PlaceSpec& at) {
    const std::size_t nearest = nearest_block(at.x, at.y, -1);
    const bool found_any = nearest < assembly_.blocks.size();  // false where x or y is not finite
    if (!found_any || distance(nearest, at.x, at.y) > 0.05 * assembly_.height) return {};
    const int course = assembly_.blocks[nearest].course;
    if (at.courses <= 1 || course < 0) {
      if (at.courses > 1)
        fault("at.courses", std::to_string(at.courses), "this wall has no courses",
              "push at a box: at = { x, y, width, height }");
      return {nearest};
    }
    if (at.courses > assembly_.report.courses) {
      fault("at.courses", std::to_string(at.courses),
            fmt::format("the wall has {} courses", assembly_.report.courses),
            "lower courses, or push at a box: at = { x, y, width, height }");
      return {};
    }
    std::vector<std::size_t> found;
    const int first = course - (at.courses - 1) / 2;
    for (int c = first; c < first + at.courses; ++c) {
      const std::size_t b = nearest_block(at.x, at.y, c);
      if (b < assembly_.blocks.size()) found.push_back(b);
    }
    if (static_cast<int>(found.size()) < at.courses)
      fault("at.courses", std::to_string(at.courses), "reaches beyond the wall",
            "lower courses or move the point");
    return found;
  }

  // Distance from a point to a block's bounding box; 0 inside.
  [[nodiscard]] double distance(std::size_t b, double x, double y) const {
    double x0 = 1e300, x1 = -1e300, y0 = 1e300, y1 = -1e300;
    for (const Vec2& v : assembly_.blocks[b].outline) {
      x0 = std::min(x0, v.x);
      x1 = std::max(x1, v.x);
      y0 = std::min(y0, v.y);
      y1 = std::max(y1, v.y);
    }
    return elementary::hypot(std::max({0.0, x0 - x, x - x1}), std::max({0.0, y0 - y, y - y1}));
  }

  // Nearest block in a course, or in any for course = -1; one past the last block where there is none.
  [[nodiscard]] std::size_t nearest_block(double x, double y, int course) const {
    std::size_t best = assembly_.blocks.size();
    double least = 1e300;
    for (std::size_t b = 0; b < assembly_.blocks.size(); ++b) {
      const geometry::Block& block = assembly_.blocks[b];
      if (block.role == Role::kSupport || (course >= 0 && block.course != course)) continue;
      const Vec2 c = centroid_of(b);
      // by box first; centroids decide between neighbours that both touch the point
      const double d = course >= 0 ? distance(b, x, c.y) : distance(b, x, y);
      const double score = d + 1e-6 * elementary::hypot(c.x - x, course >= 0 ? 0.0 : c.y - y);
      if (score < least) {
        least = score;
        best = b;
      }
    }
    return best;
  }

  const ModelSpec& spec_;
  const Assembly& assembly_;
  const BlockMap& map_;
  const std::vector<PointLoad>& floors_;
  Model& model_;
  FaultList& faults_;
  std::string path_;
  bool has_factor_ = false, floors_lie_ = false;
};

}  // namespace

std::size_t stage_of_floors(const ModelSpec& spec, FaultList& faults) {
  const std::size_t none = spec.stage.size();
  std::size_t gravity = none, asked = none;
  const auto fault = [&](std::size_t k, std::string problem, std::string cure) {
    faults.add({"", fmt::format("stage.{}.floors", k), "", std::move(problem), std::move(cure), 0});
  };
  for (std::size_t k = 0; k < none; ++k) {
    const StageSpec& s = spec.stage[k];
    if (s.kind() == StageKind::kGravity) gravity = std::min(gravity, k);
    if (const auto* load = std::get_if<LoadStage>(&s.action); !load || !load->floors) continue;
    if (spec.floor.empty())
      fault(k, "there is no floor to set on the wall",
            "write [[floor]] tables, or leave floors out");
    if (asked < none)
      fault(k, "the floors lie on the wall already", "let one stage set them, all together");
    asked = std::min(asked, k);
  }
  const std::size_t found = asked < none ? asked : gravity;
  if (found == none && !spec.floor.empty())
    faults.add({"", "floor.0", "", "no stage sets it on the wall",
                "add a gravity stage, or a load stage with floors = true", 0});
  for (std::size_t k = 0; k < found && found < none && !spec.floor.empty(); ++k) {
    if (!drives(spec.stage[k].kind())) continue;
    fault(found, fmt::format("would lie on the wall only after stage.{} has moved it", k),
          "put the stage that sets them before it");
    break;
  }
  return found;
}

void set_manner(StageSpec& stage) {
  if (auto* load = std::get_if<LoadStage>(&stage.action); load && load->as == Manner::kDefault)
    load->as = Manner::kPressure;
  if (auto* push = std::get_if<PushStage>(&stage.action); push && push->as == Manner::kDefault)
    push->as = Manner::kSpreader;
}

void set_targets(const std::string& path, PushStage& s, const Stage& stage, FaultList& faults) {
  if (const auto found = fault_of_protocol(s))
    faults.add({"", path + "." + found->key, found->value, found->problem, found->cure, 0});
  else if (!s.drifts.empty() && !stage.driven.empty() && !(stage.load_height > 0))
    faults.add({"", path + ".drifts", "", "have no height: what is pushed is at the wall's foot",
                "write the levels as amplitudes", 0});
  else
    s.targets = targets_of(s, stage.load_height);
}

void compile_stages(const ModelSpec& spec, const Assembly& assembly, const BlockMap& map,
                    const std::vector<PointLoad>& floors, Model& model, FaultList& faults) {
  StageCompiler(spec, assembly, map, floors, model, faults).run();
}

}  // namespace wythe
