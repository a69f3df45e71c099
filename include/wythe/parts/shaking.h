// Results of a shake: rows over time, and values derived from them (docs/reference/results.md, "Shakes").
#pragma once

#include <array>
#include <string>
#include <vector>

#include "wythe/parts/message.h"

namespace wythe {

// Displacement of a point against the base in one row, in the axes of the wall [m].
using PointMotion = std::array<double, 3>;

struct ShakeRow {
  double time = 0;                               // since the start of the first shake [s]
  std::array<double, 3> base_acceleration = {};  // [m/s^2], at the row
  std::array<double, 3> base_displacement = {};  // [m]
  std::array<double, 3> base_force =
      {};              // wall on ground, compression + upwards: mean since the last row [N]
  double drift = 0;    // horizontal displacement of the first point over its height [-]
  double opening = 0;  // largest of any joint [m]
  double slip = 0;     // largest accumulated plastic slip of any joint [m]
  double kinetic = 0;  // relative to the base [J]
  bool operator==(const ShakeRow&) const = default;
};

struct ShakeHistory {
  std::vector<std::string> point;  // names
  std::vector<ShakeRow> row;
  std::vector<PointMotion> motion;  // (rows, points)
  // Storeys from the ground up, where the wall has them: heights, and displacement of each top, the mean
  // of its blocks weighted by mass.
  std::vector<std::string> storey;
  std::vector<double> storey_height;    // [m]
  std::vector<PointMotion> storey_top;  // (rows, storeys)
};

// One component of the record as applied.
struct AppliedRecord {
  std::string source, hash;
  std::array<double, 3> along = {};
  bool of_base = true;
  double factor = 1;
  double peak_acceleration = 0, peak_velocity = 0, arias = 0;  // [m/s^2], [m/s], [m/s]
  double duration = 0;                                         // [s]
  double final_velocity = 0, final_displacement = 0;           // errors of the baseline [m/s], [m]
};

struct PeakMotion {
  std::string point;
  double peak = 0, at = 0;  // largest horizontal displacement against the base [m], its time [s]
  double residual = 0;      // mean of the last tenth of the rows [m]
};

// Drift of a storey: horizontal displacement of its top against its foot, over its height.
struct StoreyDrift {
  std::string storey;
  double peak = 0, at = 0;  // [-], its time [s]
  double residual = 0;      // of the mean of the last tenth of the rows [-]
};

struct ShakeReadings {
  bool was_shaken = false;
  std::vector<AppliedRecord> record;
  std::vector<PeakMotion> motion;
  double peak_drift = 0, residual_drift = 0;     // of the first point [-]
  std::vector<StoreyDrift> storey;               // from the ground up
  double peak_base_shear = 0;                    // horizontal [N]
  double largest_opening = 0, largest_slip = 0;  // [m]
  bool collapsed = false;
  double collapse_time = 0;  // since the start of the first shake [s]
};

}  // namespace wythe
