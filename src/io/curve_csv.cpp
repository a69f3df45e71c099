#include "io/curve_csv.h"

#include <fmt/format.h>

namespace wythe::io {

std::string curve_csv(const std::vector<CurveRow>& curve, bool has_lintel) {
  const std::vector<CurveColumn> columns = columns_shown(has_lintel);
  std::string text;
  for (const CurveColumn& column : columns)
    text += (text.empty() ? "" : ",") + std::string(column.name);
  // ten digits: far below any error of the method, and 0.3 mm reads 0.3
  for (const CurveRow& row : curve)
    for (const CurveColumn& column : columns)
      text += fmt::format("{}{:.10g}", &column == columns.data() ? '\n' : ',',
                          row.*column.value * column.to_unit);
  return text + '\n';
}

}  // namespace wythe::io
