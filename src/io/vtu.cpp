#include "io/vtu.h"

#include <fmt/core.h>
#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>

#include "core/text.h"
#include "dynamics/zone_state.h"
#include "model/deformed.h"

namespace wythe::io {
namespace {

static_assert(std::endian::native == std::endian::little, "byte_order below says little endian");

constexpr std::uint8_t kVtkLine = 3;
constexpr std::uint8_t kVtkPolygon = 7;

template <class T>
constexpr const char* vtk_type();
template <>
constexpr const char* vtk_type<double>() {
  return "Float64";
}
template <>
constexpr const char* vtk_type<std::int64_t>() {
  return "Int64";
}
template <>
constexpr const char* vtk_type<std::int32_t>() {
  return "Int32";
}
template <>
constexpr const char* vtk_type<std::uint8_t>() {
  return "UInt8";
}

// VTK's inline binary: the byte count (UInt64), then the values, as one base64 text.
template <class T>
std::string data_array(const char* name, const std::vector<T>& values, int components = 1) {
  const std::uint64_t size = values.size() * sizeof(T);
  std::vector<std::uint8_t> bytes(sizeof size + size);
  std::memcpy(bytes.data(), &size, sizeof size);
  if (size > 0) std::memcpy(bytes.data() + sizeof size, values.data(), size);
  return fmt::format(
      "<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"binary\">{}"
      "</DataArray>\n",
      vtk_type<T>(), name, components, base64(bytes));
}

// Points and cells while they are collected.
struct Mesh {
  std::vector<double> points;  // x, y, 0 of each point [m]
  std::vector<std::int64_t> offsets;
  std::uint8_t cell_type = kVtkPolygon;

  void add_point(const PlacedPoint& p) { points.insert(points.end(), {p.x, p.y, 0.0}); }
  void close_cell() { offsets.push_back(static_cast<std::int64_t>(points.size() / 3)); }
};

std::string mesh_vtu(const Mesh& mesh, const State& state, const std::string& cell_data) {
  const std::size_t n_point = mesh.points.size() / 3;
  std::vector<std::int64_t> connectivity(n_point);
  for (std::size_t i = 0; i < n_point; ++i) connectivity[i] = static_cast<std::int64_t>(i);
  const std::vector<std::uint8_t> types(mesh.offsets.size(), mesh.cell_type);
  std::string text =
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" "
      "byte_order=\"LittleEndian\" header_type=\"UInt64\">\n<UnstructuredGrid>\n<FieldData>\n";
  text += fmt::format(
      "<DataArray type=\"Float64\" Name=\"TimeValue\" NumberOfTuples=\"1\" format=\"ascii\">{}"
      "</DataArray>\n</FieldData>\n",
      state.time);
  text += fmt::format("<Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n", n_point,
                      mesh.offsets.size());
  text += "<Points>\n" + data_array("Points", mesh.points, 3) + "</Points>\n<Cells>\n";
  text += data_array("connectivity", connectivity) + data_array("offsets", mesh.offsets) +
          data_array("types", types) + "</Cells>\n<CellData>\n" + cell_data;
  return text + "</CellData>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
}

// The cell arrays of the joints, one value a joint.
struct JointColumns {
  std::vector<double> opening, slip, damage, damage_tension, damage_shear, normal, shear, crushing;
  std::vector<std::int32_t> kind, joint;
};

// The points of one joint or contact, with their shares of its area.
struct PointRange {
  const PointStress* first;
  const double* weight;
  int count;
};

// Reduces them to a row (see vtu.h for the rule of each column).
void add_row(JointColumns& columns, const PointRange& points, JointKind kind, JointId joint) {
  PointStress row;
  row.opening = -HUGE_VAL;
  for (int k = 0; k < points.count; ++k) {
    const PointStress& point = points.first[k];
    row.opening = std::fmax(row.opening, point.opening);
    if (std::abs(point.slip) > std::abs(row.slip)) row.slip = point.slip;
    row.damage = std::fmax(row.damage, point.damage);
    row.damage_tension = std::fmax(row.damage_tension, point.damage_tension);
    row.damage_shear = std::fmax(row.damage_shear, point.damage_shear);
    row.crushing = std::fmax(row.crushing, point.crushing);
    row.normal_stress += points.weight[k] * point.normal_stress;
    row.shear_stress += points.weight[k] * point.shear_stress;
  }
  columns.opening.push_back(row.opening * 1e3);
  columns.slip.push_back(row.slip * 1e3);
  columns.damage.push_back(row.damage);
  columns.damage_tension.push_back(row.damage_tension);
  columns.damage_shear.push_back(row.damage_shear);
  columns.normal.push_back(row.normal_stress * 1e-6);
  columns.shear.push_back(row.shear_stress * 1e-6);
  columns.crushing.push_back(row.crushing);
  columns.kind.push_back(static_cast<std::int32_t>(kind));
  columns.joint.push_back(joint);
}

// Lines and rows of the zone contacts.
void add_contacts(const Model& model, const State& state, Mesh& mesh, JointColumns& columns) {
  static constexpr double kHalf[2] = {0.5, 0.5};
  const std::vector<PointStress> points = dynamics::contact_stresses(model, state);
  for (std::size_t c = 0; 2 * c < points.size(); ++c) {
    for (std::size_t k = 0; k < 2; ++k) mesh.add_point({points[2 * c + k].x, points[2 * c + k].y});
    mesh.close_cell();
    add_row(columns, {&points[2 * c], kHalf, 2}, JointKind::kLintelBond, -1);
  }
}

}  // namespace

std::string blocks_vtu(const Model& model, const State& state) {
  Mesh mesh;
  std::vector<double> displacement, rotation;
  std::vector<std::int32_t> role, course, block;
  for (BlockId b = 0; b < model.n_block; ++b) {
    for (const PlacedPoint& p : placed_outline(model, state, b)) mesh.add_point(p);
    mesh.close_cell();
    displacement.insert(displacement.end(), {state.ux[b] * 1e3, state.uy[b] * 1e3, 0.0});
    rotation.push_back(state.theta[b] * 1e3);
    role.push_back(static_cast<std::int32_t>(model.anatomy.block_role[b]));
    course.push_back(model.anatomy.block_course[b]);
    block.push_back(b);
  }
  return mesh_vtu(mesh, state,
                  data_array("displacement_mm", displacement, 3) +
                      data_array("rotation_mrad", rotation) + data_array("role", role) +
                      data_array("course", course) + data_array("block", block));
}

std::string joints_vtu(const Model& model, const State& state,
                       const std::vector<PointStress>& points) {
  Mesh mesh;
  mesh.cell_type = kVtkLine;
  JointColumns columns;
  for (JointId j = 0; j < model.n_joint; ++j) {
    for (const PlacedPoint& p : placed_joint(model, state, j)) mesh.add_point(p);
    mesh.close_cell();
    add_row(columns,
            {&points[j * model.n_face_point], model.point_weight.data(), model.n_face_point},
            model.anatomy.joint_kind[j], j);
  }
  add_contacts(model, state, mesh, columns);
  return mesh_vtu(mesh, state,
                  data_array("opening_mm", columns.opening) + data_array("slip_mm", columns.slip) +
                      data_array("damage", columns.damage) +
                      data_array("damage_tension", columns.damage_tension) +
                      data_array("damage_shear", columns.damage_shear) +
                      data_array("normal_stress_MPa", columns.normal) +
                      data_array("shear_stress_MPa", columns.shear) +
                      data_array("crushing", columns.crushing) + data_array("kind", columns.kind) +
                      data_array("joint", columns.joint));
}

std::string zones_vtu(const Model& model, const State& state) {
  Mesh mesh;
  std::vector<double> displacement, x, y, xy, first, second;
  std::vector<std::int32_t> body, zone;
  const std::vector<ZoneStress> stresses = zone_stresses(model, state);
  for (std::size_t b = 0; b < model.solids.bodies.size(); ++b)
    for (int z = 0; z < model.solids.bodies[b].n_zone; ++z) {
      const auto at = static_cast<std::size_t>(model.solids.bodies[b].first_zone + z);
      const ZoneStress& now = stresses[at];
      const bool triangle = model.solids.corner[2][at] == model.solids.corner[3][at];
      double moved_x = 0, moved_y = 0;
      for (std::size_t k = 0; k < (triangle ? 3 : 4); ++k) {
        const auto node = static_cast<std::size_t>(model.solids.corner[k][at]);
        mesh.add_point({now.x[k], now.y[k]});
        moved_x += state.node_ux[node] / (triangle ? 3 : 4);
        moved_y += state.node_uy[node] / (triangle ? 3 : 4);
      }
      mesh.close_cell();
      displacement.insert(displacement.end(), {moved_x * 1e3, moved_y * 1e3, 0.0});
      const auto [greatest, least] = dynamics::principal_stresses(now);
      x.push_back(now.sigma_x * 1e-6);
      y.push_back(now.sigma_y * 1e-6);
      xy.push_back(now.tau * 1e-6);
      first.push_back(greatest * 1e-6);
      second.push_back(least * 1e-6);
      body.push_back(static_cast<std::int32_t>(b));
      zone.push_back(static_cast<std::int32_t>(at));
    }
  return mesh_vtu(mesh, state,
                  data_array("displacement_mm", displacement, 3) + data_array("stress_x_MPa", x) +
                      data_array("stress_y_MPa", y) + data_array("stress_xy_MPa", xy) +
                      data_array("principal_1_MPa", first) + data_array("principal_2_MPa", second) +
                      data_array("body", body) + data_array("zone", zone));
}

std::string series_pvd(const std::vector<SeriesEntry>& entries) {
  std::string text =
      "<?xml version=\"1.0\"?>\n<!-- timestep: displacement of the push [mm] -->\n"
      "<VTKFile type=\"Collection\" version=\"1.0\" byte_order=\"LittleEndian\">\n<Collection>\n";
  for (const SeriesEntry& entry : entries) {
    text += fmt::format("<DataSet timestep=\"{}\" part=\"{}\" name=\"{}\" file=\"{}\"/>\n",
                        entry.time, entry.part, entry.name, entry.file);
  }
  return text + "</Collection>\n</VTKFile>\n";
}

}  // namespace wythe::io
