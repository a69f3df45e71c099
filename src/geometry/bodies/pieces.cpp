// Collects the faces of a solid from edge to edge. Where several faces run in the other direction along an edge, the one with the
// smallest angle through the inside continues. Angles are compared by a measure from 0 to 4, without a sine. A face that
// coincides with this one belongs to a neighbour: its angle counts as the largest.
#include "geometry/bodies/pieces.h"

#include <algorithm>
#include <map>

#include "geometry/bodies/polyhedron.h"

namespace wythe::geometry {
namespace {

using Edge = std::pair<std::int32_t, std::int32_t>;

bool is_before(Vec3 a, Vec3 b) {
  if (a.x != b.x) return a.x < b.x;
  return a.y != b.y ? a.y < b.y : a.z < b.z;
}

// Grows with the angle from the first axis towards the second, from 0 to 4; needs no sine.
double turn_of(double along, double across) {
  const double sum = std::abs(along) + std::abs(across);
  if (sum == 0) return 0;
  const double part = along / sum;
  return across >= 0 ? 1 - part : 3 + part;
}

class Surfaces {
 public:
  Surfaces(const std::vector<Vec3>& vertex, const FaceList& faces)
      : vertex_(vertex), faces_(faces) {
    for (std::size_t f = 0; f < faces.size(); ++f) {
      std::vector<Vec3> corners;
      for (const std::int32_t i : faces[f]) corners.push_back(vertex[i]);
      facets_.push_back(measured(std::move(corners)));
      for (std::size_t k = 0; k < faces[f].size(); ++k)
        if (const Edge edge = edge_of(faces[f], k); edge.first != edge.second)
          edges_[edge].push_back(static_cast<int>(f));
    }
  }

  [[nodiscard]] std::vector<std::vector<int>> solids() const {
    std::vector<bool> taken(faces_.size(), false);
    std::vector<std::vector<int>> all;
    for (std::size_t first = 0; first < faces_.size(); ++first) {
      if (taken[first]) continue;
      std::vector<int> found = {static_cast<int>(first)};
      taken[first] = true;
      for (std::size_t i = 0; i < found.size(); ++i) {
        const auto& face = faces_[found[i]];
        for (std::size_t k = 0; k < face.size(); ++k) {
          const Edge edge = edge_of(face, k);
          const int next = edge.first != edge.second ? beyond(found[i], edge) : -1;
          if (next < 0 || taken[next]) continue;
          taken[next] = true;
          found.push_back(next);
        }
      }
      std::sort(found.begin(), found.end());
      all.push_back(std::move(found));
    }
    return all;
  }

 private:
  // Two corners at one place form no edge.
  static Edge edge_of(const std::vector<std::int32_t>& face, std::size_t k) {
    return {face[k], face[(k + 1) % face.size()]};
  }

  // The face that continues at an edge; -1 where there is none.
  [[nodiscard]] int beyond(int f, Edge edge) const {
    const auto back = edges_.find({edge.second, edge.first});
    if (back == edges_.end()) return turned_beside(f, edge);
    if (back->second.size() == 1) return back->second.front();
    const Vec3 line = unit(vertex_[edge.second] - vertex_[edge.first]);
    const Vec3 normal = facets_[f].normal;
    const Vec3 into = cross(normal, line);  // in the face, pointing away from the edge
    int best = -1;
    double least = 5;
    for (const int g : back->second) {
      const Vec3 other = cross(facets_[g].normal, -1 * line);
      double turn = turn_of(dot(other, into), -dot(other, normal));
      if (turn < 1e-9) turn = 4;  // the coinciding face of a neighbour
      if (turn >= least) continue;
      least = turn;
      best = g;
    }
    return best;
  }

  // The only other face at an edge, where its orientation is wrong; -1 where there is none or more than one.
  [[nodiscard]] int turned_beside(int f, Edge edge) const {
    const std::vector<int>& all = edges_.at(edge);
    if (all.size() != 2) return -1;
    return all[0] == f ? all[1] : all[0];
  }

  const std::vector<Vec3>& vertex_;
  const FaceList& faces_;
  std::vector<Facet> facets_;
  std::map<Edge, std::vector<int>> edges_;
};

}  // namespace

void weld_corners(const std::vector<Vec3>& vertex, FaceList& faces) {
  std::vector<std::int32_t> order(vertex.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<std::int32_t>(i);
  std::stable_sort(order.begin(), order.end(),
                   [&](int a, int b) { return is_before(vertex[a], vertex[b]); });
  std::vector<std::int32_t> first(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool repeats = i > 0 && !is_before(vertex[order[i - 1]], vertex[order[i]]);
    first[order[i]] = repeats ? first[order[i - 1]] : order[i];
  }
  for (auto& face : faces)
    for (std::int32_t& i : face) i = first[i];
}

std::size_t most_faces_at_an_edge(const FaceList& faces) {
  std::vector<Edge> edges;
  for (const auto& face : faces)
    for (std::size_t k = 0; k < face.size(); ++k)
      if (const std::int32_t a = face[k], b = face[(k + 1) % face.size()]; a != b)
        edges.emplace_back(std::min(a, b), std::max(a, b));
  std::sort(edges.begin(), edges.end());
  std::size_t most = 0;
  for (std::size_t first = 0; first < edges.size();) {
    std::size_t next = first;
    while (next < edges.size() && edges[next] == edges[first]) ++next;
    most = std::max(most, next - first);
    first = next;
  }
  return most;
}

std::vector<std::vector<int>> solids_of(const std::vector<Vec3>& vertex, const FaceList& faces) {
  return Surfaces(vertex, faces).solids();
}

}  // namespace wythe::geometry
