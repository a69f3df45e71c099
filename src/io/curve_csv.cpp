#include "io/curve_csv.h"

#include <fmt/format.h>

namespace wythe::io {

std::string curve_csv(const std::vector<CurveRow>& curve) {
  std::string text =
      "time_s,displacement_mm,drift_percent,reaction_kN,base_shear_kN,unbalance_ratio,"
      "kinetic_ratio\n";
  // ten digits: far below any error of the method, and 0.3 mm reads 0.3
  for (const CurveRow& row : curve) {
    text += fmt::format("{:.10g},{:.10g},{:.10g},{:.10g},{:.10g},{:.6g},{:.6g}\n", row.time,
                        row.displacement * 1e3, row.drift * 1e2, row.reaction * 1e-3,
                        row.base_shear * 1e-3, row.unbalance_ratio, row.kinetic_ratio);
  }
  return text;
}

}  // namespace wythe::io
