// Sums of joint opening, slip and crushing over the parts of a wall; see wythe/parts/failure_mode.h.
#include <algorithm>
#include <cmath>

#include "judge/modes/joint_motion.h"
#include "judge/modes/wall_parts.h"
#include "wythe/parts/failure_mode.h"
#include "wythe/parts/reading.h"

namespace wythe {
namespace {

using study::Box;
using study::JointMotion;

std::string key_of(std::string name) {
  std::replace(name.begin(), name.end(), ' ', '_');
  std::erase(name, ':');
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
  const std::vector<study::Elevation> elevations = study::elevations_of(model);
  std::vector<std::vector<Region>> regions;
  for (const study::WallParts& parts : study::find_parts(model, elevations))
    regions.push_back(regions_of(parts));
  std::vector<Feature> features;
  for (const Snapshot& snapshot : result.states.snapshots) {
    const WallReading wall = read_wall(model, snapshot.state);
    for (std::size_t k = 0; k < elevations.size(); ++k) {
      const auto joints = study::evaluate_motion(model, wall, elevations[k]).joints;
      const std::string of = elevations[k].wall.empty() ? "" : key_of(elevations[k].wall) + "_";
      for (const Region& r : regions[k]) {
        double opening = 0, slip = 0, crushing = 0;
        for (const JointMotion& j : joints) {
          if (!r.box.holds(j.x, j.y) || (r.is_base && !j.is_bed)) continue;
          opening += j.opening;
          slip += std::fabs(j.slip);
          crushing += j.crushed;
        }
        const std::string name = r.is_base ? of + r.name : r.name;  // parts bear their wall's name
        features.push_back({name + "_opening", snapshot.displacement, opening});
        features.push_back({name + "_slip", snapshot.displacement, slip});
        features.push_back({name + "_crushing", snapshot.displacement, crushing});
      }
    }
  }
  return features;
}

}  // namespace wythe
