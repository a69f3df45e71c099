// Appends nodes, zones and rim of one body to the arrays of all bodies, and adds the masses of zones to their nodes.
// All zones of a grid share one shape; a triangle has its own and repeats its last corner. join_nodes() follows after all
// contacts. It lists for each node where the step's force array holds its forces.
#include "solids/mesh.h"

#include <algorithm>
#include <numeric>

namespace wythe::solids {
namespace {

SolidBody& begin_body(Solids& s) {
  SolidBody& body = s.bodies.emplace_back();
  body.first_node = s.n_node;
  body.first_zone = s.n_zone;
  return body;
}

void add_node(double x, double y, Solids& s) {
  s.node_x.push_back(x);
  s.node_y.push_back(y);
  s.node_mass.push_back(0);
  s.node_gravity_mass.push_back(0);
  s.node_free_x.push_back(1);
  s.node_free_y.push_back(1);
  ++s.n_node;
}

// Adds a zone with the last shape.
void add_zone(const std::array<std::int32_t, 4>& corner, Solids& s) {
  const ZoneShape& shape = s.shapes.back();
  for (std::size_t k = 0; k < 4; ++k) {
    s.corner[k].push_back(corner[k]);
    s.node_mass[corner[k]] += shape.share[k] * shape.mass;
    s.node_gravity_mass[corner[k]] += shape.share[k] * shape.mass;
  }
  s.zone_shape.push_back(static_cast<std::int32_t>(s.shapes.size()) - 1);
  ++s.n_zone;
}

void end_body(SolidBody& body, const Solids& s) {
  body.n_node = s.n_node - body.first_node;
  body.n_zone = s.n_zone - body.first_zone;
  const auto from = static_cast<std::ptrdiff_t>(body.first_node);
  const auto [x0, x1] = std::minmax_element(s.node_x.begin() + from, s.node_x.end());
  const auto [y0, y1] = std::minmax_element(s.node_y.begin() + from, s.node_y.end());
  body.x0 = *x0;
  body.x1 = *x1;
  body.y0 = *y0;
  body.y1 = *y1;
}

void set_rim(SolidBody& body) {
  for (int i = 0; i < body.columns; ++i) body.rim.push_back(body.node(i, 0));
  for (int j = 0; j < body.rows; ++j) body.rim.push_back(body.node(body.columns, j));
  for (int i = body.columns; i > 0; --i) body.rim.push_back(body.node(i, body.rows));
  for (int j = body.rows; j > 0; --j) body.rim.push_back(body.node(0, j));
}

// One row for each node: place_of(k) for all k with node_of(k) equal to that node.
template <class NodeOf, class PlaceOf>
void list_by_node(int n_node, int count, const NodeOf& node_of, const PlaceOf& place_of,
                  std::vector<std::int32_t>& begin, std::vector<std::int32_t>& entry) {
  begin.assign(static_cast<std::size_t>(n_node) + 1, 0);
  for (int k = 0; k < count; ++k) ++begin[static_cast<std::size_t>(node_of(k)) + 1];
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  entry.resize(count);
  std::vector<std::int32_t> next(begin.begin(), begin.end() - 1);
  for (int k = 0; k < count; ++k) entry[next[node_of(k)]++] = place_of(k);
}

}  // namespace

SolidBody& add_grid(const Grid& grid, ZoneKind kind, const ZoneMaterial& material, Solids& s) {
  SolidBody& body = begin_body(s);
  body.columns = grid.columns;
  body.rows = grid.rows;
  const auto along = [](double from, double to, int k, int n) {
    return from + static_cast<double>(k) / n * (to - from);
  };
  for (int j = 0; j <= grid.rows; ++j)
    for (int i = 0; i <= grid.columns; ++i)
      add_node(along(grid.x0, grid.x1, i, grid.columns), along(grid.y0, grid.y1, j, grid.rows), s);
  const double w = (grid.x1 - grid.x0) / grid.columns, h = (grid.y1 - grid.y0) / grid.rows;
  s.shapes.push_back(make_shape({{0, w, w, 0}, {0, 0, h, h}}, kind, material));
  for (int j = 0; j < grid.rows; ++j)
    for (int i = 0; i < grid.columns; ++i)
      add_zone({body.node(i, j), body.node(i + 1, j), body.node(i + 1, j + 1), body.node(i, j + 1)},
               s);
  set_rim(body);
  end_body(body, s);
  return body;
}

SolidBody& add_triangles(const Triangles& mesh, const ZoneMaterial& material, Solids& s) {
  SolidBody& body = begin_body(s);
  for (std::size_t i = 0; i < mesh.x.size(); ++i) add_node(mesh.x[i], mesh.y[i], s);
  for (const auto& corner : mesh.corner) {
    Corners at{};
    std::array<std::int32_t, 4> node{};
    for (std::size_t k = 0; k < 4; ++k) {
      const std::size_t local = corner[std::min<std::size_t>(k, 2)];
      node[k] = body.first_node + static_cast<std::int32_t>(local);
      at.x[k] = mesh.x[local];
      at.y[k] = mesh.y[local];
    }
    s.shapes.push_back(make_shape(at, ZoneKind::kCst, material));
    add_zone(node, s);
  }
  for (const std::int32_t node : mesh.rim) body.rim.push_back(body.first_node + node);
  end_body(body, s);
  return body;
}

void join_nodes(Solids& s) {
  const auto at = [](int k, int n) { return static_cast<std::size_t>(k / n); };
  // places where the step writes forces: corners 0 and 1 of all zones, then 2 and 3; p, then q
  const auto zone_place = [&](int k) {
    return 2 * s.n_zone * ((k % 4) & 2) + k / 4 * 4 + k % 2 * 2;
  };
  const auto contact_place = [](int k) { return k / 2 * 4 + k % 2 * 2; };
  list_by_node(
      s.n_node, 4 * s.n_zone, [&](int k) { return s.corner[k % 4][at(k, 4)]; }, zone_place,
      s.zone_begin, s.zone_entry);
  list_by_node(
      s.n_node, 2 * s.n_contact,
      [&](int k) { return (k % 2 == 0 ? s.contact_p : s.contact_q)[at(k, 2)]; }, contact_place,
      s.contact_begin, s.contact_entry);
}

}  // namespace wythe::solids
