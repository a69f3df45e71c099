// limit_load(): both programmes, and the reason where there is no answer. quick_limit_load(): one of them.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <exception>
#include <limits>

#include "limit/in_space.h"
#include "limit/plane/programmes.h"
#include "limit/standing.h"
#include "wythe/parts/error.h"
#include "wythe/parts/limit.h"
#include "wythe/parts/quick_limit.h"

namespace wythe {
namespace {

using namespace limit;

// How far to search, and whether the static programme's dual is the kinematic answer.
struct Search {
  Tolerance tolerance;
  bool by_dual;
};
constexpr Search kFull{kExact, false}, kFast{kQuick, true};
constexpr double kGap = 1e-6;  // of both theorems, relative, at most [-]

// A quick search whose answer may be wrong by more than kQuickError.
struct Unsure : std::exception {};

[[noreturn]] void refuse(std::string path, std::string value, std::string problem,
                         std::string cure) {
  throw InputError({{.path = std::move(path),
                     .value = std::move(value),
                     .problem = std::move(problem),
                     .cure = std::move(cure)}});
}

std::string name_of(const Model& model, BlockId block) {
  if (block == kGroundBlock) return "the ground";
  if (block >= model.n_block) return model.space.body[block].id;  // a support
  return model.anatomy.block_id[block];
}

std::string joint_text(const Model& model, int joint) {
  return fmt::format("the joint between {} and {} ({})", name_of(model, model.joint_a[joint]),
                     name_of(model, model.joint_b[joint]),
                     model.material_names[model.joint_material[joint]]);
}

bool has_joint(const Model& model, BlockId block) {
  return model.block_begin[block + 1] > model.block_begin[block];
}

[[noreturn]] void refuse_unbalanced(const Model& model, const Unbalanced& worst) {
  if (worst.block < 0)
    refuse("wall", "", "limit analysis found no state in balance",
           "check the joints' strengths with wythe check");
  const std::string block = name_of(model, worst.block);
  if (!has_joint(model, worst.block))
    refuse("wall.block", block, "flies: no joint holds it", "move it onto its neighbours");
  refuse("wall.block", block,
         fmt::format("cannot stand under the dead loads alone: {:.3g} kN are left unbalanced",
                     1e-3 * worst.force),
         "support it, give its joints friction or cohesion, or lower the dead loads");
}

[[noreturn]] void refuse_unsolved() {
  refuse("wall", "", "its linear programme was not solved: round-off is larger than the answer",
         "look for joints or blocks a thousand times smaller or stronger than the rest");
}

// Loads that can be carried lie side by side, but not always from nothing on: a wall that dead loads bring down may
// stand while the growing load holds it up.
void check_it_stands_alone(const Model& model, const Unbalanced& without_load) {
  if (without_load.status == ProgrammeStatus::kStopped) throw LimitStopped();
  if (without_load.status != ProgrammeStatus::kOptimal) refuse_unsolved();
  if (without_load.block >= 0) refuse_unbalanced(model, without_load);
}

// `carrier`: a joint or, after those, a link.
[[noreturn]] void refuse_unlimited(const Model& model, int carrier) {
  const std::string name = carrier < 0               ? "some joint"
                           : carrier < model.n_joint ? joint_text(model, carrier)
                                                     : model.links.name[carrier - model.n_joint];
  refuse(
      "stage", "",
      fmt::format("the load can grow without end: no mechanism exists, {} carries any force", name),
      "push where blocks can move, give that joint or tie a strength, or count crushing. What "
      "friction holds between blocks that cannot give way counts as pressed together; a run "
      "tells whether it is");
}

// Entries of the model's own blocks and joints; its deformable ones came after them.
void keep_first(const Model& model, LimitResult& answer) {
  const std::size_t blocks = model.n_block;
  const std::size_t joints = model.n_joint;
  const std::size_t points = answer.point_force.size() / answer.shear_force.size();
  for (auto* motion : {&answer.vx, &answer.vy, &answer.omega}) motion->resize(blocks);
  answer.shear_force.resize(joints);
  answer.point_force.resize(joints * points);
}

Monitor monitor_from(const LimitMonitor& monitor, double from, double to) {
  return [&monitor, from, to](double share) {
    if (monitor.progress) monitor.progress(from + share * (to - from));
    return monitor.stop != nullptr && monitor.stop->load();
  };
}

// A wall on tilted ground, with everything divided by the cosine: weights W (tan, -1), while strengths
// and loads of fixed direction grow by 1/cos of the tilt. The tilt of one solution gives the factor of
// the next; a dry wall without loads needs only the first, whose factor is 1.
double secant_of(double tangent) { return std::sqrt(1 + tangent * tangent); }

// What is solved, and how its answer is written down, in the plane and in space.
struct InPlane {
  LimitLoads loads;
  YieldModel yield;
  Units units;
  StaticSolution by_forces;

  InPlane(const Model& model, const LimitOptions& options, double secant, bool masses)
      : loads(limit_loads(model, secant, masses)),
        yield(yield_of(model, options, secant)),
        units(units_of(model, loads, yield)) {}

  void write(const KinematicSolution& by_motion, LimitResult& answer) const {
    answer.shear_force = by_forces.shear;
    answer.point_force = by_forces.point_force;
    answer.vx = by_motion.vx;
    answer.vy = by_motion.vy;
    answer.omega = by_motion.omega;
    answer.cuts = static_cast<int>(yield.tangent.size());
  }
};
struct InSpace {
  SpaceLoads loads;
  SpaceYield yield;
  Units units;
  SpaceStaticSolution by_forces;

  InSpace(const Model& model, const LimitOptions& options, double secant, bool masses)
      : loads(space_loads(model, secant, masses)),
        yield(space_yield(model, options, secant)),
        units(units_of(model, loads)) {}

  void write(const SpaceKinematicSolution& by_motion, LimitResult& answer) const {
    answer.point_force = by_forces.compression;
    answer.shear_force = by_forces.shear_1;
    answer.shear_force_2 = by_forces.shear_2;
    answer.friction_excess = by_forces.friction_excess;
    for (std::size_t i = 0; i < by_motion.velocity.size(); ++i) {
      answer.vx.push_back(by_motion.velocity[i].x);
      answer.vy.push_back(by_motion.velocity[i].y);
      answer.vz.push_back(by_motion.velocity[i].z);
      answer.omega_x.push_back(by_motion.spin[i].x);
      answer.omega_y.push_back(by_motion.spin[i].y);
      answer.omega.push_back(by_motion.spin[i].z);
    }
  }
};

template <class Wall>
Wall solve_by_forces(const Model& model, const LimitOptions& options, const Search& search,
                     double secant, const LimitMonitor& monitor) {
  Wall p(model, options, secant, options.loads_are_masses);
  const Monitor part_monitor = monitor_from(monitor, 0, 0.5);
  p.by_forces = solve_static(model, p.loads, p.yield, p.units, part_monitor, search.tolerance);
  if (p.by_forces.status == ProgrammeStatus::kStopped) throw LimitStopped();
  if (search.by_dual && p.by_forces.status == ProgrammeStatus::kFailed) throw Unsure();
  if (p.by_forces.status == ProgrammeStatus::kInfeasible)
    refuse_unbalanced(model, find_unbalanced(model, p.loads, p.yield, p.units, part_monitor));
  if (p.by_forces.status == ProgrammeStatus::kUnbounded) {
    // the load may grow beside a wall that falls: both are proofs, and the solver gives one
    check_it_stands_alone(model, find_unbalanced(model, p.loads, p.yield, p.units, part_monitor));
    refuse_unlimited(model, p.by_forces.carrier);
  }
  return p;
}

// `solve(secant)` gives the programmes for one factor of the loads that do not turn. A tilt is the root of the load that
// they give at it less its own tangent, found by secants: a wall that stands dry has one root alone (theory 6.1).
template <class Solve>
auto solve_tilted(const Search& search, const Solve& solve) {
  constexpr int kTilts = 40;
  constexpr double kVertical = 1e3;  // tangent of the steepest tilt [-]
  auto p = solve(1.0);
  if (p.loads.stage->spec.kind() != StageKind::kTilt) return p;
  double before = 0, excess_before = p.by_forces.load, tangent = p.by_forces.load;
  double stands = 0, falls = std::numeric_limits<double>::infinity();
  for (int i = 0; i < kTilts && p.by_forces.status == ProgrammeStatus::kOptimal; ++i) {
    p = solve(secant_of(tangent));
    const double excess = p.by_forces.load - tangent;
    const double slope = (excess - excess_before) / (tangent - before);
    const double error =
        search.by_dual ? 0.1 * kQuickError * std::fabs(tangent) : 1e-9 * secant_of(tangent);
    if (excess == 0 || (slope < 0 && std::fabs(excess) <= -slope * error)) return p;
    (excess > 0 ? stands : falls) = tangent;
    if (stands >= kVertical)
      refuse("stage", p.loads.stage->spec.name, "no tilt up to 90 degrees brings the wall down",
             "push it by a force that grows");
    before = tangent, excess_before = excess;
    tangent -= excess / slope;
    if (slope < 0 && tangent > stands && tangent < falls) continue;
    tangent = std::isfinite(falls) ? 0.5 * (stands + falls) : 8 * p.by_forces.load;
  }
  refuse("stage", p.loads.stage->spec.name, "the wall's limit tilt could not be found",
         "use a body force, which needs no second look");
}

// Whether the wall stands without the growing load, in the plane or in space. The programme of unbalanced forces takes
// longer, and names the block that does not.
template <class Wall>
void check_rest(const Model& model, const Search& search, const Wall& wall, const Units& units,
                const LimitMonitor& monitor) {
  const Monitor part_monitor = monitor_from(monitor, 1, 1);
  if (search.by_dual) {
    const ProgrammeStatus found = find_rest(model, wall.loads, wall.yield, units, part_monitor);
    if (found == ProgrammeStatus::kStopped) throw LimitStopped();
    if (found == ProgrammeStatus::kOptimal) return;
  }
  check_it_stands_alone(model, find_unbalanced(model, wall.loads, wall.yield, units, part_monitor));
}

// What both programmes say of a wall, in the plane or in space.
template <class Wall, class Kinematic>
LimitResult answer_of(const LimitOptions& options, const Search& search, const Wall& p,
                      const Kinematic& by_motion) {
  LimitResult answer;
  answer.options = options;
  answer.is_force = p.loads.is_force;
  const auto without_round_off = [&](double load) {
    const double least = 1e-9 * (p.loads.is_force ? p.units.force : 1.0);
    return std::fabs(load) < least ? 0.0 : load;
  };
  if (search.by_dual && p.by_forces.error > kQuickError * std::fabs(p.by_forces.load))
    throw Unsure();
  answer.load = without_round_off(p.by_forces.load);
  answer.kinematic = without_round_off(by_motion.load);
  answer.dissipation = by_motion.dissipation;
  answer.rows = p.by_forces.rows;
  answer.columns = p.by_forces.columns;
  answer.accuracy = std::max(p.by_forces.accuracy, by_motion.accuracy);
  const double least = kGap * (p.loads.is_force ? p.units.force : 1.0);
  const double gap = std::fabs(answer.kinematic - answer.load);
  if (!search.by_dual && gap > kGap * std::fabs(answer.load) + least)
    refuse("wall", "",
           fmt::format("its limit load is not known: the theorems give {:.6g} and {:.6g}",
                       answer.load, answer.kinematic),
           "look for joints or blocks a thousand times smaller or stronger than the rest");
  return answer;
}

template <class Wall>
LimitResult limit_in(const Model& model, const LimitOptions& options, const Search& search,
                     const LimitMonitor& monitor) {
  const Wall p = solve_tilted(search, [&](double secant) {
    return solve_by_forces<Wall>(model, options, search, secant, monitor);
  });
  const auto by_motion = search.by_dual ? p.by_forces.dual
                                        : solve_kinematic(model, p.loads, p.yield, p.units,
                                                          monitor_from(monitor, 0.5, 1));
  if (by_motion.status == ProgrammeStatus::kStopped) throw LimitStopped();
  if (by_motion.status == ProgrammeStatus::kInfeasible) refuse_unlimited(model, -1);
  if (p.by_forces.status != ProgrammeStatus::kOptimal ||
      by_motion.status != ProgrammeStatus::kOptimal)
    refuse_unsolved();
  // at rest a tilted wall has its loads and strengths as they are, not those over the cosine of its limit tilt
  const bool is_tilt = p.loads.stage->spec.kind() == StageKind::kTilt;
  check_rest(model, search, is_tilt ? Wall(model, options, 1, false) : p, p.units, monitor);
  LimitResult answer = answer_of(options, search, p, by_motion);
  answer.link_force = p.by_forces.link_force;
  p.write(by_motion, answer);
  return answer;
}

LimitResult limit_of(const Model& model, const LimitOptions& options, const Search& search,
                     const LimitMonitor& monitor) {
  if (model.standing.any()) {
    const StandingWall wall(model);
    LimitResult answer = limit_of(wall.model, options, search, monitor);
    wall.spread_out(answer);
    return answer;
  }
  if (!model.solids.bodies.empty()) {
    LimitResult answer = limit_of(with_rigid_bodies(model), options, search, monitor);
    keep_first(model, answer);
    return answer;
  }
  if (!model.space.solids.bodies.empty())
    refuse("wall.blocks." + model.space.solids.bodies.front().body.id + ".zones", "",
           "is a deformable block in space, and limit analysis in space knows rigid blocks alone",
           "leave zones out, or give the lintel model = \"segments\", for this analysis");
  if (model.frames.n > 0)
    refuse("frame", model.frames.name.front(),
           "bends and yields, and limit analysis knows no frames",
           "leave it out for this analysis; the run takes it");
  const auto& kinds = model.anatomy.joint_kind;  // mortar alone has no fibres
  if (model.layers.n > 0 || std::find(kinds.begin(), kinds.end(), JointKind::kCoat) != kinds.end())
    refuse("layer", model.layers.n > 0 ? model.layers.name.front() : "mortar",
           "detaches and breaks, and limit analysis knows no layers",
           "leave it out for this analysis; the run takes it");
  const Stage* grows = growing_stage(model);
  if (grows != nullptr && grows->push() == nullptr && !has_weight(model, grows))
    refuse("solve.gravity", fmt::format("{:g} m/s^2", model.solve.gravity),
           "is nothing, and the load of stage \"" + grows->spec.name +
               "\" is a share of the blocks' weight",
           "give gravity, or push with a force");
  const auto start = std::chrono::steady_clock::now();
  if (model.in_space() && options.crushing == CrushingChoice::kStressBlock)
    refuse("crushing", "stress block", "is for walls in their plane",
           "let each contact point carry its share of fc A");
  LimitResult answer = model.in_space() ? limit_in<InSpace>(model, options, search, monitor)
                                        : limit_in<InPlane>(model, options, search, monitor);
  answer.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return answer;
}

}  // namespace

LimitResult limit_load(const Model& model, const LimitOptions& options,
                       const LimitMonitor& monitor) {
  return limit_of(model, options, kFull, monitor);
}

LimitResult quick_limit_load(const Model& model, const LimitOptions& options,
                             const LimitMonitor& monitor) {
  if (options.crushing == CrushingChoice::kStressBlock) return limit_load(model, options, monitor);
  try {
    return limit_of(model, options, kFast, monitor);
  } catch (const Unsure&) {
    return limit_load(model, options, monitor);
  }
}

}  // namespace wythe
