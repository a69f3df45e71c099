#include "report/wall_arrays.h"

#include <algorithm>
#include <cmath>

namespace wythe::report {
namespace {

template <class To, class From>
std::vector<To> as(const std::vector<From>& values) {
  std::vector<To> out;
  out.reserve(values.size());
  for (const From& v : values) out.push_back(static_cast<To>(v));
  return out;
}

void add_floats(Bundle& bundle, const std::string& name, const std::vector<double>& values) {
  bundle.add(name, std::span<const float>(as<float>(values)));
}

// What one joint shows: the largest of its points, and the resultant of their stresses.
struct JointFace {
  double opening = -HUGE_VAL, slip = 0, damage = 0, crushing = 0;
  double compression = 0, shear = 0, moment = 0;  // [N], [N], [N] per half face
};

JointFace face_of(const Model& model, JointId joint, const std::vector<PointStress>& points) {
  JointFace face;
  for (int k = 0; k < model.n_face_point; ++k) {
    const PointStress& p = points[joint * model.n_face_point + k];
    const double area = model.area[joint] * model.point_weight[k];
    face.opening = std::fmax(face.opening, p.opening);
    if (std::fabs(p.slip) > std::fabs(face.slip)) face.slip = p.slip;
    face.damage = std::fmax(face.damage, p.damage);
    face.crushing = std::fmax(face.crushing, p.crushing);
    face.compression -= area * p.normal_stress;
    face.shear += area * p.shear_stress;
    face.moment -= area * p.normal_stress * model.point_xi[k];
  }
  return face;
}

// The stage that pushes, or nullptr.
const Stage* push_of(const Model& model) {
  for (auto stage = model.stages.rbegin(); stage != model.stages.rend(); ++stage)
    if (!stage->driven.empty()) return &*stage;
  return nullptr;
}

}  // namespace

void add_wall(Bundle& bundle, const Model& model) {
  const Anatomy& a = model.anatomy;
  Json wall = {{"length", a.length},   {"height", a.height},      {"thickness", a.thickness},
               {"courses", a.courses}, {"blocks", model.n_block}, {"joints", model.n_joint},
               {"pairs", model.n_pair}};
  if (const Stage* push = push_of(model)) {
    wall["push"] = {push->drive_x, push->drive_y};
    wall["load_height"] = push->load_height;
    bundle.add("wall.driven", std::span<const BlockId>(push->driven));
  }
  bundle.header["wall"] = wall;
  bundle.add("wall.outline_begin", std::span<const int>(a.outline_begin));
  add_floats(bundle, "wall.outline_x", a.outline_x);
  add_floats(bundle, "wall.outline_y", a.outline_y);
  add_floats(bundle, "wall.centroid_x", model.centroid_x);
  add_floats(bundle, "wall.centroid_y", model.centroid_y);
  add_floats(bundle, "wall.thickness", a.block_thickness);
  bundle.add("wall.role", std::span<const std::uint8_t>(as<std::uint8_t>(a.block_role)));
  bundle.add("wall.joint_a", std::span<const BlockId>(model.joint_a));
  bundle.add("wall.joint_b", std::span<const BlockId>(model.joint_b));
  bundle.add("wall.kind", std::span<const std::uint8_t>(as<std::uint8_t>(a.joint_kind)));
  add_floats(bundle, "wall.arm_a_x", model.arm_a_x);
  add_floats(bundle, "wall.arm_a_y", model.arm_a_y);
  add_floats(bundle, "wall.arm_b_x", model.arm_b_x);
  add_floats(bundle, "wall.arm_b_y", model.arm_b_y);
  add_floats(bundle, "wall.half_x", model.half_x);
  add_floats(bundle, "wall.half_y", model.half_y);
  bundle.add("wall.support_begin", std::span<const int>(a.support_begin));
  add_floats(bundle, "wall.support_x", a.support_x);
  add_floats(bundle, "wall.support_y", a.support_y);
}

void FrameArrays::add(const Model& model, const State& state) {
  ++count_;
  ux_.insert(ux_.end(), state.ux.begin(), state.ux.end());
  uy_.insert(uy_.end(), state.uy.begin(), state.uy.end());
  theta_.insert(theta_.end(), state.theta.begin(), state.theta.end());
  const std::vector<PointStress> points = point_stresses(model, state);
  for (JointId j = 0; j < model.n_joint; ++j) {
    const JointFace face = face_of(model, j, points);
    opening_.push_back(std::fmax(0.0, face.opening));
    slip_.push_back(face.slip);
    damage_.push_back(share_byte(face.damage));
    crushing_.push_back(share_byte(face.crushing));
    if (!with_forces_) continue;
    compression_.push_back(face.compression);
    shear_.push_back(face.shear);
    const bool presses = face.compression > 0;
    eccentricity_.push_back(presses ? std::clamp(face.moment / face.compression, -1.0, 1.0) : 0.0);
  }
}

void FrameArrays::write(Bundle& bundle) const {
  bundle.add_rounded("frame.ux", ux_);
  bundle.add_rounded("frame.uy", uy_);
  bundle.add_rounded("frame.theta", theta_);
  bundle.add_rounded("frame.opening", opening_);
  bundle.add_rounded("frame.slip", slip_);
  bundle.add("frame.damage", std::span<const std::uint8_t>(damage_));
  bundle.add("frame.crushing", std::span<const std::uint8_t>(crushing_));
  if (!with_forces_) return;
  bundle.add_rounded("frame.compression", compression_);
  bundle.add_rounded("frame.shear", shear_);
  bundle.add_rounded("frame.eccentricity", eccentricity_);
}

}  // namespace wythe::report
