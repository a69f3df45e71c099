// A wall, a curve and a campaign that tests of the assessment share.
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "wythe/parts/assessment.h"
#include "wythe/parts/io.h"
#include "wythe/parts/statistics.h"

namespace wythe::test {

// Linear to the force `peak` at `yield`, flat to `fall`, then linear to zero at twice that displacement.
struct Made {
  double peak = 20e3, yield = 2e-3, fall = 20e-3, until = 40e-3, height = 5;
};
inline std::vector<CurveRow> curve_of(const Made& m) {
  std::vector<CurveRow> curve;
  for (int i = 0; i <= 4000; ++i) {
    CurveRow row;
    row.displacement = m.until * i / 4000;
    row.drift = row.displacement / m.height;
    const double up = std::fmin(1, row.displacement / m.yield);
    const double down = std::fmax(0, 1 - (row.displacement - m.fall) / m.fall);
    row.reaction = row.base_shear = m.peak * std::fmin(up, std::fmin(1, down));
    curve.push_back(row);
  }
  return curve;
}

inline bool says(const Message& message, const std::string& part) {
  return text_of(message).find(part) != std::string::npos;
}

inline std::string wall_text(const std::string& more, const std::string& x = "0 m",
                             const std::string& direction = "+x") {
  return R"([wall]
length = "1.0 m"
height = "1.0 m"
thickness = "0.2 m"
unit = { length = "500 mm", height = "250 mm", split = "none", density = "2000 kg/m^3" }
[material.joint]
normal_stiffness = "20 GPa/m"
shear_stiffness = "8 GPa/m"
tensile_strength = "0 MPa"
cohesion = "0 MPa"
residual_cohesion = "0 MPa"
friction_angle = "30 deg"
residual_friction_angle = "30 deg"
compressive_strength = "unlimited"
[[stage]]
name = "gravity"
[[stage]]
name = "floor"
pressure = "0.0981 MPa"
[[stage]]
name = "push"
at = { x = ")" +
         x + R"(", y = "0.9 m" }
direction = ")" +
         direction + R"("
velocity = "20 mm/s"
until = "12 mm"
)" + more;
}
inline constexpr const char* kAssessed = R"([project]
title = "School"
[assessment]
code = "en1998_3"
limit_state = "near_collapse"
added_mass = "300 kg"
added_height = "0.875 m"
[assessment.spectrum]
kind = "en1998"
ground_acceleration = "1 m/s^2"
ground = "B"
)";

// Samples like this curve, with peaks from 10 to 30 kN.
inline Campaign campaign_of(int n, double until = 40e-3) {
  Campaign campaign;
  for (int i = 0; i < n; ++i) {
    const Made made{.peak = 10e3 + 20e3 * i / (n - 1), .until = until, .height = 0.875};
    SampleRecord& record = campaign.records.emplace_back();
    record.sample = i + 1, record.status = "completed";
    record.curve = curve_of(made);
    record.responses = read_responses(record.curve);
    record.quasi_static.judgement = "slow enough";
  }
  return campaign;
}

}  // namespace wythe::test
