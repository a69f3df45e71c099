// Divides hexahedra into zones by the trilinear map of their corners, and cuts joint faces at the sides of zones (8.14).
// Direction b starts along the edge nearest to vertical. Zones of a parallelepiped share one shape. Points of contacts
// follow those of joints in Space. A face that lies on zones by less than 99.9 % is a fault.
#include "model/space/space_solids.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "geometry/bodies/polygon_in_space.h"
#include "model/space/space_points.h"
#include "model/space/space_roles.h"
#include "solids/elasticity.h"
#include "solids/hexahedron.h"

namespace wythe {
namespace {

using geometry::Convex;
using geometry::JointFace;
using solids::HexahedronCorners;

constexpr double kThinnest = 20;  // longest side of a zone over its shortest
constexpr int kMostZones = 20000;
constexpr double kLeastShape = 0.05;  // smallest Jacobian at a corner over the mean one
// Position of the corners of a hexahedron: at the start (0) or end (1) of a, b, c.
constexpr int kEnds[8][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                             {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
// Corners of the six sides of a hexahedron: side k is where direction k/2 ends at k%2; anticlockwise seen from outside.
constexpr int kSides[6][4] = {{0, 4, 7, 3}, {1, 2, 6, 5}, {0, 1, 5, 4},
                              {3, 7, 6, 2}, {0, 3, 2, 1}, {4, 5, 6, 7}};

// --- corners of a block in the order of a zone's ----------------------------------------------------------

// Corners connected with corner v by edges; all faces of the solid have four corners.
std::vector<std::int32_t> neighbours(const Polyhedron& part, std::int32_t v) {
  std::vector<std::int32_t> found;
  for (const auto& face : part.face)
    for (std::size_t k = 0; k < face.size(); ++k)
      if (face[k] == v) found.push_back(face[(k + 1) % face.size()]);
  return found;
}

// The corner connected with both p and q, other than v; -1 where there is none.
std::int32_t across(const Polyhedron& part, std::int32_t v, std::int32_t p, std::int32_t q) {
  const std::vector<std::int32_t> of_p = neighbours(part, p), of_q = neighbours(part, q);
  for (const std::int32_t n : of_p)
    if (n != v && std::find(of_q.begin(), of_q.end(), n) != of_q.end()) return n;
  return -1;
}

// Orders the corners: the first has the least x + y + z, b is its edge nearest to y, and a, b, c are
// right-handed. False where the solid is no hexahedron.
bool order_corners(const BodySpec& body, HexahedronCorners& corners) {
  if (body.part.size() != 1) return false;
  const Polyhedron& part = body.part.front();
  const auto is_quadrilateral = [](const auto& face) { return face.size() == 4; };
  if (part.vertex.size() != 8 || part.face.size() != 6 ||
      !std::all_of(part.face.begin(), part.face.end(), is_quadrilateral))
    return false;
  std::int32_t first = 0;
  const auto sum = [&](std::int32_t v) {
    const Vec3& p = part.vertex[v];
    return p.x + p.y + p.z;
  };
  for (std::int32_t v = 1; v < 8; ++v)
    if (sum(v) < sum(first)) first = v;
  std::vector<std::int32_t> next = neighbours(part, first);
  if (next.size() != 3) return false;
  const Vec3 origin = part.vertex[first];
  const auto edge = [&](std::int32_t v) { return part.vertex[v] - origin; };
  const auto upright = [&](std::int32_t v) { return std::fabs(geometry::unit(edge(v)).y); };
  std::size_t up = 0;
  for (std::size_t k = 1; k < 3; ++k)
    if (upright(next[k]) > upright(next[up])) up = k;
  std::int32_t b = next[up], a = next[(up + 1) % 3], c = next[(up + 2) % 3];
  if (dot(cross(edge(a), edge(b)), edge(c)) < 0) std::swap(a, c);
  const std::int32_t ab = across(part, first, a, b), bc = across(part, first, b, c),
                     ac = across(part, first, a, c);
  if (ab < 0 || bc < 0 || ac < 0) return false;
  const std::int32_t last = across(part, b, ab, bc);
  const std::int32_t order[8] = {first, a, ab, b, c, ac, last, bc};
  for (std::size_t k = 0; k < 8; ++k) {
    if (order[k] < 0) return false;
    corners[k] = part.vertex[order[k]];
  }
  return true;
}

// Trilinear map of the corners, a, b, c from 0 to 1.
Vec3 place_in(const HexahedronCorners& corners, double a, double b, double c) {
  Vec3 sum;
  for (std::size_t k = 0; k < 8; ++k) {
    const double share = (kEnds[k][0] == 1 ? a : 1 - a) * (kEnds[k][1] == 1 ? b : 1 - b) *
                         (kEnds[k][2] == 1 ? c : 1 - c);
    sum = sum + share * corners[k];
  }
  return sum;
}

// --- division of a block into zones -----------------------------------------------------------------------

class BodyBuilder {
 public:
  BodyBuilder(const ModelSpec& spec, Model& model, FaultList& faults)
      : spec_(spec), model_(model), s_(model.space.solids), faults_(faults) {}

  void add(const BodySpec& body, Vec3 centroid) {
    path_ = "wall.blocks." + body.id;
    sound_ = true;
    refuse_plane_keys(body);
    const auto found = spec_.material.find(body.material);
    if (found == spec_.material.end())
      return fault("material", body.material, "is no [material.*] table; zones need its moduli",
                   fmt::format("add [material.{}] with density, youngs_modulus, shear_modulus",
                               body.material));
    check_material(body.material, found->second);
    if (!order_corners(body, corners_))
      fault("zones", std::to_string(body.zone.zones),
            "needs a hexahedron: one convex part with eight corners and six faces of four",
            "give the block that shape, or leave zones out");
    if (!sound_) return;
    set_counts(body);
    if (!sound_) return;
    mesh(found->second);
    SpaceSolidBody& added = s_.bodies.back();
    added.body = body;
    added.centroid = centroid;
    const bool spans = body.role.empty() ? body.id.find(".lintel") != std::string::npos
                                         : role_of(body) == BlockRole::kLintel;
    added.role = spans ? BlockRole::kLintel : BlockRole::kMasonry;
    added.tension_limit = found->second.tension_limit;
    added.compression_limit = found->second.compression_limit;
  }

 private:
  void fault(const std::string& key, std::string value, std::string problem, std::string cure) {
    faults_.add({"", path_ + "." + key, std::move(value), std::move(problem), std::move(cure), 0});
    sound_ = false;
  }

  void refuse_plane_keys(const BodySpec& body) {
    if (body.zone.kind == ZoneKind::kCst)
      fault("zone_kind", "cst", "is a kind of zones in the plane; in space there is one kind",
            "leave it out");
    if (body.zone.plane == Plane::kStrain)
      fault("plane", "strain", "is for walls in their plane; this one is in space", "leave it out");
    if (body.fixed)
      fault("zones", std::to_string(body.zone.zones), "would deform a support",
            "leave zones out, or fixed");
  }

  // Reports the faults of each material once, for any number of blocks.
  void check_material(const std::string& name, const JointMaterial& material) {
    const auto [state, is_new] = checked_.try_emplace(name, true);
    if (is_new)
      for (const MaterialFault& f : solids::check_elasticity(material)) {
        faults_.add({"", "material." + name + "." + f.key, f.value, f.problem, f.cure, 0});
        state->second = false;
      }
    sound_ = sound_ && state->second;
  }

  // Mean length of the four edges along direction d.
  [[nodiscard]] Vec3 mean_edge(std::size_t d) const {
    Vec3 sum;
    for (std::size_t k = 0; k < 8; ++k) sum = sum + (kEnds[k][d] == 1 ? 0.25 : -0.25) * corners_[k];
    return sum;
  }

  void set_counts(const BodySpec& body) {
    const double high = geometry::norm(mean_edge(1));
    const double size = std::isnan(body.zone.length) ? high / body.zone.zones : body.zone.length;
    double all = 1, longest = 0, shortest = 1e300;
    for (std::size_t d = 0; d < 3; ++d) {
      const double length = geometry::norm(mean_edge(d));
      const double n = d == 1 ? body.zone.zones : std::clamp(std::round(length / size), 1.0, 1e6);
      all *= n;
      count_[d] = static_cast<int>(n);
      longest = std::fmax(longest, length / n);
      shortest = std::fmin(shortest, length / n);
      size_[d] = length / n;
    }
    if (all > kMostZones)
      fault("zones", fmt::format("{:.0f} zones", all),
            fmt::format("makes more than {} zones", kMostZones),
            "write fewer zones, or a greater zone_length");
    if (longest > kThinnest * shortest)
      fault("zones", fmt::format("{:.3g} x {:.3g} mm", 1e3 * longest, 1e3 * shortest),
            fmt::format("zones are too thin: one way they are over {:g} times as long as another",
                        kThinnest),
            "write another number of zones through the height, or another zone_length");
    if (solids::least_jacobian(corners_) < kLeastShape)
      fault("zones", std::to_string(body.zone.zones), "is a block too pointed for zones",
            "cut it into better shaped blocks, or leave zones out");
  }

  void mesh(const JointMaterial& material) {
    SpaceSolidBody& body = s_.bodies.emplace_back();
    body.count = count_;
    body.first_node = s_.n_node;
    body.first_zone = s_.n_zone;
    for (int k = 0; k <= count_[2]; ++k)
      for (int j = 0; j <= count_[1]; ++j)
        for (int i = 0; i <= count_[0]; ++i) {
          const auto along = [&](int n, std::size_t d) {
            return static_cast<double>(n) / count_[d];
          };
          s_.node.push_back(place_in(corners_, along(i, 0), along(j, 1), along(k, 2)));
          s_.node_mass.push_back(0);
          ++s_.n_node;
        }
    body.n_node = s_.n_node - body.first_node;
    std::size_t longest = 0;
    for (std::size_t d = 1; d < 3; ++d)
      if (geometry::norm(mean_edge(d)) > geometry::norm(mean_edge(longest))) longest = d;
    elasticity_ = solids::elasticity_in_space(material, mean_edge(longest));
    density_ = material.density;
    const bool even = is_parallelepiped();
    for (int k = 0; k < count_[2]; ++k)
      for (int j = 0; j < count_[1]; ++j)
        for (int i = 0; i < count_[0]; ++i)
          add_zone(body, i, j, k, even && s_.n_zone > body.first_zone);
    body.n_zone = s_.n_zone - body.first_zone;
    model_.anatomy.notes.push_back({"zones.in_space",
                                    {{"block", path_.substr(std::string("wall.blocks.").size())},
                                     {"columns", count_[0]},
                                     {"rows", count_[1]},
                                     {"layers", count_[2]},
                                     {"a_mm", 1e3 * size_[0]},
                                     {"b_mm", 1e3 * size_[1]},
                                     {"c_mm", 1e3 * size_[2]}}});
  }

  [[nodiscard]] bool is_parallelepiped() const {
    const Vec3 a = corners_[1] - corners_[0], b = corners_[3] - corners_[0],
               c = corners_[4] - corners_[0];
    double off = 0;
    for (std::size_t k = 0; k < 8; ++k)
      off = std::fmax(off, geometry::norm(corners_[0] + kEnds[k][0] * a + kEnds[k][1] * b +
                                          kEnds[k][2] * c - corners_[k]));
    return off < 1e-9 * geometry::norm(a + b + c);
  }

  void add_zone(const SpaceSolidBody& body, int i, int j, int k, bool same_shape) {
    HexahedronCorners place;
    std::array<std::int32_t, 8> node{};
    for (std::size_t c = 0; c < 8; ++c) {
      node[c] = body.node(i + kEnds[c][0], j + kEnds[c][1], k + kEnds[c][2]);
      place[c] = s_.node[node[c]];
      s_.corner.push_back(node[c]);
    }
    if (!same_shape) s_.shapes.push_back(solids::make_hexahedron(place, elasticity_, density_));
    const HexahedronShape& shape = s_.shapes.back();
    for (std::size_t c = 0; c < 8; ++c) s_.node_mass[node[c]] += shape.share[c] * shape.mass;
    s_.zone_shape.push_back(static_cast<std::int32_t>(s_.shapes.size()) - 1);
    ++s_.n_zone;
  }

  const ModelSpec& spec_;
  Model& model_;
  SpaceSolids& s_;
  FaultList& faults_;
  std::map<std::string, bool> checked_;
  std::string path_;
  HexahedronCorners corners_{};
  std::array<int, 3> count_ = {1, 1, 1};
  std::array<double, 3> size_ = {};  // of a zone [m]
  solids::Elasticity6 elasticity_{};
  double density_ = 0;
  bool sound_ = true;
};

// --- contacts -----------------------------------------------------------------------------------------------

// A side of a zone: its nodes, anticlockwise seen from outside.
using Side = std::array<std::int32_t, 4>;

// Sides of zones on the surface of a body.
std::vector<Side> outer_sides(const SpaceSolids& s, const SpaceSolidBody& body) {
  std::vector<Side> sides;
  for (int k = 0; k < body.count[2]; ++k)
    for (int j = 0; j < body.count[1]; ++j)
      for (int i = 0; i < body.count[0]; ++i) {
        const int index[3] = {i, j, k};
        for (int side = 0; side < 6; ++side) {
          const int d = side / 2, last = side % 2 == 1 ? body.count[d] - 1 : 0;
          if (index[d] != last) continue;
          Side& one = sides.emplace_back();
          for (std::size_t c = 0; c < 4; ++c)
            one[c] = s.corner[8 * body.zone(i, j, k) + kSides[side][c]];
        }
      }
  return sides;
}

Vec2 mix(double share, Vec2 p, Vec2 q) {
  return {(1 - share) * p.x + share * q.x, (1 - share) * p.y + share * q.y};
}

// Shape functions of the corners of a convex quadrilateral at p, by Newton's iteration on its bilinear map.
std::array<double, 4> shares_at(const std::array<Vec2, 4>& q, Vec2 p) {
  double x = 0.5, y = 0.5;
  for (int k = 0; k < 30; ++k) {
    const Vec2 low = mix(x, q[0], q[1]), high = mix(x, q[3], q[2]);
    const Vec2 along = mix(y, q[1] - q[0], q[2] - q[3]), up = high - low;
    const Vec2 off = p - mix(y, low, high);
    const double det = cross(along, up), dx = cross(off, up) / det, dy = cross(along, off) / det;
    x += dx, y += dy;
    if (std::fabs(dx) + std::fabs(dy) < 1e-14) break;
  }
  const auto inside = [](double v) {
    constexpr double kSame = 1e-9;  // a point within this distance of an edge is on it
    return v < kSame ? 0.0 : v > 1 - kSame ? 1.0 : v;
  };
  x = inside(x), y = inside(y);
  return {(1 - x) * (1 - y), x * (1 - y), x * y, (1 - x) * y};
}

class ContactBuilder {
 public:
  ContactBuilder(const QuadratureChoice& choice, Model& model)
      : choice_(choice), m_(model), s_(model.space.solids) {
    for (const SpaceSolidBody& body : s_.bodies) sides_.push_back(outer_sides(s_, body));
    s_.point_begin.push_back(m_.n_point());
  }

  // Adds contacts of a face; returns the share of its area that lies on zones.
  double add(const SpaceSolidFace& of) {
    const JointFace& face = *of.face;
    const Vec3 normal = of.from_rigid ? face.normal : -1.0 * face.normal;
    const geometry::PlaneAxes axes = geometry::axes_of(face.centre, normal);
    Convex outline;
    for (const Vec3& p : face.polygon) outline.push_back(axes.flat(p));
    if (!of.from_rigid) std::reverse(outline.begin(), outline.end());
    const double size = std::sqrt(face.area);
    double found = 0;
    for (const Side& side : sides_[of.body]) {
      std::array<Vec3, 4> corner;
      for (std::size_t k = 0; k < 4; ++k) corner[k] = s_.node[side[3 - k]];  // in the sense of n
      const geometry::Facet facet =
          geometry::measured(std::vector<Vec3>(corner.begin(), corner.end()));
      if (dot(facet.normal, normal) < 0.999) continue;
      if (std::fabs(dot(facet.centre - face.centre, normal)) > 0.01 * size) continue;
      Convex own;
      for (const Vec3& p : corner) own.push_back(axes.flat(p));
      const Convex common = geometry::common_part(outline, own, 1e-7 * size);
      const double area = common.empty() ? 0 : geometry::area_of(common);
      if (area < 1e-6 * facet.area) continue;
      found += area;
      push(of, normal, axes, common, area, side, own);
    }
    return found / face.area;
  }

 private:
  void push(const SpaceSolidFace& of, Vec3 normal, const geometry::PlaneAxes& axes,
            const Convex& common, double area, const Side& side, const Convex& own) {
    const Vec3 centre = axes.raised(geometry::centroid_of(common));
    const Vec3 t1 = of.tangent, t2 = cross(normal, t1);
    std::vector<Vec2> corner;
    std::vector<Vec3> outline;
    for (const Vec2& p : common) {
      outline.push_back(axes.raised(p));
      corner.push_back({dot(outline.back() - centre, t1), dot(outline.back() - centre, t2)});
    }
    const FacePoints points = points_on(corner, choice_);
    std::array<Vec2, 4> quadrilateral;
    std::copy(own.begin(), own.end(), quadrilateral.begin());
    Space& space = m_.space;
    for (std::size_t p = 0; p < points.r1.size(); ++p) {
      space.point_r1.push_back(points.r1[p]);
      space.point_r2.push_back(points.r2[p]);
      space.point_share.push_back(points.share[p]);
      const Vec3 place = centre + points.r1[p] * t1 + points.r2[p] * t2;
      for (const double share : shares_at(quadrilateral, axes.flat(place)))
        s_.node_share.push_back(share);
    }
    s_.point_begin.push_back(static_cast<std::int32_t>(space.point_r1.size()));
    s_.contact_block.push_back(of.rigid);
    s_.contact_body.push_back(of.body);
    for (std::size_t k = 0; k < 4; ++k) s_.contact_node.push_back(side[3 - k]);
    s_.contact_arm.push_back(centre - of.centroid);
    s_.contact_tangent.push_back(t1);
    s_.contact_normal.push_back(normal);
    s_.contact_area.push_back(area);
    s_.contact_material.push_back(of.material);
    s_.contact_face.push_back(std::move(outline));
    ++s_.n_contact;
  }

  QuadratureChoice choice_;
  Model& m_;
  SpaceSolids& s_;
  std::vector<std::vector<Side>> sides_;  // of each body
};

// For each node the numbers k with node[k] equal to it.
void list_by_node(int n_node, const std::vector<std::int32_t>& node,
                  std::vector<std::int32_t>& begin, std::vector<std::int32_t>& entry) {
  begin.assign(static_cast<std::size_t>(n_node) + 1, 0);
  for (const std::int32_t n : node) ++begin[n + 1];
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  entry.resize(node.size());
  std::vector<std::int32_t> next(begin.begin(), begin.end() - 1);
  for (std::size_t k = 0; k < node.size(); ++k)
    entry[next[node[k]]++] = static_cast<std::int32_t>(k);
}

}  // namespace

void compile_space_solids(const ModelSpec& spec, const geometry::SpaceAssembly& assembly,
                          Model& model, FaultList& faults) {
  BodyBuilder builder(spec, model, faults);
  for (std::size_t k = 0; k < assembly.body.size(); ++k)
    if (has_zones(assembly.body[k])) builder.add(assembly.body[k], assembly.moments[k].centroid);
  model.space.solids.node_gravity_mass = model.space.solids.node_mass;
}

void compile_space_contacts(const std::vector<SpaceSolidFace>& faces,
                            const QuadratureChoice& choice, Model& model, FaultList& faults) {
  SpaceSolids& s = model.space.solids;
  if (s.bodies.empty()) return;
  constexpr double kWhole = 0.999;
  ContactBuilder builder(choice, model);
  for (const SpaceSolidFace& face : faces)
    if (const double share = builder.add(face); share < kWhole)
      faults.add({"", "wall.blocks." + s.bodies[face.body].body.id + ".zones",
                  fmt::format("{:.3g} %", 100 * share),
                  "is all of a joint's face that meets the block's zones",
                  "check the block's faces: they must be plane", 0});
  list_by_node(s.n_node, s.corner, s.zone_begin, s.zone_entry);
  list_by_node(s.n_node, s.contact_node, s.contact_begin, s.contact_entry);
}

std::vector<double> space_node_bounds(const Model& m) {
  const SpaceSolids& s = m.space.solids;
  std::vector<double> sum(s.n_node, 0.0);
  for (std::size_t k = 0; k < s.corner.size(); ++k) {
    const HexahedronShape& shape = s.shapes[s.zone_shape[k / 8]];
    sum[s.corner[k]] += shape.share[k % 8] * shape.mass * shape.omega_squared;
  }
  for (std::size_t c = 0; c < static_cast<std::size_t>(s.n_contact); ++c) {
    const JointMaterial& law = m.materials[s.contact_material[c]];
    const double k = std::fmax(law.normal_stiffness, law.shear_stiffness);
    const double sides = s.contact_block[c] < m.n_block ? 2.0 : 1.0;
    for (std::size_t p = s.point_begin[c]; p < static_cast<std::size_t>(s.point_begin[c + 1]); ++p)
      for (std::size_t n = 0; n < 4; ++n)
        sum[s.contact_node[4 * c + n]] +=
            sides * k * s.contact_area[c] * m.space.point_share[p] *
            s.node_share[4 * (p - static_cast<std::size_t>(s.point_begin[0])) + n];
  }
  for (std::size_t i = 0; i < sum.size(); ++i) sum[i] /= s.node_mass[i];
  return sum;
}

}  // namespace wythe
