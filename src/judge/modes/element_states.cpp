// Measures each sign of damage of each part: cracks, slips of whole sections, rocking, crushing, pieces broken
// off. A crack reaches as far as lines through the part moved apart by `crack`, (5.1) to (5.3). In a dry pier
// the rotation share (5.5) counts as rocking and shortens the diagonal crack. Truths repeat this at five crack
// widths. Reasons: docs/theory/failure_modes.md. Lengths are in m; the value of a sign shown in mm is in mm.
#include "judge/modes/element_states.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

namespace wythe {

ModeRules rules_for(const Model& model) { return study::rules_of(study::find_parts(model)); }

namespace study {

ModeRules rules_of(const WallParts& parts) {
  constexpr double kOfCourse = 0.01;  // a tenth of a 10 mm bed in courses of 100 mm
  ModeRules rules;
  rules.crack = kOfCourse * parts.course;
  rules.sliding = 3 * rules.crack;
  return rules;
}

namespace {

constexpr double kFoot = 0.25;  // of a pier's width (at most of its height): zone of toes and head
constexpr double kSlender = 0.75;  // of a panel's length: no crack needs to be longer
constexpr double kMillimetres = 1e3;

ElementSign sign(const char* state, const char* measure, double value, double threshold,
                 const char* unit) {
  ElementSign s;
  s.state = state;
  s.measure = measure;
  const double scale = std::string_view(unit) == "mm" ? kMillimetres : 1.0;
  s.value = scale * value;
  s.threshold = scale * threshold;
  s.unit = unit;
  return s;
}

// Signs come in order of severity, so the first one gives the state.
ElementState element(const std::string& name, const char* kind, std::vector<ElementSign> signs) {
  ElementState e;
  e.element = name;
  e.kind = kind;
  e.signs = std::move(signs);
  std::string found;
  for (const ElementSign& s : e.signs)
    if (s.holds()) found += (found.empty() ? "" : ", ") + s.state;
  if (!found.empty()) e.state = found;
  return e;
}

double foot_height(const Pier& pier) {
  return kFoot * std::min(pier.box.width(), pier.box.height());
}

// The part of a panel that has parted by a crack's width: its length along the panel and its depth across.
struct PartedPanel {
  double along = 0, across = 0;  // [m]
  // Length needed to cross `depth` at this slope; the bond's stepped line is the least slope.
  [[nodiscard]] double to_cross(double depth, double bond) const {
    return depth * (across > 0 ? std::max(bond, along / across) : bond);
  }
};

// `lines` cross the long axis of the panel.
PartedPanel parted(const std::vector<JointMotion>& joints, const Box& panel, Lines lines,
                   const WallParts& parts, double crack) {
  const bool level = lines == Lines::kLevel;
  const double pitch = level ? parts.course : parts.column;
  const double pitch_across = level ? parts.column : parts.course;  // no crack takes less
  Box reached = panel;  // from the first to the last line that has parted
  double &from = level ? reached.y0 : reached.x0, &to = level ? reached.y1 : reached.x1;
  const auto is_parted = [&](const LineSum& l) { return l.movement() >= crack; };
  const std::vector<LineSum> all = scan(joints, panel, lines, pitch);
  const auto open = std::count_if(all.begin(), all.end(), is_parted);
  if (open == 0) return {};
  const auto first = std::find_if(all.begin(), all.end(), is_parted);
  const auto last = std::find_if(all.rbegin(), all.rend(), is_parted);
  const double length = to - from, depth = level ? panel.width() : panel.height();
  from = std::max(from, first->at - 0.6 * pitch);  // including the joints at its ends
  to = std::min(to, last->at + 0.6 * pitch);
  const std::vector<LineSum> other =
      scan(joints, reached, level ? Lines::kUpright : Lines::kLevel, pitch_across);
  const auto crossed = std::count_if(other.begin(), other.end(), is_parted);
  return {length * static_cast<double>(open) / static_cast<double>(all.size()),
          std::max(pitch_across,
                   depth * static_cast<double>(crossed) / static_cast<double>(other.size()))};
}

double widest_line(const std::vector<LineSum>& lines) {
  double widest = 0;
  for (const LineSum& line : lines) widest = std::max(widest, line.opened);
  return widest;
}

// The slip that 90 % of the lines reach [m].
double slip_on_all(const std::vector<LineSum>& lines) {
  std::vector<double> slip;
  for (const LineSum& line : lines) slip.push_back(std::fabs(line.slip));
  std::sort(slip.begin(), slip.end());
  return slip[slip.size() / 10];
}

bool is_foundation(const BedSection& section) {
  const JointMotion& j = *section.joints.front();
  return j.on_ground || j.kind == JointKind::kFoundation;
}

// Slip of bed sections: the largest in one section or in all together, and on the foundation.
struct BedSlips {
  double above = 0, below = 0;  // [m]
};

double length_of(const BedSection& section) {
  double length = 0;
  for (const JointMotion* j : section.joints) length += j->length();
  return length;
}

// `width` of a section, or 0: the length of its joints. Then sections shorter than half of `least` do not count.
BedSlips slips_of(const std::vector<BedSection>& sections, double course, double width,
                  double least = 0) {
  constexpr double kStep =
      1.25;  // of a course: beds above each other, with courses of other heights
  constexpr double kFlat =
      0.15;  // rise of a plane over its length: a steeper one is a diagonal crack
  BedSlips slips;
  double together = 0;  // many small slips in one direction
  for (const BedSection& section : sections) {
    const double all = width > 0 ? width : length_of(section);
    if (all < 0.5 * least) continue;
    double& most = is_foundation(section) ? slips.below : slips.above;
    most = std::max(most, slip_all_across(section, all));
    if (!is_foundation(section)) together += slid_all_across(section, all);
  }
  slips.above = std::max(slips.above, std::fabs(together));
  // a plane that steps from bed to bed is slid over although no bed is slid along all its length
  for (std::size_t k = 0; k < sections.size(); ++k)
    for (std::size_t m = k + 1; m < sections.size(); ++m) {
      const double all =
          width > 0 ? width : std::max(length_of(sections[k]), length_of(sections[m]));
      const double rise = sections[m].y - sections[k].y;
      if (rise > std::max(kStep * course, kFlat * all)) break;
      if (all < 0.5 * least) continue;
      const SteppedSlip stepped = slip_in_steps(sections[k], sections[m], all);
      const double alone =
          std::max(slip_all_across(sections[k], all), slip_all_across(sections[m], all));
      if (alone >= 0.5 * stepped.slip) continue;
      const bool at_foundation = is_foundation(sections[stepped.in_first > 0.5 ? k : m]);
      double& most = at_foundation ? slips.below : slips.above;
      most = std::max(most, stepped.slip);
    }
  return slips;
}

// Rotation share of a pier: how much of its blocks' motion against the base is a rotation about a toe.
class Turning {
 public:
  Turning(const Pier& pier, const WallParts& parts, const std::vector<BlockMotion>& blocks,
          double crack)
      : pier_(pier),
        course_(parts.course),
        is_topmost_(parts.wall.y1 - pier.box.y1 < 0.5 * parts.course),
        blocks_(blocks),
        crack_(crack) {}

  // The smaller of that share and twice the share of the pier's mass that has moved so.
  [[nodiscard]] double share() const {
    const auto under = [&](const BlockMotion& b) {
      return is_in_line(b) && b.at.y < pier_.base && b.at.y > pier_.base - 2 * course_;
    };
    const auto above = [&](const BlockMotion& b) {
      const bool is_cap =
          b.role == BlockRole::kBeam || b.role == BlockRole::kPlate || b.role == BlockRole::kFrame;
      return b.at.y > pier_.box.y1 && (is_topmost_ ? is_cap : is_in_line(b)) &&
             (is_topmost_ || b.at.y < pier_.box.y1 + 2 * course_);
    };
    const RigidMotion base = fitted(blocks_, under), head = fitted(blocks_, above);
    double most = 0;
    for (const double x : {pier_.box.x0, pier_.box.x1})
      for (const double y : {pier_.base, pier_.box.y0})
        most = std::max(most, about({x, y}, base, head));
    return most;
  }

 private:
  [[nodiscard]] bool is_in_line(const BlockMotion& b) const {
    return b.at.x > pier_.box.x0 && b.at.x < pier_.box.x1;
  }
  // Motion of a block relative to a rigid frame of reference.
  static RigidMotion against(const RigidMotion& frame, const RigidMotion& b) {
    return {b.at, b.moved - frame.moved - cross(frame.turn, b.at - frame.at), b.turn - frame.turn};
  }
  // The share of a motion that is a rotation about a toe: displacement by rotation, over that and the rest.
  static double turned(const RigidMotion& m, Vec3 toe) {
    const Vec3 arm = m.at - toe;
    const double by_turn = length(m.turn) * length(arm);
    const double left = length(m.moved - cross(m.turn, arm));
    return by_turn > 0 ? by_turn / (by_turn + left) : 0.0;
  }

  [[nodiscard]] double about(Vec3 toe, const RigidMotion& base, const RigidMotion& head) const {
    constexpr double kHalf = 0.5;
    // a head that does not turn with the pier holds its top: blocks that hang on it do not count
    const RigidMotion at_head = against(base, head);
    const bool is_held = length(at_head.moved) >= crack_ && turned(at_head, toe) < kHalf;
    double turns = 0, way = 0, moved = 0, all = 0;
    for (const BlockMotion& b : blocks_) {
      if (b.role != BlockRole::kMasonry || !pier_.box.holds(b.at.x, b.at.y)) continue;
      all += b.mass;
      const RigidMotion m = against(base, b), hangs = against(head, b);
      const double far = length(m.moved);
      if (far < crack_ || (is_held && length(hangs.moved) < crack_)) continue;
      moved += b.mass;
      way += b.mass * far;
      turns += b.mass * far * turned(m, toe);
    }
    return way > 0 ? std::min(turns / way, 2 * moved / all) : 0.0;
  }

  const Pier& pier_;
  double course_;
  bool is_topmost_;  // only plates or a beam stand on it
  const std::vector<BlockMotion>& blocks_;
  double crack_;
};

// Measures from a pier's bed sections.
struct Beds {
  double open_foot = 0;  // open share of the sections in the foot, taken together from one side
  double open_bed = 0;   // largest of one of them
  double opened = 0;     // widest joint at foot or head [m]
  double widest = 0;     // widest joint anywhere [m]
  double bond = 0, force = 0;  // of all sections but the foundation [N]
};

class SignReader {
 public:
  SignReader(const WallParts& parts, const WallMotion& motion, const ModeRules& rules)
      : parts_(parts), motion_(motion), joints_(motion.joints), rules_(rules) {}

  [[nodiscard]] ElementState pier(const Pier& p) const {
    const double width = p.box.width();
    const Reach crack = crack_through(p);
    const Box whole{p.box.x0, p.box.x1, p.base - 0.5 * parts_.course, p.box.y1};
    const std::vector<BedSection> sections = bed_sections(joints_, whole, parts_.course);
    const Beds beds = beds_of(p, sections);
    const BedSlips slips = slips_of(sections, parts_.course, width);
    // the steps of a crack that goes on through the pier are no bed that it rocks on
    const double goes_on = std::clamp(2 * crack.length / crack.needed - 1, 0.0, 1.0);
    double apart = crack.length,
           rocks = beds.open_foot - goes_on * (beds.open_foot - beds.open_bed);
    const double dry = dryness(beds);
    if (dry > 0) {
      const double turning = dry * Turning(p, parts_, motion_.blocks, rules_.crack).share();
      // a stepped crack through joints without strength is the shape of rocking, not a failure
      if (turning > rules_.rocking)
        apart = std::min(apart, crack.needed * (1 - turning) / (1 - rules_.rocking));
      rocks = std::max(rocks, std::min(turning, rules_.rocking * beds.widest / rules_.crack));
    }
    return element(
        p.name, "pier",
        {sign(kDiagonal, "height over which it is parted", apart, crack.needed, "m"),
         sign(kSliding, "slip all across its bed sections", slips.above, rules_.sliding, "mm"),
         sign(kBaseSliding, "slip all across the foundation", slips.below, rules_.sliding, "mm"),
         sign(kRocking,
              dry > 0 ? "open share of its foot, or share turning about a toe"
                      : "open share of its foot",
              rocks, rules_.rocking, "share"),
         sign(kFlexural, "widest bed joint at foot or head", beds.opened, rules_.crack, "mm")});
  }

  // Bed joints that run through the whole wall, above its openings or between them.
  [[nodiscard]] ElementState whole_wall() const {
    Box all = parts_.wall;
    all.x0 -= parts_.column;
    all.x1 += parts_.column;
    all.y0 -= 0.5 * parts_.course;
    const BedSlips slips =
        slips_of(bed_sections(joints_, all, parts_.course), parts_.course, 0, parts_.wall.width());
    return element(
        kWholeWall, "wall",
        {sign(kSliding, "slip all along its beds", slips.above, rules_.sliding, "mm"),
         sign(kBaseSliding, "slip all along the foundation", slips.below, rules_.sliding, "mm"),
         sign(kBreaking, "masonry that came off in one piece", largest_piece(), rules_.broken_off,
              "share")});
  }

  [[nodiscard]] ElementState top_joint() const {
    BedSection top;
    double opened = 0;
    for (const JointMotion& j : motion_.top) {
      if (!j.is_bed) continue;
      top.joints.push_back(&j);
      opened = std::max(opened, j.widest);
    }
    return element(kTopJoint, "top joint",
                   {sign(kSliding, "slip all along it", slip_all_across(top, length_of(top)),
                         rules_.sliding, "mm"),
                    sign(kFlexural, "its widest opening", opened, rules_.crack, "mm")});
  }

  [[nodiscard]] ElementState spandrel(const Spandrel& s) const {
    Box masonry = s.box;
    masonry.y0 += s.lintel;
    const double length = masonry.width();
    const Box haunched = with_haunches(s, masonry);
    const PartedPanel crack = parted(joints_, haunched, Lines::kUpright, parts_, rules_.crack);
    const double needed = std::min(
        crack.to_cross(rules_.spandrel_crossed * masonry.height(), parts_.column / parts_.course),
        kSlender * length);
    const std::vector<LineSum> inner = scan(joints_, masonry, Lines::kLevel, parts_.course);
    Box ends = haunched;  // with the joints at the jambs
    ends.x0 -= 0.5 * parts_.column;
    ends.x1 += 0.5 * parts_.column;
    const std::vector<LineSum> whole = scan(joints_, ends, Lines::kLevel, parts_.course);
    return element(
        s.name, s.is_sill ? "sill" : "spandrel",
        {sign(kDiagonal, "length over which it is parted", crack.along, needed, "m"),
         sign(kSliding, "slip all down an upright section", slip_on_all(inner), rules_.sliding,
              "mm"),
         sign(kFlexural, "widest crack along a course", widest_line(whole), rules_.crack, "mm")});
  }

  [[nodiscard]] ElementState connection(const Part& c) const {
    const std::vector<LineSum> lines = scan(joints_, c.box, Lines::kLevel, parts_.course);
    double opened = widest_line(lines);
    for (const JointMotion& j : joints_)
      if (j.is_bed && j.kind == JointKind::kBed && c.box.holds(j.x, j.y))
        opened = std::max(opened, j.opened);
    return element(
        c.name, "connection",
        {sign(kSliding, "slip all down an upright section", slip_on_all(lines), rules_.sliding,
              "mm"),
         sign(kFlexural, "widest crack along a course or bed", opened, rules_.crack, "mm")});
  }

  [[nodiscard]] ElementState toe(const Part& t) const {
    double crushed = 0;
    for (const JointMotion& j : joints_)
      if (t.box.holds(j.x, j.y)) crushed = std::max(crushed, j.crushing);
    return element(
        t.name, "toe",
        {sign(kCrushing, "compressive strength lost", crushed, rules_.crushing, "share")});
  }

 private:
  // Over an arch, also the masonry beside its crown, because there is none within the opening's width.
  static Box with_haunches(const Spandrel& s, Box masonry) {
    if (!s.is_sill && !(s.lintel > 0)) masonry.y0 -= s.opening;
    return masonry;
  }
  [[nodiscard]] double largest_piece() const {
    const std::vector<PieceOff> pieces = broken_off(motion_, rules_);
    return pieces.empty() ? 0.0 : pieces.front().share;
  }
  // Length of a crack, and the length that counts as failure.
  struct Reach {
    double length = 0, needed = 0;  // [m]
  };
  // The crack that is nearer to failure: across the pier from side to side, or along its shaft, where a steep crack splits it.
  [[nodiscard]] Reach crack_through(const Pier& p) const {
    const Box core = without_edges(p.box), shaft = without_edges(shaft_of(p));
    const PartedPanel crack = parted(joints_, core, Lines::kLevel, parts_, rules_.crack);
    const PartedPanel split = parted(joints_, shaft, Lines::kLevel, parts_, rules_.crack);
    const Reach across{crack.along, crack.to_cross(rules_.pier_crossed * core.width(),
                                                   parts_.course / parts_.column)};
    const Reach along{split.along, kSlender * shaft.height()};
    return along.length * across.needed > across.length * along.needed ? along : across;
  }
  // A strip of half a unit that comes off a pier's edge is no crack through
  // the pier. The strip must be less than half of the toe's quarter.
  [[nodiscard]] Box without_edges(Box pier) const {
    if (parts_.column > 0.5 * kFoot * pier.width()) return pier;
    pier.x0 += parts_.column;
    pier.x1 -= parts_.column;
    return pier;
  }
  [[nodiscard]] Beds beds_of(const Pier& p, const std::vector<BedSection>& sections) const {
    Beds beds;
    std::vector<BedSection> foot;
    for (const BedSection& section : sections) {
      const bool is_foot = section.y < p.box.y0 + foot_height(p);
      const bool is_head = section.y >= p.box.y1 - foot_height(p);
      // the bed on which a pier rocks may lie at the edge of its foot
      if (section.y < p.box.y0 + foot_height(p) + 0.5 * parts_.course) foot.push_back(section);
      for (const JointMotion* j : section.joints) {
        beds.widest = std::max(beds.widest, j->widest);
        if (is_foot || is_head) beds.opened = std::max(beds.opened, j->widest);
        if (is_foundation(section)) continue;
        beds.bond += j->bond;
        beds.force += std::max(0.0, j->force);
      }
    }
    for (const BedSection& section : foot)
      beds.open_bed = std::max(beds.open_bed, open_share(section, p.box.width(), rules_.crack));
    beds.open_foot = std::max(beds.open_bed, open_share_in_steps(foot, p.box, rules_.crack));
    return beds;
  }
  // Truth (0 to 1) that the bond of the joints is negligible against the force across them.
  static double dryness(const Beds& beds) {
    constexpr double kNextToNothing = 0.05;
    if (!(beds.bond > 0)) return 1;
    return std::clamp(1.5 - beds.bond / (kNextToNothing * beds.force), 0.0, 1.0);  // force 0: 0
  }

  const WallParts& parts_;
  const WallMotion& motion_;
  const std::vector<JointMotion>& joints_;
  const ModeRules& rules_;
};

}  // namespace

Box shaft_of(const Pier& pier) {
  Box shaft = pier.box;
  shaft.y0 += foot_height(pier);
  shaft.y1 -= foot_height(pier);
  return shaft;
}

double width_growth(const Pier& pier, const WallParts& parts,
                    const std::vector<JointMotion>& joints) {
  double growth = 0;
  for (const LineSum& line : scan(joints, shaft_of(pier), Lines::kLevel, parts.course))
    growth = std::max(growth, line.opening);
  return growth;
}

std::vector<PieceOff> broken_off(const WallMotion& motion, const ModeRules& rules) {
  constexpr double kHalf = 0.5;  // a piece may still hang at a hinge
  std::vector<PieceOff> pieces = pieces_off(motion, rules.crack, rules.sliding);
  std::erase_if(pieces, [&](const PieceOff& p) {
    return p.torn < kHalf || p.share < (1 - rules.doubt) * rules.broken_off;
  });
  return pieces;
}

ElementStates element_states(const WallParts& parts, const WallMotion& motion,
                             const ModeRules& rules) {
  const SignReader reader(parts, motion, rules);
  ElementStates elements;
  for (const Pier& p : parts.piers) elements.push_back(reader.pier(p));
  for (const Spandrel& s : parts.spandrels) elements.push_back(reader.spandrel(s));
  for (const Part& c : parts.connections) elements.push_back(reader.connection(c));
  for (const Part& t : parts.toes) elements.push_back(reader.toe(t));
  if (parts.openings > 0) elements.push_back(reader.whole_wall());
  if (!motion.top.empty()) elements.push_back(reader.top_joint());
  return elements;
}

double ramp(double value, double threshold, const ModeRules& rules) {
  const double beyond = (value / threshold - 1) / (2 * rules.doubt);
  return std::clamp(0.5 + beyond, 0.0, 1.0);
}

Truths truths_of(const WallParts& parts, const WallMotion& motion, const ModeRules& rules) {
  constexpr double kWidths[] = {0.5, 0.75, 1, 1.5, 2};
  Truths truths;
  for (const double width : kWidths) {
    ModeRules scaled = rules;
    scaled.crack *= width;
    scaled.sliding *= width;
    const ElementStates elements = element_states(parts, motion, scaled);
    truths.resize(elements.size());
    for (std::size_t e = 0; e < elements.size(); ++e) {
      truths[e].resize(elements[e].signs.size());
      for (std::size_t k = 0; k < truths[e].size(); ++k) {
        const ElementSign& s = elements[e].signs[k];
        truths[e][k] += ramp(s.value, s.threshold, rules) / std::size(kWidths);
      }
    }
  }
  return truths;
}

double truth(const ElementStates& elements, const Truths& truths, const std::string& element,
             const std::string& state) {
  for (std::size_t e = 0; e < elements.size(); ++e) {
    if (elements[e].element != element) continue;
    for (std::size_t k = 0; k < elements[e].signs.size(); ++k)
      if (elements[e].signs[k].state == state) return truths[e][k];
  }
  return 0;
}

}  // namespace study
}  // namespace wythe
