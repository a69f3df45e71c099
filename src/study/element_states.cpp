#include "study/element_states.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

namespace wythe {

ModeRules rules_for(const Model& model) {
  constexpr double kOfCourse = 0.01;  // a tenth of a 10 mm bed in courses of 100 mm
  ModeRules rules;
  rules.crack = kOfCourse * study::find_parts(model).course;
  rules.sliding = 3 * rules.crack;
  return rules;
}

namespace study {
namespace {

constexpr double kFoot = 0.25;  // of a pier's width (at most of its height): zone of toes and head
constexpr double kSlender = 0.75;  // of a panel's length: no crack has to be longer
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

// Signs come gravest first, so the state reads that way.
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

// Length of the lines on which the panel has parted by a crack's width.
double parted(const std::vector<LineSum>& lines, double length, double crack) {
  const auto open = std::count_if(lines.begin(), lines.end(),
                                  [&](const LineSum& l) { return l.movement() >= crack; });
  return length * static_cast<double>(open) / static_cast<double>(lines.size());
}

double widest_line(const std::vector<LineSum>& lines) {
  double widest = 0;
  for (const LineSum& line : lines) widest = std::max(widest, line.opened);
  return widest;
}

// The slip that nine lines in ten have at least.
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

class Reader {
 public:
  Reader(const WallParts& parts, const std::vector<JointMotion>& joints, const ModeRules& rules)
      : parts_(parts), joints_(joints), rules_(rules) {}

  [[nodiscard]] ElementState pier(const Pier& p) const {
    const Box shaft = shaft_of(p);
    const double width = p.box.width();
    const double needed = std::min(rules_.pier_crossed * width * parts_.course / parts_.column,
                                   kSlender * shaft.height());
    const std::vector<LineSum> lines = scan(joints_, shaft, Lines::kLevel, parts_.course);
    const Box whole{p.box.x0, p.box.x1, p.base - 0.5 * parts_.course, p.box.y1};
    double slid = 0, slid_below = 0, rocks = 0, opened = 0;
    for (const BedSection& section : bed_sections(joints_, whole, parts_.course)) {
      const double slip = slip_all_across(section, width);
      double& most = is_foundation(section) ? slid_below : slid;
      most = std::max(most, slip);
      const bool is_foot = section.y < p.box.y0 + foot_height(p);
      if (is_foot) rocks = std::max(rocks, open_share(section, width, rules_.crack));
      if (!is_foot && section.y < p.box.y1 - foot_height(p)) continue;
      for (const JointMotion* j : section.joints) opened = std::max(opened, j->widest);
    }
    return element(
        p.name, "pier",
        {sign(kDiagonal, "height over which it is parted",
              parted(lines, shaft.height(), rules_.crack), needed, "m"),
         sign(kSliding, "slip all across a bed section", slid, rules_.sliding, "mm"),
         sign(kBaseSliding, "slip all across the foundation", slid_below, rules_.sliding, "mm"),
         sign(kRocking, "open share of its foot", rocks, rules_.rocking, "share"),
         sign(kFlexural, "widest bed joint at foot or head", opened, rules_.crack, "mm")});
  }

  [[nodiscard]] ElementState spandrel(const Spandrel& s) const {
    Box masonry = s.box;
    masonry.y0 += s.lintel;
    const double length = masonry.width();
    const double needed =
        std::min(rules_.spandrel_crossed * masonry.height() * parts_.column / parts_.course,
                 kSlender * length);
    const std::vector<LineSum> columns = scan(joints_, masonry, Lines::kUpright, parts_.column);
    const std::vector<LineSum> inner = scan(joints_, masonry, Lines::kLevel, parts_.course);
    Box ends = masonry;  // with the joints at the jambs
    ends.x0 -= 0.5 * parts_.column;
    ends.x1 += 0.5 * parts_.column;
    const std::vector<LineSum> whole = scan(joints_, ends, Lines::kLevel, parts_.course);
    return element(
        s.name, s.is_sill ? "sill" : "spandrel",
        {sign(kDiagonal, "length over which it is parted", parted(columns, length, rules_.crack),
              needed, "m"),
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
  const WallParts& parts_;
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

ElementStates element_states(const WallParts& parts, const std::vector<JointMotion>& joints,
                             const ModeRules& rules) {
  const Reader reader(parts, joints, rules);
  ElementStates elements;
  for (const Pier& p : parts.piers) elements.push_back(reader.pier(p));
  for (const Spandrel& s : parts.spandrels) elements.push_back(reader.spandrel(s));
  for (const Part& c : parts.connections) elements.push_back(reader.connection(c));
  for (const Part& t : parts.toes) elements.push_back(reader.toe(t));
  return elements;
}

Truths truths_of(const WallParts& parts, const std::vector<JointMotion>& joints,
                 const ModeRules& rules) {
  constexpr double kWidths[] = {0.5, 0.75, 1, 1.5, 2};
  Truths truths;
  for (const double width : kWidths) {
    ModeRules scaled = rules;
    scaled.crack *= width;
    scaled.sliding *= width;
    const ElementStates elements = element_states(parts, joints, scaled);
    truths.resize(elements.size());
    for (std::size_t e = 0; e < elements.size(); ++e) {
      truths[e].resize(elements[e].signs.size());
      for (std::size_t k = 0; k < truths[e].size(); ++k) {
        const ElementSign& s = elements[e].signs[k];
        const double beyond = (s.value / s.threshold - 1) / (2 * rules.doubt);
        truths[e][k] += std::clamp(0.5 + beyond, 0.0, 1.0) / std::size(kWidths);
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
