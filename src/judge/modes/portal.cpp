// Cuts a wall with one opening into the macro-blocks of FM-1 and FM-4.
//
//        C12                         push ->    bodies, for a push towards +x (mirrored otherwise):
//   +-----o----------+------+                     left pier      turns about its inner toe C1
//   | left|spandrel  |right |                     spandrel       from C12 to C23
//   |     |          o------+                     right pier     turns about its outer toe C3;
//   +-----+         C23  .  |                                    FM-1: only what lies above the
//   |     |          | .    |                                    diagonal from the opening's corner
//   |     |          |   .  |                                    to the toe
//   +-----o          +------o
//        C1                 C3
//
// Weights are those of the blocks, or parts of blocks, inside each body; a deformable lintel counts as
// one rigid block. Reference: Pulatsu et al.
// (2022), section 6; hinges: docs/theory/limit_analysis.md.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/polygon.h"
#include "judge/assessment/assessment_parts.h"
#include "judge/modes/wall_parts.h"
#include "limit/limit_loads.h"
#include "wythe/parts/error.h"
#include "wythe/parts/limit.h"
#include "wythe/parts/reading.h"

namespace wythe {
namespace {

using geometry::Polygon;

constexpr double kStressBlock = 0.85;  // of fc, in the crushed part of a joint

// --- description of the wall ------------------------------------------------------------------------

void add_fault(FaultList& faults, std::string path, std::string value, std::string problem,
               std::string cure) {
  faults.add({.path = std::move(path),
              .value = std::move(value),
              .problem = std::move(problem),
              .cure = std::move(cure)});
}

// The motion of three hinged bodies is fixed. Other restraints of the pushed blocks are refused.
void refuse_what_chains_ignore(const Model& model, const Stage& push, const Portal& portal,
                               FaultList& faults) {
  const std::string stage = "stage." + push.spec.name;
  const char* cure = "leave it out, or take the limit load of the blocks, which counts it";
  if (push.push()->fixity.rotation == Freedom::kBlocked)
    add_fault(faults, stage + ".rotation", "blocked", "the macro-blocks turn where they are pushed",
              cure);
  if (push.push()->fixity.across == Freedom::kBlocked)
    add_fault(faults, stage + ".across", "blocked", "the macro-blocks rise where they are pushed",
              cure);
  for (const BlockId b : push.driven) {
    if (!push.moves_each()) break;
    const double off = model.centroid_y[b] - portal.load_point.y;
    if (std::fabs(off) < 1e-6) continue;
    add_fault(faults, stage + ".as", "each",
              "blocks at several heights that move alike would keep a macro-block from turning",
              cure);
    break;
  }
  if (std::isfinite(push.drive_arm))
    add_fault(faults, stage + ".contraflexure", fmt::format("{:g}", push.push()->contraflexure),
              "macro-blocks are pushed at a point of theirs, and here it is the end of an arm",
              cure);
  if (push.has_pattern())
    add_fault(faults, stage + ".pattern", word_of(kPatternWords, push.push()->pattern),
              "macro-blocks are pushed at one point", cure);
  const Stage* grows = limit::growing_stage(model);
  for (const Stage& s : model.stages)
    if (s.spec.kind() == StageKind::kBodyForce || s.spec.kind() == StageKind::kTilt)
      add_fault(faults, "stage." + s.spec.name, "",
                grows == &s
                    ? "is what grows last, not the push"
                    : "stays in force under the push, and macro-blocks carry dead loads only",
                cure);
}

void evaluate_push(const Model& model, Portal& portal, FaultList& faults) {
  const Stage* push = study::push_of(model);
  if (push == nullptr || push->drive_x == 0 || push->driven.empty()) {
    add_fault(faults, "stage", push == nullptr ? "" : push->spec.name,
              push == nullptr ? "no stage pushes the wall" : "the push is not horizontal",
              "macro-blocks need a push along x, e.g. at = { x = \"0 m\", y = \"3.12 m\" }, "
              "direction = \"+x\"; the limit load of the blocks takes any");
    return;
  }
  for (std::size_t k = 0; k < push->driven.size(); ++k) {
    const std::size_t b = push->driven[k];
    portal.load_point.x += push->driven_share[k] * model.centroid_x[b];
    portal.load_point.y += push->driven_share[k] * model.centroid_y[b];
  }
  const auto n = static_cast<double>(push->driven.size());
  portal.load_point = {portal.load_point.x / n, portal.load_point.y / n};
  portal.direction = push->drive_x > 0 ? 1 : -1;
  if (limit::goes_back(*push)) portal.direction = -portal.direction;
  refuse_what_chains_ignore(model, *push, portal, faults);
}

void evaluate_opening(const study::WallParts& parts, const std::vector<study::Box>& openings,
                      Portal& portal, FaultList& faults) {
  portal.left = parts.wall.x0, portal.right = parts.wall.x1, portal.top = parts.wall.y1;
  portal.block_height = parts.course;
  if (openings.size() != 1) {
    add_fault(faults, "wall.opening", fmt::format("{}", openings.size()),
              openings.empty()
                  ? "no opening between two piers (one at the wall's edge has a pier on "
                    "one side only)"
                  : "more than one opening: no chain of three macro-blocks",
              "the mechanisms FM-1 and FM-4 are those of two piers and one opening with masonry "
              "above it; the limit load of the blocks takes any wall");
    return;
  }
  const study::Box& hole = openings.front();
  portal.jamb_left = hole.x0, portal.jamb_right = hole.x1;
  portal.foot = hole.y0, portal.head = hole.y1;
}

// The weakest joint in which a pier's foot may crush.
void evaluate_strength(const Model& model, Portal& portal) {
  portal.compressive_strength = std::numeric_limits<double>::infinity();
  for (int j = 0; j < model.n_joint; ++j) {
    const JointKind kind = model.anatomy.joint_kind[j];
    if (kind != JointKind::kBed && kind != JointKind::kFoundation && kind != JointKind::kOther)
      continue;
    const std::size_t m = model.joint_material[j];
    if (model.materials[m].compressive_strength >= portal.compressive_strength) continue;
    portal.compressive_strength = model.materials[m].compressive_strength;
    portal.strength_material = model.material_names[m];
  }
}

bool has(const Model& model, BlockRole role) {
  const auto& roles = model.anatomy.block_role;
  return std::find(roles.begin(), roles.end(), role) != roles.end();
}

// Whether the masonry has several thicknesses; stands_on_steps(): whether foundation joints lie at several heights.
bool has_several_thicknesses(const Model& model) {
  const Anatomy& a = model.anatomy;
  for (std::size_t b = 0; b < a.block_role.size(); ++b)
    if (a.block_role[b] == BlockRole::kMasonry &&
        std::fabs(a.block_thickness[b] - a.thickness) > 1e-9 * a.thickness)
      return true;
  return false;
}

bool stands_on_steps(const Model& model) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (JointId j = 0; j < model.n_joint; ++j) {
    const JointShape joint = joint_shape(model, j);
    if (joint.a != kGroundBlock) continue;
    low = std::min(low, joint.centre.y), high = std::max(high, joint.centre.y);
  }
  return high - low > 1e-6;
}

void check_load_point(const Portal& p, FaultList& faults) {
  const Vec2 at = p.load_point;
  const bool inside = at.x >= p.left && at.x <= p.right && at.y >= p.foot && at.y <= p.top;
  const bool in_hole = at.x > p.jamb_left && at.x < p.jamb_right && at.y < p.head;
  if (inside && !in_hole) return;
  add_fault(faults, "stage.push.at", fmt::format("({:.3f} m, {:.3f} m)", at.x, at.y),
            "the load point lies outside the macro-blocks",
            fmt::format("push between x = {:.3f} and {:.3f} m, y = {:.3f} and {:.3f} m", p.left,
                        p.right, p.foot, p.top));
}

// --- bodies ----------------------------------------------------------------------------------------

bool holds(const Polygon& convex, Vec2 p) {
  for (std::size_t i = 0; i < convex.size(); ++i) {
    const Vec2 a = convex[i], b = convex[(i + 1) % convex.size()];
    if (cross(b - a, p - a) < 0) return false;
  }
  return true;
}

// Self-weight of the blocks inside a convex outline, at their common centroid.
BodyLoad weight_inside(const Model& model, const Polygon& outline) {
  BodyLoad weight;
  weight.is_weight = true;
  for (std::size_t b = 0; b < model.gravity_mass.size(); ++b) {
    const Polygon block = geometry::polygon_of(outline_of(model, static_cast<BlockId>(b)));
    const Polygon part = geometry::part_inside(block, outline);
    if (part.empty()) continue;
    const auto m = geometry::moments(part);
    const double newton =
        model.solve.gravity * model.gravity_mass[b] * m.area / geometry::moments(block).area;
    weight.fy -= newton;
    weight.at.x += newton * m.centroid.x;
    weight.at.y += newton * m.centroid.y;
  }
  if (weight.fy < 0) weight.at = {weight.at.x / -weight.fy, weight.at.y / -weight.fy};
  return weight;
}

// The share of a point load that a body takes: one half each where two bodies meet at a vertical line.
double share_of(const Portal& p, const Polygon& outline, Vec2 at) {
  constexpr double kNear = 1e-6;  // [m], above the round-off of coordinates, below any unit
  const double x = std::clamp(at.x, p.left + 2 * kNear, p.right - 2 * kNear);
  const double y = std::min(at.y, p.top - kNear);  // above the wall: on what is below
  return 0.5 * (holds(outline, {x - kNear, y}) + holds(outline, {x + kNear, y}));
}

void add_dead_loads(const Model& model, const Portal& portal, const Polygon& outline,
                    std::vector<BodyLoad>& loads) {
  const Stage* grows = limit::growing_stage(model);
  for (const Stage& stage : model.stages) {
    if (&stage == grows) break;
    for (const PointLoad& p : stage.loads) {
      const std::size_t b = p.block;
      const Vec2 at{model.centroid_x[b] + p.arm_x, model.centroid_y[b] + p.arm_y};
      const double share = share_of(portal, outline, at);
      if (share > 0) loads.push_back({at, share * p.fx, share * p.fy});
    }
  }
}

double sum_of_weights(const std::vector<BodyLoad>& loads) {
  double sum = 0;
  for (const BodyLoad& load : loads) sum -= load.fy;
  return sum;
}

// Cuts in the frame of the push: s runs along the push, from the end where it comes from.
class PortalCutter {
 public:
  PortalCutter(const Model& model, const Portal& portal, bool cracked)
      : model_(model),
        p_(portal),
        cracked_(cracked),
        near_(portal.direction > 0 ? portal.jamb_left - portal.left
                                   : portal.right - portal.jamb_right),
        far_(portal.direction > 0 ? portal.jamb_right - portal.left
                                  : portal.right - portal.jamb_left),
        length_(portal.right - portal.left) {}

  // Vertical loads on C1 and C3 by influence area: the loads on each side of the spandrel's middle.
  struct Axial {
    double near = 0, far = 0;
  };
  [[nodiscard]] Axial axial() const {
    const double middle = 0.5 * (near_ + far_);
    const auto weight = [&](const std::vector<Vec2>& outline) {
      return sum_of_weights(loads_on(outline));
    };
    return {weight(near_pier()) + weight(box(near_, middle, p_.head, p_.top)),
            weight(far_pier(length_)) + weight(box(middle, far_, p_.head, p_.top))};
  }

  // `inwards`: of C1 and C3; `shift`: of C12 down and C23 up [m].
  [[nodiscard]] Chain cut(const Axial& inwards, double shift) const {
    Chain chain;
    chain.hinges = {at(near_ - inwards.near, p_.foot), at(near_, p_.top - shift),
                    at(far_, p_.head + shift), at(length_ - inwards.far, p_.foot)};
    const bool forward = p_.direction > 0;
    add(chain, forward ? "left pier" : "right pier", near_pier());
    add(chain, "spandrel", box(near_, far_, p_.head, p_.top));
    add(chain, forward ? "right pier" : "left pier", far_pier(length_ - inwards.far));
    chain.load_point = p_.load_point;
    chain.direction = p_.direction;
    chain.loaded_body = -1;
    double most = 0;  // on a jamb the pier takes it, because it comes first
    for (std::size_t i = 0; i < chain.bodies.size(); ++i) {
      const double share = share_of(p_, chain.bodies[i].outline, p_.load_point);
      if (share > most) chain.loaded_body = static_cast<int>(i);
      most = std::max(most, share);
    }
    return chain;
  }
  [[nodiscard]] double near_width() const { return near_; }
  [[nodiscard]] double far_width() const { return length_ - far_; }

 private:
  [[nodiscard]] Vec2 at(double s, double y) const {
    return {p_.direction > 0 ? p_.left + s : p_.right - s, y};
  }
  // Anticlockwise in the wall's axes.
  [[nodiscard]] std::vector<Vec2> turned_right(std::vector<Vec2> outline) const {
    if (p_.direction < 0) std::reverse(outline.begin(), outline.end());
    return outline;
  }
  [[nodiscard]] std::vector<Vec2> box(double s0, double s1, double y0, double y1) const {
    return turned_right({at(s0, y0), at(s1, y0), at(s1, y1), at(s0, y1)});
  }
  [[nodiscard]] std::vector<Vec2> near_pier() const { return box(0, near_, p_.foot, p_.top); }
  // The whole far pier, or its part above the diagonal that ends at `toe`.
  [[nodiscard]] std::vector<Vec2> far_pier(double toe) const {
    if (!cracked_) return box(far_, length_, p_.foot, p_.top);
    std::vector<Vec2> outline{at(far_, p_.head), at(toe, p_.foot)};
    if (toe < length_) outline.push_back(at(length_, p_.foot));
    outline.push_back(at(length_, p_.top));
    outline.push_back(at(far_, p_.top));
    return turned_right(outline);
  }

  [[nodiscard]] std::vector<BodyLoad> loads_on(const std::vector<Vec2>& outline) const {
    std::vector<BodyLoad> loads{weight_inside(model_, outline)};
    add_dead_loads(model_, p_, outline, loads);
    return loads;
  }
  void add(Chain& chain, const std::string& name, const std::vector<Vec2>& outline) const {
    chain.bodies.push_back({name, outline, loads_on(outline)});
  }

  const Model& model_;
  const Portal& p_;
  bool cracked_;
  double near_, far_, length_;  // jambs and end, from where the push comes
};

[[noreturn]] void refuse(std::string path, std::string value, std::string problem,
                         std::string cure) {
  FaultList faults;
  add_fault(faults, std::move(path), std::move(value), std::move(problem), std::move(cure));
  faults.throw_if_any();
  throw std::logic_error("unreachable");
}

// t_h = W / (2 0.85 fc t), eq. (13) of the paper.
double crushed_half(const Portal& p, double weight, double width, const std::string& hinge) {
  if (!(p.compressive_strength > 0) || std::isinf(p.compressive_strength))
    refuse("material.joint.compressive_strength", "unlimited",
           "Macro-Block 1 and 2 need a compressive strength",
           "give one, e.g. compressive_strength = \"3.96 MPa\"; the other analyses do without");
  const double half = weight / (2 * kStressBlock * p.compressive_strength * p.thickness);
  if (2 * half >= width)
    refuse("material." + p.strength_material + ".compressive_strength",
           fmt::format("{:.4g} MPa", 1e-6 * p.compressive_strength),
           fmt::format("{:.4g} kN on hinge {} crush the pier's whole foot", 1e-3 * weight, hinge),
           "raise the strength or the pier's width, or lower the loads");
  return half;
}

std::vector<NamedNumber> numbers_of(const Portal& p, const PortalCutter::Axial& axial,
                                    const PortalCutter::Axial& inwards, double shift) {
  return {{"wall_left", p.left, "m"},
          {"wall_right", p.right, "m"},
          {"opening_left", p.jamb_left, "m"},
          {"opening_right", p.jamb_right, "m"},
          {"pier_foot", p.foot, "m"},
          {"opening_head", p.head, "m"},
          {"wall_top", p.top, "m"},
          {"thickness", p.thickness, "m"},
          {"block_height", p.block_height, "m"},
          {"load_point_x", p.load_point.x, "m"},
          {"load_point_y", p.load_point.y, "m"},
          {"push_direction", p.direction, "-"},
          {"compressive_strength", p.compressive_strength, "Pa"},
          {"stress_block_factor", kStressBlock, "-"},
          {"weight_on_C1", axial.near, "N"},
          {"weight_on_C3", axial.far, "N"},
          {"C1_inwards", inwards.near, "m"},
          {"C3_inwards", inwards.far, "m"},
          {"C12_down", shift, "m"},
          {"C23_up", shift, "m"}};
}

// Hinges must open as drawn: both piers turn with the push, the spandrel against it. So
// C1 C12 must be steeper than the extension of C12 C23: the far pier's lever, (6.8).
void check_lever(const Portal& p, const Mechanism& m) {
  const std::vector<Vec2>& c = m.chain.hinges;
  const double width = std::fabs(c[2].x - c[1].x), far = std::fabs(c[3].x - c[2].x);
  if ((c[2].y - c[3].y) * width > far * (c[1].y - c[2].y)) return;
  refuse("wall.opening", fmt::format("{:.3f} m of spandrel above it", p.top - p.head),
         "a pier would turn against the push: the spandrel is too deep, or the far pier too wide, "
         "for the chain of " +
             m.mode,
         "its hinges belong to walls where (opening height) x (opening width) > (far pier's width) "
         "x (spandrel depth); the limit load of the blocks takes any wall");
}

// If the push is on the near pier, its place is right, and another mechanism governs.
std::string cure_of_pull(const Portal& p) {
  const bool forward = p.direction > 0;
  const double end = forward ? p.left : p.right, jamb = forward ? p.jamb_left : p.jamb_right;
  if (forward ? p.load_point.x <= jamb : p.load_point.x >= jamb)
    return "the push stands where this chain wants it: the wall fails by another mechanism; take "
           "the "
           "limit load of the blocks, or load the piers more";
  return fmt::format(
      "push on the {} pier, e.g. at.x = {:.3f} m, or the other way, direction = \"{}x\"; the limit "
      "load of the blocks takes any place",
      forward ? "left" : "right", end, forward ? "-" : "+");
}

// Refuses a mechanism with tension in a hinge, because cracks carry
// none: the push then belongs on the other side of the chain.
void check_hinges(const Portal& p, const Mechanism& m) {
  const double force = m.curve.states.front().force;
  const std::vector<Vec2> h = hinge_forces(m.chain, force);
  // compression: the ground lifts, the spandrel holds the near pier back and pushes the far one
  const double pressure[] = {h[0].y, -p.direction * h[1].x, p.direction * h[2].x, h[3].y};
  const char* const names[] = {"C1", "C12", "C23", "C3"};
  for (std::size_t i = 0; i < 4; ++i) {
    if (pressure[i] >= -1e-9 * force) continue;
    refuse(
        "stage.push.at", fmt::format("({:.3f} m, {:.3f} m)", p.load_point.x, p.load_point.y),
        fmt::format("hinge {} of {} would have to pull with {:.3g} kN, and cracks carry no tension",
                    names[i], m.mode, -1e-3 * pressure[i]),
        cure_of_pull(p));
  }
}

}  // namespace

std::string Mechanism::file_name() const {
  return fmt::format("mechanism_{}_{}", mode == "FM-1" ? "fm1" : "fm4",
                     word_of(kHypothesisWords, hypothesis));
}

Portal find_portal(const Model& model) {
  if (!model.solids.bodies.empty()) return find_portal(with_rigid_bodies(model));
  FaultList faults;
  Portal portal;
  if (dimension_of(model) == 3)
    add_fault(faults, "wall.blocks", "", "is a wall in space, and macro-blocks are for plane walls",
              "read the limit loads instead");
  faults.throw_if_any();
  const study::WallParts parts = study::find_parts(model);
  evaluate_opening(parts, study::find_openings(model), portal, faults);
  evaluate_push(model, portal, faults);
  if (has_several_thicknesses(model))
    add_fault(faults, "wall.thickness", "",
              "macro-blocks have one thickness, and this masonry has several",
              "read the limit load of the blocks, which takes any wall");
  if (has(model, BlockRole::kRingBeam))
    add_fault(faults, "ring_beam", "", "a ring beam ties the macro-blocks together",
              "leave it out for the mechanisms; the limit load of the blocks takes it");
  if (stands_on_steps(model))
    add_fault(faults, "wall.foundation", "", "the macro-blocks stand on ground of one level",
              "leave it out for the mechanisms; the limit load of the blocks takes any ground");
  if (has(model, BlockRole::kBeam))
    add_fault(faults, "wall.beam", "", "a loading beam ties the macro-blocks together",
              "load the piers with pier_load instead; the limit load of the blocks takes any wall");
  if (model.frames.n > 0)
    add_fault(faults, "frame", model.frames.name.front(),
              "helps to carry, and macro-blocks know no frames", "leave it out for the mechanisms");
  if (model.standing.any())
    add_fault(faults, "wall.opening", "", "is cut by a stage, and macro-blocks know no stages",
              "leave cut out of the openings for the mechanisms");
  const auto& kinds = model.anatomy.joint_kind;  // only mortar has no fibres
  if (model.layers.n > 0 || std::find(kinds.begin(), kinds.end(), JointKind::kCoat) != kinds.end())
    add_fault(faults, "layer", model.layers.n > 0 ? model.layers.name.front() : "mortar",
              "helps to carry, and macro-blocks know no layers", "leave it out for the mechanisms");
  if (model.links.n > 0)
    add_fault(faults, std::string(word_of(kLinkKindWords, model.links.kind.front())),
              model.links.name.front(), "holds the wall, and macro-blocks know no ties",
              "leave it out for the mechanisms; the limit load of the blocks takes it");
  if (faults.empty()) check_load_point(portal, faults);
  faults.throw_if_any();
  portal.thickness = model.anatomy.thickness;
  evaluate_strength(model, portal);
  return portal;
}

Mechanism cut_mechanism(const Model& model, const Portal& portal, const std::string& mode,
                        Hypothesis hypothesis) {
  if (!model.solids.bodies.empty())
    return cut_mechanism(with_rigid_bodies(model), portal, mode, hypothesis);
  const PortalCutter cutter(model, portal, mode == "FM-1");
  const PortalCutter::Axial axial = cutter.axial();
  PortalCutter::Axial inwards;
  if (hypothesis != Hypothesis::kInfinite)
    inwards = {crushed_half(portal, axial.near, cutter.near_width(), "C1"),
               crushed_half(portal, axial.far, cutter.far_width(), "C3")};
  const double shift = hypothesis == Hypothesis::kMacroBlock2 ? portal.block_height : 0;
  if (2 * shift >= portal.top - portal.head)
    refuse("wall.opening", fmt::format("{:.3f} m above it", portal.top - portal.head),
           "the spandrel is no deeper than two blocks: Macro-Block 2 has no lever",
           "the other hypotheses take this wall");
  Mechanism m;
  m.mode = mode;
  m.hypothesis = hypothesis;
  m.chain = cutter.cut(inwards, shift);
  if (m.chain.loaded_body < 0)
    refuse("stage.push.at",
           fmt::format("({:.3f} m, {:.3f} m)", portal.load_point.x, portal.load_point.y),
           "the load point lies on the part of the wall that stays in " + mode,
           "push higher, beside the spandrel");
  m.inputs = numbers_of(portal, axial, inwards, shift);
  check_lever(portal, m);
  m.curve = follow(m.chain);
  check_hinges(portal, m);
  return m;
}

}  // namespace wythe
