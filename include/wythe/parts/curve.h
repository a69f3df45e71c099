// The curve of a push, one row a window, and the names of its columns in every file, store and page.
//
// A column is a member of CurveRow, which the Recorder (src/dynamics/stages/recorder.cpp) fills, and a line of
// kCurveColumns. From there it reaches force_displacement.csv, the store, the page of a run and the
// table of docs/reference/results.md (make docs).
#pragma once

#include <iterator>
#include <string>
#include <string_view>
#include <vector>

namespace wythe {

// Averages over one window [SI].
struct CurveRow {
  double time = 0;
  double displacement = 0;  // starts at 0
  double drift = 0;
  double reaction = 0;    // + resists the push
  double base_shear = 0;  // + resists the push
  double unbalance_ratio = 0;
  double kinetic_ratio = 0;
  double work_drive = 0;
  double work_damping = 0;
  double load_factor = 0;
  double lintel_deflection = 0;
  double lintel_end_rotation = 0;
  double lintel_axial = 0;
  double head_axial = 0;
};

enum class ColumnOf { kAnyWall, kLintelOfZones, kHeldHead };
// Features of a wall that add columns to those of every wall.
struct ShownColumns {
  bool lintel_of_zones = false;
  bool held_head = false;  // a push holds its blocks crosswise: `across = "blocked"`
  bool operator==(const ShownColumns&) const = default;
};

struct CurveColumn {
  double CurveRow::*value;
  const char* name;    // in force_displacement.csv and on the page
  const char* stored;  // in the store, SI
  const char* unit;    // shown
  double to_unit;      // shown = SI * to_unit
  ColumnOf of;
  const char* over;     // which value of its window: mean, end, ...
  const char* meaning;  // for docs/reference/results.md
};

// In the order of the CSV. Other programs rely on the first seven.
// clang-format off
inline constexpr CurveColumn kCurveColumns[] = {
  {&CurveRow::time, "time_s", "time_s", "s", 1, ColumnOf::kAnyWall, "end of window",
   "time since the start of the stage that wrote the row"},
  {&CurveRow::displacement, "displacement_mm", "displacement_m", "mm", 1e3, ColumnOf::kAnyWall, "end of window",
   "push: displacement of the control block, or the prescribed mean of the driven blocks (weighted by the shares of "
   "a pattern), along the push, 0 at its start; body_force, tilt: "
   "largest horizontal displacement of the top blocks"},
  {&CurveRow::drift, "drift_percent", "drift", "%", 1e2, ColumnOf::kAnyWall, "end of window",
   "displacement / height of the control block or mean height of the driven blocks (weighted as they are), at the "
   "start; 0 without a push"},
  {&CurveRow::reaction, "reaction_kN", "reaction_N", "kN", 1e-3, ColumnOf::kAnyWall, "mean over the window's path, all steps",
   "push: −Σ contact forces on the driven blocks along the push; body_force: λ × weight; tilt: tan(tilt) × weight"},
  {&CurveRow::base_shear, "base_shear_kN", "base_shear_N", "kN", 1e-3, ColumnOf::kAnyWall, "the same, every 8th step",
   "Σ forces on the ground along the direction, + resists; push: less what the weights of blocks that are not "
   "driven, and the dead loads on them, bring there; tilt: / cos(tilt)"},
  {&CurveRow::unbalance_ratio, "unbalance_ratio", "unbalance_ratio", "–", 1, ColumnOf::kAnyWall, "mean of every 32nd",
   "Σ (|F_x| + |F_y|) of free blocks / the same of contact forces on both sides of joints"},
  {&CurveRow::kinetic_ratio, "kinetic_ratio", "kinetic_ratio", "–", 1, ColumnOf::kAnyWall, "mean of every 8th",
   "kinetic energy / |work of the drive since the stage began|; large in the first rows"},
  {&CurveRow::work_drive, "work_drive_J", "work_drive_J", "J", 1, ColumnOf::kAnyWall, "end of window",
   "work of the drive since the stage began"},
  {&CurveRow::work_damping, "work_damping_J", "work_damping_J", "J", 1, ColumnOf::kAnyWall, "end of window",
   "work taken by local damping since the stage began"},
  {&CurveRow::load_factor, "load_factor", "load_factor", "–", 1, ColumnOf::kAnyWall, "end of window",
   "body_force: λ, the horizontal force as a share of each block's weight; tilt: tan(tilt); 0 of a push"},
  {&CurveRow::lintel_deflection, "lintel_deflection_mm", "lintel_deflection_m", "mm", 1e3, ColumnOf::kLintelOfZones, "end of window",
   "of the first lintel of zones: sag of mid-span (mean through the depth) below the mean of the two ends"},
  {&CurveRow::lintel_end_rotation, "lintel_end_rotation_mrad", "lintel_end_rotation_rad", "mrad", 1e3, ColumnOf::kLintelOfZones, "end of window",
   "turn of its right end against the left, anticlockwise +"},
  {&CurveRow::lintel_axial, "lintel_axial_kN", "lintel_axial_N", "kN", 1e-3, ColumnOf::kLintelOfZones, "end of window",
   "axial force at its mid-span, tension +"},
  {&CurveRow::head_axial, "head_axial_kN", "head_axial_N", "kN", 1e-3, ColumnOf::kHeldHead, "end of window",
   "N at the head: the force across the push that the pushed blocks press into the joints below them, compression +: "
   "the load on them, and what holding them there adds"},
};
// clang-format on
static_assert(sizeof(CurveRow) == std::size(kCurveColumns) * sizeof(double),
              "every member of a row has its line in kCurveColumns");

// The columns that a wall's curve shows.
[[nodiscard]] inline std::vector<CurveColumn> columns_shown(ShownColumns of) {
  const auto is_shown = [&](const CurveColumn& column) {
    if (column.of == ColumnOf::kLintelOfZones) return of.lintel_of_zones;
    return column.of != ColumnOf::kHeldHead || of.held_head;
  };
  std::vector<CurveColumn> shown;
  for (const CurveColumn& column : kCurveColumns)
    if (is_shown(column)) shown.push_back(column);
  return shown;
}

}  // namespace wythe
