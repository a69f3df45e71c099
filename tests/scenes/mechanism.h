// A wall that a test moves as rigid bodies, for the tests of failure modes.
//
// Every block moves with the body that contains its centroid. The
// joints' largest openings and their slips are those of the motion.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "wythe/parts/model.h"
#include "wythe/parts/reading.h"
#include "wythe/parts/result.h"

namespace wythe::scenes {

struct Motion {
  double pivot_x = 0, pivot_y = 0;  // [m]
  double turn = 0;                  // anticlockwise [rad]
  double move_x = 0, move_y = 0;    // [m]
};
using Mechanism = std::function<Motion(double x, double y)>;

[[nodiscard]] inline Mechanism mirrored(const Mechanism& mechanism, double length) {
  return [=](double x, double y) {
    Motion m = mechanism(length - x, y);
    m.pivot_x = length - m.pivot_x;
    m.turn = -m.turn;
    m.move_x = -m.move_x;
    return m;
  };
}

[[nodiscard]] inline State moved(const Model& model, const Mechanism& mechanism) {
  State state = initial_state(model);
  for (std::size_t b = 0; b < static_cast<std::size_t>(model.n_block); ++b) {
    const double x = model.centroid_x[b], y = model.centroid_y[b];
    const Motion m = mechanism(x, y);
    const double c = std::cos(m.turn), s = std::sin(m.turn);
    const double arm_x = x - m.pivot_x, arm_y = y - m.pivot_y;
    state.ux[b] = m.move_x + c * arm_x - s * arm_y - arm_x;
    state.uy[b] = m.move_y + s * arm_x + c * arm_y - arm_y;
    state.theta[b] = m.turn;
  }
  const std::vector<PointReading> points = read_points(model, state);
  for (std::size_t p = 0; p < points.size(); ++p) {
    state.kappa[p] = std::max(0.0, points[p].opening);
    state.plastic_slip[p] = points[p].slip;
    state.slip[p] = std::fabs(points[p].slip);
  }
  return state;
}

// --- mirrored names of parts

[[nodiscard]] inline std::string swapped_sides(std::string name) {
  const auto left = name.find("left"), right = name.find("right");
  // the later one first, so that the earlier position stays valid
  const auto change = [&](std::size_t at) {
    if (at == std::string::npos) return;
    const bool is_left = name.compare(at, 4, "left") == 0;
    name.replace(at, is_left ? 4 : 5, is_left ? "right" : "left");
  };
  const bool both = left != std::string::npos && right != std::string::npos;
  if (!both) {
    change(left != std::string::npos ? left : right);
    return name;
  }
  change(std::max(left, right));
  change(std::min(left, right));
  return name;
}

// Names of toes and piers contain a side twice: "left toe of the left pier" mirrors to "right ... right".
[[nodiscard]] inline std::string mirror_name(const std::string& name) {
  const auto of = name.find(" of the ");
  if (of == std::string::npos) return swapped_sides(name);
  return swapped_sides(name.substr(0, of)) + " of the " + swapped_sides(name.substr(of + 8));
}

}  // namespace wythe::scenes
