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
                                    const YieldModel& yield, const Units& units) {
  const Unbalanced worst = find_unbalanced(model, loads, yield, units);
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
  refuse("stage", "",
         fmt::format("the load can grow without end: no mechanism exists, {} carries any force",
                     between),
         "push where blocks can move, give that joint a strength, or count crushing");
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

}  // namespace

LimitAnswer limit_load(const Model& model, const LimitOptions& options) {
  if (!model.solids.bodies.empty()) {
    LimitAnswer answer = limit_load(with_rigid_bodies(model), options);
    keep_first(model, answer);
    return answer;
  }
  const auto start = std::chrono::steady_clock::now();
  const LimitLoads loads = limit_loads(model);
  YieldModel yield = yield_of(model, options);
  const Units units = units_of(model, loads, yield);
  const StaticAnswer by_forces = solve_static(model, loads, yield, units);
  if (by_forces.status == ProgrammeStatus::kInfeasible)
    refuse_unbalanced(model, loads, yield, units);
  if (by_forces.status == ProgrammeStatus::kUnbounded) refuse_unlimited(model, by_forces, yield);
  const KinematicAnswer by_motion = solve_kinematic(model, loads, yield, units);
  if (by_motion.status == ProgrammeStatus::kInfeasible) refuse_unlimited(model, by_forces, yield);
  if (by_forces.status != ProgrammeStatus::kOptimal ||
      by_motion.status != ProgrammeStatus::kOptimal)
    throw std::runtime_error("limit analysis: the linear programme was not solved");
  LimitAnswer answer;
  answer.options = options;
  answer.is_force = loads.is_force;
  const auto without_round_off = [&](double load) {
    const double least = 1e-9 * (loads.is_force ? units.force : 1.0);
    return std::fabs(load) < least ? 0.0 : load;
  };
  answer.load = without_round_off(by_forces.load);
  answer.kinematic = without_round_off(by_motion.load);
  answer.shear_force = by_forces.shear;
  answer.point_force = by_forces.point_force;
  answer.vx = by_motion.vx;
  answer.vy = by_motion.vy;
  answer.omega = by_motion.omega;
  answer.dissipation = by_motion.dissipation;
  answer.rows = by_forces.rows;
  answer.columns = by_forces.columns;
  answer.cuts = static_cast<int>(yield.tangent.size());
  answer.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return answer;
}

}  // namespace wythe
