#include "scenes/sample_run.h"

namespace wythe::scenes {
namespace {

JointMaterial tuff_joint() {
  JointMaterial joint;
  joint.normal_stiffness = 20e9;
  joint.shear_stiffness = 8e9;
  joint.tensile_strength = 0.15e6;
  joint.cohesion = 0.15e6;
  joint.friction_angle = 0.2827;
  joint.residual_friction_angle = 0.2548;
  joint.residual_cohesion = 0;
  joint.mode_1_energy = 4.3;
  joint.mode_2_energy = 125;
  joint.compressive_strength = 3.96e6;
  joint.compressive_energy = 12800;
  return joint;
}

// Two blocks 0.2 m x 0.1 m, one on the other, 0.1 m thick.
Anatomy sample_anatomy() {
  Anatomy a;
  a.block_id = {"lower", "<upper> & \"co\""};  // names are text, never markup
  a.block_role = {BlockRole::kMasonry, BlockRole::kLintel};
  a.block_course = {0, 1};
  a.block_thickness = {0.1, 0.1};
  a.outline_begin = {0, 4, 8};
  a.outline_x = {0, 0.2, 0.2, 0, 0, 0.2, 0.2, 0};
  a.outline_y = {0, 0, 0.1, 0.1, 0.1, 0.1, 0.2, 0.2};
  a.joint_kind = {JointKind::kBed, JointKind::kFoundation};
  a.pier_x0 = {0};
  a.pier_x1 = {0.2};
  a.pier_height = {0.2};
  a.support_begin = {0};
  a.length = 0.2;
  a.height = 0.2;
  a.thickness = 0.1;
  a.half_unit = 0.1;
  a.course_height = 0.1;
  a.courses = 2;
  return a;
}

CurveRow row(double time, double millimetres, double kilonewtons) {
  CurveRow r;
  r.time = time;
  r.displacement = millimetres * 1e-3;
  r.drift = r.displacement / 0.15;
  r.reaction = kilonewtons * 1e3;
  r.base_shear = 0.99 * r.reaction;
  r.unbalance_ratio = 1e-4;
  r.kinetic_ratio = 1e-3;
  return r;
}

FailureMode sample_mode() {
  FailureMode mode;
  mode.name = "FM-1";
  mode.scores = {{"FM-1", 0.8}, {"FM-2", 0.1}};
  mode.sentence = as_text("The upper block slides on the bed joint.");
  mode.evidence = {
      {.element = "bed joint", .measure = "slip", .value = 3, .threshold = 1, .unit = "mm"}};
  mode.read_at = 6e-3;
  return mode;
}

}  // namespace

ModelSpec sample_spec() {
  ModelSpec spec;
  spec.solve.points_per_face = 2;
  spec.name = "sample <script>alert(1)</script>";
  spec.wall.length = 0.2;
  spec.wall.height = 0.2;
  spec.wall.thickness = 0.1;
  spec.wall.unit = {.length = 0.2, .height = 0.1, .width = kUnset, .density = 1250};
  spec.material["joint"] = tuff_joint();
  spec.stage = {{.name = "gravity"},
                {.name = "push", .action = PushStage{.velocity = 0.01, .until = 0.01}}};
  return spec;
}

Model sample_model() {
  Model m;
  m.n_block = 2;
  m.n_joint = 2;
  m.n_pair = 1;
  m.joint_a = {0, kGroundBlock};
  m.joint_b = {1, 0};
  m.joint_material = {0, 0};
  m.arm_a_x = {0, 0};
  m.arm_a_y = {0.05, 0};
  m.arm_b_x = {0, 0};
  m.arm_b_y = {-0.05, -0.05};
  m.half_x = {0.1, 0.1};
  m.half_y = {0, 0};
  m.tangent_x = {1, 1};
  m.tangent_y = {0, 0};
  m.area = {0.02, 0.02};
  m.point_xi = {-1, 1};
  m.point_weight = {0.5, 0.5};
  m.block_begin = {0, 2, 3};
  m.block_entry = {0, 3, 1};
  m.mass = {2.5, 2.5};
  m.inertia = {0.0104, 0.0104};
  m.centroid_x = {0.1, 0.1};
  m.centroid_y = {0.05, 0.15};
  m.weight = 49.05;
  m.materials = {tuff_joint()};
  m.material_names = {"joint"};
  for (const StageSpec& spec : sample_spec().stage) {
    Stage stage;
    stage.spec = spec;
    m.stages.push_back(stage);
  }
  m.stages[1].driven = {1};
  m.stages[1].driven_share = {1};
  m.stages[1].drive_x = 1;
  m.stages[1].load_height = 0.15;
  m.anatomy = sample_anatomy();
  m.spec_hash = 0xabcdef;
  return m;
}

State sample_state() {
  State s;
  s.ux = {0, 3e-3};
  s.uy = {0, 0.2e-3};
  s.theta = {0, 1e-3};
  s.vx = s.vy = s.omega = {0, 0};
  s.kappa = {0, 0.3e-3, 0, 0};
  s.crush = {0.1e-3, 0, 0, 0};
  s.plastic_slip = {3e-3, 3e-3, 0, 0};
  s.slip = {3e-3, 3e-3, 0, 0};
  s.shear_damage = {1, 1, 0, 0};
  s.tension_set = {0, 0, 0, 0};
  s.load_scale = {0, 0};
  s.time = 2.5;
  return s;
}

Result sample_result() {
  Result r;
  r.curve = {row(0, 0, 0), row(0.2, 2, 10), row(0.6, 6, 8), row(1, 10, 6)};
  r.responses = {.peak_reaction = 10e3,
                 .displacement_at_peak = 2e-3,
                 .displacement_at_80 = 6e-3,
                 .censored_80 = false,
                 .displacement_max = 10e-3,
                 .censored_max = true,
                 .initial_stiffness = 5e6};
  r.energy.drive = 100;
  r.energy.friction = 60;
  r.energy.fracture = 2.5;
  r.energy.damping = 7;
  r.energy.gap_ratio = kUnset;  // not a number: null in JSON, a dash on the page
  r.quasi_static.verdict = as_text("slow enough");
  r.events = {{{"event.first_crack"},
               0.5e-3,
               3e3,
               {"place.joint", {{"joint", Message{"joint.bed"}}, {"x_m", 0.1}, {"y_m", 0.1}}}}};
  r.failure_mode = sample_mode();
  r.states.snapshots = {{"start of push", 0, 0, sample_state()},
                        {"end", 10e-3, 6e3, sample_state()}};
  r.stages = {
      {.name = "gravity", .time = 0.4, .steps = 4000, .unbalance_ratio = 1e-6, .settled = true}};
  r.steps = 12345;
  r.time_step = 1e-5;
  r.wall_seconds = 1.5;
  r.state_hash = "0123456789abcdef";
  return r;
}

}  // namespace wythe::scenes
