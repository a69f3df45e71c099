// A part of a wall in its plane as a strip that falls on its face: masonry, floors, holds.
//
//        |<- thickness ->|          outer faces are flush; floors bear on the inner side
//   head +---------------+
//        |       W  N|bearing       falls outwards: turns about the outer face, `inset` within
//   foot +o--------------+  inner
//
// docs/theory/local_mechanisms.md. Called by add_local_checks().
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "core/text.h"
#include "geometry/polygon.h"
#include "judge/assessment/assessment_parts.h"
#include "judge/local/local_parts.h"
#include "wythe/parts/error.h"
#include "wythe/parts/reading.h"

namespace wythe::study {
namespace {

using geometry::Polygon;

constexpr double kStressBlock = 0.85;  // of fc
constexpr double kSliver = 1e-3;       // beside a bed joint [m]
constexpr double kNear = 0.011;        // a floor finds a bed joint within this distance [m]

struct Extents {
  double left = 0, right = 0, foot = 0, top = 0;  // [m]
};
Extents extents_of(const Model& model) {
  constexpr double kFar = std::numeric_limits<double>::infinity();
  Extents e{kFar, -kFar, kFar, -kFar};
  for (BlockId b = 0; b < model.n_block; ++b)
    for (const Vec3& corner : outline_of(model, b)) {
      e.left = std::min(e.left, corner.x), e.right = std::max(e.right, corner.x);
      e.foot = std::min(e.foot, corner.y), e.top = std::max(e.top, corner.y);
    }
  return e;
}

// Height of a floor above the wall's foot; NaN where it names a storey that does not exist.
double level_of(const FloorSpec& floor, const Anatomy& a, double foot) {
  double level = floor.y;
  for (std::size_t k = 0; k < a.storey_name.size(); ++k)
    if (!floor.storey.empty() && a.storey_name[k] == floor.storey) level = a.storey_top[k] - foot;
  return level;
}

// Masonry between two heights.
struct PartPiece {
  double weight = 0, first = 0, across = 0,
         volume = 0;  // sums of weight, weight height, weight t/2
  [[nodiscard]] double height() const { return first / weight; }
  [[nodiscard]] double behind() const { return across / weight; }  // the outer face
};

// A load on the part.
struct Lying {
  double height = 0, behind = 0, weight = 0, slides_off = 0;
  bool is_floor = false;
};

class Strip {
 public:
  Strip(const ModelSpec& spec, const Model& bare, const PartSpec& part, std::string path)
      : spec_(spec),
        model_(with_rigid_bodies(bare)),
        part_(part),
        path_(std::move(path)),
        wall_(extents_of(model_)) {
    x0_ = wall_.left + (std::isfinite(part.left) ? part.left : 0);
    x1_ = std::isfinite(part.right) ? wall_.left + part.right : wall_.right;
    y0_ = wall_.foot + (std::isfinite(part.foot) ? part.foot : 0);
    y1_ = std::isfinite(part.head) ? wall_.foot + part.head : wall_.top;
  }

  LocalCheck check() {
    measure();
    gather_loads();
    gather_above();
    check_holds();
    find_inset();
    LocalCheck out;
    out.name = part_.name;
    out.by = "part";
    out.foot = y0_ - wall_.foot, out.head = y1_ - wall_.foot;
    out.inset = inset_;
    out.masonry = masonry_.weight;
    for (const Lying& l : lying_) out.floors += l.is_floor ? l.weight : 0;
    out.building.height = out.foot;
    const std::vector<LocalCapacity> curves = part_.head_held ? bend(out) : turn_over();
    say_what_is_left_out(out);
    conclude(spec_, model_, crushes_, curves, out);
    return out;
  }

 private:
  [[noreturn]] void refuse(const std::string& key, std::string value, std::string problem,
                           std::string cure) const {
    throw InputError({{.path = path_ + key,
                       .value = std::move(value),
                       .problem = std::move(problem),
                       .cure = std::move(cure)}});
  }

  [[nodiscard]] double thickness_at(BlockId block) const {
    return model_.anatomy.block_thickness[block];
  }
  // Steel is not masonry, and a block that a stage cuts out is not there.
  [[nodiscard]] bool is_no_masonry(BlockId block) const {
    const BlockRole role = model_.anatomy.block_role[block];
    return role == BlockRole::kFrame || role == BlockRole::kCutOut;
  }
  [[nodiscard]] Polygon box(double y0, double y1) const {
    return {{x0_, y0}, {x1_, y0}, {x1_, y1}, {x0_, y1}};
  }
  [[nodiscard]] PartPiece between(double y0, double y1) const {
    PartPiece piece;
    const Polygon frame = box(y0, y1);
    for (BlockId b = 0; b < model_.n_block; ++b) {
      if (is_no_masonry(b)) continue;
      const Polygon outline = geometry::polygon_of(outline_of(model_, b));
      const geometry::Rect around = geometry::bounds(outline);
      if (around.y1 <= y0 || around.y0 >= y1 || around.x1 <= x0_ || around.x0 >= x1_) continue;
      const Polygon inside = geometry::part_inside(outline, frame);
      if (inside.empty()) continue;
      const auto m = geometry::moments(inside);
      const double weight =
          model_.solve.gravity * model_.gravity_mass[b] * m.area / geometry::moments(outline).area;
      const double thickness = model_.anatomy.block_thickness[b];
      piece.weight += weight;
      piece.first += weight * (m.centroid.y - y0_);
      piece.across += weight * 0.5 * thickness;
      piece.volume += m.area * thickness;
    }
    return piece;
  }

  // Pieces of the part that a horizontal line crosses.
  struct Stretch {
    double from = 0, to = 0, thickness = 0;
  };
  [[nodiscard]] std::vector<Stretch> stretches_at(double y) const {
    std::vector<Stretch> all;
    for (BlockId b = 0; b < model_.n_block; ++b) {
      if (is_no_masonry(b)) continue;
      const Polygon outline = geometry::polygon_of(outline_of(model_, b));
      const geometry::Rect around = geometry::bounds(outline);
      if (around.y0 > y || around.y1 < y) continue;
      const double from = std::max(around.x0, x0_), to = std::min(around.x1, x1_);
      if (to > from) all.push_back({from, to, thickness_at(b)});
    }
    return all;
  }
  struct Section {
    double length = 0, thickness = 0;
  };
  [[nodiscard]] Section section_above(double y) const {
    Section section;
    for (const Stretch& s : stretches_at(y + kSliver)) {
      section.length += s.to - s.from;
      section.thickness = std::max(section.thickness, s.thickness);
    }
    return section;
  }
  // The contact of blocks above and below a bed joint.
  [[nodiscard]] Section section_through(double y) const {
    Section section;
    const std::vector<Stretch> above = stretches_at(y + kSliver);
    for (const Stretch& b : stretches_at(y - kSliver))
      for (const Stretch& a : above) {
        const double length = std::min(a.to, b.to) - std::max(a.from, b.from);
        if (length <= 0) continue;
        section.length += length;
        section.thickness = std::max(section.thickness, std::min(a.thickness, b.thickness));
      }
    return section;
  }

  // Masonry of two thicknesses at one level turns about its common face, and a wall in its plane does not
  // say which face that is. With the larger thickness alone, a pilaster of 1.5 m would hold a wall of 0.3 m.
  void refuse_side_by_side() const {
    struct Masonry {
      geometry::Rect box;
      double thickness;
    };
    std::vector<Masonry> blocks;
    for (BlockId b = 0; b < model_.n_block; ++b) {
      if (model_.anatomy.block_role[b] != BlockRole::kMasonry) continue;
      const geometry::Rect box = geometry::bounds(geometry::polygon_of(outline_of(model_, b)));
      if (std::min(box.y1, y1_) - std::max(box.y0, y0_) > kSliver &&
          std::min(box.x1, x1_) - std::max(box.x0, x0_) > kSliver)
        blocks.push_back({box, thickness_at(b)});
    }
    const auto is_other = [&](const Masonry& a, const Masonry& b) {
      return std::fabs(a.thickness - b.thickness) > 1e-9 * b.thickness;
    };
    for (const Masonry& a : blocks) {
      if (!is_other(a, blocks.front())) continue;  // two thicknesses: one differs
      for (const Masonry& b : blocks)
        if (is_other(a, b) && std::min(a.box.y1, b.box.y1) - std::max(a.box.y0, b.box.y0) > kSliver)
          refuse(
              "", "",
              fmt::format("masonry of {:g} m and of {:g} m stands side by side at {:.2f} m, and "
                          "which of their faces is common is not known",
                          std::min(a.thickness, b.thickness), std::max(a.thickness, b.thickness),
                          std::max(a.box.y0, b.box.y0) - wall_.foot),
              "check the part beside it, by left and right; or its section as a wall of its own");
    }
  }

  void measure() {
    if (!(x1_ > x0_) || x0_ < wall_.left - 1e-9 || x1_ > wall_.right + 1e-6)
      refuse(".right", fmt::format("{:g} m", x1_ - wall_.left),
             fmt::format(
                 "the part goes from {:.3f} to {:.3f} m along the wall, which is {:.3f} m long",
                 x0_ - wall_.left, x1_ - wall_.left, wall_.right - wall_.left),
             "write left and right within the wall");
    if (!(y1_ > y0_) || y1_ > wall_.top + 1e-6)
      refuse(".head", fmt::format("{:g} m", y1_ - wall_.foot),
             fmt::format("the part goes from {:.3f} to {:.3f} m, and the wall is {:.3f} m high",
                         y0_ - wall_.foot, y1_ - wall_.foot, wall_.top - wall_.foot),
             "write foot and head within the wall");
    masonry_ = between(y0_, y1_);
    if (!(masonry_.weight > 0))
      refuse("", "",
             model_.solve.gravity > 0 ? "no masonry with a weight lies between its ends"
                                      : "weighs nothing: gravity is 0",
             "move its ends onto masonry, and give that a density");
    refuse_side_by_side();
    const Section at_foot = section_above(y0_);
    length_ = at_foot.length, thickness_ = at_foot.thickness;
    if (!(thickness_ > 0))
      refuse(".foot", fmt::format("{:g} m", y0_ - wall_.foot),
             "no masonry stands at this height, so there is nothing to turn about",
             "write the height of a bed joint below the part");
  }

  [[nodiscard]] std::pair<double, double> range_of(const FloorSpec& floor) const {
    const double from = wall_.left + (std::isfinite(floor.x) ? floor.x : 0);
    return {from, std::isfinite(floor.width) ? from + floor.width : wall_.right};
  }
  // Half the length of a load: about its middle, up to the nearer end of the block's side there.
  [[nodiscard]] double half_of(BlockId block, double x, double y) const {
    constexpr double kLevel = 1e-4;  // [m]
    double left = std::numeric_limits<double>::infinity(), right = -left;
    const auto reach = [&](bool all) {
      for (const Vec3& corner : outline_of(model_, block))
        if (all || std::fabs(corner.y - y) < kLevel)
          left = std::min(left, corner.x), right = std::max(right, corner.x);
    };
    reach(false);
    if (!(right > left)) reach(true);
    return std::max(0.0, std::min(x - left, right - x));
  }
  // The floor to which this load belongs. Two floors may lie at one place, and other loads beside them.
  struct Brought {
    const FloorSpec* floor = nullptr;
    double half = 0;                    // length of the load on either side [m]
    const FloorSpec* beside = nullptr;  // one at the same place
  };
  using Found = std::map<const FloorSpec*, double>;  // loads assigned so far [N]
  [[nodiscard]] Brought floor_at(BlockId block, double x, double y, double weight,
                                 Found& found) const {
    constexpr double kSameWeight = 1e-6;
    Brought by{nullptr, half_of(block, x, y)};
    for (const FloorSpec& floor : spec_.floor) {
      const double level = level_of(floor, model_.anatomy, wall_.foot);
      const auto [from, to] = range_of(floor);
      if (!(std::fabs(y - wall_.foot - level) <= kNear && floor.load > 0)) continue;
      const double half = floor.joists.empty() ? std::min({by.half, x - from, to - x}) : 0;
      const bool is_its_own =
          floor.joists.empty()
              ? std::fabs(weight - floor.load * 2 * half) < kSameWeight * weight
              : std::any_of(floor.joists.begin(), floor.joists.end(), [&](double joist) {
                  return std::fabs(wall_.left + joist - x) < kNear;
                });
      by.beside = &floor;
      double& told = found[&floor];
      if (!is_its_own || weight < 0 || told + weight > (1 + kSameWeight) * floor.load * (to - from))
        continue;
      told += weight;
      return {&floor, half};
    }
    return by;
  }
  [[nodiscard]] double bearing_of(const FloorSpec& floor) const {
    const double bearing = std::isfinite(part_.bearing) ? part_.bearing : floor.bearing;
    if (!std::isfinite(bearing))
      refuse(".bearing", "",
             fmt::format(
                 "floor {} lies on it, and how deep it bears on the wall is not known",
                 floor.name.empty() ? std::to_string(&floor - spec_.floor.data() + 1) : floor.name),
             "write bearing = \"150 mm\", here or in the floor");
    return bearing;
  }

  // Share of the load from x - half to x + half on this part.
  [[nodiscard]] double share_within(double x, double half) const {
    constexpr double kPoint = 1e-9;  // [m]
    if (half > kPoint)
      return std::max(0.0, std::min(x + half, x1_) - std::max(x - half, x0_)) / (2 * half);
    const bool is_last = x1_ > wall_.right - kPoint;  // a point at a common end lies on one part
    return x >= x0_ && (x < x1_ || is_last) ? 1 : 0;
  }

  void gather_loads() {
    Found found;
    std::set<const FloorSpec*> beside;
    for (const Stage& stage : model_.stages) {
      const StageKind kind = stage.spec.kind();
      if (kind == StageKind::kPush || kind == StageKind::kBodyForce || kind == StageKind::kTilt ||
          kind == StageKind::kShake)
        break;
      for (const PointLoad& load : stage.loads) {
        const std::size_t i = load.block;
        const double x = model_.centroid_x[i] + load.arm_x, y = model_.centroid_y[i] + load.arm_y;
        if (y <= y0_ + 1e-9) continue;
        const Brought by = floor_at(load.block, x, y, -load.fy, found);
        if (by.floor == nullptr && by.beside != nullptr && load.fy < 0) beside.insert(by.beside);
        const double weight = -load.fy * share_within(x, by.half),
                     thickness = thickness_at(load.block);
        if (weight == 0) continue;
        if (weight < 0 && y <= y1_ + 1e-9) lifted_ -= weight;
        if (!(weight > 0)) continue;
        if (by.floor == nullptr) other_ += weight;
        if (y > y1_ + 1e-9) {
          above_.push_back({y1_ - y0_, 0.5 * thickness, weight});
          continue;
        }
        Lying lying{y - y0_, 0.5 * thickness, weight, std::numeric_limits<double>::infinity()};
        if (by.floor != nullptr) {
          const double bearing = bearing_of(*by.floor);
          if (bearing > thickness)
            refuse(".bearing", fmt::format("{:g} m", bearing),
                   fmt::format("is deeper than the wall is thick there, {:g} m", thickness),
                   "write how much of the thickness the floor lies on");
          lying.behind = thickness - 0.5 * bearing;
          if (part_.falls == Fall::kOutwards) lying.slides_off = bearing;  // else it goes under it
          lying.is_floor = true;
        }
        lying_.push_back(lying);
      }
    }
    // without its floor, such a load would wrongly lie in the middle of the wall
    for (const FloorSpec* floor : beside) {
      const auto [from, to] = range_of(*floor);
      if (found[floor] > (1 - 1e-3) * floor->load * (to - from)) continue;
      refuse("", "",
             fmt::format("loads at floor {} can't be distinguished from its own",
                         floor->name.empty() ? std::to_string(floor - spec_.floor.data() + 1)
                                             : floor->name),
             "write each load there as a [[floor]] with its bearing");
    }
  }

  // Masonry above the part presses on its head if that is held. Above a free head it would fall as well.
  void gather_above() {
    const PartPiece masonry = y1_ < wall_.top - 1e-6 ? between(y1_, wall_.top) : PartPiece{};
    if (masonry.weight > 0) above_.push_back({y1_ - y0_, masonry.behind(), masonry.weight});
    double weight = 0;
    for (const Lying& load : above_) weight += load.weight;
    if (!(weight > 1e-6 * masonry_.weight)) return;
    if (!part_.head_held)
      refuse(".head", fmt::format("{:g} m", y1_ - wall_.foot),
             fmt::format("{:.4g} kN of masonry and floors stand on the part, and would fall along",
                         1e-3 * weight),
             "leave head out, or write head_held = true where a floor or tie holds it");
    for (Lying& load : above_) load.slides_off = std::numeric_limits<double>::infinity();
    lying_.insert(lying_.end(), above_.begin(), above_.end());
    pressed_ = weight;
  }

  void check_holds() const {
    for (std::size_t k = 0; k < part_.hold.size(); ++k) {
      const HoldSpec& hold = part_.hold[k];
      const double height = hold.height - (y0_ - wall_.foot);
      if (height > 0 && height <= y1_ - y0_ + 1e-9) continue;
      refuse(fmt::format(".hold.{}.height", hold.name.empty() ? std::to_string(k + 1) : hold.name),
             fmt::format("{:g} m", hold.height),
             fmt::format("lies beside the part, which goes from {:.3f} to {:.3f} m",
                         y0_ - wall_.foot, y1_ - wall_.foot),
             "write a height within the part, or leave it out");
    }
  }

  // (21.2): the line of rotation lies within the face, where the masonry can carry all the load above it.
  [[nodiscard]] double inset_on(double height, double length) const {
    if (std::isfinite(part_.inset)) return part_.inset;
    if (!std::isfinite(strength_)) return 0;
    double load = between(y0_ + height, y1_).weight;
    for (const Lying& lying : lying_) load += lying.height > height ? lying.weight : 0;
    return load / (2 * kStressBlock * strength_ * length);
  }
  void find_inset() {
    for (JointId j = 0; j < model_.n_joint; ++j) {
      const auto kind = model_.anatomy.joint_kind[j];
      if (kind != JointKind::kBed && kind != JointKind::kFoundation && kind != JointKind::kOther)
        continue;
      const std::size_t m = model_.joint_material[j];
      strength_ = std::min(strength_, model_.materials[m].compressive_strength);
    }
    crushes_ = std::isfinite(part_.inset) ? part_.inset > 0 : std::isfinite(strength_);
    inset_ = inset_on(0, length_);
    if (inset_ < 0.5 * thickness_) return;
    refuse(std::isfinite(part_.inset) ? ".inset" : "", fmt::format("{:g} m", inset_),
           fmt::format(
               "the line it turns about would lie beyond the middle of the wall, {:g} m thick: {}",
               thickness_,
               std::isfinite(part_.inset) ? "that is no part of a face"
                                          : "the masonry crushes under its load"),
           std::isfinite(part_.inset) ? "write a few centimetres, or leave it out"
                                      : "lower the loads, or check the compressive strength");
  }

  // Position from the line of rotation, with the initial lean.
  [[nodiscard]] LocalWeight leaning(double behind, double above) const {
    const double c = std::cos(part_.lean), s = std::sin(part_.lean);
    LocalWeight w;
    w.travel = w.drop = above * c + behind * s;
    w.rise = behind * c - above * s;
    return w;
  }
  [[nodiscard]] double behind_line(double from_outer_face) const {
    return part_.falls == Fall::kOutwards ? from_outer_face - inset_
                                          : thickness_ - inset_ - from_outer_face;
  }

  [[nodiscard]] std::vector<LocalCapacity> turn_over() const {
    std::vector<LocalWeight> weights;
    const auto add = [&](double from_outer_face, double height, double weight, double slides_off) {
      LocalWeight w = leaning(behind_line(from_outer_face), height);
      w.weight = w.pushed = weight;
      w.slides_off = slides_off;
      weights.push_back(w);
    };
    add(masonry_.behind(), masonry_.height(), masonry_.weight,
        std::numeric_limits<double>::infinity());
    for (const Lying& l : lying_) add(l.behind, l.height, l.weight, l.slides_off);
    std::vector<LocalHold> holds;
    for (const HoldSpec& hold : part_.hold) {
      // a hold acts at the leading face
      const LocalWeight at = leaning(-inset_, hold.height - (y0_ - wall_.foot));
      holds.push_back({hold.force, at.travel, at.rise, hold.travel});
    }
    return overturning(weights, holds, teeth(), leaning(0, y1_ - y0_).travel, model_.solve.gravity);
  }

  // (21.6): each face of a tooth carries the corner masonry above it, and slides in proportion to its height above the line.
  [[nodiscard]] double teeth() const {
    const TeethSpec& t = part_.teeth;
    if (t.corners == 0) return 0;
    if (t.corners * t.length > x1_ - x0_ + 1e-9)
      refuse(
          ".teeth.length", fmt::format("{:g} m", t.length),
          fmt::format("teeth at {} corners are longer than the part, {:g} m", t.corners, x1_ - x0_),
          "write the thickness of a wall across");
    const double height = y1_ - y0_, area = t.length * thickness_;
    const double unit_weight = masonry_.weight / masonry_.volume;
    return t.corners * t.friction * unit_weight * area * height * height * height / (6 * t.course);
  }

  std::vector<LocalCapacity> bend(LocalCheck& out) const {
    if (part_.lean != 0)
      refuse(".lean", fmt::format("{:g} rad", part_.lean),
             "is of a part whose head is free: this one bends between foot and head",
             "leave lean out, or head_held");
    if (!part_.hold.empty() || part_.teeth.corners > 0)
      refuse(
          part_.hold.empty() ? ".teeth" : ".hold", "",
          "is of a part whose head is free: this one is held at its head by what need not give way",
          "leave it out, or leave head_held out");
    if (part_.falls != Fall::kOutwards)
      refuse(".falls", "inwards", "a part whose head is held bends outwards", "leave falls out");
    const double height = y1_ - y0_;
    double head_thickness = 0;
    for (const Stretch& s : stretches_at(y1_ - kSliver))
      head_thickness = std::max(head_thickness, s.thickness);
    const auto strip_at = [&](double hinge) {
      const Section section = section_through(y0_ + hinge);
      BentStrip strip{.height = height,
                      .at_hinge = section.thickness,
                      .at_head = head_thickness,
                      .inset = std::max(inset_, inset_on(hinge, section.length))};
      const auto masonry = [&](const PartPiece& piece) {
        return BentStrip::Weight{.height = piece.height(),
                                 .behind = piece.behind(),
                                 .weight = piece.weight,
                                 .pushed = piece.weight};
      };
      const PartPiece below = between(y0_, y0_ + hinge), above = between(y0_ + hinge, y1_);
      if (below.weight > 0) strip.lower.push_back(masonry(below));
      if (above.weight > 0) strip.upper.push_back(masonry(above));
      for (const Lying& l : lying_) {
        const bool at_head = l.height > height - kNear;
        (l.height <= hinge ? strip.lower : strip.upper)
            .push_back({l.height, l.behind, l.weight, at_head ? 0 : l.weight, l.slides_off});
      }
      return strip;
    };
    // the hinge forms at the bed joint with the smallest multiplier
    double hinge = kUnset, least = std::numeric_limits<double>::infinity();
    for (const double joint : bed_joints()) {
      const double onset = bending(strip_at(joint), joint, model_.solve.gravity).alpha0;
      if (onset < least) least = onset, hinge = joint;
    }
    if (std::isnan(hinge))
      refuse(".head_held", "true", "no bed joint lies between foot and head, where it could bend",
             "leave head_held out, or give the part more courses");
    out.hinge = out.foot + hinge;
    out.building.height = 0.5 * (out.foot + out.head);
    out.notes.push_back({"local.note.head_held"});
    if (pressed_ > 0) out.notes.push_back({"local.note.pressed", {{"load_kN", 1e-3 * pressed_}}});
    return {bending(strip_at(hinge), hinge, model_.solve.gravity)};
  }

  // Heights of block ends above the foot, within the part.
  [[nodiscard]] std::vector<double> bed_joints() const {
    constexpr double kApart = 1e-3;  // [m]
    std::vector<double> all, joints;
    for (BlockId b = 0; b < model_.n_block; ++b) {
      if (is_no_masonry(b)) continue;
      double top = -std::numeric_limits<double>::infinity();
      for (const Vec3& corner : outline_of(model_, b)) top = std::max(top, corner.y);
      if (top > y0_ + kApart && top < y1_ - kApart) all.push_back(top - y0_);
    }
    std::sort(all.begin(), all.end());
    for (const double y : all)
      if (joints.empty() || y > joints.back() + kApart) joints.push_back(y);
    return joints;
  }

  void say_what_is_left_out(LocalCheck& out) const {
    if (lying_.empty()) out.notes.push_back({"local.note.no_floors"});
    if (model_.frames.n > 0) out.notes.push_back({"local.note.frame"});
    if (other_ > 0 && other_ + out.floors > masonry_.weight)
      out.cautions.push_back(
          {"local.caution.heavy_loads",
           {{"loads_kN", 1e-3 * other_}, {"masonry_kN", 1e-3 * masonry_.weight}}});
    if (out.floors > masonry_.weight)
      out.cautions.push_back(
          {"local.caution.heavy_floors",
           {{"floors_kN", 1e-3 * out.floors}, {"masonry_kN", 1e-3 * masonry_.weight}}});
    if (lifted_ > 0) out.notes.push_back({"local.note.lifted", {{"load_kN", 1e-3 * lifted_}}});
    if (part_.teeth.corners > 0) out.notes.push_back({"local.note.teeth"});
    bool is_any_short = false;
    for (const HoldSpec& hold : part_.hold) is_any_short |= !std::isfinite(hold.travel);
    if (is_any_short) out.notes.push_back({"local.note.holds_unknown"});
    for (std::vector<Message> cautions :
         {cautions_of_inputs(spec_, model_), cautions_of_demand(spec_.assessment)})
      for (Message& caution : cautions) out.cautions.push_back(std::move(caution));
  }

  const ModelSpec& spec_;
  const Model model_;
  const PartSpec& part_;
  std::string path_;
  Extents wall_;
  double x0_ = 0, x1_ = 0, y0_ = 0, y1_ = 0;
  double thickness_ = 0, length_ = 0;  // at the foot
  double inset_ = 0, lifted_ = 0, pressed_ = 0, other_ = 0;
  double strength_ = std::numeric_limits<double>::infinity();  // in compression [Pa]
  bool crushes_ = false;
  PartPiece masonry_;
  std::vector<Lying> lying_, above_;
};

// The parts of a held part where nothing holds it: between its foot and its holds, whose heads are held level there, and the
// free one above. They give way at any strength of the holds.
std::vector<PartSpec> spans_of(const PartSpec& part) {
  std::vector<double> heights;
  for (const HoldSpec& hold : part.hold) heights.push_back(hold.height);
  std::sort(heights.begin(), heights.end());
  PartSpec span = part;
  span.hold.clear();
  span.teeth = {}, span.lean = 0, span.inset = kUnset;
  std::vector<PartSpec> spans;
  for (const double height : heights) {
    span.head = height, span.head_held = true, span.falls = Fall::kOutwards;
    spans.push_back(span);
    span.foot = height;
  }
  span.head = part.head, span.head_held = false, span.falls = part.falls;
  spans.push_back(span);
  return spans;
}

// Tells of a held part whether a part of it carries less. If that one is not safe, the whole is not to be signed.
void look_beside_holds(const ModelSpec& spec, const Model& model, const PartSpec& part,
                       const std::string& path, LocalCheck& out) {
  std::optional<LocalCheck> least;
  bool all_known = std::isfinite(out.reserve());
  for (const PartSpec& span : spans_of(part)) try {
      LocalCheck one = Strip(spec, model, span, path).check();
      all_known = all_known && std::isfinite(one.reserve());
      if (std::isfinite(one.reserve()) && (!least || one.reserve() < least->reserve()))
        least = std::move(one);
    } catch (const InputError&) {  // too low to bend, or crushed
      all_known = false;
    }
  if (!all_known) out.notes.push_back({"local.note.held"});
  if (!least || !(least->reserve() < out.reserve())) return;
  Message weaker = {"local.weaker_beside",
                    {{"foot_m", least->foot},
                     {"head_m", least->head},
                     {"ratio", least->reserve()},
                     {"held", out.reserve()}}};
  add_weaker(std::move(weaker), least->reserve(), least->verdict == AssessmentVerdict::kHolds, out);
}

}  // namespace

LocalCheck check_of_part(const ModelSpec& spec, const Model& model, const PartSpec& part,
                         const std::string& path) {
  LocalCheck out = Strip(spec, model, part, path).check();
  if (!part.hold.empty() && !part.head_held) look_beside_holds(spec, model, part, path, out);
  return out;
}

namespace {

// Length of 0 to `length` that intervals leave out.
double left_out(std::vector<std::pair<double, double>> intervals, double length) {
  std::sort(intervals.begin(), intervals.end());
  double missing = 0, reached = 0;
  for (const auto& [low, high] : intervals) {
    missing += std::max(0.0, std::min(low, length) - reached);
    reached = std::clamp(high, reached, std::max(reached, length));
  }
  return missing + std::max(0.0, length - reached);
}

// Whether named parts stand for one that was found between two heights: along nine tenths of the wall one of them has its foot
// there, and parts cover nine tenths of the height. A named part of another foot is another mechanism: a facade that holds as a
// whole says nothing of its parapet. One whose head is held bends at any height, and so stands for those above its foot too. What
// is left out may be the depth of a floor.
bool are_covering(const std::vector<PartSpec>& named, const Extents& wall, double foot,
                  double head) {
  constexpr double kTenth = 0.1;
  const double length = wall.right - wall.left, top = wall.top - wall.foot, height = head - foot;
  struct Place {
    double left, right, foot, head;
    bool is_held;
  };
  std::vector<Place> places;
  const auto given = [](double value, double otherwise) {
    return std::isfinite(value) ? value : otherwise;
  };
  for (const PartSpec& part : named)
    places.push_back({given(part.left, 0), given(part.right, length), given(part.foot, 0),
                      given(part.head, top), part.head_held});
  std::vector<std::pair<double, double>> at_foot;
  std::vector<double> edges = {0, length};
  for (const Place& part : places) {
    const bool bends = part.is_held && part.foot < foot && part.head > head - kTenth * height;
    if (bends || std::fabs(part.foot - foot) <= kTenth * height)
      at_foot.emplace_back(part.left, part.right);
    if (part.foot >= head || part.head <= foot) continue;
    for (const double x : {part.left, part.right}) edges.push_back(std::clamp(x, 0.0, length));
  }
  if (!(left_out(at_foot, length) < kTenth * length)) return false;
  std::sort(edges.begin(), edges.end());
  double uncovered = 0;
  for (std::size_t i = 1; i < edges.size(); ++i) {
    const double x = 0.5 * (edges[i] + edges[i - 1]);
    std::vector<std::pair<double, double>> above;
    for (const Place& part : places)
      if (x > part.left && x < part.right) above.emplace_back(part.foot - foot, part.head - foot);
    if (!(left_out(above, height) < kTenth * height)) uncovered += edges[i] - edges[i - 1];
  }
  return uncovered < kTenth * length;
}

}  // namespace

std::vector<PartSpec> found_parts(const ModelSpec& spec, const Model& model,
                                  const std::vector<PartSpec>& named) {
  const Extents wall = extents_of(with_rigid_bodies(model));
  std::vector<PartSpec> parts;
  const auto add = [&](std::string name, double foot) {
    PartSpec& part = parts.emplace_back();
    part.name = std::move(name);
    part.foot = foot;
  };
  const Anatomy& a = model.anatomy;
  double foot = 0, highest = 0;
  for (std::size_t k = 0; k < a.storey_top.size(); ++k) {
    add(a.storey_name[k].empty() ? fmt::format("storey {}", k + 1) : a.storey_name[k], foot);
    foot = a.storey_top[k] - wall.foot;
  }
  if (parts.empty()) add("wall", 0);
  for (const FloorSpec& floor : spec.floor) {
    const double level = level_of(floor, a, wall.foot);
    if (std::isfinite(level)) highest = std::max(highest, level);
  }
  constexpr double kParapet = 0.05;  // a smaller rise is the thickness of a floor [m]
  const bool is_a_storey = std::any_of(parts.begin(), parts.end(), [&](const PartSpec& p) {
    return std::fabs(p.foot - highest) < kNear;
  });
  if (highest > 0 && !is_a_storey && wall.top - wall.foot - highest > kParapet)
    add("parapet", highest);
  // each reaches to the wall's top; what it stands for ends at the foot of the next
  std::vector<double> feet;
  for (const PartSpec& part : parts) feet.push_back(part.foot);
  feet.push_back(wall.top - wall.foot);
  std::sort(feet.begin(), feet.end());
  std::erase_if(parts, [&](const PartSpec& part) {
    const double head = *std::upper_bound(feet.begin(), feet.end() - 1, part.foot);
    return !named.empty() && are_covering(named, wall, part.foot, head);
  });
  return parts;
}

}  // namespace wythe::study
