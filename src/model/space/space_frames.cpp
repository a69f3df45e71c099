// Frames in space -> sections between segments: the plane's three fibres, and what is elastic across the plane
// (docs/theory/frames.md, "In space").
#include <fmt/core.h>

#include <algorithm>

#include "geometry/wall/frames.h"
#include "model/parts.h"
#include "model/plane/fasteners.h"
#include "model/space/space.h"

namespace wythe {
namespace {

using geometry::FrameJoint;
using geometry::FramePart;
using geometry::Section;
using geometry::SpaceFrame;

class SpaceFrameCompiler {
 public:
  SpaceFrameCompiler(const ModelSpec& spec, const geometry::SpaceAssembly& assembly,
                     const std::vector<BlockId>& id, Model& model, FaultList& faults)
      : spec_(spec), assembly_(assembly), id_(id), model_(model), faults_(faults) {}

  void run() {
    if (!spec_.frame.empty() && spec_.solve.contacts == Contacts::kFree)
      faults_.add({"", "solve.contacts", "free", "does not know frames yet",
                   "leave it out, or leave the frames out", 0});
    for (const SpaceFrame& frame : assembly_.frames) add(frame);
  }

 private:
  [[nodiscard]] bool holds(std::size_t body, Vec3 p) const {
    constexpr double kNear = 1e-4;  // [m]
    const auto is_within = [&](const Polyhedron& part) {
      return std::all_of(part.face.begin(), part.face.end(), [&](const auto& corners) {
        const geometry::Facet facet = geometry::facet_of(part, corners);
        return dot(p - facet.centre, facet.normal) < kNear;
      });
    };
    const std::vector<Polyhedron>& parts = assembly_.body[body].part;
    return std::any_of(parts.begin(), parts.end(), is_within);
  }

  // The moving masonry at a place of the frame's plane that no stage cuts out; none where there is none.
  [[nodiscard]] std::optional<BlockId> masonry_at(Vec3 p) const {
    for (std::size_t k = 0; k < assembly_.body.size(); ++k) {
      const BodySpec& body = assembly_.body[k];
      if (!body.fixed && body.cut.empty() && !is_solid(id_[k]) &&
          geometry::frame_of(assembly_, static_cast<int>(k)) < 0 && holds(k, p))
        return id_[k];
    }
    return std::nullopt;
  }

  [[nodiscard]] FastenerSite site_of(const SpaceFrame& frame) const {
    return {
        .masonry_at = [&](Vec2 p) { return masonry_at(frame.plane.place(p)); },
        .segment_at = [&](Vec2 p) -> std::optional<BlockId> {
          for (std::size_t j = 0; j < frame.placed.segments.size(); ++j)
            if (holds(frame.first_body + j, frame.plane.place(p))) return id_[frame.first_body + j];
          return std::nullopt;
        },
        .arm = [&](BlockId of, Vec2 p) { return frame.plane.place(p) - model_.space.centroid[of]; },
        .turned = [&](Vec2 v) { return frame.plane.turned(v); },
        .across = frame.plane.across};
  }

  // A section in numbers, which the plane needs less of. Beams without their own have the columns' section.
  void need_across(const SectionSpec& section, const std::string& key) {
    if (!(section.area > 0)) return;
    const auto need = [&](const char* name, double value, const char* why, const char* example) {
      if (!(value > 0))
        faults_.add({"", path_ + "." + key + "." + name, "", std::string("is missing: ") + why,
                     std::string("write ") + name + " = \"" + example + "\", or name a profile",
                     0});
    };
    need("weak_second_moment", section.weak_second_moment,
         "in space a member bends across its plane", "2003 cm^4");
    need("torsion_constant", section.torsion_constant, "in space a member twists", "59.3 cm^4");
  }

  void add(const SpaceFrame& frame) {
    const std::size_t index = frame.placed.index;
    const FrameSpec& spec = spec_.frame[index];
    path_ = fmt::format("frame.{}", index);
    const std::size_t before = faults_.all().size();
    const FrameSteel steel = frame_steel(spec, path_, faults_);
    check_frame_gap(spec_, spec, path_, faults_);
    const auto sections = geometry::sections_of(spec, index, faults_);
    need_across(spec.section, "section");
    need_across(spec.beam_section, "beam_section");
    if (faults_.all().size() > before || !sections) return;
    Frames& f = model_.frames;
    const std::int32_t first = add_members(frame.placed, *sections, steel, f);
    for (const FrameJoint& joint : frame.placed.joints)
      add_section(frame, joint, first, *sections, steel);
    for (std::size_t k = 0; k < frame.placed.segments.size(); ++k) {
      const Vec3 moved = frame.plane.turned(frame.placed.moved[k]);
      if (moved.x == 0 && moved.y == 0 && moved.z == 0) continue;
      f.moved.push_back(block_of(frame, static_cast<int>(k)));
      f.moved_x.push_back(moved.x);
      f.moved_y.push_back(moved.y);
      f.moved_z.push_back(moved.z);
    }
    note_frame(frame.placed, spec, model_);
    if (spec.wedges.force > 0 && spec.stage.empty())
      faults_.add({"", path_ + ".wedges", "",
                   "are driven in while a stage puts the frame up, and this one stands from the "
                   "start",
                   "write stage = \"the name of a stage of kind cut\", or cut in its opening", 0});
    add_fasteners({spec_, spec, frame.placed, *sections, path_, site_of(frame)}, model_, faults_);
  }

  [[nodiscard]] BlockId block_of(const SpaceFrame& frame, int segment) const {
    return segment == geometry::kGround ? kGroundBlock
                                        : id_[frame.first_body + static_cast<std::size_t>(segment)];
  }

  void add_section(const SpaceFrame& frame, const FrameJoint& joint, std::int32_t first,
                   const geometry::FrameSections& sections, const FrameSteel& steel) {
    Frames& f = model_.frames;
    const FramePart& part = frame.placed.parts[joint.part];
    const Section& section = section_of(part, sections);
    const bool back = joint.b == geometry::kGround;  // the ground is side a
    const int a = back ? joint.b : joint.a, b = back ? joint.a : joint.b;
    const Vec3 at = frame.plane.place({part.from.x + joint.place * part.direction.x,
                                       part.from.y + joint.place * part.direction.y});
    const auto moved = [&](int segment) {
      return segment == geometry::kGround ? Vec3{}
                                          : frame.plane.turned(frame.placed.moved[segment]);
    };
    const auto arm = [&](int segment) {
      if (segment == geometry::kGround) return Vec3{};
      const Vec3 centroid = model_.space.centroid[block_of(frame, segment)];
      return at - (centroid + moved(segment));
    };
    const Vec3 arm_a = arm(a), arm_b = arm(b), rest = moved(b) - moved(a);
    const Vec2 direction = back ? Vec2{-part.direction.x, -part.direction.y} : part.direction;
    const Vec3 axis = frame.plane.turned(direction);
    f.a.push_back(block_of(frame, a));
    f.b.push_back(block_of(frame, b));
    f.arm_a_x.push_back(arm_a.x), f.arm_a_y.push_back(arm_a.y), f.arm_a_z.push_back(arm_a.z);
    f.arm_b_x.push_back(arm_b.x), f.arm_b_y.push_back(arm_b.y), f.arm_b_z.push_back(arm_b.z);
    f.axis_x.push_back(axis.x), f.axis_y.push_back(axis.y), f.axis_z.push_back(axis.z);
    f.rest_x.push_back(rest.x), f.rest_y.push_back(rest.y), f.rest_z.push_back(rest.z);
    f.left.push_back(frame.plane.turned({-direction.y, direction.x}));
    const double turns = joint.hinged ? 0 : 1;
    add_fibres(joint, first, steel, f);
    f.aside_stiffness.push_back(steel.shear * section.weak_shear_area / joint.length);
    f.lean_stiffness.push_back(turns * steel.youngs * section.weak_second_moment / joint.length);
    f.twist_stiffness.push_back(steel.shear * section.torsion_constant / joint.length);
  }

  const ModelSpec& spec_;
  const geometry::SpaceAssembly& assembly_;
  const std::vector<BlockId>& id_;
  Model& model_;
  FaultList& faults_;
  std::string path_;
};

}  // namespace

void compile_space_frames(const ModelSpec& spec, const geometry::SpaceAssembly& assembly,
                          const std::vector<BlockId>& id, Model& model, FaultList& faults) {
  SpaceFrameCompiler(spec, assembly, id, model, faults).run();
}

void check_space_frames(const Model& model, FaultList& faults) {
  const Frames& f = model.frames;
  const auto foot = std::find(f.a.begin(), f.a.end(), kGroundBlock);
  if (foot == f.a.end()) return;
  const std::size_t member = f.member[foot - f.a.begin()];
  const std::string& name = f.name[f.members[member].frame];
  for (std::size_t k = 0; k < model.stages.size(); ++k) {
    const std::vector<BlockId>& driven = model.stages[k].driven;
    if (!driven.empty() && driven.front() >= model.n_block)
      faults.add({"", fmt::format("stage.{}.at", k), "",
                  "drives supports, and the feet of frame " + name + " stand still in the ground",
                  "write feet = \"resting\", or push blocks", 0});
  }
}

}  // namespace wythe
