#include "scenes/scenes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "wythe/parts/builder.h"
#include "wythe/parts/io.h"
#include "wythe/parts/study.h"

namespace wythe::scenes {

JointMaterial elastic_joint(double normal_stiffness, double shear_stiffness) {
  constexpr double kFar = 1e12;  // [Pa], never reached; energies that keep the branch gentle
  JointMaterial m;
  m.normal_stiffness = normal_stiffness;
  m.shear_stiffness = shear_stiffness;
  m.tensile_strength = m.cohesion = m.residual_cohesion = kFar;
  m.friction_angle = m.residual_friction_angle = 0;
  m.mode_1_energy = m.mode_2_energy =
      100 * kFar * kFar / std::min(normal_stiffness, shear_stiffness);
  m.compressive_strength = kUnlimited;
  return m;
}

JointMaterial dry_joint(double normal_stiffness, double shear_stiffness, double friction_angle) {
  JointMaterial m;
  m.normal_stiffness = normal_stiffness;
  m.shear_stiffness = shear_stiffness;
  m.tensile_strength = m.cohesion = m.residual_cohesion = 0;
  m.friction_angle = m.residual_friction_angle = friction_angle;
  m.compressive_strength = kUnlimited;
  return m;
}

JointMaterial paper_joint() {
  JointMaterial m;
  m.normal_stiffness = 20e9;
  m.shear_stiffness = 8e9;
  m.tensile_strength = m.cohesion = 0.15e6;
  m.friction_angle = degrees(16.2);
  m.residual_friction_angle = degrees(14.6);
  m.residual_cohesion = 0;
  m.mode_1_energy = 4.3;
  m.mode_2_energy = 125;
  m.compressive_strength = 3.96e6;
  m.compressive_energy = 12800;
  return m;
}

JointMaterial capped_joint() {
  JointMaterial m = paper_joint();
  m.compression_cap = 9;
  m.hardening_displacement = 0.09e-3;
  m.dilatancy_angle = degrees(4);
  m.dilatancy_slip = 0.5e-3;
  m.dilatancy_pressure = 2e6;
  return m;
}

JointMaterial paper_unit() {
  JointMaterial m = paper_joint();
  m.normal_stiffness = 10e9;
  m.shear_stiffness = 4e9;
  m.tensile_strength = 0.23e6;
  m.cohesion = 0.46e6;
  m.friction_angle = m.residual_friction_angle = degrees(38);
  m.mode_1_energy = 8;
  m.mode_2_energy = 550;
  return m;
}

BlockSpec rectangle(const std::string& id, double x, double y, double width, double height) {
  BlockSpec block;
  block.id = id;
  block.polygon = {{x, y}, {x + width, y}, {x + width, y + height}, {x, y + height}};
  return block;
}

ModelSpec assembly(std::vector<BlockSpec> blocks, const JointMaterial& joint, double thickness,
                   double density) {
  ModelSpec spec;
  spec.solve.points_per_face = 2;  // the closed forms of tests are those of two end points
  spec.wall.blocks = "(in code)";
  spec.wall.thickness = thickness;
  spec.wall.unit.density = density;
  spec.material["joint"] = joint;
  spec.block = std::move(blocks);
  return spec;
}

ModelSpec block_on_ground(double width, double height, const JointMaterial& joint, double thickness,
                          double density) {
  return stack(1, width, height, joint, thickness, density);
}

ModelSpec stack(int n, double width, double height, const JointMaterial& joint, double thickness,
                double density) {
  std::vector<BlockSpec> blocks;
  for (int k = 0; k < n; ++k)
    blocks.push_back(rectangle("b" + std::to_string(k), 0, k * height, width, height));
  return assembly(std::move(blocks), joint, thickness, density);
}

ModelSpec half_units(const BondSize& size, const JointMaterial& joint) {
  constexpr double kHalf = 0.155, kCourse = 0.11;
  std::vector<BlockSpec> blocks;
  BlockSpec sill = rectangle("sill", 0, -kCourse, size.columns * kHalf, kCourse);
  sill.fixed = true;
  blocks.push_back(sill);
  const auto in_hole = [&](int at, int from) { return at >= from && at < from + size.hole; };
  for (int r = 0; r < size.courses; ++r)
    for (int c = 0; c < size.columns; ++c) {
      if (in_hole(c, size.hole_at_column) && in_hole(r, size.hole_at_course)) continue;
      blocks.push_back(rectangle("r" + std::to_string(r) + "c" + std::to_string(c), c * kHalf,
                                 r * kCourse, kHalf, kCourse));
    }
  return assembly(std::move(blocks), joint, 0.31, 1250);
}

namespace {

ModelSpec bonded_wall(int columns, int courses) {
  ModelSpec spec;
  spec.solve.points_per_face = 2;  // the closed forms of tests are those of two end points
  spec.wall.length = 0.155 * columns;
  spec.wall.height = 0.11 * courses;
  spec.wall.thickness = 0.31;
  spec.wall.unit.length = 0.31;
  spec.wall.unit.height = 0.11;
  spec.wall.unit.density = 1250;
  spec.material["joint"] = paper_joint();
  spec.material["unit"] = paper_unit();
  spec.stage.push_back(gravity_stage());
  return spec;
}

StageSpec push_at(double y, double velocity, double until) {
  StageSpec push = push_stage("", Direction::kPlusX, velocity, until);
  push.get<PushStage>().at = {.x = 0, .y = y};
  return push;
}

}  // namespace

ModelSpec small_wall(double until, double velocity, double pier_load) {
  ModelSpec spec = bonded_wall(8, 8);
  OpeningSpec window;
  window.x = 3 * 0.155;
  window.y = 3 * 0.11;
  window.width = 2 * 0.155;
  window.height = 2 * 0.11;
  spec.wall.opening.push_back(window);
  StageSpec load{.name = "precompression", .action = LoadStage{.pier_load = pier_load}};
  spec.stage.push_back(load);
  spec.stage.push_back(push_at(6.5 * 0.11, velocity, until));
  return spec;
}

ModelSpec plain_wall(int columns, int courses, double until, double velocity) {
  ModelSpec spec = bonded_wall(columns, courses);
  spec.stage.push_back(push_at((courses - 0.5) * 0.11, velocity, until));
  return spec;
}

ModelSpec falling_portal(double until) {
  std::vector<BlockSpec> blocks{rectangle("sill", -0.5, -0.1, 2, 0.1)};
  blocks.back().fixed = true;
  constexpr double kHigh = 0.15;
  for (int course = 0; course < 5; ++course)
    for (const int pier : {0, 1})
      for (const int half : {0, 1})
        blocks.push_back(rectangle(fmt::format("p{}c{}h{}", pier, course, half),
                                   0.7 * pier + 0.15 * half, kHigh * course, 0.15, kHigh));
  for (const int stone : {0, 1})
    blocks.push_back(rectangle(fmt::format("top{}", stone), 0.5 * stone, 5 * kHigh, 0.5, kHigh));
  ModelSpec spec = assembly(std::move(blocks), dry_joint(2e9, 1e9, degrees(30)), 0.3, 2000);
  spec.solve.contacts = Contacts::kFree;
  StageSpec fall{
      .name = "fall", .damping = 0.05, .action = HoldStage{.duration = 0.4, .release = true}};
  StageSpec push = push_stage("p0c4h0", Direction::kPlusX, 0.4, until);
  push.ramp = 0.02;
  push.damping = 0.2;
  spec.stage = {gravity_stage(), push, fall};
  spec.output.rows = 50;
  return spec;
}

ModelSpec tuff_wall(const std::string& source_dir, double until) {
  ModelSpec spec = read_model(source_dir + "/examples/tuff_wall/model.toml");
  spec.stage.back().get<PushStage>().until = until;
  return spec;
}

ModelSpec tied(ModelSpec spec) {
  TieSpec tie;
  tie.name = "across";
  tie.from.x = 0.05, tie.from.y = 0.60;
  tie.to.x = 1.0, tie.to.y = 0.30;
  tie.area = 1e-5;
  tie.youngs_modulus = 200e9;
  tie.yield_strength = 5e6;
  tie.prestress = 4.9e6;
  TieSpec anchored = tie;
  anchored.name = "anchored";
  anchored.to.x = -0.5, anchored.to.y = 0.7;
  anchored.anchored = true;
  anchored.prestress = 0;
  spec.tie = {tie, anchored};
  DiaphragmSpec floor;
  floor.y = 0.66;
  floor.x = {0.1, 0.5, 0.9};
  floor.stiffness = 1e6;
  spec.diaphragm = {floor};
  SpringSpec wall;
  wall.at.x = 1.0, wall.at.y = 0.6;
  wall.stiffness = 1e7;
  wall.strength = 100;
  wall.pushes_only = true;
  spec.spring = {wall};
  return spec;
}

ModelSpec framed(ModelSpec spec) {
  spec.wall.opening[0].name = "window";
  FrameSpec frame;
  frame.round = "window";
  frame.feet = FrameFeet::kBaseBeam;
  frame.section = {.height = 0.02,
                   .width = 0.02,
                   .area = 4e-4,
                   .shear_area = 10e-4 / 3,
                   .second_moment = 4e-8 / 3,
                   .plastic_modulus = 2e-6,
                   .mass = 3.14,
                   .weak_second_moment = 4e-8 / 3,
                   .torsion_constant = 2.25e-8};
  frame.yield_strength = 0.5e6, frame.youngs_modulus = 210e9, frame.shear_modulus = 81e9;
  frame.joint = "dry";
  spec.frame = {frame};
  spec.material["dry"] = dry_joint(20e9, 8e9, 0.4);
  return spec;
}

ModelSpec cut_under_load(ModelSpec spec) {
  StageSpec cut{.name = "cut", .action = CutStage{}};
  spec.stage.insert(spec.stage.end() - 1, cut);
  spec.wall.opening[0].cut = "cut";
  return spec;
}

ModelSpec layered(ModelSpec spec) {
  LayerSpec layer;
  layer.name = "both";
  layer.sides = 2;
  layer.fibres.horizontal = 23e-6, layer.fibres.vertical = 46e-6;
  layer.fibres.youngs_modulus = 72e9, layer.fibres.strength = 0.15e6;
  layer.bond.energy = 0.01, layer.bond.slip = 1e-5;
  spec.layer = {layer};
  layer.name = "foot";
  layer.sides = 1;
  layer.height = 0.33;
  layer.fibres.strength = 5e6;
  layer.bond.energy = 2e-6, layer.bond.slip = 3e-8;
  spec.layer.push_back(layer);
  return spec;
}

namespace {

BodySpec prism(const std::string& id, std::vector<std::array<double, 2>> polygon, double from,
               double to, bool fixed) {
  double twice = 0;
  const auto n = static_cast<std::int32_t>(polygon.size());
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const auto& [x, y] = polygon[k];
    const auto& [p, q] = polygon[(k + 1) % polygon.size()];
    twice += x * q - p * y;
  }
  if (twice < 0) std::reverse(polygon.begin(), polygon.end());
  Polyhedron solid;
  for (const double z : {from, to})
    for (const auto& [x, y] : polygon) solid.vertex.push_back({x, y, z});
  std::vector<std::int32_t> back, front;
  for (std::int32_t k = 0; k < n; ++k) {
    back.push_back(n - 1 - k);
    front.push_back(n + k);
    solid.face.push_back({k, (k + 1) % n, n + (k + 1) % n, n + k});
  }
  solid.face.push_back(back);
  solid.face.push_back(front);
  BodySpec body;
  body.id = id;
  body.part = {solid};
  body.fixed = fixed;
  return body;
}

}  // namespace

BodySpec box(const std::string& id, Vec3 corner, Vec3 size, bool fixed) {
  const double x = corner.x + size.x, y = corner.y + size.y;
  return prism(id, {{corner.x, corner.y}, {x, corner.y}, {x, y}, {corner.x, y}}, corner.z,
               corner.z + size.z, fixed);
}

ModelSpec in_space(std::vector<BodySpec> bodies, const JointMaterial& joint, double density) {
  ModelSpec spec;
  spec.name = "bodies";
  spec.wall.blocks = "bodies.json";
  spec.wall.unit.density = density;
  spec.material["joint"] = joint;
  spec.body = std::move(bodies);
  return spec;
}

ModelSpec along_a_line(ModelSpec plane, int wythes) {
  PlanWallSpec wall;
  wall.name = "w";
  wall.line = {{0, 0}, {plane.wall.length, 0}};
  wall.opening = plane.wall.opening;
  wall.wythes = wythes;
  plane.wall.opening.clear();
  plane.wall.length = kUnset;
  for (FrameSpec& frame : plane.frame) frame.wall = "w";
  for (StageSpec& stage : plane.stage)
    if (auto* push = std::get_if<PushStage>(&stage.action);
        push && push->at.block.empty() && std::isfinite(push->at.x))
      push->at.z = 0;
  lay_bodies({.plan_wall = {wall}, .slab = {}, .arch = {}, .dome = {}}, plane);
  return plane;
}

ModelSpec prisms(const ModelSpec& plane) {
  ModelSpec spec = plane;
  for (const BlockSpec& block : plane.block)
    spec.body.push_back(prism(block.id, block.polygon, -0.5 * plane.wall.thickness,
                              0.5 * plane.wall.thickness, block.fixed));
  spec.block.clear();
  spec.solve.damping_form = DampingForm::kComponents;
  return spec;
}

ModelSpec turned_about_y(ModelSpec spec, double angle) {
  const Rotation turn{{0, angle, 0}};
  for (BodySpec& body : spec.body)
    for (Polyhedron& part : body.part)
      for (Vec3& v : part.vertex) v = wythe::turned(v, turn);
  for (StageSpec& stage : spec.stage)
    if (auto* along = along_of(stage); along && along->size() == 3) {
      const Vec3 d = wythe::turned(Vec3{(*along)[0], (*along)[1], (*along)[2]}, turn);
      *along = {d.x, d.y, d.z};
    }
  return spec;
}

std::vector<double>* along_of(StageSpec& stage) {
  const auto of = [](auto& action) -> std::vector<double>* {
    if constexpr (requires { action.drive; })
      return &action.drive.along;
    else if constexpr (requires { action.along; })
      return &action.along;
    else
      return nullptr;
  };
  return std::visit(of, stage.action);
}

StageSpec gravity_stage() { return {.name = "gravity"}; }

StageSpec shake_stage(double amplitude, double period) {
  RecordSpec record;
  record.pulse = PulseShape::kCycle;
  record.amplitude = amplitude;
  record.period = period;
  return {.name = "quake",
          .action = ShakeStage{.record = {record},
                               .interval = 2e-3,
                               .mass_damping = {0.02, 10},
                               .restitution = 0.5,
                               .maxwell_damping = {0.05, 20}}};
}

StageSpec push_stage(const std::string& block, Direction direction, double velocity, double until) {
  return {.name = "push",
          .action = PushStage{.at = {.block = block},
                              .drive = {.direction = direction},
                              .velocity = velocity,
                              .until = until}};
}

ModelSpec with_fields(ModelSpec spec, int seed) {
  const auto add = [&](const char* name, const char* key, double cov, double upper) {
    FieldSpec& field = spec.field[name];
    field.path = std::string("material.joint.") + key;
    field.cov = cov;
    field.upper = upper;
    field.seed = seed;
    return &field;
  };
  FieldSpec* ft = add("ft", "tensile_strength", 0.2, 1.5);
  ft->along = 0.5, ft->across = 0.2;
  add("c", "cohesion", 0.2, 2)->by = FieldBy::kUnit;
  add("kn", "normal_stiffness", 0.1, 1.4)->by = FieldBy::kJoint;
  draw_fields(spec);
  return spec;
}

ModelSpec turned(ModelSpec spec, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  for (BlockSpec& block : spec.block)
    for (auto& [x, y] : block.polygon) {
      const double x0 = x, y0 = y;
      x = c * x0 - s * y0;
      y = s * x0 + c * y0;
    }
  return spec;
}

ModelSpec mirrored(ModelSpec spec) {
  for (BlockSpec& block : spec.block) {
    for (auto& corner : block.polygon) corner[0] = -corner[0];
    std::reverse(block.polygon.begin(), block.polygon.end());
  }
  for (StageSpec& stage : spec.stage) {
    auto* push = std::get_if<PushStage>(&stage.action);
    if (push == nullptr) continue;
    Direction& direction = push->drive.direction;
    if (direction == Direction::kPlusX)
      direction = Direction::kMinusX;
    else if (direction == Direction::kMinusX)
      direction = Direction::kPlusX;
  }
  return spec;
}

ModelSpec reversed(ModelSpec spec) {
  std::reverse(spec.block.begin(), spec.block.end());
  return spec;
}

ModelSpec scaled(ModelSpec spec, double s) {
  for (BlockSpec& block : spec.block)
    for (auto& [x, y] : block.polygon) {
      x *= s;
      y *= s;
    }
  spec.wall.thickness *= s;
  for (auto& [name, m] : spec.material) {
    m.normal_stiffness /= s;
    m.shear_stiffness /= s;
    m.mode_1_energy *= s;
    m.mode_2_energy *= s;
    m.compressive_energy *= s;
  }
  spec.solve.gravity /= s;
  for (StageSpec& stage : spec.stage) {
    stage.ramp *= s;
    if (auto* push = std::get_if<PushStage>(&stage.action)) push->until *= s;
  }
  return spec;
}

std::size_t add_load(Model& model, const PointLoad& load) {
  Stage stage;
  stage.spec.name = "load";
  stage.spec.action = LoadStage{};
  stage.spec.ramp = 0.05;
  stage.spec.damping = model.solve.damping;
  stage.loads.push_back(load);
  model.stages.push_back(stage);
  return model.stages.size() - 1;
}

BlockId block_named(const Model& model, const std::string& id) {
  const auto& ids = model.anatomy.block_id;
  const auto found = std::find(ids.begin(), ids.end(), id);
  if (found == ids.end()) throw std::invalid_argument("no block " + id);
  return static_cast<BlockId>(found - ids.begin());
}

}  // namespace wythe::scenes
