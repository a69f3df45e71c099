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
  const auto j = static_cast<std::size_t>(joint);
  return fmt::format("the joint between {} and {} ({})", name_of(model, model.joint_a[j]),
                     name_of(model, model.joint_b[j]),
                     model.material_names[model.joint_material[j]]);
}

bool has_joint(const Model& model, BlockId block) {
  const auto i = static_cast<std::size_t>(block);
  return model.block_begin[i + 1] > model.block_begin[i];
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

[[noreturn]] void refuse_unlimited(const std::string& carrier) {
  refuse("stage", "",
         fmt::format("the load can grow without end: no mechanism exists, {} carries any force",
                     carrier),
         "push where blocks can move, give that joint or tie a strength, or count crushing. What "
         "friction holds between blocks that cannot give way counts as pressed together; a run "
         "tells whether it is");
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

// The joint that carries most of a load without limit.
[[noreturn]] void refuse_unlimited(const Model& model, const StaticSolution& answer,
                                   const YieldModel& yield) {
  std::string between = "its joints";
  const std::size_t stride = 1 + yield.points();
  double most = 0;
  for (int j = 0; j < model.n_joint; ++j) {
    for (std::size_t k = 0; k < stride; ++k) {
      const std::size_t at = 1 + static_cast<std::size_t>(j) * stride + k;
      if (at >= answer.ray.size() || std::fabs(answer.ray[at]) <= most) continue;
      most = std::fabs(answer.ray[at]);
      between = joint_text(model, j);
    }
  }
  for (std::size_t k = 0; k < yield.link.size(); ++k) {
    const std::size_t at = 1 + static_cast<std::size_t>(model.n_joint) * stride + k;
    if (at >= answer.ray.size() || std::fabs(answer.ray[at]) <= most) continue;
    most = std::fabs(answer.ray[at]);
    between = model.links.name[k];
  }
  refuse_unlimited(between);
}

// Entries of the model's own blocks and joints; its deformable ones came after them.
void keep_first(const Model& model, LimitResult& answer) {
  const auto blocks = static_cast<std::size_t>(model.n_block);
  const auto joints = static_cast<std::size_t>(model.n_joint);
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

struct Programmes {
  LimitLoads loads;
  YieldModel yield;
  Units units;
  StaticSolution by_forces;
};

Programmes solve_by_forces(const Model& model, const LimitOptions& options, const Search& search,
                           double secant, const LimitMonitor& monitor) {
  Programmes p{limit_loads(model, secant, options.loads_are_masses),
               yield_of(model, options, secant),
               {},
               {}};
  p.units = units_of(model, p.loads, p.yield);
  const Monitor part_monitor = monitor_from(monitor, 0, 0.5);
  p.by_forces = solve_static(model, p.loads, p.yield, p.units, part_monitor, search.tolerance);
  if (p.by_forces.status == ProgrammeStatus::kStopped) throw LimitStopped();
  if (search.by_dual && p.by_forces.status == ProgrammeStatus::kFailed) throw Unsure();
  if (p.by_forces.status == ProgrammeStatus::kInfeasible)
    refuse_unbalanced(model, find_unbalanced(model, p.loads, p.yield, p.units, part_monitor));
  if (p.by_forces.status == ProgrammeStatus::kUnbounded) {
    // the load may grow beside a wall that falls: both are proofs, and the solver gives one
    check_it_stands_alone(model, find_unbalanced(model, p.loads, p.yield, p.units, part_monitor));
    refuse_unlimited(model, p.by_forces, p.yield);
  }
  return p;
}

struct SpaceProgrammes {
  SpaceLoads loads;
  SpaceYield yield;
  Units units;
  SpaceStaticSolution by_forces;
};

// What carries most of a load without limit: a joint or, after those, a link.
std::string carrier_text(const Model& model, int carrier) {
  if (carrier < 0) return "its joints";
  if (carrier < model.n_joint) return joint_text(model, carrier);
  return model.links.name[carrier - model.n_joint];
}

SpaceProgrammes solve_by_forces_in_space(const Model& model, const LimitOptions& options,
                                         const Search& search, double secant,
                                         const LimitMonitor& monitor) {
  SpaceProgrammes p{space_loads(model, secant, options.loads_are_masses),
                    space_yield(model, options, secant),
                    {},
                    {}};
  p.units = units_of(model, p.loads);
  const Monitor part_monitor = monitor_from(monitor, 0, 0.5);
  p.by_forces = solve_static(model, p.loads, p.yield, p.units, part_monitor, search.tolerance);
  if (p.by_forces.status == ProgrammeStatus::kStopped) throw LimitStopped();
  if (search.by_dual && p.by_forces.status == ProgrammeStatus::kFailed) throw Unsure();
  if (p.by_forces.status == ProgrammeStatus::kInfeasible)
    refuse_unbalanced(model, find_unbalanced(model, p.loads, p.yield, p.units, part_monitor));
  if (p.by_forces.status == ProgrammeStatus::kUnbounded) {
    check_it_stands_alone(model, find_unbalanced(model, p.loads, p.yield, p.units, part_monitor));
    refuse_unlimited(carrier_text(model, p.by_forces.carrier));
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

// At rest a tilted wall has its loads and strengths as they are, not those over the cosine of its limit tilt.
template <class Programmes>
bool is_tilt(const Programmes& p) {
  return p.loads.stage->spec.kind() == StageKind::kTilt;
}

// Whether the wall stands without the growing load, in the plane or in space. The programme of unbalanced forces takes
// longer, and names the block that does not.
template <class Loads, class Yield>
void check_rest(const Model& model, const Search& search, const Loads& loads, const Yield& yield,
                const Units& units, const LimitMonitor& monitor) {
  const Monitor part_monitor = monitor_from(monitor, 1, 1);
  if (search.by_dual) {
    const ProgrammeStatus found = find_rest(model, loads, yield, units, part_monitor);
    if (found == ProgrammeStatus::kStopped) throw LimitStopped();
    if (found == ProgrammeStatus::kOptimal) return;
  }
  check_it_stands_alone(model, find_unbalanced(model, loads, yield, units, part_monitor));
}

template <class Static, class Kinematic>
void check_solved(const Static& by_forces, const Kinematic& by_motion) {
  if (by_forces.status != ProgrammeStatus::kOptimal ||
      by_motion.status != ProgrammeStatus::kOptimal)
    refuse_unsolved();
}

// What both programmes say of a wall, in the plane or in space.
template <class Programmes, class Kinematic>
LimitResult answer_of(const LimitOptions& options, const Search& search, const Programmes& p,
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

LimitResult limit_in_plane(const Model& model, const LimitOptions& options, const Search& search,
                           const LimitMonitor& monitor) {
  const Programmes p = solve_tilted(search, [&](double secant) {
    return solve_by_forces(model, options, search, secant, monitor);
  });
  const KinematicSolution by_motion =
      search.by_dual
          ? p.by_forces.dual
          : solve_kinematic(model, p.loads, p.yield, p.units, monitor_from(monitor, 0.5, 1));
  if (by_motion.status == ProgrammeStatus::kStopped) throw LimitStopped();
  if (by_motion.status == ProgrammeStatus::kInfeasible)
    refuse_unlimited(model, p.by_forces, p.yield);
  check_solved(p.by_forces, by_motion);
  if (is_tilt(p))
    check_rest(model, search, limit_loads(model), yield_of(model, options), p.units, monitor);
  else
    check_rest(model, search, p.loads, p.yield, p.units, monitor);
  LimitResult answer = answer_of(options, search, p, by_motion);
  answer.shear_force = p.by_forces.shear;
  answer.point_force = p.by_forces.point_force;
  answer.link_force = p.by_forces.link_force;
  answer.vx = by_motion.vx;
  answer.vy = by_motion.vy;
  answer.omega = by_motion.omega;
  answer.cuts = static_cast<int>(p.yield.tangent.size());
  return answer;
}

LimitResult limit_in_space(const Model& model, const LimitOptions& options, const Search& search,
                           const LimitMonitor& monitor) {
  if (options.crushing == CrushingChoice::kStressBlock)
    refuse("crushing", "stress block", "is for walls in their plane",
           "let each contact point carry its share of fc A");
  const SpaceProgrammes p = solve_tilted(search, [&](double secant) {
    return solve_by_forces_in_space(model, options, search, secant, monitor);
  });
  const SpaceKinematicSolution by_motion =
      search.by_dual
          ? p.by_forces.dual
          : solve_kinematic(model, p.loads, p.yield, p.units, monitor_from(monitor, 0.5, 1));
  if (by_motion.status == ProgrammeStatus::kStopped) throw LimitStopped();
  if (by_motion.status == ProgrammeStatus::kInfeasible) refuse_unlimited("some joint");
  check_solved(p.by_forces, by_motion);
  if (is_tilt(p))
    check_rest(model, search, space_loads(model), space_yield(model, options), p.units, monitor);
  else
    check_rest(model, search, p.loads, p.yield, p.units, monitor);
  LimitResult answer = answer_of(options, search, p, by_motion);
  answer.point_force = p.by_forces.compression;
  answer.shear_force = p.by_forces.shear_1;
  answer.shear_force_2 = p.by_forces.shear_2;
  answer.link_force = p.by_forces.link_force;
  answer.friction_excess = p.by_forces.friction_excess;
  for (std::size_t i = 0; i < by_motion.velocity.size(); ++i) {
    answer.vx.push_back(by_motion.velocity[i].x);
    answer.vy.push_back(by_motion.velocity[i].y);
    answer.vz.push_back(by_motion.velocity[i].z);
    answer.omega_x.push_back(by_motion.spin[i].x);
    answer.omega_y.push_back(by_motion.spin[i].y);
    answer.omega.push_back(by_motion.spin[i].z);
  }
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
  LimitResult answer = model.in_space() ? limit_in_space(model, options, search, monitor)
                                        : limit_in_plane(model, options, search, monitor);
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
