// Frames as placed -> sections between segments: arms, stiffnesses and yield forces (docs/theory/frames.md).
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "core/text.h"
#include "geometry/polygon.h"
#include "geometry/wall/frames.h"
#include "model/parts.h"
#include "model/plane/fasteners.h"

namespace wythe {
namespace {

using geometry::Assembly;
using geometry::FrameJoint;
using geometry::FramePart;
using geometry::PlacedFrame;
using geometry::Section;

// EN 1993-1-1, table 3.1 (thickness up to 40 mm) and 3.2.6.
const std::map<std::string, FrameSteel>& grades() {
  static const std::map<std::string, FrameSteel> kGrades = {{"S235", {235e6, 210e9, 81e9}},
                                                            {"S275", {275e6, 210e9, 81e9}},
                                                            {"S355", {355e6, 210e9, 81e9}}};
  return kGrades;
}

bool holds(const geometry::Polygon& outline, Vec2 p) {
  constexpr double kSpot = 1e-4;  // [m]
  const geometry::Rect spot{p.x - kSpot, p.y - kSpot, p.x + kSpot, p.y + kSpot};
  return geometry::overlaps(geometry::bounds(outline), spot, 0) &&
         geometry::overlap_area(outline, geometry::outline_of(spot)) > 0;
}

class FrameCompiler {
 public:
  FrameCompiler(const ModelSpec& spec, const Assembly& assembly, const BlockMap& map, Model& model,
                FaultList& faults)
      : spec_(spec), assembly_(assembly), map_(map), model_(model), faults_(faults) {}

  void run() {
    if (spec_.frame.empty()) return;
    if (spec_.solve.contacts == Contacts::kFree)
      faults_.add({"", "solve.contacts", "free", "does not know frames yet",
                   "leave it out, or leave the frames out", 0});
    for (const PlacedFrame& frame : assembly_.frames) add(frame);
  }

 private:
  void add(const PlacedFrame& placed) {
    const std::size_t index = placed.index;
    const FrameSpec& frame = spec_.frame[index];
    path_ = fmt::format("frame.{}", index);
    const std::size_t before = faults_.all().size();
    const FrameSteel steel = frame_steel(frame, path_, faults_);
    check_frame_gap(spec_, frame, path_, faults_);
    const auto sections = geometry::sections_of(frame, index, faults_);
    if (faults_.all().size() > before || !sections) return;
    std::vector<BlockId> block(placed.segments.size(), kGroundBlock);
    for (std::size_t b = 0; b < assembly_.blocks.size(); ++b)
      if (assembly_.blocks[b].frame == placed.index) block[assembly_.blocks[b].segment] = map_[b];
    Frames& f = model_.frames;
    const std::int32_t first = add_members(placed, *sections, steel, f);
    for (const FrameJoint& joint : placed.joints) add_section(placed, joint, first, block, steel);
    for (std::size_t k = 0; k < block.size(); ++k) {
      const Vec2 moved = placed.moved[k];
      if (moved.x == 0 && moved.y == 0) continue;
      f.moved.push_back(block[k]);
      f.moved_x.push_back(moved.x);
      f.moved_y.push_back(moved.y);
    }
    note_frame(placed, frame, model_);
    add_fasteners({spec_, frame, placed, *sections, path_, site_of(placed, block)}, model_,
                  faults_);
  }

  // The moving masonry at a place that no stage cuts out; none where there is none.
  [[nodiscard]] std::optional<BlockId> masonry_at(Vec2 p) const {
    for (std::size_t b = 0; b < assembly_.blocks.size(); ++b) {
      const geometry::Block& block = assembly_.blocks[b];
      if (block.frame < 0 && block.cut_from < 0 && map_[b] >= 0 && holds(block.outline, p))
        return map_[b];
    }
    return std::nullopt;
  }

  [[nodiscard]] FastenerSite site_of(const PlacedFrame& placed,
                                     const std::vector<BlockId>& block) const {
    return {.masonry_at = [this](Vec2 p) { return masonry_at(p); },
            .segment_at = [&](Vec2 p) -> std::optional<BlockId> {
              for (std::size_t j = 0; j < placed.segments.size(); ++j)
                if (holds(placed.segments[j].outline, p)) return block[j];
              return std::nullopt;
            },
            .arm =
                [this](BlockId of, Vec2 p) {
                  return Vec3{p.x - model_.centroid_x[of], p.y - model_.centroid_y[of], 0};
                },
            .turned =
                [](Vec2 v) {
                  return Vec3{v.x, v.y, 0};
                },
            .across = std::nullopt};
  }

  void add_section(const PlacedFrame& placed, const FrameJoint& joint, std::int32_t first,
                   const std::vector<BlockId>& block, const FrameSteel& steel) {
    Frames& f = model_.frames;
    const FramePart& part = placed.parts[joint.part];
    // the ground is side a
    const bool back = joint.b == geometry::kGround;
    const int a = back ? joint.b : joint.a, b = back ? joint.a : joint.b;
    const Vec2 at{part.from.x + joint.place * part.direction.x,
                  part.from.y + joint.place * part.direction.y};
    const auto id = [&](int segment) {
      return segment == geometry::kGround ? kGroundBlock : block[segment];
    };
    const auto moved = [&](int segment) {
      return segment == geometry::kGround ? Vec2{0, 0} : placed.moved[segment];
    };
    const auto arm = [&](int segment) {
      if (segment == geometry::kGround) return Vec2{0, 0};
      const std::size_t i = id(segment);
      const Vec2 by = moved(segment);
      return Vec2{at.x - (model_.centroid_x[i] + by.x), at.y - (model_.centroid_y[i] + by.y)};
    };
    const Vec2 arm_a = arm(a), arm_b = arm(b), moved_a = moved(a), moved_b = moved(b);
    f.a.push_back(id(a));
    f.b.push_back(id(b));
    f.arm_a_x.push_back(arm_a.x);
    f.arm_a_y.push_back(arm_a.y);
    f.arm_b_x.push_back(arm_b.x);
    f.arm_b_y.push_back(arm_b.y);
    f.axis_x.push_back(back ? -part.direction.x : part.direction.x);
    f.axis_y.push_back(back ? -part.direction.y : part.direction.y);
    f.rest_x.push_back(moved_b.x - moved_a.x);
    f.rest_y.push_back(moved_b.y - moved_a.y);
    add_fibres(joint, first, steel, f);
  }

  const ModelSpec& spec_;
  const Assembly& assembly_;
  const BlockMap& map_;
  Model& model_;
  FaultList& faults_;
  std::string path_;
};

}  // namespace

FrameSteel frame_steel(const FrameSpec& frame, const std::string& path, FaultList& faults) {
  const auto fault = [&](const char* key, std::string value, std::string problem,
                         std::string cure) {
    faults.add({"", path + "." + key, std::move(value), std::move(problem), std::move(cure), 0});
  };
  FrameSteel steel;
  if (!frame.grade.empty()) {
    const auto found = grades().find(frame.grade);
    if (found == grades().end())
      fault("grade", "\"" + frame.grade + "\"", "is no grade of steel that is known here",
            name_advice(frame.grade, {"S235", "S275", "S355"}) +
                " Or write yield_strength, youngs_modulus and shear_modulus");
    else
      steel = found->second;
  }
  const auto take = [&](const char* key, double stated, double& value, const char* example) {
    if (!std::isnan(stated)) value = stated;
    if (frame.grade.empty() && !(value > 0))
      fault(key, "", "is missing", fmt::format("write grade = \"S275\", or {} = {}", key, example));
  };
  take("yield_strength", frame.yield_strength, steel.yield, "\"275 MPa\"");
  take("youngs_modulus", frame.youngs_modulus, steel.youngs, "\"210 GPa\"");
  take("shear_modulus", frame.shear_modulus, steel.shear, "\"81 GPa\"");
  return steel;
}

const Section& section_of(const FramePart& part, const geometry::FrameSections& sections) {
  return std::fabs(part.direction.y) > std::fabs(part.direction.x) ? sections.column
                                                                   : sections.beam;
}

std::int32_t add_members(const PlacedFrame& placed, const geometry::FrameSections& sections,
                         const FrameSteel& steel, Frames& frames) {
  const auto first = static_cast<std::int32_t>(frames.members.size());
  for (const FramePart& part : placed.parts) {
    const Section& s = section_of(part, sections);
    frames.members.push_back({static_cast<int>(frames.name.size()), part.words, part.length,
                              part.from.x, part.from.y, part.direction.x, part.direction.y, s.area,
                              s.shear_area, s.second_moment, s.plastic_modulus, steel.youngs,
                              steel.yield, s.second_moment / s.plastic_modulus});
  }
  frames.name.push_back(placed.name);
  return first;
}

void add_fibres(const FrameJoint& joint, std::int32_t first, const FrameSteel& steel,
                Frames& frames) {
  const FrameMember& member = frames.members[first + joint.part];
  const double d = member.fibre;
  const double outer = joint.hinged ? 0 : member.second_moment / (2 * d * d);
  const double middle = member.area - 2 * outer;
  frames.outer_stiffness.push_back(steel.youngs * outer / joint.length);
  frames.middle_stiffness.push_back(steel.youngs * middle / joint.length);
  frames.shear_stiffness.push_back(steel.shear * member.shear_area / joint.length);
  frames.fibre.push_back(d);
  frames.outer_yield.push_back(steel.yield * outer);
  frames.middle_yield.push_back(steel.yield * middle);
  frames.member.push_back(first + joint.part);
  frames.place.push_back(joint.place);
  frames.length.push_back(joint.length);
  ++frames.n;
}

// A gap is open at the start: what can pull across it would have to be broken first.
void check_frame_gap(const ModelSpec& spec, const FrameSpec& frame, const std::string& path,
                     FaultList& faults) {
  const auto joint = spec.material.find(frame.joint);
  if (!(frame.gap > 0) || joint == spec.material.end()) return;
  const auto fault = [&](std::string problem, std::string cure) {
    faults.add({"", path + ".gap", fmt::format("{:g} mm", 1e3 * frame.gap), std::move(problem),
                std::move(cure), 0});
  };
  if (joint->second.tensile_strength > 0 || joint->second.cohesion > 0)
    fault(
        fmt::format("is open, and [material.{}] has strength in tension or cohesion", frame.joint),
        "name a dry joint: tensile_strength and cohesion 0 MPa; or leave the gap out");
  if (!(frame.gap < 0.05))
    fault("is wider than any gap: 50 mm at most",
          "write e.g. gap = \"5 mm\", or make the opening smaller");
}

void note_frame(const geometry::PlacedFrame& placed, const FrameSpec& frame, Model& model) {
  double weight = 0;
  for (const geometry::Block& segment : placed.segments)
    weight += segment.own_density * segment.thickness * geometry::moments(segment.outline).area;
  model.anatomy.notes.push_back({"frame.stands",
                                 {{"frame", placed.name},
                                  {"segments", placed.segments.size()},
                                  {"mass_kg", weight},
                                  {"gap_mm", 1e3 * frame.gap}}});
}

void compile_frames(const ModelSpec& spec, const Assembly& assembly, const BlockMap& map,
                    Model& model, FaultList& faults) {
  FrameCompiler(spec, assembly, map, model, faults).run();
}

}  // namespace wythe
