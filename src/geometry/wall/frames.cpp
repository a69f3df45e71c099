// Builds the axis of a frame from an opening or a line and places its corners. Each part between them has 4 to 8
// segments, an even number. Lengths of sections are weights of Gregory's rule (docs/theory/frames.md, 20.6 and 20.7). Outlines
// are moved by the gap so that they touch the masonry; each segment stores its gap.
#include "geometry/wall/frames.h"

#include <algorithm>
#include <cmath>

#include "core/text.h"
#include "geometry/text.h"
#include "geometry/wall/joints.h"

namespace wythe::geometry {
namespace {

constexpr double kNear = 1e-6;        // [m]
constexpr int kPieces = 8;            // segments of a part (docs/theory/frames.md, 20.7)
constexpr double kLeastShare = 0.75;  // of the crossing member's depth: least length of a segment
constexpr int kFewestPieces = 4;

std::string path_of(std::size_t index, const std::string& key) {
  const std::string table = "frame." + std::to_string(index);
  return key.empty() ? table : table + "." + key;
}

std::string called(const FrameSpec& frame, std::size_t index) {
  return "frame " + (frame.name.empty() ? std::to_string(index + 1) : frame.name);
}

bool is_stated(const SectionSpec& s) {
  return !std::isnan(s.height) || !std::isnan(s.width) || !std::isnan(s.area) ||
         !std::isnan(s.shear_area) || !std::isnan(s.second_moment) ||
         !std::isnan(s.plastic_modulus) || !std::isnan(s.mass) ||
         !std::isnan(s.weak_second_moment) || !std::isnan(s.torsion_constant) ||
         !std::isnan(s.weak_shear_area);
}

std::optional<Section> stated_section(const SectionSpec& s, const std::string& path,
                                      FaultList& faults) {
  const std::size_t before = faults.all().size();
  const auto need = [&](const char* key, double value, const char* unit, const char* example) {
    (void)is_positive({path + "." + key, value, unit, example}, faults);
  };
  need("height", s.height, "m", "200 mm");
  need("width", s.width, "m", "200 mm");
  need("area", s.area, "m^2", "78.1 cm^2");
  need("shear_area", s.shear_area, "m^2", "16.7 cm^2");
  need("second_moment", s.second_moment, "m^4", "5696 cm^4");
  need("plastic_modulus", s.plastic_modulus, "m^3", "642.5 cm^3");
  need("mass", s.mass, "kg/m", "61.3 kg/m");
  if (!std::isnan(s.weak_shear_area)) need("weak_shear_area", s.weak_shear_area, "m^2", "50 cm^2");
  if (faults.all().size() > before) return std::nullopt;
  const Section found{s.height,
                      s.width,
                      s.area,
                      s.shear_area,
                      s.second_moment,
                      s.plastic_modulus,
                      s.mass,
                      s.weak_second_moment,
                      s.torsion_constant,
                      std::isnan(s.weak_shear_area) ? s.shear_area : s.weak_shear_area};
  // The outer fibres have the area I / 2 d^2 each, at d = I / Wpl (frames.md, 20.1).
  const double fibre = s.second_moment / s.plastic_modulus;
  if (s.second_moment > s.area * fibre * fibre || fibre > s.height / 2) {
    add_fault(faults, path + ".plastic_modulus", "",
              "does not go with area, second_moment and height: no section has these numbers",
              "look for a unit that slipped: Wpl is I over a third to a half of the height");
    return std::nullopt;
  }
  return found;
}

std::optional<Section> one_section(const std::string& profile, const SectionSpec& section,
                                   int count, std::size_t index, const std::string& prefix,
                                   FaultList& faults) {
  const std::string key = path_of(index, prefix + "profile");
  if (profile.empty() == !is_stated(section)) {
    add_fault(faults, key, profile,
              profile.empty() ? "missing" : "stands beside a section in numbers",
              "write " + prefix + "profile = \"HEB 200\", or " + prefix +
                  "section = { ... }, one of both");
    return std::nullopt;
  }
  std::optional<Section> found =
      profile.empty() ? stated_section(section, path_of(index, prefix + "section"), faults)
                      : profile_named(profile);
  if (!profile.empty() && !found)
    add_fault(faults, key, "\"" + profile + "\"", "is not in the table of profiles",
              profile_advice(profile) + " Or write its numbers: " + prefix + "section = { ... }");
  if (!found) return found;
  found->width *= count;
  found->area *= count, found->shear_area *= count;
  found->second_moment *= count, found->plastic_modulus *= count;
  found->mass *= count;
  found->weak_second_moment *= count, found->torsion_constant *= count;
  found->weak_shear_area *= count;
  return found;
}

// The axis corner by corner, as built; the gap moves vertical parts sideways and level ones down.
struct FrameAxis {
  std::vector<Vec2> point;
  bool closed = false;
  std::vector<Message> words;  // names of its parts
  [[nodiscard]] std::size_t parts() const { return closed ? point.size() : point.size() - 1; }
  [[nodiscard]] Vec2 from(std::size_t k) const { return point[k]; }
  [[nodiscard]] Vec2 to(std::size_t k) const { return point[(k + 1) % point.size()]; }
  [[nodiscard]] bool upright(std::size_t k) const {
    return std::abs(to(k).y - from(k).y) > std::abs(to(k).x - from(k).x);
  }
};

// Builds one frame of the spec.
class Builder {
 public:
  Builder(const FrameSpec& spec, std::size_t index, const FrameSections& sections,
          const FrameSite& site, FaultList& faults)
      : spec_(spec), index_(index), sections_(sections), site_(site), faults_(faults) {
    frame_.index = static_cast<int>(index);
    frame_.name = spec.name.empty() ? std::to_string(index + 1) : spec.name;
  }

  bool round(const PlacedOpening& opening) {
    if (!opening.arch.empty())
      return fault("round", opening.called, "has an arch, and a frame needs a level head",
                   "write the frame's axis: line = [[\"1 m\", \"0 m\"], ...]");
    const Rect& hole = opening.hole;
    const double c = sections_.column.height / 2 + spec_.gap, b = sections_.beam.height / 2;
    const double left = hole.x0 + c, right = hole.x1 - c, top = hole.y1 - b - spec_.gap;
    const bool has_base = spec_.feet == FrameFeet::kBaseBeam;
    const double foot = has_base ? hole.y0 + b : hole.y0;
    axis_.closed = has_base;
    axis_.point = {{left, foot}, {left, top}, {right, top}, {right, foot}};
    axis_.words = {{"frame.left_column"}, {"frame.beam"}, {"frame.right_column"}};
    if (has_base) axis_.words.push_back({"frame.base_beam"});
    return true;
  }

  bool along_line() {
    for (const auto& [x, y] : spec_.line) {
      const auto n = axis_.point.size();
      const Vec2 next{x, y};
      if (n > 0 && length(next - axis_.point[n - 1]) < kNear)
        return fault("line", metres(x) + ", " + metres(y), "is there twice in a row",
                     "write each corner once");
      if (n > 1 && !is_corner(axis_.point[n - 2], axis_.point[n - 1], next))
        return no_corner(n - 1);
      axis_.point.push_back(next);
    }
    if (axis_.point.size() < 2)
      return fault(
          "line", "", "has fewer than two points",
          "write its axis from corner to corner: [[\"1 m\", \"0 m\"], [\"1 m\", \"2.5 m\"]]");
    axis_.closed =
        axis_.point.size() > 3 && length(axis_.point.back() - axis_.point.front()) < kNear;
    if (axis_.closed) {
      axis_.point.pop_back();
      if (!is_corner(axis_.point.back(), axis_.point[0], axis_.point[1])) return no_corner(0);
    }
    for (std::size_t k = 0; k < axis_.parts(); ++k) {
      const Vec2 d = axis_.to(k) - axis_.from(k);
      if (std::min(std::abs(d.x), std::abs(d.y)) > kNear)
        return fault("line." + std::to_string(k), "",
                     "is the start of a part that is neither level nor upright",
                     "give both of its ends one x or one y");
      axis_.words.push_back({"frame.part", {{"number", k + 1}}});
    }
    const bool has_base = spec_.feet == FrameFeet::kBaseBeam;
    if (has_base != axis_.closed)
      return fault(
          "feet", has_base ? "base_beam" : "",
          has_base ? "needs a line that comes back to its first point"
                   : "does not go with a line that closes: it has no feet",
          has_base ? "repeat the first point at the end of line" : "write feet = \"base_beam\"");
    if (spec_.gap > 0)
      return fault("gap", millimetres(spec_.gap), "is for a frame round an opening",
                   "draw the line farther from the masonry, or write round");
    return true;
  }

  // Builds segments and sections; false after a fault.
  bool build() {
    if (!check_feet()) return false;
    const std::size_t parts = axis_.parts();
    const std::size_t corners = axis_.closed ? parts : parts - 1;
    std::vector<int> corner(axis_.point.size(), kGround);
    for (std::size_t k = 0; k < corners; ++k) {
      const std::size_t at = axis_.closed ? k : k + 1;
      corner[at] = add_corner(at);
    }
    for (std::size_t k = 0; k < parts; ++k)
      if (!add_part(k, corner[k], corner[(k + 1) % axis_.point.size()])) return false;
    return true;
  }

  PlacedFrame take() { return std::move(frame_); }

 private:
  bool fault(const std::string& key, std::string value, std::string problem, std::string cure) {
    add_fault(faults_, path_of(index_, key), std::move(value),
              called(spec_, index_) + ": " + std::move(problem), std::move(cure));
    return false;
  }

  // Whether the line changes direction at `at`.
  static bool is_corner(const Vec2& before, const Vec2& at, const Vec2& after) {
    return std::abs(cross(at - before, after - at)) >= kNear * length(after - at);
  }
  bool no_corner(std::size_t k) {
    return fault("line." + std::to_string(k),
                 metres(axis_.point[k].x) + ", " + metres(axis_.point[k].y),
                 "is no corner: the line goes straight on or turns back there",
                 k == 0 ? "let the line begin and end at a corner" : "leave this point out");
  }
  [[nodiscard]] bool is_held() const {
    return spec_.feet == FrameFeet::kFixed || spec_.feet == FrameFeet::kHinged;
  }
  [[nodiscard]] const Section& section(bool upright) const {
    return upright ? sections_.column : sections_.beam;
  }

  // Whether one end of an open line, its first or last point, reaches down to a foot.
  [[nodiscard]] bool is_foot(bool last) const {
    if (axis_.closed) return false;
    const std::size_t n = axis_.point.size();
    const Vec2 end = last ? axis_.point[n - 1] : axis_.point[0];
    const Vec2 next = last ? axis_.point[n - 2] : axis_.point[1];
    return end.y < next.y - kNear;
  }

  bool check_feet() {
    if (!is_held()) return true;
    if (site_.ground.empty())
      return fault("feet", "", "has no ground to hold its feet: its plane cuts no fixed block",
                   "let a block there be fixed = true, or write feet = \"resting\"");
    const bool starts_well = check_foot(false);
    const bool ends_well = check_foot(true);
    if (!is_foot(false) && !is_foot(true))
      return fault("feet", "", "has no end that goes down to a foot",
                   "let the line begin or end on the ground, or write feet = \"resting\"");
    return starts_well && ends_well;
  }

  bool check_foot(bool last) {
    if (!is_foot(last)) return true;
    const Vec2 foot = last ? axis_.point.back() : axis_.point.front();
    double ground = kUnset, aside = 0;
    for (const Rect& box : site_.ground) {
      const double away = std::max({0.0, box.x0 - foot.x, foot.x - box.x1});
      if (std::isnan(ground) || away < aside) ground = box.y1, aside = away;
    }
    if (std::abs(foot.y - ground) < kNear) return true;
    const std::string where = metres(foot.x) + ", " + metres(foot.y);
    const std::string level = metres(ground);
    if (spec_.line.empty())
      return fault("feet", where,
                   "stands on masonry there, and the ground, at " + level + ", holds its feet",
                   "write feet = \"base_beam\", or feet = \"resting\"");
    return fault("line", where,
                 "has a foot in the air or in the ground, which is at " + level + " there",
                 "write y = " + level + " there, or feet = \"resting\" where masonry carries it");
  }

  int add_segment(const Rect& built, double mass, double width, Vec2 moved) {
    Block block;
    const int number = static_cast<int>(frame_.segments.size());
    block.id = "frame" + std::to_string(index_) + "_" + std::to_string(number);
    block.outline = outline_of(
        {built.x0 - moved.x, built.y0 - moved.y, built.x1 - moved.x, built.y1 - moved.y});
    block.material = "frame";
    block.thickness = width;
    block.role = Role::kFrame;
    block.frame = frame_.index;
    block.segment = number;
    block.own_density = mass / ((built.x1 - built.x0) * (built.y1 - built.y0) * width);
    frame_.segments.push_back(block);
    frame_.moved.push_back(moved);
    return number;
  }

  // Gap of a segment from its outline to its true place: columns move away from their jambs, beams from the head.
  [[nodiscard]] Vec2 moved(bool column, bool level, double x, double y) const {
    if (spec_.gap == 0) return {0, 0};
    const double middle = (axis_.point[1].x + axis_.point[2].x) / 2;
    const bool is_head = std::abs(y - axis_.point[1].y) < kNear;
    return {column ? (x < middle ? spec_.gap : -spec_.gap) : 0.0,
            level && is_head ? -spec_.gap : 0.0};
  }

  int add_corner(std::size_t at) {
    const Vec2 p = axis_.point[at];
    const double c = sections_.column.height / 2, b = sections_.beam.height / 2;
    const double mass = sections_.column.mass * b + sections_.beam.mass * c;
    return add_segment({p.x - c, p.y - b, p.x + c, p.y + b}, mass,
                       std::min(sections_.column.width, sections_.beam.width),
                       moved(true, true, p.x, p.y));
  }

  // Adds a part with corners at both ends, or kGround. The sum of the sections' lengths is exact for moments up to a cubic: Gregory's
  // weights (20.6) where an end has a section.
  bool add_part(std::size_t k, int first, int last) {
    const Vec2 from = axis_.from(k), d = axis_.to(k) - from;
    const double whole = length(d);
    const Vec2 direction{d.x / whole, d.y / whole};
    const bool upright = axis_.upright(k);
    const Section &own = section(upright), &other = section(!upright);
    const double shortest = kLeastShare * other.height;
    const double fit = 2 * std::floor(whole / shortest / 2 + 1e-9);  // many where a section is thin
    const int pieces = static_cast<int>(std::min<double>(kPieces, fit));
    if (pieces < kFewestPieces)
      return fault("", metres(whole),
                   "has a part that is too short to be a bar: less than three times as long as "
                   "what it meets "
                   "is deep",
                   "write longer parts, or less deep sections");
    const double step = whole / pieces;
    frame_.parts.push_back({axis_.words[k], from, direction, whole});
    const double begin = first == kGround ? 0 : other.height / 2;
    const double end = whole - (last == kGround ? 0 : other.height / 2);
    std::vector<int> segment;
    for (int i = 0; i < pieces; ++i) {
      const double s0 = std::max(begin, i * step), s1 = std::min(end, (i + 1) * step);
      const Vec2 p{from.x + s0 * direction.x, from.y + s0 * direction.y};
      const Vec2 q{from.x + s1 * direction.x, from.y + s1 * direction.y};
      const double half = own.height / 2;
      const Rect box = upright
                           ? Rect{p.x - half, std::min(p.y, q.y), p.x + half, std::max(p.y, q.y)}
                           : Rect{std::min(p.x, q.x), p.y - half, std::max(p.x, q.x), p.y + half};
      segment.push_back(
          add_segment(box, own.mass * (s1 - s0), own.width, moved(upright, !upright, p.x, p.y)));
    }
    const bool begins = first != kGround || (is_held() && k == 0 && is_foot(false));
    const bool ends = last != kGround || (is_held() && k + 1 == axis_.parts() && is_foot(true));
    for (int i = 0; i <= pieces; ++i) {
      if ((i == 0 && !begins) || (i == pieces && !ends)) continue;
      FrameJoint joint;
      joint.part = static_cast<int>(frame_.parts.size()) - 1;
      joint.a = i == 0 ? first : segment[i - 1];
      joint.b = i == pieces ? last : segment[i];
      joint.place = i * step;
      joint.length = step * (1 + (begins ? at_end(i) : 0) + (ends ? at_end(pieces - i) : 0));
      joint.hinged = spec_.feet == FrameFeet::kHinged && (joint.a == kGround || joint.b == kGround);
      frame_.joints.push_back(joint);
    }
    return true;
  }

  // Term that Gregory's rule adds to the weight 1 of a section, `i` sections from an end.
  static double at_end(int i) {
    constexpr double kAdds[] = {3.0 / 8 - 1, 7.0 / 6 - 1, 23.0 / 24 - 1};
    return i < 3 ? kAdds[i] : 0.0;
  }

  const FrameSpec& spec_;
  std::size_t index_;
  const FrameSections& sections_;
  const FrameSite& site_;
  FaultList& faults_;
  FrameAxis axis_;
  PlacedFrame frame_;
};

const PlacedOpening* find_opening(const Shape& shape, const std::vector<PlacedOpening>& openings,
                                  const FrameSpec& frame, std::size_t index, FaultList& faults) {
  std::vector<std::string> names;
  for (const OpeningSpec& opening : shape.wall.opening) names.push_back(opening.name);
  for (const PlacedOpening& opening : openings)
    if (shape.wall.opening[opening.index].name == frame.round) return &opening;
  // a faulty opening is reported elsewhere
  if (std::find(names.begin(), names.end(), frame.round) != names.end()) return nullptr;
  add_fault(faults, path_of(index, "round"), "\"" + frame.round + "\"",
            called(frame, index) + ": no opening has this name",
            names.empty() ? "add a [[wall.opening]], or write the frame's axis: line"
                          : name_advice(frame.round, names));
  return nullptr;
}

// Checks the keys that every frame needs; false after a fault.
bool is_given(const FrameSpec& frame, std::size_t index, FaultList& faults) {
  const std::size_t before = faults.all().size();
  const auto fault = [&](const char* key, std::string value, const std::string& problem,
                         const char* cure) {
    add_fault(faults, path_of(index, key), std::move(value), called(frame, index) + ": " + problem,
              cure);
  };
  const bool in_opening = !frame.round.empty() || has_hole(frame);
  if (in_opening != frame.line.empty())
    fault("round", frame.round, frame.line.empty() ? "has no place" : "has two places",
          "write round = \"the opening's name\", or its axis as line, one of both");
  if (frame.feet == FrameFeet::kNone)
    fault("feet", "", "missing",
          "write feet = \"fixed\", \"hinged\", \"base_beam\" or \"resting\"");
  if (frame.count < 1)
    fault("count", std::to_string(frame.count), "must be 1 or more", "write count = 1");
  if (frame.beam_count < 0)
    fault("beam_count", std::to_string(frame.beam_count), "must be 1 or more",
          "write beam_count = 1");
  if (in_opening && frame.joint.empty())
    fault("joint", "", "missing",
          "name the [material.*] between it and the masonry: dry for contact alone");
  if (!(frame.gap >= 0))
    fault("gap", millimetres(frame.gap), "must not be negative",
          "write gap = \"0 mm\", or how far it stands from the masonry");
  return faults.all().size() == before;
}

}  // namespace

std::optional<FrameSections> sections_of(const FrameSpec& frame, std::size_t index,
                                         FaultList& faults) {
  const auto column = one_section(frame.profile, frame.section, frame.count, index, "", faults);
  const int beams = frame.beam_count > 0 ? frame.beam_count : frame.count;
  const bool own = !frame.beam_profile.empty() || is_stated(frame.beam_section);
  if (!own && !column) return std::nullopt;  // its faults are told, and a beam has the same section
  const auto beam =
      own ? one_section(frame.beam_profile, frame.beam_section, beams, index, "beam_", faults)
          : one_section(frame.profile, frame.section, beams, index, "", faults);
  if (!column || !beam) return std::nullopt;
  return FrameSections{*column, *beam};
}

std::optional<PlacedFrame> place_frame(const FrameSpec& spec, std::size_t index,
                                       const PlacedOpening* opening, const FrameSite& site,
                                       FaultList& faults) {
  const bool given = is_given(spec, index, faults);
  const auto sections = sections_of(spec, index, faults);
  if (!given || !sections || (opening == nullptr && spec.line.empty())) return std::nullopt;
  Builder builder(spec, index, *sections, site, faults);
  if (!(opening != nullptr ? builder.round(*opening) : builder.along_line()) || !builder.build())
    return std::nullopt;
  return builder.take();
}

bool has_hole(const FrameSpec& frame) {
  const HoleSpec& hole = frame.hole;
  return !std::isnan(hole.x) || !std::isnan(hole.y) || !std::isnan(hole.width) ||
         !std::isnan(hole.height);
}

void check_frame_names(const std::vector<FrameSpec>& frames, FaultList& faults) {
  for (std::size_t k = 0; k < frames.size(); ++k)
    for (std::size_t j = 0; j < k; ++j)
      if (!frames[k].name.empty() && frames[j].name == frames[k].name)
        add_fault(faults, path_of(k, "name"), frames[k].name, "is the name of another frame",
                  "give each a name of its own");
}

std::vector<PlacedFrame> place_frames(const Shape& shape,
                                      const std::vector<PlacedOpening>& openings,
                                      const FrameSite& site, FaultList& faults) {
  std::vector<PlacedFrame> placed;
  for (std::size_t k = 0; k < shape.frame.size(); ++k) {
    const FrameSpec& spec = shape.frame[k];
    for (const auto& [key, stated] : {std::pair("wall", !spec.wall.empty()),
                                      {"x", !std::isnan(spec.x)},
                                      {"y", !std::isnan(spec.y)},
                                      {"z", !std::isnan(spec.z)},
                                      {"turn", spec.turn != 0},
                                      {"hole", has_hole(spec)}})
      if (stated)
        add_fault(faults, path_of(k, key), "",
                  called(spec, k) + ": is for walls in space; this one lies in its plane",
                  "leave it out, and write round or line");
    const PlacedOpening* opening =
        spec.round.empty() ? nullptr : find_opening(shape, openings, spec, k, faults);
    if (auto frame = place_frame(spec, k, opening, site, faults))
      placed.push_back(std::move(*frame));
  }
  check_frame_names(shape.frame, faults);
  for (const PlacedFrame& frame : placed) {
    Rect box = bounds(frame.segments.front().outline);
    for (const Block& segment : frame.segments) box = join(box, bounds(segment.outline));
    const Rect& wall = site.wall;
    if (overlaps(box, wall, -kNear)) continue;
    const std::size_t k = frame.index;
    add_fault(faults, path_of(k, "line"), metres(box.x0) + " to " + metres(box.x1),
              called(shape.frame[k], k) +
                  " stands outside the wall, which spans x = " + metres(wall.x0) + " to " +
                  metres(wall.x1) + ", y = " + metres(wall.y0) + " to " + metres(wall.y1),
              "move it to the wall");
  }
  return placed;
}

void check_frames(const Assembly& assembly, FaultList& faults) {
  if (assembly.frames.empty()) return;
  std::vector<bool> told(assembly.frames.size(), false);
  const double tolerance = contact_tolerance(assembly.blocks);
  for (const auto& [i, j] : near_pairs(assembly.blocks, 0)) {
    const Block &a = assembly.blocks[i], &b = assembly.blocks[j];
    if (a.frame == b.frame || a.cut_from >= 0 || b.cut_from >= 0) continue;
    const Block &segment = a.frame >= 0 ? a : b, &other = a.frame >= 0 ? b : a;
    const Rect box = bounds(segment.outline);
    if (!overlaps(box, bounds(other.outline), tolerance) ||
        overlap_area(segment.outline, other.outline) <=
            tolerance * (box.x1 - box.x0 + box.y1 - box.y0))
      continue;
    const auto known =
        std::find_if(assembly.frames.begin(), assembly.frames.end(),
                     [&](const PlacedFrame& frame) { return frame.index == segment.frame; });
    const std::size_t at = known - assembly.frames.begin();
    if (told[at]) continue;
    told[at] = true;
    add_fault(faults, path_of(static_cast<std::size_t>(segment.frame), ""), "",
              "frame " + known->name + " reaches into " +
                  (other.frame >= 0 ? "another frame" : "block \"" + other.id + "\"") + " at " +
                  metres((box.x0 + box.x1) / 2) + ", " + metres((box.y0 + box.y1) / 2),
              "make the opening larger, or move the frame's line");
  }
}

}  // namespace wythe::geometry
