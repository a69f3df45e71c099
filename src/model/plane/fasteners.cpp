// Each anchor is a link along its axis and one across it, in space two; each wedge is a jack with friction
// (docs/theory/frames.md, "Anchors and wedges").
#include "model/plane/fasteners.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "core/elementary.h"
#include "core/to_int.h"

namespace wythe {
namespace {

using geometry::FramePart;

constexpr double kOnFace = 1e-3;  // distance from a face up to which masonry counts [m]

class FastenerCompiler {
 public:
  FastenerCompiler(const Fastened& fastened, Model& model, FaultList& faults)
      : f_(fastened), model_(model), faults_(faults) {}

  void run() {
    add_anchors();
    add_wedges();
  }

 private:
  void fault(const std::string& key, std::string value, std::string problem, std::string cure) {
    faults_.add(
        {"", f_.path + "." + key, std::move(value), std::move(problem), std::move(cure), 0});
  }

  // A place on the outside of a member: the segment there, the direction away from its axis, and the unit behind it.
  struct Footing {
    BlockId segment, masonry;
    Vec2 face, normal, behind;
  };
  // Places on both sides of part `k`, `spacing` apart and centred, where masonry lies at the face and `depth` behind it.
  [[nodiscard]] std::vector<Footing> footings(std::size_t k, double spacing, double depth) const {
    const FramePart& part = f_.placed.parts[k];
    const bool upright = std::fabs(part.direction.y) > std::fabs(part.direction.x);
    const double half = (upright ? f_.sections.column : f_.sections.beam).height / 2;
    const int count = std::max(1, to_int(std::floor(part.length / spacing + 1e-9)));
    std::vector<Footing> found;
    for (int i = 0; i < count; ++i) {
      const double s = 0.5 * part.length + (i - 0.5 * (count - 1)) * spacing;
      const Vec2 axis{part.from.x + s * part.direction.x, part.from.y + s * part.direction.y};
      for (const double side : {1.0, -1.0}) {
        const Vec2 n{-side * part.direction.y, side * part.direction.x};
        const Vec2 face{axis.x + half * n.x, axis.y + half * n.y};
        const Vec2 behind{face.x + depth * n.x, face.y + depth * n.y};
        const auto masonry = f_.site.masonry_at(behind);
        if (!masonry || !f_.site.masonry_at({face.x + kOnFace * n.x, face.y + kOnFace * n.y}))
          continue;
        if (const auto segment = f_.site.segment_at(axis))
          found.push_back({*segment, *masonry, face, n, behind});
      }
    }
    return found;
  }

  // Whether the parts of the frame have room for links so close. A fault where they would have more than any frame:
  // probably a spacing in metres that was meant in another unit.
  [[nodiscard]] bool have_room(const std::string& key, double spacing) {
    constexpr double kMost = 1000;  // a frame of 100 m with anchors each 100 mm
    double length = 0;
    for (const FramePart& part : f_.placed.parts) length += part.length;
    if (length / spacing <= kMost) return true;
    fault(key, fmt::format("{:g} mm", 1e3 * spacing),
          fmt::format("makes more than {:g} places along {:.4g} m of frame", kMost, length),
          fmt::format("write {:.4g} mm or more", std::ceil(1e3 * length / kMost)));
    return false;
  }

  // Adds a link between the face of the segment and a place in the unit.
  void add(std::string name, LinkKind kind, const Footing& at, Vec2 far, Vec3 span,
           double stiffness, double tension, double press, double jack = 0) {
    add_link(model_.links,
             {std::move(name), kind, at.segment, at.masonry, f_.site.arm(at.segment, at.face),
              f_.site.arm(at.masonry, far), span, false, stiffness, tension, press, jack});
  }
  // Adds links across the axis: one in the frame's plane, in space one normal to it too.
  void add_across(const std::string& name, const Footing& at, double stiffness, double strength) {
    add(name, LinkKind::kDowel, at, at.face, f_.site.turned({-at.normal.y, at.normal.x}), stiffness,
        strength, strength);
    if (f_.site.across)
      add(name + " aside", LinkKind::kDowel, at, at.face, *f_.site.across, stiffness, strength,
          strength);
  }

  void add_anchors() {
    const AnchorSpec& a = f_.frame.anchors;
    if (!is_given("anchors", {{"spacing", a.spacing},
                              {"depth", a.depth},
                              {"tension", a.tension},
                              {"shear", a.shear}}))
      return;
    if (f_.frame.gap > 0)
      return fault("anchors", "", "bridge a gap, in which they would bend",
                   "leave the gap out, or the anchors");
    if (!have_room("anchors.spacing", a.spacing)) return;
    int count = 0;
    for (std::size_t k = 0; k < f_.placed.parts.size(); ++k)
      for (const Footing& at : footings(k, a.spacing, a.depth)) {
        ++count;
        const auto name = [&](LinkKind kind) {
          return fmt::format("{} {} {}", f_.placed.name, word_of(kLinkKindWords, kind), count);
        };
        // the joint carries compression
        add(name(LinkKind::kAnchor), LinkKind::kAnchor, at, at.behind, f_.site.turned(at.normal),
            a.tension / a.slip, a.tension, 0);
        add_across(name(LinkKind::kDowel), at, a.shear / a.slip, a.shear);
      }
    if (count == 0)
      return fault("anchors.depth", fmt::format("{:g} mm", 1e3 * a.depth),
                   "meets no masonry so far behind the frame's face",
                   "let the frame touch masonry, or write the depth where that holds the anchors");
    model_.anatomy.notes.push_back({"frame.anchored",
                                    {{"frame", f_.placed.name},
                                     {"count", count},
                                     {"tension_kN", 1e-3 * a.tension},
                                     {"shear_kN", 1e-3 * a.shear}}});
  }

  void add_wedges() {
    const WedgeSpec& w = f_.frame.wedges;
    if (!is_given("wedges", {{"force", w.force}, {"spacing", w.spacing}})) return;
    if (!have_room("wedges.spacing", w.spacing)) return;
    std::vector<Footing> above;
    for (std::size_t k = 0; k < f_.placed.parts.size(); ++k)
      for (const Footing& at : footings(k, w.spacing, kOnFace))
        if (at.normal.y > 0.5) above.push_back(at);
    if (above.empty())
      return fault("wedges", "", "have no masonry above a beam to press on",
                   "leave them out, or let a level part of the frame stand under masonry");
    const auto joint = f_.spec.material.find(f_.frame.joint);
    if (joint == f_.spec.material.end()) return;  // reported elsewhere
    const double each = w.force / static_cast<double>(above.size());
    const double friction = each * elementary::tan(joint->second.residual_friction_angle);
    for (std::size_t i = 0; i < above.size(); ++i) {
      const std::string name = fmt::format("{} wedge {}", f_.placed.name, i + 1);
      add(name, LinkKind::kWedge, above[i], above[i].face, f_.site.turned(above[i].normal), kUnset,
          0, kUnlimited, each);
      if (friction > 0) add_across(name + " friction", above[i], kUnset, friction);
    }
    model_.anatomy.notes.push_back(
        {"frame.wedged",
         {{"frame", f_.placed.name}, {"count", above.size()}, {"force_kN", 1e-3 * w.force}}});
  }

  // Whether a table is present with all its numbers; a fault where some are missing.
  bool is_given(const std::string& table, const std::vector<std::pair<const char*, double>>& keys) {
    const auto missing = [](const auto& key) { return !(key.second > 0); };
    if (std::all_of(keys.begin(), keys.end(), missing)) return false;
    const auto first = std::find_if(keys.begin(), keys.end(), missing);
    if (first == keys.end()) return true;
    fault(table + "." + first->first, "", "is missing",
          fmt::format("write {} beside {}", first->first,
                      std::find_if_not(keys.begin(), keys.end(), missing)->first));
    return false;
  }

  const Fastened& f_;
  Model& model_;
  FaultList& faults_;
};

}  // namespace

void add_fasteners(const Fastened& fastened, Model& model, FaultList& faults) {
  FastenerCompiler(fastened, model, faults).run();
}

}  // namespace wythe
