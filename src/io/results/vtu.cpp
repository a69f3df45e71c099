// Collects points and cells of a state and writes them as one unstructured grid; no two cells share a point. In space a
// block has one polyhedron for each convex part, all with the block's values; joints are polygons and zones hexahedra.
// Blocks that do not stand are kept, with 0 in the array `stands`. vtu_arrays() reads back only arrays of doubles.
#include "io/results/vtu.h"

#include <fmt/core.h>
#include <fmt/format.h>

#include <bit>
#include <cstdint>
#include <cstring>

#include "core/text.h"
#include "io/results/element_columns.h"
#include "wythe/parts/error.h"
#include "wythe/parts/reading.h"

namespace wythe::io {
namespace {

static_assert(std::endian::native == std::endian::little, "byte_order below says little endian");

constexpr std::uint8_t kVtkLine = 3;
constexpr std::uint8_t kVtkPolygon = 7;
constexpr std::uint8_t kVtkHexahedron = 12;
constexpr std::uint8_t kVtkPolyhedron = 42;

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

// Points and cells being collected.
struct Mesh {
  std::vector<double> points;  // x, y, z of each point [m]
  std::vector<std::int64_t> offsets;
  std::uint8_t cell_type = kVtkPolygon;

  void add_point(const Vec3& p) { add(points, p); }
  // of polyhedra: each cell's count of faces, then of each face its count and its points
  std::vector<std::int64_t> faces, face_offsets;

  void add_solid(const Polyhedron& part) {
    const auto first = static_cast<std::int64_t>(points.size() / 3);
    for (const Vec3& p : part.vertex) add_point(p);
    faces.push_back(static_cast<std::int64_t>(part.face.size()));
    for (const std::vector<std::int32_t>& corners : part.face) {
      faces.push_back(static_cast<std::int64_t>(corners.size()));
      for (const std::int32_t corner : corners) faces.push_back(first + corner);
    }
    face_offsets.push_back(static_cast<std::int64_t>(faces.size()));
    close_cell();
  }
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
          data_array("types", types);
  if (!mesh.faces.empty())
    text += data_array("faces", mesh.faces) + data_array("faceoffsets", mesh.face_offsets);
  text += "</Cells>\n<CellData>\n" + cell_data;
  return text + "</CellData>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
}

// The arrays of a table of columns, one value for each element.
template <class Reading, std::size_t n>
std::string arrays_of(const ElementColumn<Reading> (&columns)[n],
                      const std::vector<Reading>& elements) {
  std::string text;
  for (const ElementColumn<Reading>& column : columns) {
    std::vector<double> values;
    values.reserve(elements.size());
    for (const Reading& element : elements) values.push_back(column.shown(element));
    text += data_array(column.name, values);
  }
  return text;
}

[[noreturn]] void refuse_vtu(const std::string& file, const std::string& what) {
  throw IoError(fmt::format("{}: is damaged, or no file of wythe run: {}", file, what));
}

// The bytes of one array after its count.
std::vector<double> doubles_of(std::string_view packed, const std::string& file,
                               std::string_view name) {
  const std::string bytes = bytes_of_base64(packed);
  std::uint64_t size = 0;
  if (bytes.size() >= sizeof size) std::memcpy(&size, bytes.data(), sizeof size);
  if (bytes.size() < sizeof size || size != bytes.size() - sizeof size ||
      size % sizeof(double) != 0)
    refuse_vtu(file, fmt::format("array {} is not whole", name));
  std::vector<double> values(size / sizeof(double));
  if (size > 0) std::memcpy(values.data(), bytes.data() + sizeof size, size);
  return values;
}

}  // namespace

std::string blocks_vtu(const Model& model, const State& state) {
  Mesh mesh;
  const bool in_space = dimension_of(model) == 3;
  if (in_space) mesh.cell_type = kVtkPolyhedron;
  std::vector<double> displacement;
  std::vector<BlockReading> blocks;
  std::vector<std::int32_t> role, course, block,
      stands;  // 0 for a block that is cut out or not put up yet
  for (BlockId b = 0; b < model.n_block; ++b) {
    const BlockReading now = read_block(model, state, b);
    std::size_t cells = 1;
    if (in_space) {
      const std::vector<Polyhedron> parts = solid_now(model, state, b);
      for (const Polyhedron& part : parts) mesh.add_solid(part);
      cells = parts.size();
    } else {
      for (const Vec3& p : outline_now(model, state, b)) mesh.add_point(p);
      mesh.close_cell();
    }
    for (; cells > 0; --cells) {
      add(displacement, 1e3 * now.moved);
      blocks.push_back(now);
      role.push_back(static_cast<std::int32_t>(now.role));
      course.push_back(model.anatomy.block_course[b]);
      block.push_back(b);
      stands.push_back(model.standing.holds(b, state.stage) ? 1 : 0);
    }
  }
  return mesh_vtu(
      mesh, state,
      data_array("displacement_mm", displacement, 3) +
          (in_space ? arrays_of(kSpaceBlockColumns, blocks) : arrays_of(kBlockColumns, blocks)) +
          data_array("role", role) + data_array("course", course) + data_array("block", block) +
          (model.standing.any() ? data_array("stands", stands) : std::string()));
}

std::string joints_vtu(const Model& model, const State& state) {
  Mesh mesh;
  mesh.cell_type = dimension_of(model) == 3 ? kVtkPolygon : kVtkLine;
  std::vector<std::int32_t> kind, id;
  std::vector<JointReading> joints = read_wall(model, state).joints;
  std::erase_if(
      joints, [&](const JointReading& joint) {  // joints that do not stand stay, without stress
        return joint.handed_over && model.standing.joins(joint.shape.a, joint.shape.b, state.stage);
      });
  for (const JointReading& joint : joints) {
    for (const Vec3& p : face_now(model, state, joint.shape.id)) mesh.add_point(p);
    mesh.close_cell();
    kind.push_back(static_cast<std::int32_t>(joint.shape.kind));
    id.push_back(joint.shape.id < model.n_joint ? joint.shape.id : -1);
  }
  return mesh_vtu(
      mesh, state,
      arrays_of(kJointColumns, joints) + data_array("kind", kind) + data_array("joint", id));
}

namespace {

std::string space_zones_vtu(const Model& model, const State& state) {
  Mesh mesh;
  mesh.cell_type = kVtkHexahedron;
  std::vector<double> displacement;
  std::vector<std::int32_t> body, zone;
  const std::vector<SpaceZoneReading> zones = read_space_zones(model, state);
  const std::vector<SpaceSolidBody>& bodies = model.space.solids.bodies;
  for (std::size_t b = 0; b < bodies.size(); ++b)
    for (int z = bodies[b].first_zone; z < bodies[b].first_zone + bodies[b].n_zone; ++z) {
      const SpaceZoneReading& now = zones[z];
      for (const Vec3& corner : now.corner) mesh.add_point(corner);
      mesh.close_cell();
      add(displacement, 1e3 * now.moved);
      body.push_back(static_cast<std::int32_t>(b));
      zone.push_back(z);
    }
  return mesh_vtu(mesh, state,
                  data_array("displacement_mm", displacement, 3) +
                      arrays_of(kSpaceZoneColumns, zones) + data_array("body", body) +
                      data_array("zone", zone));
}

}  // namespace

std::string zones_vtu(const Model& model, const State& state) {
  if (!model.space.solids.bodies.empty()) return space_zones_vtu(model, state);
  Mesh mesh;
  std::vector<double> displacement;
  std::vector<std::int32_t> body, zone;
  std::vector<ZoneReading> listed;
  const std::vector<ZoneReading> zones = read_zones(model, state);
  for (std::size_t b = 0; b < model.solids.bodies.size(); ++b)
    for (int z = 0; z < model.solids.bodies[b].n_zone; ++z) {
      const int at = model.solids.bodies[b].first_zone + z;
      const ZoneReading& now = zones[at];
      for (int k = 0; k < now.corners; ++k) mesh.add_point(now.corner[k]);
      mesh.close_cell();
      add(displacement, 1e3 * now.moved);
      listed.push_back(now);
      body.push_back(static_cast<std::int32_t>(b));
      zone.push_back(at);
    }
  return mesh_vtu(mesh, state,
                  data_array("displacement_mm", displacement, 3) + arrays_of(kZoneColumns, listed) +
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

std::map<std::string, std::vector<double>, std::less<>> vtu_arrays(const std::string& text,
                                                                   const std::string& file) {
  constexpr std::string_view kBegin = "<DataArray type=\"Float64\" Name=\"",
                             kBinary = "format=\"binary\">", kEnd = "</DataArray>";
  std::map<std::string, std::vector<double>, std::less<>> arrays;
  for (std::size_t at = text.find(kBegin); at != std::string::npos; at = text.find(kBegin, at)) {
    at += kBegin.size();
    const std::size_t quote = text.find('"', at), head = text.find('>', at);
    const std::size_t end = text.find(kEnd, at);
    if (quote > head || head > end || end == std::string::npos)
      refuse_vtu(file, "it breaks off in an array");
    const std::string_view name = std::string_view(text).substr(at, quote - at);
    if (std::string_view(text).substr(at, head + 1 - at).ends_with(kBinary))
      arrays[std::string(name)] =
          doubles_of(std::string_view(text).substr(head + 1, end - head - 1), file, name);
    at = end;
  }
  if (!text.ends_with("</VTKFile>\n")) refuse_vtu(file, "its end is missing");
  return arrays;
}

}  // namespace wythe::io
