// Ranks the planes through a reflex edge and one more corner: by sharp edges crossed, reflex edges on them, balance of corners.
// It takes the first plane that leaves two closed sides. Three such searches follow each other, the last with a tenth
// of the tolerance; then the solid is tried as a prism. The volumes of the pieces must sum to that of the whole.
#include "geometry/bodies/mesh_cut.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/bodies/convex_parts.h"
#include "geometry/bodies/polygon_in_space.h"
#include "geometry/bodies/polyhedron.h"

namespace wythe::geometry {
namespace {

using Edge = std::pair<int, int>;
using Triangle = std::array<int, 3>;

constexpr double kMostTrials = 3e8;       // distances computed to find one plane
constexpr std::size_t kMostPlanes = 100;  // planes tried in turn: a cap may touch itself

Vec3 normal_of(const Mesh& mesh, const Triangle& t) {
  const Vec3 a = mesh.vertex[t[0]];
  return unit(cross(mesh.vertex[t[1]] - a, mesh.vertex[t[2]] - a));
}

std::map<Edge, int> edges_of(const Mesh& mesh) {
  std::map<Edge, int> edges;
  for (std::size_t t = 0; t < mesh.triangle.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k)
      edges[{mesh.triangle[t][k], mesh.triangle[t][(k + 1) % 3]}] = static_cast<int>(t);
  return edges;
}

bool is_closed(const Mesh& mesh) {
  const auto edges = edges_of(mesh);
  if (edges.size() != 3 * mesh.triangle.size()) return false;
  return std::all_of(edges.begin(), edges.end(), [&](const auto& edge) {
    return edges.contains({edge.first.second, edge.first.first});
  });
}

double size_of(const Mesh& mesh) { return box_of(mesh.vertex).longest(); }

int third(const Triangle& t, Edge edge) {
  for (const int i : t)
    if (i != edge.first && i != edge.second) return i;
  return t[0];
}

// An edge with the third corners of its two triangles.
struct Hinge {
  Edge edge;
  int left, right;
};

struct Plane {
  Vec3 origin, normal;
  [[nodiscard]] double height(Vec3 p) const { return dot(p - origin, normal); }
};

// --- choice of the plane

class PlaneChoice {
 public:
  PlaneChoice(const Mesh& mesh, double close, bool every_notch) : mesh_(mesh), close_(close) {
    const auto edges = edges_of(mesh);
    for (const auto& [edge, t] : edges) {
      if (edge.first > edge.second) continue;
      const auto other = edges.find({edge.second, edge.first});
      if (other != edges.end()) add_hinge(edge, t, other->second);
    }
    if (every_notch) deep_ = reflex_;
  }

  // Planes from best to worst, at most `most`.
  [[nodiscard]] std::vector<Plane> best(std::size_t most) {
    const double trials = static_cast<double>(deep_.size() * mesh_.vertex.size()) *
                          static_cast<double>(mesh_.vertex.size() + sharp_.size());
    if (trials > kMostTrials) return {};
    for (const Hinge& hinge : deep_)
      for (std::size_t v = 0; v < mesh_.vertex.size(); ++v) judge(hinge, mesh_.vertex[v]);
    std::stable_sort(judged_.begin(), judged_.end(),
                     [](const Judged& a, const Judged& b) { return a.better_than(b); });
    std::vector<Plane> planes;
    for (std::size_t i = 0; i < judged_.size() && i < most; ++i) planes.push_back(judged_[i].plane);
    return planes;
  }

 private:
  struct Judged {
    Plane plane;
    int crossings, notches, unbalance;
    [[nodiscard]] bool better_than(const Judged& o) const {
      if (crossings != o.crossings) return crossings < o.crossings;
      if (notches != o.notches) return notches > o.notches;
      return unbalance < o.unbalance;
    }
  };

  void add_hinge(Edge edge, int t, int u) {
    const Triangle &a = mesh_.triangle[t], &b = mesh_.triangle[u];
    const Vec3 na = normal_of(mesh_, a), nb = normal_of(mesh_, b);
    if (norm(cross(na, nb)) <= kFlatEdge && dot(na, nb) >= 0) return;
    const Hinge hinge{edge, third(a, edge), third(b, edge)};
    sharp_.push_back(edge);
    const Vec3 start = mesh_.vertex[edge.first];
    const double height = dot(mesh_.vertex[hinge.right] - start, na);
    if (height > 0) reflex_.push_back(hinge);
    if (height > 4 * close_) deep_.push_back(hinge);  // 4: as much as a warped quadrilateral
  }

  [[nodiscard]] int side(double height) const {
    return height > close_ ? 1 : height < -close_ ? -1 : 0;
  }

  void judge(const Hinge& hinge, Vec3 through) {
    const Vec3 p = mesh_.vertex[hinge.edge.first], q = mesh_.vertex[hinge.edge.second];
    const Vec3 across = cross(q - p, through - p);
    const double breadth = norm(across) / std::max(norm(q - p), 1e-300);
    if (breadth <= close_) return;
    const Plane plane{p, unit(across)};
    // the plane must lie between both faces, with one on each side
    const double left = plane.height(mesh_.vertex[hinge.left]),
                 right = plane.height(mesh_.vertex[hinge.right]);
    const double slack = 1e-9 * close_;
    if ((left > slack && right > slack) || (left < -slack && right < -slack)) return;
    count(plane);
  }

  void count(const Plane& plane) {
    sides_.clear();
    int above = 0, below = 0;
    for (const Vec3 v : mesh_.vertex) {
      sides_.push_back(side(plane.height(v)));
      above += sides_.back() > 0;
      below += sides_.back() < 0;
    }
    if (above == 0 || below == 0) return;
    Judged judged{plane, 0, 0, std::abs(above - below)};
    for (const Edge& edge : sharp_)
      judged.crossings += sides_[edge.first] * sides_[edge.second] < 0;
    for (const Hinge& hinge : deep_)
      judged.notches += sides_[hinge.edge.first] == 0 && sides_[hinge.edge.second] == 0;
    judged_.push_back(judged);
  }

  const Mesh& mesh_;
  double close_;
  std::vector<Edge> sharp_;
  std::vector<Hinge> reflex_, deep_;
  std::vector<int> sides_;
  std::vector<Judged> judged_;
};

// --- the cut

class Cut {
 public:
  Cut(const Mesh& mesh, const Plane& plane, double close)
      : mesh_(mesh), plane_(plane), close_(close) {
    for (const Vec3 v : mesh.vertex) height_.push_back(plane.height(v));
    all_ = mesh.vertex;
  }

  // Makes the two sides, closed by caps; false where the cut has holes or touches itself.
  bool run(Mesh& below, Mesh& above) {
    for (std::size_t t = 0; t < mesh_.triangle.size(); ++t) share_out(t);
    below_.vertex = above_.vertex = all_;
    if (!add_caps() || !is_closed(below_) || !is_closed(above_)) return false;
    below = std::move(below_);
    above = std::move(above_);
    return true;
  }

 private:
  [[nodiscard]] int side(int v) const {
    const double h = height_[v];
    return h > close_ ? 1 : h < -close_ ? -1 : 0;
  }

  // A new corner where an edge crosses the plane, shared by both of its triangles.
  int corner_on(int p, int q) {
    const Edge edge = std::minmax(p, q);
    const auto found = cut_edge_.find(edge);
    if (found != cut_edge_.end()) return found->second;
    const Vec3 a = all_[edge.first], b = all_[edge.second];
    const double t = height_[edge.first] / (height_[edge.first] - height_[edge.second]);
    all_.push_back(a + t * (b - a));
    return cut_edge_[edge] = static_cast<int>(all_.size()) - 1;
  }

  void share_out(std::size_t index) {
    const Triangle& t = mesh_.triangle[index];
    const int s[3] = {side(t[0]), side(t[1]), side(t[2])};
    if (s[0] == 0 && s[1] == 0 && s[2] == 0)
      return add(dot(normal_of(mesh_, t), plane_.normal) > 0 ? below_ : above_, t, index);
    std::vector<int> low, high;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t next = (k + 1) % 3;
      if (s[k] <= 0) low.push_back(t[k]);
      if (s[k] >= 0) high.push_back(t[k]);
      if (s[k] * s[next] >= 0) continue;
      const int corner = corner_on(t[k], t[next]);
      low.push_back(corner);
      high.push_back(corner);
    }
    const bool has_low = s[0] < 0 || s[1] < 0 || s[2] < 0;
    const bool has_high = s[0] > 0 || s[1] > 0 || s[2] > 0;
    for (std::size_t k = 1; has_low && k + 1 < low.size(); ++k)
      add(below_, {low[0], low[k], low[k + 1]}, index);
    for (std::size_t k = 1; has_high && k + 1 < high.size(); ++k)
      add(above_, {high[0], high[k], high[k + 1]}, index);
  }

  void add(Mesh& mesh, const Triangle& t, std::size_t from) {
    mesh.triangle.push_back(t);
    mesh.source.push_back(mesh_.source[from]);
  }

  bool add_caps() {
    const auto edges = edges_of(below_);
    std::map<int, int> next;  // along the cap, opposite to the open edges
    for (const auto& [edge, t] : edges) {
      if (edges.contains({edge.second, edge.first})) continue;
      if (!next.emplace(edge.second, edge.first).second) return false;
    }
    int cap = *std::max_element(mesh_.source.begin(), mesh_.source.end()) + 1;
    while (!next.empty()) {
      std::vector<int> loop;
      for (int v = next.begin()->first; next.contains(v);) {
        loop.push_back(v);
        const int after = next[v];
        next.erase(v);
        v = after;
      }
      if (!add_cap(loop, cap++)) return false;
    }
    return true;
  }

  bool add_cap(const std::vector<int>& loop, int source) {
    std::vector<Vec3> corners;
    for (const int v : loop) corners.push_back(all_[v]);
    if (corners.size() < 3 || dot(measured(corners).normal, plane_.normal) <= 0) return false;
    const std::vector<Triangle> triangles = triangles_of(corners);
    for (const Triangle& t : triangles) {
      const Triangle low = {loop[t[0]], loop[t[1]], loop[t[2]]};
      below_.triangle.push_back(low);
      above_.triangle.push_back({low[0], low[2], low[1]});
      below_.source.push_back(source);
      above_.source.push_back(source);
    }
    return !triangles.empty();
  }

  const Mesh& mesh_;
  Plane plane_;
  double close_;
  std::vector<double> height_;
  std::vector<Vec3> all_;  // the mesh's corners and those of the cut
  std::map<Edge, int> cut_edge_;
  Mesh below_, above_;
};

Mesh part_of(const Mesh& mesh, const std::vector<int>& triangles) {
  Mesh part;
  std::map<int, int> number;
  std::vector<int> used;
  for (const int t : triangles)
    for (const int v : mesh.triangle[t]) used.push_back(v);
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());
  for (const int v : used) {
    number[v] = static_cast<int>(part.vertex.size());
    part.vertex.push_back(mesh.vertex[v]);
  }
  for (const int t : triangles) {
    const Triangle& old = mesh.triangle[t];
    part.triangle.push_back({number[old[0]], number[old[1]], number[old[2]]});
    part.source.push_back(mesh.source[t]);
  }
  return part;
}

// Whether the segment pq passes through the inside of triangle t, clear of its border.
bool pierces(const Mesh& mesh, Vec3 p, Vec3 q, const Triangle& t, double margin) {
  const Vec3 a = mesh.vertex[t[0]], n = normal_of(mesh, t);
  const double hp = dot(p - a, n), hq = dot(q - a, n);
  if (!((hp > margin && hq < -margin) || (hp < -margin && hq > margin))) return false;
  const Vec3 x = p + (hp / (hp - hq)) * (q - p);
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3 from = mesh.vertex[t[k]], to = mesh.vertex[t[(k + 1) % 3]];
    if (dot(unit(cross(n, to - from)), x - from) <= margin) return false;
  }
  return true;
}

}  // namespace

std::vector<std::array<int, 3>> triangles_of(const std::vector<Vec3>& polygon) {
  const std::size_t n = polygon.size();
  if (n < 3 || n > kMostCorners) return {};
  if (n == 3) return {{0, 1, 2}};
  const auto area = [&](std::size_t i, std::size_t k, std::size_t j) {
    return norm(cross(polygon[k] - polygon[i], polygon[j] - polygon[i]));
  };
  // least[i][j]: of the polygon i, i+1, ..., j
  std::vector<std::vector<double>> least(n, std::vector<double>(n, 0));
  std::vector<std::vector<std::size_t>> apex(n, std::vector<std::size_t>(n, 0));
  for (std::size_t span = 2; span < n; ++span)
    for (std::size_t i = 0; i + span < n; ++i) {
      const std::size_t j = i + span;
      least[i][j] = std::numeric_limits<double>::infinity();
      for (std::size_t k = i + 1; k < j; ++k) {
        const double sum = least[i][k] + least[k][j] + area(i, k, j);
        if (sum < least[i][j]) {
          least[i][j] = sum;
          apex[i][j] = k;
        }
      }
    }
  std::vector<Triangle> triangles;
  std::vector<std::pair<std::size_t, std::size_t>> open = {{0, n - 1}};
  while (!open.empty()) {
    const auto [i, j] = open.back();
    open.pop_back();
    if (j - i < 2) continue;
    const std::size_t k = apex[i][j];
    triangles.push_back({static_cast<int>(i), static_cast<int>(k), static_cast<int>(j)});
    open.emplace_back(k, j);
    open.emplace_back(i, k);
  }
  return triangles;
}

double volume_of(const Mesh& mesh) {
  double sum = 0;
  const Vec3 o = mesh.vertex.front();
  for (const Triangle& t : mesh.triangle)
    sum += dot(mesh.vertex[t[0]] - o, cross(mesh.vertex[t[1]] - o, mesh.vertex[t[2]] - o));
  return sum / 6;
}

std::vector<Mesh> connected_pieces(const Mesh& mesh) {
  const auto edges = edges_of(mesh);
  std::vector<int> piece(mesh.triangle.size(), -1);
  std::vector<Mesh> pieces;
  for (std::size_t first = 0; first < piece.size(); ++first) {
    if (piece[first] >= 0) continue;
    std::vector<int> found = {static_cast<int>(first)};
    piece[first] = static_cast<int>(pieces.size());
    for (std::size_t i = 0; i < found.size(); ++i)
      for (std::size_t k = 0; k < 3; ++k) {
        const Triangle& t = mesh.triangle[found[i]];
        const auto other = edges.find({t[(k + 1) % 3], t[k]});
        if (other == edges.end() || piece[other->second] >= 0) continue;
        piece[other->second] = piece[first];
        found.push_back(other->second);
      }
    std::sort(found.begin(), found.end());
    pieces.push_back(part_of(mesh, found));
  }
  return pieces;
}

std::optional<std::array<Vec3, 2>> crossing_edge(const Mesh& mesh) {
  const double margin = 1e-6 * size_of(mesh);
  std::vector<Box3> boxes;
  for (const Triangle& t : mesh.triangle) {
    const std::array<Vec3, 3> p = {mesh.vertex[t[0]], mesh.vertex[t[1]], mesh.vertex[t[2]]};
    boxes.push_back(box_of(p));
  }
  for (const auto& [edge, own] : edges_of(mesh)) {
    if (edge.first > edge.second) continue;
    const std::array<Vec3, 2> ends = {mesh.vertex[edge.first], mesh.vertex[edge.second]};
    const Box3 box = box_of(ends);
    for (std::size_t t = 0; t < boxes.size(); ++t)
      if (near(box, boxes[t], 0) && pierces(mesh, ends[0], ends[1], mesh.triangle[t], margin))
        return ends;
  }
  return std::nullopt;
}

namespace {

// Settings of the search for planes: through every reflex edge or only deep ones; tolerance of corners on a plane, as share of size.
struct Search {
  bool every_notch;
  double close;
};
// The first gives the fewest parts of warped faces; the others help where caps of the first touch themselves.
constexpr Search kSearches[] = {
    {false, kConvexPart}, {true, kConvexPart}, {true, kConvexPart / 10}};

// Cuts by the best plane that leaves two closed sides.
bool cut_once(const Mesh& mesh, const Search& search, std::vector<Mesh>& open) {
  const double close = search.close * size_of(mesh);
  for (const Plane& plane : PlaneChoice(mesh, close, search.every_notch).best(kMostPlanes)) {
    Mesh below, above;
    if (!Cut(mesh, plane, close).run(below, above)) continue;
    if (volume_of(below) <= 0 || volume_of(above) <= 0) continue;
    for (Mesh& piece : connected_pieces(above)) open.push_back(std::move(piece));
    for (Mesh& piece : connected_pieces(below)) open.push_back(std::move(piece));
    return true;
  }
  return false;
}

std::string cut_by(const Search& search, const Mesh& mesh, const IsConvex& is_convex,
                   std::vector<Mesh>& done) {
  std::vector<Mesh> open = {mesh};
  const double whole = volume_of(mesh);
  double sum = 0;
  while (!open.empty()) {
    const Mesh next = std::move(open.back());
    open.pop_back();
    if (is_convex(next)) {
      sum += volume_of(next);
      done.push_back(next);
    } else if (done.size() + open.size() >= kMostParts) {
      return "takes more than " + std::to_string(kMostParts) + " convex parts";
    } else if (!cut_once(next, search, open)) {
      return "can't be cut into convex parts by planes through its notches";
    }
  }
  return std::abs(sum - whole) <= 1e-6 * whole ? "" : "is not kept whole by cuts into convex parts";
}

// --- a prism: its base in convex polygons
//
//   +-----------+      The surface lies in two parallel planes and in faces at right angles to them. So convex polygons of
//   |  +--+--+  |      the base cut the whole solid. The triangles of the base are such a cut already, and neighbours
//   |  |  |  |  |      whose union is convex become one. No plane can cut a base with holes: each cut would leave a
//   +--+--+--+--+      cap with a hole.

// Levels of the two planes; nothing where the surface is not that of a prism along `axis`.
std::optional<std::array<double, 2>> heights_of_prism(const Mesh& mesh, Vec3 axis) {
  const double close = 1e-5 * size_of(mesh);
  std::array<double, 2> ends{std::numeric_limits<double>::infinity(),
                             -std::numeric_limits<double>::infinity()};
  for (const Vec3 v : mesh.vertex) {
    ends[0] = std::min(ends[0], dot(v, axis));
    ends[1] = std::max(ends[1], dot(v, axis));
  }
  for (const Vec3 v : mesh.vertex)
    if (dot(v, axis) > ends[0] + close && dot(v, axis) < ends[1] - close) return std::nullopt;
  return ends;
}

// Triangles of the upper base, in the axes of its plane.
std::vector<Convex> upper_base(const Mesh& mesh, const PlaneAxes& axes) {
  std::vector<Convex> base;
  for (const Triangle& t : mesh.triangle)
    if (dot(normal_of(mesh, t), axes.normal) > 0.5) {
      Convex corners;
      for (const int v : t) corners.push_back(axes.flat(mesh.vertex[v]));
      base.push_back(std::move(corners));
    }
  return base;
}

void join_convex_neighbours(std::vector<Convex>& polygons, double tolerance) {
  for (std::size_t i = 0; i < polygons.size(); ++i)
    for (std::size_t k = i + 1; k < polygons.size();) {
      const auto both = united(polygons[i], polygons[k], tolerance);
      if (!both) {
        ++k;
        continue;
      }
      polygons[i] = *both;
      polygons.erase(polygons.begin() + static_cast<std::ptrdiff_t>(k));
      k = i + 1;  // neighbours rejected before may fit now
    }
}

Mesh prism_on(const Convex& base, const PlaneAxes& axes, double height) {
  Mesh mesh;
  const int n = static_cast<int>(base.size());
  for (const double h : {-height, 0.0})
    for (const Vec2 p : base) mesh.vertex.push_back(axes.raised(p, h));
  const auto add = [&](Triangle t, int source) {
    mesh.triangle.push_back(t);
    mesh.source.push_back(source);
  };
  for (int k = 1; k + 1 < n; ++k) {
    add({0, k + 1, k}, 0);
    add({n, n + k, n + k + 1}, 1);
  }
  for (int k = 0; k < n; ++k) {
    const int next = (k + 1) % n;
    add({k, next, n + next}, 2 + k);
    add({k, n + next, n + k}, 2 + k);
  }
  return mesh;
}

// Convex prisms; empty where the solid is no prism.
std::vector<Mesh> prisms_of(const Mesh& mesh) {
  const double whole = volume_of(mesh), size = size_of(mesh);
  for (std::size_t t = 0; t < mesh.triangle.size(); ++t) {
    const Vec3 axis = normal_of(mesh, mesh.triangle[t]);
    const auto ends = heights_of_prism(mesh, axis);
    if (!ends) continue;
    const double height = (*ends)[1] - (*ends)[0];
    const PlaneAxes axes = axes_of((*ends)[1] * axis, axis);
    std::vector<Convex> base = upper_base(mesh, axes);
    double area = 0;
    for (const Convex& triangle : base) area += area_of(triangle);
    if (std::abs(area * height - whole) > 1e-5 * whole) continue;
    join_convex_neighbours(base, 1e-9 * size);
    std::vector<Mesh> prisms;
    for (const Convex& polygon : base) prisms.push_back(prism_on(polygon, axes, height));
    return prisms;
  }
  return {};
}

}  // namespace

std::string cut_into_convex(const Mesh& mesh, const IsConvex& is_convex,
                            std::vector<Mesh>& pieces) {
  std::string problem;
  for (const Search& search : kSearches) {
    std::vector<Mesh> done;
    problem = cut_by(search, mesh, is_convex, done);
    if (!problem.empty()) continue;
    for (Mesh& piece : done) pieces.push_back(std::move(piece));
    return "";
  }
  std::vector<Mesh> prisms = prisms_of(mesh);
  if (prisms.empty() || prisms.size() > kMostParts) return problem;
  for (Mesh& prism : prisms) pieces.push_back(std::move(prism));
  return "";
}

}  // namespace wythe::geometry
