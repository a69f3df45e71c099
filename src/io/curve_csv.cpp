#include "io/curve_csv.h"

#include <fmt/format.h>

namespace wythe::io {

std::string curve_csv(const std::vector<CurveRow>& curve, bool has_lintel) {
  std::string text =
      "time_s,displacement_mm,drift_percent,reaction_kN,base_shear_kN,unbalance_ratio,"
      "kinetic_ratio,work_drive_J,work_damping_J";
  text += has_lintel ? ",lintel_deflection_mm,lintel_end_rotation_mrad,lintel_axial_kN\n" : "\n";
  // ten digits: far below any error of the method, and 0.3 mm reads 0.3
  for (const CurveRow& row : curve) {
    text += fmt::format("{:.10g},{:.10g},{:.10g},{:.10g},{:.10g},{:.6g},{:.6g},{:.10g},{:.10g}",
                        row.time, row.displacement * 1e3, row.drift * 1e2, row.reaction * 1e-3,
                        row.base_shear * 1e-3, row.unbalance_ratio, row.kinetic_ratio,
                        row.work_drive, row.work_damping);
    if (has_lintel)
      text += fmt::format(",{:.10g},{:.10g},{:.10g}", row.lintel_deflection * 1e3,
                          row.lintel_end_rotation * 1e3, row.lintel_axial * 1e-3);
    text += '\n';
  }
  return text;
}

}  // namespace wythe::io
