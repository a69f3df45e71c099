// Writes the tables of a run with at most ten digits. Links, frames and layers are flat lists with n entries for each
// row of the curve. Callers use such a table only where n > 0, because with n = 0 the loop over rows would not end.
#include "io/results/curve_csv.h"

#include <fmt/format.h>

#include "io/text/csv.h"
#include "model/shaking.h"
#include "wythe/parts/reading.h"

namespace wythe::io {

std::string curve_csv(const std::vector<CurveRow>& curve, ShownColumns of) {
  const std::vector<CurveColumn> columns = columns_shown(of);
  std::string text;
  for (const CurveColumn& column : columns)
    text += (text.empty() ? "" : ",") + std::string(column.name);
  // ten digits: far more exact than the method, and 0.3 mm reads 0.3
  for (const CurveRow& row : curve)
    for (const CurveColumn& column : columns)
      text += fmt::format("{}{:.10g}", &column == columns.data() ? '\n' : ',',
                          row.*column.value * column.to_unit);
  return text + '\n';
}

std::string history_csv(const ShakeHistory& history, int axes) {
  const bool in_space = axes == 3;
  const char* const names[] = {"x", "y", "z"};
  const char* const acceleration[] = {"base_acceleration_x_m_per_s2",
                                      "base_acceleration_y_m_per_s2",
                                      "base_acceleration_z_m_per_s2"};
  const char* const displacement[] = {"base_displacement_x_mm", "base_displacement_y_mm",
                                      "base_displacement_z_mm"};
  std::string text = "time_s";
  const auto head = [&](const std::string& name) { text += ',' + csv_cell(name); };
  for (int k = 0; k < axes; ++k) head(acceleration[k]);
  for (int k = 0; k < axes; ++k) head(displacement[k]);
  head("base_shear_x_kN"), head("base_vertical_kN");
  if (in_space) head("base_shear_z_kN");
  for (const char* name : {"drift_percent", "largest_opening_mm", "largest_slip_mm", "kinetic_J"})
    head(name);
  for (const std::string& point : history.point)
    for (int k = 0; k < axes; ++k) head(fmt::format("{}_u{}_mm", point, names[k]));
  for (const std::string& storey : history.storey) {
    head(fmt::format("{}_drift_x_percent", storey));
    if (in_space) head(fmt::format("{}_drift_z_percent", storey));
  }
  for (std::size_t r = 0; r < history.row.size(); ++r) {
    const ShakeRow& row = history.row[r];
    text += fmt::format("\n{:.10g}", row.time);
    const auto put = [&](double value, double to_unit) {
      text += fmt::format(",{:.10g}", value * to_unit);
    };
    const auto each = [&](const std::array<double, 3>& values, double to_unit) {
      for (int k = 0; k < axes; ++k) put(values[k], to_unit);
    };
    each(row.base_acceleration, 1);
    each(row.base_displacement, 1e3);
    each(row.base_force, 1e-3);
    put(row.drift, 1e2), put(row.opening, 1e3), put(row.slip, 1e3), put(row.kinetic, 1);
    for (std::size_t p = 0; p < history.point.size(); ++p)
      each(history.motion[r * history.point.size() + p], 1e3);
    for (std::size_t k = 0; k < history.storey.size(); ++k) {
      const auto [x, z] = storey_drift(history, r, k);
      put(x, 1e2);
      if (in_space) put(z, 1e2);
    }
  }
  return text + '\n';
}

std::string links_csv(const std::vector<std::string>& names, const Result& result) {
  std::string text = "displacement_mm";
  for (const std::string& name : names)
    text += ',' + csv_cell(name + " force_kN") + ',' + csv_cell(name + " elongation_mm");
  for (std::size_t row = 0; (row + 1) * names.size() <= result.strengthening.links.size(); ++row) {
    text += fmt::format("\n{:.10g}", 1e3 * result.curve[row].displacement);
    for (std::size_t k = 0; k < names.size(); ++k) {
      const LinkRow& link = result.strengthening.links[row * names.size() + k];
      text += fmt::format(",{:.10g},{:.10g}", 1e-3 * link.force, 1e3 * link.elongation);
    }
  }
  return text + '\n';
}

std::string frames_csv(const Model& model, const Result& result) {
  const Frames& f = model.frames;
  const std::size_t n = f.a.size();
  std::string text = "displacement_mm,frame,member,place_m,N_kN,V_kN,M_kNm,use";
  for (std::size_t row = 0; (row + 1) * n <= result.strengthening.frame_rows.size(); ++row)
    for (std::size_t k = 0; k < n; ++k) {
      const FrameMember& member = f.members[f.member[k]];
      const FrameRow& now = result.strengthening.frame_rows[row * n + k];
      text += fmt::format("\n{:.10g},{},{},{:.6g},{:.7g},{:.7g},{:.7g},{:.5g}",
                          1e3 * result.curve[row].displacement, csv_cell(f.name[member.frame]),
                          csv_cell(text_of(member.words)), f.place[k], 1e-3 * now.normal,
                          1e-3 * now.shear, 1e-3 * now.moment,
                          section_use(member, now.normal, now.shear, now.moment));
    }
  return text + '\n';
}

std::string layers_csv(const Model& model, const Result& result) {
  const std::size_t n = model.layers.name.size();
  std::string text = "displacement_mm,layer,use,x_m,y_m,detached_percent,broken_percent";
  for (std::size_t row = 0; (row + 1) * n <= result.strengthening.layer_rows.size(); ++row)
    for (std::size_t k = 0; k < n; ++k) {
      const LayerRow& now = result.strengthening.layer_rows[row * n + k];
      text += fmt::format("\n{:.10g},{},{:.5g},{:.6g},{:.6g},{:.5g},{:.5g}",
                          1e3 * result.curve[row].displacement, csv_cell(model.layers.name[k]),
                          now.use, now.x, now.y, 100 * now.detached, 100 * now.broken);
    }
  return text + '\n';
}

}  // namespace wythe::io
