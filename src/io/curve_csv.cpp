#include "io/curve_csv.h"

#include <fmt/format.h>

#include "io/csv.h"

namespace wythe::io {

std::string curve_csv(const std::vector<CurveRow>& curve, ShownColumns of) {
  const std::vector<CurveColumn> columns = columns_shown(of);
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

std::string links_csv(const std::vector<std::string>& names, const Result& result) {
  std::string text = "displacement_mm";
  for (const std::string& name : names)
    text += ',' + csv_cell(name + " force_kN") + ',' + csv_cell(name + " elongation_mm");
  for (std::size_t row = 0; (row + 1) * names.size() <= result.links.size(); ++row) {
    text += fmt::format("\n{:.10g}", 1e3 * result.curve[row].displacement);
    for (std::size_t k = 0; k < names.size(); ++k) {
      const LinkRow& link = result.links[row * names.size() + k];
      text += fmt::format(",{:.10g},{:.10g}", 1e-3 * link.force, 1e3 * link.elongation);
    }
  }
  return text + '\n';
}

}  // namespace wythe::io
