// limit_load(): both programmes, and words for what has no answer.
#include <fmt/format.h>

#include <chrono>
#include <cmath>

#include "limit/programmes.h"
#include "wythe/error.h"
#include "wythe/limit.h"

namespace wythe {
namespace {

using namespace limit;

[[noreturn]] void refuse(std::string path, std::string value, std::string problem,
                         std::string cure) {
  throw InputError({{.file = "",
                     .path = std::move(path),
                     .value = std::move(value),
                     .problem = std::move(problem),
                     .cure = std::move(cure)}});
}

std::string name_of(const Model& model, BlockId block) {
  return model.anatomy.block_id[static_cast<std::size_t>(block)];
}

bool has_joint(const Model& model, BlockId block) {
  const auto i = static_cast<std::size_t>(block);
  return model.block_begin[i + 1] > model.block_begin[i];
}

[[noreturn]] void refuse_unbalanced(const Model& model, const LimitLoads& loads,
                                    const YieldModel& yield, const Units& units,
                                    const Watch& watch) {
  const Unbalanced worst = find_unbalanced(model, loads, yield, units, watch);
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

// The joint that carries most of a load without limit.
[[noreturn]] void refuse_unlimited(const Model& model, const StaticAnswer& answer,
                                   const YieldModel& yield) {
  std::string between = "its joints";
  const std::size_t stride = 1 + yield.points();
  double most = 0;
  for (int j = 0; j < model.n_joint; ++j) {
    for (std::size_t k = 0; k < stride; ++k) {
      const std::size_t at = 1 + static_cast<std::size_t>(j) * stride + k;
      if (at >= answer.ray.size() || std::fabs(answer.ray[at]) <= most) continue;
      most = std::fabs(answer.ray[at]);
      const BlockId a = model.joint_a[j];
      between = fmt::format(
          "the joint between {} and {} ({})", a == kGroundBlock ? "the ground" : name_of(model, a),
          name_of(model, model.joint_b[j]), model.material_names[model.joint_material[j]]);
    }
  }
  for (std::size_t k = 0; k < yield.link.size(); ++k) {
    const std::size_t at = 1 + static_cast<std::size_t>(model.n_joint) * stride + k;
    if (at >= answer.ray.size() || std::fabs(answer.ray[at]) <= most) continue;
    most = std::fabs(answer.ray[at]);
    between = model.links.name[k];
  }
  refuse("stage", "",
         fmt::format("the load can grow without end: no mechanism exists, {} carries any force",
                     between),
         "push where blocks can move, give that joint or tie a strength, or count crushing");
}

// Entries of the model's own blocks and joints; its deformable ones came after them.
void keep_first(const Model& model, LimitAnswer& answer) {
  const auto blocks = static_cast<std::size_t>(model.n_block);
  const auto joints = static_cast<std::size_t>(model.n_joint);
  const std::size_t points = answer.point_force.size() / answer.shear_force.size();
  for (auto* motion : {&answer.vx, &answer.vy, &answer.omega}) motion->resize(blocks);
  answer.shear_force.resize(joints);
  answer.point_force.resize(joints * points);
}

Watch watch_from(const LimitWatch& watch, double from, double to) {
  return [&watch, from, to](double share) {
    if (watch.progress) watch.progress(from + share * (to - from));
    return watch.stop != nullptr && watch.stop->load();
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
  StaticAnswer by_forces;
};

Programmes solve_by_forces(const Model& model, const LimitOptions& options, double secant,
                           const LimitWatch& watch) {
  Programmes p{limit_loads(model, secant), yield_of(model, options, secant), {}, {}};
  p.units = units_of(model, p.loads, p.yield);
  const Watch ask = watch_from(watch, 0, 0.5);
  p.by_forces = solve_static(model, p.loads, p.yield, p.units, ask);
  if (p.by_forces.status == ProgrammeStatus::kStopped) throw LimitStopped();
  if (p.by_forces.status == ProgrammeStatus::kInfeasible)
    refuse_unbalanced(model, p.loads, p.yield, p.units, ask);
  if (p.by_forces.status == ProgrammeStatus::kUnbounded)
    refuse_unlimited(model, p.by_forces, p.yield);
  return p;
}

Programmes solve_tilted(const Model& model, const LimitOptions& options, const LimitWatch& watch) {
  constexpr int kTilts = 60;
  constexpr double kSame = 1e-10;
  Programmes p = solve_by_forces(model, options, 1, watch);
  if (p.loads.stage->spec.kind != StageKind::kTilt) return p;
  for (int i = 0; i < kTilts && p.by_forces.status == ProgrammeStatus::kOptimal; ++i) {
    const double before = p.by_forces.load;
    p = solve_by_forces(model, options, secant_of(before), watch);
    if (std::fabs(p.by_forces.load - before) <= kSame * secant_of(before)) return p;
  }
  refuse("stage", p.loads.stage->spec.name, "the wall's limit tilt could not be found",
         "use a body force, which needs no second look");
}

}  // namespace

LimitAnswer limit_load(const Model& model, const LimitOptions& options, const LimitWatch& watch) {
  if (model.in_space())
    refuse("wall.blocks", "", "is a wall in space, and limit analysis is for walls in their plane",
           "run it: a body force that grows gives the load it carries");
  if (!model.solids.bodies.empty()) {
    LimitAnswer answer = limit_load(with_rigid_bodies(model), options, watch);
    keep_first(model, answer);
    return answer;
  }
  const auto start = std::chrono::steady_clock::now();
  const Programmes p = solve_tilted(model, options, watch);
  const StaticAnswer& by_forces = p.by_forces;
  const KinematicAnswer by_motion =
      solve_kinematic(model, p.loads, p.yield, p.units, watch_from(watch, 0.5, 1));
  if (by_motion.status == ProgrammeStatus::kStopped) throw LimitStopped();
  if (by_motion.status == ProgrammeStatus::kInfeasible) refuse_unlimited(model, by_forces, p.yield);
  if (by_forces.status != ProgrammeStatus::kOptimal ||
      by_motion.status != ProgrammeStatus::kOptimal)
    refuse("wall", "", "its linear programme was not solved: round-off is larger than the answer",
           "look for joints or blocks a thousand times smaller or stronger than the rest");
  LimitAnswer answer;
  answer.options = options;
  answer.is_force = p.loads.is_force;
  const auto without_round_off = [&](double load) {
    const double least = 1e-9 * (p.loads.is_force ? p.units.force : 1.0);
    return std::fabs(load) < least ? 0.0 : load;
  };
  answer.load = without_round_off(by_forces.load);
  answer.kinematic = without_round_off(by_motion.load);
  answer.shear_force = by_forces.shear;
  answer.point_force = by_forces.point_force;
  answer.link_force = by_forces.link_force;
  answer.vx = by_motion.vx;
  answer.vy = by_motion.vy;
  answer.omega = by_motion.omega;
  answer.dissipation = by_motion.dissipation;
  answer.rows = by_forces.rows;
  answer.columns = by_forces.columns;
  answer.accuracy = std::max(by_forces.accuracy, by_motion.accuracy);
  answer.cuts = static_cast<int>(p.yield.tangent.size());
  answer.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return answer;
}

}  // namespace wythe
