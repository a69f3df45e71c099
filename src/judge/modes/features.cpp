// Sums of joint opening, slip and crushing over the parts of a wall; see wythe/parts/failure_mode.h.
#include <algorithm>
#include <cmath>

#include "judge/modes/joint_motion.h"
#include "judge/modes/wall_parts.h"
#include "wythe/parts/failure_mode.h"

namespace wythe {
namespace {

using study::Box;
using study::JointMotion;

std::string key_of(std::string name) {
  std::replace(name.begin(), name.end(), ' ', '_');
  return name;
}

struct Region {
  std::string name;
  Box box;
  bool is_base = false;
};

std::vector<Region> regions_of(const study::WallParts& parts) {
  std::vector<Region> regions;
  for (const study::Pier& p : parts.piers) regions.push_back({key_of(p.name), p.box, false});
  for (const study::Spandrel& s : parts.spandrels)
    regions.push_back({key_of(s.name), s.box, false});
  for (const study::Part& c : parts.connections) regions.push_back({key_of(c.name), c.box, false});
  Box base = parts.wall;
  base.x0 -= parts.column;
  base.x1 += parts.column;
  base.y1 = base.y0 + 0.5 * parts.course;
  base.y0 -= 0.5 * parts.course;
  regions.push_back({"base", base, true});
  return regions;
}

}  // namespace

std::vector<Feature> read_features(const Model& model, const Result& result) {
  if (model.in_space()) return {};
  const std::vector<Region> regions = regions_of(study::find_parts(model));
  std::vector<Feature> features;
  for (const Snapshot& snapshot : result.snapshots) {
    const std::vector<JointMotion> joints = study::evaluate_motion(model, snapshot.state).joints;
    for (const Region& r : regions) {
      double opening = 0, slip = 0, crushing = 0;
      for (const JointMotion& j : joints) {
        if (!r.box.holds(j.x, j.y) || (r.is_base && !j.is_bed)) continue;
        opening += j.opening;
        slip += std::fabs(j.slip);
        crushing += j.crushed;
      }
      features.push_back({r.name + "_opening", snapshot.displacement, opening});
      features.push_back({r.name + "_slip", snapshot.displacement, slip});
      features.push_back({r.name + "_crushing", snapshot.displacement, crushing});
    }
  }
  return features;
}

}  // namespace wythe
