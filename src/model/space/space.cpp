// Compiles a wall in space: zones, blocks in principal axes, joints, floors, links, stages, and finally the step.
// Free blocks are numbered first, then supports. Joints between blocks come before those on supports; within each group
// variant of the law, material and number of points order them. A lintel's section is two joints (11.10).
#include "model/space/space.h"

#include "model/coarse_units.h"
#include "model/densities.h"
#include "model/shaking.h"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>

#include "contact/parameters.h"
#include "geometry/blocks_file.h"
#include "geometry/builder/space_frames.h"
#include "model/field_places.h"
#include "model/fields.h"
#include "model/free_shapes.h"
#include "model/idle_inputs.h"
#include "model/joint_laws.h"
#include "model/parts.h"
#include "model/space/space_places.h"
#include "model/space/space_points.h"
#include "model/space/space_roles.h"
#include "model/space/space_solids.h"

namespace wythe {
namespace {

using geometry::JointFace;
using geometry::Shape;
using geometry::SpaceAssembly;

// Refuses parts that a wall in space cannot have yet, by name.
void refuse_plane_parts(const ModelSpec& spec, FaultList& faults) {
  const auto refuse = [&](const char* path, bool is_there,
                          const char* cure = "leave it out, or write it as blocks of the file") {
    if (is_there)
      faults.add({"", path, "", "is for walls in their plane; this one is in space", cure, 0});
  };
  refuse("region", !spec.region.empty(),
         "write it in its wall as [[plan_wall.region]], or give blocks of a file another material");
  refuse("ring_beam", !spec.ring_beam.empty(),
         "write it as a [[plan_wall]] with ring_beam = true, or as blocks of the file");
  refuse("layer", !spec.layer.empty());
  refuse("wall.opening", !spec.wall.opening.empty());
  refuse("wall.beam", std::isfinite(spec.wall.beam.height));
  refuse("wall.foundation", !spec.wall.foundation.empty());
  for (std::size_t k = 0; k < spec.stage.size(); ++k)
    if (const auto* push = std::get_if<PushStage>(&spec.stage[k].action))
      refuse(fmt::format("stage.{}.contraflexure", k).c_str(), std::isfinite(push->contraflexure));
}

// In space storeys are levels for drifts and for diaphragms. Walls along plan lines have their own
// masonry.
void check_storeys(const ModelSpec& spec, FaultList& faults) {
  std::set<std::string> names;
  for (std::size_t k = 0; k < spec.storey.size(); ++k) {
    const StoreySpec& s = spec.storey[k];
    const auto fault = [&](const char* key, std::string value, const char* problem,
                           const char* cure) {
      faults.add({"", fmt::format("storey.{}.{}", k, key), std::move(value), problem, cure, 0});
    };
    if (s.name.empty() || !names.insert(s.name).second)
      fault("name", s.name, s.name.empty() ? "missing" : "two storeys have this name",
            "give each storey a name of its own; they stand on each other in their order");
    if (!(s.height > 0))
      fault("height", fmt::format("{:g} m", s.height), "is no height of a storey",
            "write e.g. height = \"3 m\"");
    const UnitSpec& u = s.unit;
    for (const auto& [key, is_there] :
         {std::pair("thickness", !std::isnan(s.thickness)),
          {"bond", !s.bond.empty()},
          {"fit", !s.fit.empty()},
          {"joint", !s.joints.joint.empty()},
          {"head_joint", !s.joints.head_joint.empty()},
          {"unit_joint", !s.joints.unit_joint.empty()},
          {"unit", !(std::isnan(u.length) && std::isnan(u.height) && std::isnan(u.density))}})
      if (is_there)
        fault(key, "", "is for walls in their plane; this one is in space",
              "write it in [[plan_wall]]: above another wall one with a base of its own");
  }
}

// Refuses rules for kinds of blocks that the wall does not have: they would have no effect, unnoticed.
void check_materials_of_blocks(const ModelSpec& spec, FaultList& faults) {
  geometry::BlockNames names;
  for (const BodySpec& body : spec.body) names.try_emplace(body.material, body.id);
  geometry::check_names(geometry::Shape(spec), names, faults);
}

// Numbers bodies: free ones first, in order, then supports; deformable ones by solid_id().
std::vector<BlockId> number(const SpaceAssembly& assembly, Model& model) {
  std::vector<BlockId> id(assembly.body.size());
  int solids = 0;
  for (std::size_t k = 0; k < id.size(); ++k)
    if (has_zones(assembly.body[k]))
      id[k] = solid_id(solids++);
    else if (!assembly.body[k].fixed)
      id[k] = model.n_block++;
  for (std::size_t k = 0; k < id.size(); ++k)
    if (assembly.body[k].fixed && !is_solid(id[k])) id[k] = model.n_block + model.space.n_support++;
  return id;
}

double density_of_segment(const geometry::SpaceFrame& frame, std::size_t body) {
  return frame.placed.segments[body - frame.first_body].own_density;
}

void fill_blocks(const ModelSpec& spec, const SpaceAssembly& assembly, const FieldValues& fields,
                 Model& model, FaultList& faults) {
  const Shape shape(spec);
  Space& space = model.space;
  Anatomy& anatomy = model.anatomy;
  for (const bool fixed : {false, true})
    for (std::size_t k = 0; k < assembly.body.size(); ++k) {
      const BodySpec& body = assembly.body[k];
      if (body.fixed != fixed || has_zones(body)) continue;
      const geometry::SolidMoments& moments = assembly.moments[k];
      space.body.push_back(body);
      space.centroid.push_back(moments.centroid);
      if (fixed) continue;
      const int frame = geometry::frame_of(assembly, static_cast<int>(k));
      const double density =
          frame < 0 ? fields.density_of(static_cast<int>(k),
                                        geometry::density_in_file(shape, body.material))
                    : density_of_segment(assembly.frames[frame], k);
      if (!(density > 0))
        faults.add({"", "wall.blocks." + body.id, "",
                    fmt::format("has no density: neither material {} nor wall.unit has one",
                                body.material),
                    "add e.g. [wall.unit] density = \"1800 kg/m^3\"", 0});
      const PrincipalAxes axes = principal_axes(moments.inertia);
      model.mass.push_back(density * moments.volume);
      model.gravity_mass.push_back(density * moments.volume);
      space.inertia.push_back(density * axes.moment);
      space.axis_1.push_back(axes.axis_1);
      space.axis_2.push_back(axes.axis_2);
      space.axis_3.push_back(axes.axis_3);
      model.centroid_x.push_back(moments.centroid.x);
      model.centroid_y.push_back(moments.centroid.y);
      anatomy.block_id.push_back(body.id);
      anatomy.block_role.push_back(body.cut.empty() ? role_of(body) : BlockRole::kCutOut);
      anatomy.block_course.push_back(-1);
    }
  model.inertia.assign(model.n_block,
                       0.0);  // of rotations in the plane: not used
  model.turn_freedom.assign(model.n_block, 1.0);
}

// Tangent t1 of a face: along its longest side, so that it does not depend on the first corner of the polygon.
Vec3 tangent_of(const JointFace& face) {
  Vec3 longest;
  double most = -1;
  for (std::size_t k = 0; k < face.polygon.size(); ++k) {
    const Vec3 side = face.polygon[(k + 1) % face.polygon.size()] - face.polygon[k];
    if (dot(side, side) > most * (1 + 1e-9)) most = dot(side, side), longest = side;
  }
  const Vec3 in_plane = longest - dot(longest, face.normal) * face.normal;
  return geometry::unit(in_plane);
}

// A joint before its number is known.
struct Placed {
  const JointFace* face;
  BlockId a, b;
  std::int32_t material;
  Vec3 tangent, normal;
  FacePoints points;
  std::vector<Vec3> outline;
  double area;
  bool of_chain = false, of_frame = false;
};

Placed placed(const JointFace& face, BlockId a, BlockId b, std::int32_t material,
              const QuadratureChoice& choice) {
  Placed joint{&face, a, b, material, tangent_of(face), face.normal, {}, face.polygon, face.area};
  const Vec3 t2 = cross(joint.normal, joint.tangent);
  std::vector<Vec2> corner;
  for (const Vec3& p : face.polygon)
    corner.push_back({dot(p - face.centre, joint.tangent), dot(p - face.centre, t2)});
  joint.points = points_on(corner, choice);
  return joint;
}

void append(const Placed& joint, Model& model) {
  Space& space = model.space;
  model.joint_a.push_back(joint.a);
  model.joint_b.push_back(joint.b);
  model.joint_material.push_back(joint.material);
  model.area.push_back(joint.area);
  space.arm_a.push_back(joint.face->centre - space.centroid[joint.a]);
  space.arm_b.push_back(joint.face->centre - space.centroid[joint.b]);
  space.tangent.push_back(joint.tangent);
  space.normal.push_back(joint.normal);
  space.face.push_back(joint.outline);
  const FacePoints& p = joint.points;
  space.point_r1.insert(space.point_r1.end(), p.r1.begin(), p.r1.end());
  space.point_r2.insert(space.point_r2.end(), p.r2.begin(), p.r2.end());
  space.point_share.insert(space.point_share.end(), p.share.begin(), p.share.end());
  space.point_begin.push_back(static_cast<std::int32_t>(space.point_r1.size()));
  const bool upright = std::fabs(joint.normal.y) < 0.5;
  model.anatomy.joint_kind.push_back(joint.of_frame             ? JointKind::kFrame
                                     : joint.of_chain           ? JointKind::kLintelChain
                                     : joint.a >= model.n_block ? JointKind::kFoundation
                                     : upright                  ? JointKind::kHead
                                                                : JointKind::kBed);
}

// Torsion constant of a rectangle a x b [m^4] by Roark's polynomial, within 0.5 %.
double torsion_constant(double a, double b) {
  if (a < b) std::swap(a, b);
  const double r = b / a, r4 = r * r * r * r;
  return a * b * b * b * (1.0 / 3 - 0.21 * r * (1 - r4 / 12));
}

// The section between two segments of a lintel, at spacing l, as two joints with half the area each
// (docs/theory/space.md, "A lintel that bends"): one has four points at h/sqrt(6) in both directions, the other its centre. With
// kn = E/l in both, the chain has the EA and, about both axes, the EI of the beam. ks is chosen so that both together
// have the beam's 5/6 GA, and the four points alone its GJ.
std::array<Placed, 2> chain_joints(Placed joint, const std::string& of, const JointMaterial& body,
                                   double spacing, JointLaws& laws) {
  const Vec3 t2 = cross(joint.normal, joint.tangent);
  double half_1 = 0, half_2 = 0;
  for (const Vec3& p : joint.outline) {
    half_1 = std::fmax(half_1, std::fabs(dot(p - joint.face->centre, joint.tangent)));
    half_2 = std::fmax(half_2, std::fabs(dot(p - joint.face->centre, t2)));
  }
  const double h1 = 2 * half_1, h2 = 2 * half_2, area = joint.area;
  JointMaterial rim;
  rim.normal_stiffness = body.youngs_modulus / spacing;
  rim.shear_stiffness =
      12 * body.shear_modulus * torsion_constant(h1, h2) / (spacing * area * (h1 * h1 + h2 * h2));
  rim.tensile_strength = rim.cohesion = rim.residual_cohesion = kUnlimited;
  rim.friction_angle = rim.residual_friction_angle = 0;
  rim.compressive_strength = kUnlimited;
  JointMaterial core = rim;
  core.shear_stiffness = 2 * 5.0 / 6 * body.shear_modulus / spacing - rim.shear_stiffness;
  joint.area = area / 2;
  joint.of_chain = true;
  const double c1 = h1 / std::sqrt(6.0), c2 = h2 / std::sqrt(6.0);
  std::array<Placed, 2> both{joint, joint};
  both[0].points = {{-c1, c1, c1, -c1}, {-c2, -c2, c2, c2}, {0.25, 0.25, 0.25, 0.25}};
  both[1].points = {{0.0}, {0.0}, {1.0}};
  const std::string name = fmt::format("{} chain {:.4f} x {:.4f} / {:.4f} m", of, h1, h2, spacing);
  both[0].material = laws.derived(name + ", rim", rim);
  both[1].material = laws.derived(name + ", core", core);
  return both;
}

// A face with zones on one or both sides; its material is set later.
void add_solid_face(const SpaceAssembly& assembly, const JointFace& face,
                    const std::vector<BlockId>& id, std::vector<SpaceSolidFace>& faces,
                    FaultList& faults) {
  const bool zones_are_b = has_zones(assembly.body[face.b]);
  const int solid = zones_are_b ? face.b : face.a, rigid = zones_are_b ? face.a : face.b;
  if (has_zones(assembly.body[rigid]))
    faults.add({"", "wall.blocks." + assembly.body[solid].id + ".zones", "",
                "two blocks of zones touch each other",
                "make one of them rigid, or put a rigid course between them", 0});
  faces.push_back({&face, id[rigid], solid_of(id[solid]), 0, tangent_of(face), zones_are_b,
                   assembly.moments[rigid].centroid});
}

// as in the plane (geometry/assembly.cpp)
void note_foundation(const ModelSpec& spec, Model& model) {
  std::set<std::string> names;
  const std::string& named = spec.wall.joints.joint;
  for (std::size_t j = model.n_pair; j < static_cast<std::size_t>(model.n_joint); ++j) {
    const std::string& name = model.material_names[model.joint_material[j]];
    if (name == (named.empty() ? "joint" : named)) names.insert("[material." + name + "]");
  }
  if (!spec.material.contains("foundation") && !names.empty())
    model.anatomy.notes.push_back(
        {"material.no_foundation", {{"materials", fmt::format("{}", fmt::join(names, ", "))}}});
}

void fill_joints(const ModelSpec& spec, const SpaceAssembly& assembly,
                 const std::vector<BlockId>& id, const FieldValues& fields, Model& model,
                 FaultList& faults) {
  const Shape shape(spec);
  JointLaws laws(spec, model, faults, true);
  const QuadratureChoice choice = quadrature_choice(spec.solve);
  model.solve.point_rule = choice.rule;
  model.solve.points_per_face = choice.points;
  std::vector<Placed> joints;
  std::vector<SpaceSolidFace> solids;
  for (std::size_t number = 0; number < assembly.faces.size(); ++number) {
    const JointFace& face = assembly.faces[number];
    const BodySpec &a = assembly.body[face.a], &b = assembly.body[face.b];
    if (a.fixed && b.fixed) continue;
    const int frame =
        std::max(geometry::frame_of(assembly, face.a), geometry::frame_of(assembly, face.b));
    const auto material = [&] {
      if (frame >= 0) {
        const int index = assembly.frames[frame].placed.index;
        return laws.index_of(spec.frame[index].joint);
      }
      return laws.index_of(joint_material_of(shape, a, b, face.normal),
                           shares_bed(shape, a, b, face.normal), static_cast<int>(number),
                           face.centre, fields);
    };
    if (has_zones(a) || has_zones(b)) {
      add_solid_face(assembly, face, id, solids, faults);
      solids.back().material = material();
      continue;
    }
    if (frame >= 0) {
      joints.push_back(placed(face, id[face.a], id[face.b], material(), choice));
      joints.back().of_frame = true;
      continue;
    }
    if (is_chain(a, b)) {
      const std::string chain = chain_of(a.id);
      const auto body = spec.material.find(a.material);
      if (body == spec.material.end() || !(body->second.youngs_modulus > 0) ||
          !(body->second.shear_modulus > 0)) {
        faults.add({"", "material." + a.material, "",
                    "has no youngs_modulus and shear_modulus, and " + chain +
                        " bends as a chain of segments",
                    "write both, or its segments as one block", 0});
        continue;
      }
      const double spacing = std::fabs(
          dot(assembly.moments[face.b].centroid - assembly.moments[face.a].centroid, face.normal));
      Placed joint = placed(face, id[face.a], id[face.b], 0, choice);
      for (const Placed& half :
           chain_joints(std::move(joint), a.material, body->second, spacing, laws))
        joints.push_back(half);
      continue;
    }
    joints.push_back(placed(face, id[face.a], id[face.b], material(), choice));
  }
  laws.report_drawn();
  faults.throw_if_any();
  const auto variant = [&](const Placed& joint) {
    const contact::LawChoice c = contact::choice_of(model.materials[joint.material]);
    return std::array{static_cast<int>(c.softening), static_cast<int>(c.coupling),
                      static_cast<int>(c.unloading), static_cast<int>(c.cap)};
  };
  const auto key = [&](const Placed& joint) {
    return std::tuple(joint.a >= model.n_block, variant(joint), model.stated(joint.material),
                      joint.points.r1.size());
  };
  std::stable_sort(joints.begin(), joints.end(),
                   [&](const Placed& p, const Placed& q) { return key(p) < key(q); });
  model.space.point_begin.push_back(0);
  for (const Placed& joint : joints) append(joint, model);
  model.n_joint = static_cast<int>(joints.size());
  model.n_pair = static_cast<int>(std::count_if(
      joints.begin(), joints.end(), [&](const Placed& joint) { return joint.a < model.n_block; }));
  compile_space_contacts(solids, choice, model, faults);
  note_foundation(spec, model);
}

void measure(const SpaceAssembly& assembly, Model& model) {
  geometry::Box3 all;
  double smallest = 1e300;
  bool first = true;
  for (const BodySpec& body : assembly.body) {
    if (body.fixed) continue;
    const geometry::Box3 box = geometry::box_of(body);
    all = first ? box : geometry::join(all, box);
    first = false;
    smallest = std::fmin(smallest, box.high.y - box.low.y);
  }
  Anatomy& anatomy = model.anatomy;
  anatomy.length = all.high.x - all.low.x;
  anatomy.height = all.high.y - all.low.y;
  anatomy.thickness = all.high.z - all.low.z;
  anatomy.lost_joints = assembly.lost_faces;
  anatomy.notes.insert(anatomy.notes.begin(), assembly.notes.begin(), assembly.notes.end());
  anatomy.support_begin = {0};
  anatomy.outline_begin.assign(static_cast<std::size_t>(model.n_block) + 1, 0);
  anatomy.block_thickness.assign(model.n_block, anatomy.thickness);
  if (std::isnan(model.solve.collapse_displacement))
    model.solve.collapse_displacement = model.solve.contacts == Contacts::kFree
                                            ? std::numeric_limits<double>::infinity()
                                            : smallest;
}

void fill_storeys(const ModelSpec& spec, const SpaceAssembly& assembly, Model& model,
                  FaultList& faults) {
  if (spec.storey.empty()) return;
  double foot = std::numeric_limits<double>::infinity(), top = 0;
  for (const BodySpec& body : assembly.body)
    if (!body.fixed) foot = std::fmin(foot, geometry::box_of(body).low.y);
  if (std::fabs(foot) > 1e-6)
    faults.add(
        {"", "storey", "",
         fmt::format("heights of storeys count from level 0, and the lowest block begins at {:g} m",
                     foot),
         "move the blocks up or down", 0});
  for (const StoreySpec& storey : spec.storey) {
    model.anatomy.storey_name.push_back(storey.name);
    model.anatomy.storey_top.push_back(top += storey.height);
  }
}

// Loads on a slab are distributed like the slab, so its moments of inertia grow in proportion to its mass.
void spread_over_slabs(const std::vector<double>& bare, Model& model) {
  for (std::size_t i = 0; i < bare.size(); ++i)
    if (model.anatomy.block_role[i] == BlockRole::kSlab && model.mass[i] > bare[i])
      model.space.inertia[i] = (model.mass[i] / bare[i]) * model.space.inertia[i];
}

// Smooth start of pushes that state none: at most a fifth of the push.
void set_ramps(Model& model) {
  constexpr double kUsual = 0.05;  // [s]
  for (Stage& stage : model.stages) {
    const PushStage* push = stage.push();
    if (push == nullptr || !std::isnan(stage.spec.ramp)) continue;
    const double first = push->targets.empty() ? push->until : std::fabs(push->targets.front());
    stage.spec.ramp = std::fmin(kUsual, 0.2 * first / push->velocity);
  }
}

}  // namespace

PrincipalAxes principal_axes(const std::array<double, 6>& inertia) {
  double m[3][3] = {{inertia[0], inertia[3], inertia[4]},
                    {inertia[3], inertia[1], inertia[5]},
                    {inertia[4], inertia[5], inertia[2]}};
  double v[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};  // columns are axes
  const double scale = inertia[0] + inertia[1] + inertia[2];
  for (int sweep = 0; sweep < 12; ++sweep)
    for (const auto& [p, q] : {std::pair(0, 1), {0, 2}, {1, 2}}) {
      if (std::fabs(m[p][q]) <= 1e-15 * scale) continue;
      const double theta = (m[q][q] - m[p][p]) / (2 * m[p][q]);
      const double t = (theta >= 0 ? 1 : -1) / (std::fabs(theta) + std::sqrt(theta * theta + 1));
      const double c = 1 / std::sqrt(t * t + 1), s = t * c;
      for (int k = 0; k < 3; ++k) {
        const double a = m[k][p], b = m[k][q];
        m[k][p] = c * a - s * b, m[k][q] = s * a + c * b;
      }
      for (int k = 0; k < 3; ++k) {
        const double a = m[p][k], b = m[q][k];
        m[p][k] = c * a - s * b, m[q][k] = s * a + c * b;
      }
      for (auto& row : v) {
        const double a = row[p], b = row[q];
        row[p] = c * a - s * b, row[q] = s * a + c * b;
      }
    }
  const auto axis = [&](int k) { return Vec3{v[0][k], v[1][k], v[2][k]}; };
  return {{m[0][0], m[1][1], m[2][2]}, axis(0), axis(1), cross(axis(0), axis(1))};
}

SpaceAssembly assemble_space(const ModelSpec& spec, FaultList& faults) {
  refuse_plane_parts(spec, faults);
  check_storeys(spec, faults);
  check_materials_of_blocks(spec, faults);
  check_points(spec.solve, faults);
  std::vector<std::string> stages;
  for (const StageSpec& stage : spec.stage) stages.push_back(stage.name);
  std::vector<BodySpec> bodies = spec.body;
  std::vector<geometry::SpaceFrame> frames = geometry::place_frames_in_space(spec, bodies, faults);
  return geometry::assemble(bodies, faults, stages, std::move(frames));
}

Model compile_space(const ModelSpec& spec, const SpaceAssembly& assembly) {
  FaultList faults;
  Model model;
  model.solve = spec.solve;
  model.output = spec.output;
  const FieldValues fields(spec, assembly, faults);
  faults.throw_if_any();
  const std::vector<BlockId> id = number(assembly, model);
  compile_space_solids(spec, assembly, model, faults);
  fill_blocks(spec, assembly, fields, model, faults);
  if (model.n_block == 0 && !model.space.solids.bodies.empty())
    faults.add({"", "wall.blocks", "", "every moving block is cut into zones",
                "leave at least one rigid block: loads and pushes act on those", 0});
  else if (model.n_block == 0)
    faults.add({"", "wall.blocks", "", "holds no block that moves", "leave at least one free", 0});
  faults.throw_if_any();
  fill_joints(spec, assembly, id, fields, model, faults);
  list_joints_of_blocks(model);
  measure(assembly, model);
  std::vector<Message>& notes = model.anatomy.notes;
  notes.insert(notes.begin(), spec.built.begin(), spec.built.end());
  fill_storeys(spec, assembly, model, faults);
  compile_free_in_space(spec, model, faults);
  for (std::size_t i = 0; i < model.gravity_mass.size(); ++i)  // cut-out masonry has no weight
    if (model.anatomy.block_role[i] != BlockRole::kCutOut)
      model.weight += model.gravity_mass[i] * model.solve.gravity;
  for (const double mass : model.space.solids.node_gravity_mass)
    model.weight += mass * model.solve.gravity;
  const std::vector<double> bare = model.mass;
  const std::vector<PointLoad> floors = compile_space_floors(spec, assembly, id, model, faults);
  spread_over_slabs(bare, model);
  compile_links(spec, assembly, id, model, faults);
  compile_space_frames(spec, assembly, id, model, faults);
  compile_space_standing(spec, assembly, id, model, faults);
  compile_space_stages(spec, assembly, id, floors, model, faults);
  check_standing(model, faults);
  check_space_frames(model, faults);
  faults.throw_if_any();
  carry_floors(bare, model);
  fields.describe(spec, assembly, id, model);
  note_storeys_without_top(model);
  note_idle_inputs(spec, model);
  note_densities(spec, model);
  note_coarse_units(spec, model);
  bound_space_step(model);
  set_dashpots(model);
  set_ramps(model);
  model.topology = topology_of(model);
  return model;
}

}  // namespace wythe
