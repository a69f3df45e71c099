// Measures how severe a failure is: wider piers, sliding in spandrels, slip of pushed blocks, falls of the force.
// A fall counts if it lies within one crack width of push; it is a share of the largest reaction of the curve.
#include "judge/modes/mode_flags.h"

#include <algorithm>
#include <cmath>

#include "judge/modes/element_states.h"

namespace wythe::study {
namespace {

// Share of the spandrel's length that slides in one bed without opening.
double sliding_band(const Spandrel& s, const WallParts& parts,
                    const std::vector<JointMotion>& joints, const ModeRules& rules) {
  double most = 0;
  for (const BedSection& section : bed_sections(joints, s.box, parts.course)) {
    double length = 0;
    for (const JointMotion* j : section.joints)
      if (j->kind != JointKind::kLintelBond && std::fabs(j->slip) >= rules.crack &&
          std::fabs(j->slip) > 2 * j->opening)
        length += j->length();
    most = std::max(most, length / s.box.width());
  }
  return std::min(1.0, most);
}

// Slip between the pushed blocks and their neighbours.
double node_slip(const Model& model, const std::vector<JointMotion>& joints) {
  std::vector<bool> driven(model.n_block, false);
  for (const Stage& stage : model.stages)
    for (const BlockId b : stage.driven) driven[b] = true;
  const auto is_driven = [&](BlockId b) { return b != kGroundBlock && driven[b]; };
  double slip = 0;
  for (const JointMotion& j : joints) {
    if (is_driven(j.a) != is_driven(j.b)) slip = std::max(slip, std::fabs(j.slip));
  }
  return slip;
}

}  // namespace

std::vector<Evidence> state_flags(const Model& model, const WallParts& parts,
                                  const std::vector<JointMotion>& joints, const ModeRules& rules) {
  constexpr double kBand = 0.9;
  std::vector<Evidence> flags;
  for (const Pier& p : parts.piers)
    flags.push_back({p.name, "growth of its width", 1e3 * width_growth(p, parts, joints),
                     1e3 * rules.growth, "mm"});
  for (const Spandrel& s : parts.spandrels)
    if (!s.is_sill)
      flags.push_back({s.name, "length sliding in one bed", sliding_band(s, parts, joints, rules),
                       kBand, "share"});
  flags.push_back({"loaded node", "slip against its neighbours", 1e3 * node_slip(model, joints),
                   1e3 * rules.sliding, "mm"});
  return flags;
}

Evidence drop_flag(const std::vector<CurveRow>& curve, const ModeRules& rules) {
  double peak = 0, drop = 0;
  std::size_t from = 0;
  for (std::size_t i = 0; i < curve.size(); ++i) {
    peak = std::max(peak, curve[i].reaction);
    while (std::fabs(curve[i].displacement - curve[from].displacement) > 1.0001 * rules.crack)
      ++from;
    for (std::size_t k = from; k < i; ++k)
      drop = std::max(drop, curve[k].reaction - curve[i].reaction);
  }
  return {"reaction", "sudden fall, of the peak", peak > 0 ? drop / peak : 0.0, rules.drop,
          "share"};
}

}  // namespace wythe::study
