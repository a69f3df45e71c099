#include "io/vtu.h"

#include <fmt/core.h>
#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>

#include "core/text.h"
#include "wythe/reading.h"

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

void add(std::vector<double>& list, const Vec3& v) { list.insert(list.end(), {v.x, v.y, v.z}); }

// Points and cells while they are collected.
struct Mesh {
  std::vector<double> points;  // x, y, z of each point [m]
  std::vector<std::int64_t> offsets;
  std::uint8_t cell_type = kVtkPolygon;

  void add_point(const Vec3& p) { add(points, p); }
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

void add_row(JointColumns& columns, const JointReading& joint, JointId id) {
  columns.opening.push_back(joint.opening * 1e3);
  columns.slip.push_back(joint.slip * 1e3);
  columns.damage.push_back(joint.damage);
  columns.damage_tension.push_back(joint.damage_tension);
  columns.damage_shear.push_back(joint.damage_shear);
  columns.normal.push_back(joint.normal_stress * 1e-6);
  columns.shear.push_back(joint.shear_stress * 1e-6);
  columns.crushing.push_back(joint.crushing);
  columns.kind.push_back(static_cast<std::int32_t>(joint.shape.kind));
  columns.joint.push_back(id);
}

}  // namespace

std::string blocks_vtu(const Model& model, const State& state) {
  Mesh mesh;
  std::vector<double> displacement, rotation;
  std::vector<std::int32_t> role, course, block;
  for (BlockId b = 0; b < model.n_block; ++b) {
    const BlockReading now = read_block(model, state, b);
    for (const Vec3& p : outline_now(model, state, b)) mesh.add_point(p);
    mesh.close_cell();
    add(displacement, 1e3 * now.moved);
    rotation.push_back(1e3 * now.turned.by.z);
    role.push_back(static_cast<std::int32_t>(now.role));
    course.push_back(model.anatomy.block_course[b]);
    block.push_back(b);
  }
  return mesh_vtu(mesh, state,
                  data_array("displacement_mm", displacement, 3) +
                      data_array("rotation_mrad", rotation) + data_array("role", role) +
                      data_array("course", course) + data_array("block", block));
}

std::string joints_vtu(const Model& model, const State& state) {
  Mesh mesh;
  mesh.cell_type = kVtkLine;
  JointColumns columns;
  for (const JointReading& joint : read_wall(model, state).joints) {
    for (const Vec3& p : ends_now(model, state, joint.shape.id)) mesh.add_point(p);
    mesh.close_cell();
    add_row(columns, joint, joint.shape.id < model.n_joint ? joint.shape.id : -1);
  }
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
  const std::vector<ZoneReading> zones = read_zones(model, state);
  for (std::size_t b = 0; b < model.solids.bodies.size(); ++b)
    for (int z = 0; z < model.solids.bodies[b].n_zone; ++z) {
      const int at = model.solids.bodies[b].first_zone + z;
      const ZoneReading& now = zones[at];
      for (int k = 0; k < now.corners; ++k) mesh.add_point(now.corner[k]);
      mesh.close_cell();
      add(displacement, 1e3 * now.moved);
      const auto [greatest, least] = principal_stresses(now);
      x.push_back(now.sigma_x * 1e-6);
      y.push_back(now.sigma_y * 1e-6);
      xy.push_back(now.tau * 1e-6);
      first.push_back(greatest * 1e-6);
      second.push_back(least * 1e-6);
      body.push_back(static_cast<std::int32_t>(b));
      zone.push_back(at);
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
