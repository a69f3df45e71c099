// Derives limit loads from stages: the last push, body force or tilt grows; stages before it give the dead loads. A
// factor multiplies the weights of blocks, and vertical loads only if they are declared as masses. The `secant` of a
// tilt, 1/cos, multiplies dead point loads only. with_rigid_bodies() has replaced zones by rigid blocks before.
#include "limit/limit_loads.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/elementary.h"
#include "geometry/polygon.h"
#include "model/parts.h"
#include "wythe/parts/error.h"
#include "wythe/parts/limit.h"
#include "wythe/parts/reading.h"

namespace wythe::limit {
namespace {

void add_dead_loads(const Model& model, double secant, LimitLoads& loads) {
  const Vec3 gravity = gravity_before(model, loads.stage);
  for (std::size_t i = 0; i < loads.dead.size(); ++i) {
    loads.dead[i].fx += gravity.x * model.gravity_mass[i];
    loads.dead[i].fy += gravity.y * model.gravity_mass[i];
  }
  for (const Stage& stage : model.stages) {
    if (&stage == loads.stage) break;
    for (const PointLoad& p : stage.loads) {
      BlockForce& f = loads.dead[p.block];
      f.fx += secant * p.fx;
      f.fy += secant * p.fy;
      f.moment += secant * (p.arm_x * p.fy - p.arm_y * p.fx);
    }
  }
}

void add_push(const Stage& push, LimitLoads& loads) {
  loads.together = push.moves_each();
  const FixitySpec fixity = fixity_of(push.spec);
  const auto n = static_cast<double>(push.driven.size());
  for (std::size_t k = 0; k < push.driven.size(); ++k) {
    const std::size_t i = push.driven[k];
    const double share = push.driven_share[k];
    if (!loads.together) loads.growing[i] = {share * loads.push_x / n, share * loads.push_y / n, 0};
    // the push on a head acts along a line beside its centroid
    if (std::isfinite(push.drive_arm)) loads.growing[i].moment = -push.drive_arm * loads.push_x;
    if (fixity.across == Freedom::kBlocked) loads.held_across[i] = 1;
    // a beam that is kept level stays so, whatever the push states
    if (fixity.rotation == Freedom::kBlocked) loads.held_turn[i] = 1;
  }
}

// Adds vertical loads to the masses that a factor multiplies.
void push_loads(const Model& model, LimitLoads& loads) {
  for (const Stage& stage : model.stages) {
    if (&stage == loads.stage) break;
    for (const PointLoad& p : stage.loads) {
      if (!(p.fy < 0)) continue;  // an uplift is no mass
      const double fx = -p.fy * loads.stage->drive_x, fy = -p.fy * loads.stage->drive_y;
      BlockForce& f = loads.growing[p.block];
      f.fx += fx, f.fy += fy;
      f.moment += p.arm_x * fy - p.arm_y * fx;
    }
  }
}

BlockId body_of(const Solids& solids, std::int32_t node) {
  const auto at = std::find_if(solids.bodies.begin(), solids.bodies.end(), [&](const auto& body) {
    return node < body.first_node + body.n_node;
  });
  return static_cast<BlockId>(at - solids.bodies.begin());
}

// Adds a deformable body as a block with its outline and the weight of its nodes.
void add_block(const Solids& solids, const SolidBody& body, Model& model) {
  geometry::Polygon outline;
  for (const std::int32_t node : body.rim) {
    outline.push_back({solids.node_x[node], solids.node_y[node]});
    model.anatomy.outline_x.push_back(outline.back().x);
    model.anatomy.outline_y.push_back(outline.back().y);
  }
  model.anatomy.outline_begin.push_back(static_cast<int>(model.anatomy.outline_x.size()));
  model.anatomy.block_id.push_back(body.id);
  model.anatomy.block_role.push_back(body.role);
  model.anatomy.block_course.push_back(-1);
  const auto shape = solids.zone_shape[body.first_zone];
  model.anatomy.block_thickness.push_back(solids.shapes[shape].thickness);
  const Vec2 centroid = geometry::moments(outline).centroid;
  model.centroid_x.push_back(centroid.x);
  model.centroid_y.push_back(centroid.y);
  double mass = 0, heavy = 0;
  for (int k = 0; k < body.n_node; ++k) {
    mass += solids.node_mass[body.first_node + k];
    heavy += solids.node_gravity_mass[body.first_node + k];
  }
  model.mass.push_back(mass);
  model.gravity_mass.push_back(heavy);
  model.inertia.push_back(0);  // not used by limit analysis
  model.turn_freedom.push_back(1);
  ++model.n_block;
}

// Adds a contact of zones as a joint between the same rigid block and the body.
void add_joint(const Solids& s, std::size_t c, BlockId body, Model& model) {
  const bool ground = s.contact_block[c] == model.n_block - static_cast<int>(s.bodies.size());
  const BlockId a = ground ? kGroundBlock : s.contact_block[c];
  const double x = 0.5 * (s.arm_0_x[c] + s.arm_1_x[c]), y = 0.5 * (s.arm_0_y[c] + s.arm_1_y[c]);
  const auto i = static_cast<std::size_t>(a), b = static_cast<std::size_t>(body);
  model.joint_a.push_back(a);
  model.joint_b.push_back(body);
  model.joint_material.push_back(s.contact_material[c]);
  model.arm_a_x.push_back(x);
  model.arm_a_y.push_back(y);
  model.arm_b_x.push_back(x + (ground ? 0 : model.centroid_x[i]) - model.centroid_x[b]);
  model.arm_b_y.push_back(y + (ground ? 0 : model.centroid_y[i]) - model.centroid_y[b]);
  model.half_x.push_back(0.5 * (s.arm_1_x[c] - s.arm_0_x[c]));
  model.half_y.push_back(0.5 * (s.arm_1_y[c] - s.arm_0_y[c]));
  model.tangent_x.push_back(s.contact_tangent_x[c]);
  model.tangent_y.push_back(s.contact_tangent_y[c]);
  model.area.push_back(s.contact_area[c]);
  const bool lintel = model.anatomy.block_role[b] == BlockRole::kLintel;
  model.anatomy.joint_kind.push_back(lintel ? JointKind::kLintelBond : JointKind::kOther);
  ++model.n_joint;
}

}  // namespace

Vec3 gravity_before(const Model& model, const Stage* grows) {
  const double g = model.solve.gravity;
  Vec3 gravity;
  for (const Stage& s : model.stages) {
    const bool now = &s == grows;
    if (s.spec.kind() == StageKind::kGravity || (now && is_factor(s))) gravity = {0, -g, 0};
    if (now) break;
    if (const auto* force = std::get_if<BodyForceStage>(&s.spec.action))
      gravity = Vec3{0, -g, 0} + g * force->factor * s.drive();
    if (const auto* tilt = std::get_if<TiltStage>(&s.spec.action))
      gravity = g * elementary::sin(tilt->tilt_until) * s.drive() +
                Vec3{0, -g * elementary::cos(tilt->tilt_until), 0};
  }
  return gravity;
}

bool has_weight(const Model& model, const Stage* grows) {
  if (!(model.solve.gravity > 0)) return false;
  for (const Stage& s : model.stages) {
    if (s.spec.kind() == StageKind::kGravity || is_factor(s)) return true;
    if (&s == grows) break;
  }
  return false;
}

const Stage* growing_stage(const Model& model) {
  const Stage* found = nullptr;
  for (const Stage& s : model.stages)
    if (s.push() != nullptr || is_factor(s)) found = &s;
  return found;
}

bool goes_back(const Stage& push) {
  const auto targets = push.targets();
  return !targets.empty() &&
         std::all_of(targets.begin(), targets.end(), [](double t) { return t <= 0; });
}

LimitLoads limit_loads(const Model& model, double secant, bool loads_are_masses) {
  LimitLoads loads;
  loads.stage = growing_stage(model);
  if (loads.stage == nullptr)
    throw InputError({{.path = "stage",
                       .problem = "no stage has a load that grows",
                       .cure = "add a push, e.g. at = { x = \"0 m\", y = \"3.12 m\" }, or a "
                               "body_force stage"}});
  const std::size_t n = model.n_block;
  loads.dead.resize(n);
  loads.growing.resize(n);
  loads.held_across.assign(n, 0);
  loads.held_turn.assign(n, 0);
  for (std::size_t i = 0; i < n; ++i) loads.held_turn[i] = model.turn_freedom[i] == 0;
  const double sense = goes_back(*loads.stage) ? -1 : 1;
  loads.push_x = sense * loads.stage->drive_x;
  loads.push_y = sense * loads.stage->drive_y;
  add_dead_loads(model, secant, loads);
  loads.is_force = !is_factor(*loads.stage);
  if (loads.is_force) {
    add_push(*loads.stage, loads);
    return loads;
  }
  for (std::size_t i = 0; i < n; ++i) {
    const double w = model.solve.gravity * model.gravity_mass[i];
    loads.growing[i] = {w * loads.stage->drive_x, w * loads.stage->drive_y, 0};
  }
  if (loads_are_masses) push_loads(model, loads);
  return loads;
}

}  // namespace wythe::limit

namespace wythe {

Model with_rigid_bodies(Model model) {
  if (model.solids.bodies.empty()) return model;
  const Solids solids = std::move(model.solids);
  model.solids = {};
  const int first = model.n_block;
  for (const SolidBody& body : solids.bodies) limit::add_block(solids, body, model);
  for (std::size_t c = 0; c < static_cast<std::size_t>(solids.n_contact); ++c)
    limit::add_joint(solids, c, first + limit::body_of(solids, solids.contact_p[c]), model);
  list_joints_of_blocks(model);
  return model;
}

namespace {

// The direction of a stage and its opposite, in the words of the file.
std::pair<std::string, std::string> ways_of(const DriveSpec& drive) {
  if (drive.along.size() == 3) {
    const auto text = [&](double sign) {
      return fmt::format("[{:g}, {:g}, {:g}]", sign * drive.along[0], sign * drive.along[1],
                         sign * drive.along[2]);
    };
    return {text(1), text(-1)};
  }
  const std::string way = word_of(kDirectionWords, drive.direction);
  return {way, (way[0] == '+' ? "-" : "+") + way.substr(1)};
}

void note_stages(const Model& model, std::vector<Message>& notes) {
  const Stage* grows = limit::growing_stage(model);
  if (grows == nullptr) return;
  const std::string name = "\"" + grows->spec.name + "\"";
  std::string before, after;
  bool later = false;
  for (const Stage& s : model.stages) {
    if (&s == grows) {
      later = true;
    } else if (!later && s.push() != nullptr) {
      before += (before.empty() ? "\"" : ", \"") + s.spec.name + "\"";
    } else if (later && !s.loads.empty()) {
      after += (after.empty() ? "\"" : ", \"") + s.spec.name + "\"";
    }
  }
  if (!limit::has_weight(model, grows)) notes.push_back({"limit.weightless", {{"stage", name}}});
  if (!before.empty())
    notes.push_back({"limit.after_pushes", {{"stage", name}, {"before", before}}});
  if (!after.empty()) notes.push_back({"limit.later_loads", {{"stage", name}, {"after", after}}});
  const auto targets = grows->targets();
  const bool forth = std::any_of(targets.begin(), targets.end(), [](double t) { return t > 0; });
  const bool back = std::any_of(targets.begin(), targets.end(), [](double t) { return t < 0; });
  const auto [along, against] = ways_of(drive_of(grows->spec));
  if (forth && back)
    notes.push_back({"limit.both_ways",
                     {{"stage", name},
                      {"direction", along},
                      {"key", "stage." + grows->spec.name + ".direction"},
                      {"other", against}}});
  if (limit::goes_back(*grows))
    notes.push_back({"limit.backwards", {{"stage", name}, {"direction", against}}});
}

}  // namespace

std::vector<Message> left_aside(const Model& model) {
  std::vector<Message> notes;
  note_stages(model, notes);
  const Stage* grows = limit::growing_stage(model);
  if (model.standing.any() && grows != nullptr)
    notes.push_back({"limit.stands_in", {{"stage", "\"" + grows->spec.name + "\""}}});
  // masses that a body force or a tilt ignores
  for (const Message& note : model.anatomy.notes)
    if (note.code.starts_with("body_force.") || note.code.starts_with("tilt."))
      notes.push_back(note);
  const auto& kinds = model.anatomy.joint_kind;
  const bool chain = std::find(kinds.begin(), kinds.end(), JointKind::kLintelChain) != kinds.end();
  if (chain || !model.solids.bodies.empty()) notes.push_back({"limit.rigid_lintels"});
  return notes;
}

// Measured: 0.6 s for 5 600 rows, 12 s for 32 000 (docs/decisions/0017).
// In space: 1 s for 1 200 points, 80 s for 16 600.
double expected_seconds(const Model& model) {
  if (dimension_of(model) == 3) return 8 * elementary::pow(model.n_point() / 16600.0, 1.4);
  const double rows = 3.0 * model.n_block + 2.0 * (model.n_joint + model.solids.n_contact);
  return 12 * elementary::pow(rows / 32000, 1.5);
}

bool has_bond(const Model& model) {
  const auto bonds = [&](std::int32_t material) {
    const JointMaterial& m = model.materials[material];
    return m.tensile_strength > 0 && std::isfinite(m.tensile_strength);
  };
  const auto& contacts = model.solids.contact_material;
  return std::any_of(model.joint_material.begin(), model.joint_material.end(), bonds) ||
         std::any_of(contacts.begin(), contacts.end(), bonds);
}

}  // namespace wythe
