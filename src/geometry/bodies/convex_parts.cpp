// Repairs bodies one by one. Corners are welded only where a surface is not closed. The sign of its volume tells whether
// a closed piece is inside out. A piece that is not convex is cut, and coplanar neighbours become one face. What can't be
// repaired throws a Problem; Preparation::take() turns it into a fault and leaves the body unchanged.
#include "geometry/bodies/convex_parts.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include <fmt/format.h>

#include "geometry/bodies/body_checks.h"
#include "geometry/bodies/mesh_cut.h"
#include "geometry/bodies/pieces.h"
#include "geometry/bodies/polygon_in_space.h"
#include "geometry/bodies/polyhedron.h"
#include "geometry/text.h"

namespace wythe::geometry {
namespace {

using Corners = std::vector<std::int32_t>;
using Edge = std::pair<std::int32_t, std::int32_t>;

std::string shown(Vec3 p) { return fmt::format("({:.4g}, {:.4g}, {:.4g})", p.x, p.y, p.z); }
std::string shown(Vec3 p, Vec3 q) { return shown(p) + " - " + shown(q); }

// A defect of a body, thrown inside this file and caught where the body's id is known.
struct Problem {
  std::string value, problem, cure;
};

// Faces by their edges. On a closed, consistently oriented surface each edge has one face in each direction.
std::map<Edge, std::vector<int>> edges_of(const std::vector<Corners>& faces) {
  std::map<Edge, std::vector<int>> edges;
  for (std::size_t f = 0; f < faces.size(); ++f)
    for (std::size_t i = 0; i < faces[f].size(); ++i)
      edges[{faces[f][i], faces[f][(i + 1) % faces[f].size()]}].push_back(static_cast<int>(f));
  return edges;
}

std::size_t users(const std::map<Edge, std::vector<int>>& edges, Edge edge) {
  const auto found = edges.find(edge);
  return found == edges.end() ? 0 : found->second.size();
}

bool is_closed(const std::vector<Corners>& faces) {
  const auto edges = edges_of(faces);
  return std::all_of(edges.begin(), edges.end(), [&](const auto& edge) {
    const Edge back = {edge.first.second, edge.first.first};
    return edge.second.size() + users(edges, back) == 2;
  });
}

// Removes corners that are named twice in a row, and faces with fewer than three corners.
void drop_idle(std::vector<Corners>& faces) {
  for (Corners& face : faces) {
    face.erase(std::unique(face.begin(), face.end()), face.end());
    while (face.size() > 1 && face.front() == face.back()) face.pop_back();
  }
  std::erase_if(faces, [](const Corners& face) { return face.size() < 3; });
}

// Removes faces that are listed twice in the same orientation. In the opposite one they belong to a neighbour.
bool drop_repeated(std::vector<Corners>& faces) {
  std::set<Corners> seen;
  const std::size_t before = faces.size();
  std::erase_if(faces, [&](const Corners& face) {
    Corners from_least = face;
    std::rotate(from_least.begin(), std::min_element(from_least.begin(), from_least.end()),
                from_least.end());
    return !seen.insert(std::move(from_least)).second;
  });
  return faces.size() < before;
}

// Orients all faces alike: neighbours traverse their common edge in opposite directions. False where that is impossible.
bool turn_alike(std::vector<Corners>& faces, bool& changed) {
  const auto edges = edges_of(faces);
  std::vector<int> turn(faces.size(), 0);  // 1 as listed, -1 reversed
  for (std::size_t first = 0; first < faces.size(); ++first) {
    if (turn[first] != 0) continue;
    turn[first] = 1;
    std::vector<int> queue = {static_cast<int>(first)};
    for (std::size_t q = 0; q < queue.size(); ++q) {
      const int f = queue[q];
      const auto meets = [&](Edge edge, int wanted) {
        const auto found = edges.find(edge);
        if (found == edges.end()) return true;
        for (const int g : found->second) {
          if (g == f) continue;
          if (turn[g] == 0) {
            turn[g] = wanted;
            queue.push_back(g);
          }
          if (turn[g] != wanted) return false;
        }
        return true;
      };
      const Corners& face = faces[f];
      for (std::size_t i = 0; i < face.size(); ++i) {
        const std::int32_t p = face[i], r = face[(i + 1) % face.size()];
        if (!meets({r, p}, turn[f]) || !meets({p, r}, -turn[f])) return false;
      }
    }
  }
  for (std::size_t f = 0; f < faces.size(); ++f)
    if (turn[f] < 0) {
      std::reverse(faces[f].begin(), faces[f].end());
      changed = true;
    }
  return true;
}

// Pieces of a closed surface that share no edge; an open surface is divided as that of a mesh file.
std::vector<std::vector<Corners>> pieces_of(const Polyhedron& part) {
  std::vector<std::vector<Corners>> pieces;
  if (!is_closed(part.face)) {
    for (const std::vector<int>& solid : solids_of(part.vertex, part.face)) {
      pieces.emplace_back();
      for (const int f : solid) pieces.back().push_back(part.face[f]);
    }
    return pieces;
  }
  const auto edges = edges_of(part.face);
  std::vector<bool> taken(part.face.size(), false);
  for (std::size_t first = 0; first < taken.size(); ++first) {
    if (taken[first]) continue;
    std::vector<int> found = {static_cast<int>(first)};
    taken[first] = true;
    const auto take = [&](Edge edge) {
      const auto others = edges.find(edge);
      if (others == edges.end()) return;
      for (const int g : others->second)
        if (!taken[g]) {
          taken[g] = true;
          found.push_back(g);
        }
    };
    for (std::size_t i = 0; i < found.size(); ++i) {
      const Corners& face = part.face[found[i]];
      for (std::size_t k = 0; k < face.size(); ++k) {
        const std::int32_t p = face[k], r = face[(k + 1) % face.size()];
        take({p, r});
        take({r, p});
      }
    }
    std::sort(found.begin(), found.end());
    pieces.emplace_back();
    for (const int f : found) pieces.back().push_back(part.face[f]);
  }
  return pieces;
}

// Keeps only the corners that faces use, in their order; unchanged where all are used.
Polyhedron with_used_corners(const std::vector<Vec3>& vertex, std::vector<Corners> faces) {
  std::vector<std::int32_t> number(vertex.size(), -1);
  for (const Corners& face : faces)
    for (const std::int32_t i : face) number[i] = 0;
  Polyhedron part;
  for (std::size_t i = 0; i < vertex.size(); ++i)
    if (number[i] == 0) {
      number[i] = static_cast<std::int32_t>(part.vertex.size());
      part.vertex.push_back(vertex[i]);
    }
  for (Corners& face : faces)
    for (std::int32_t& i : face) i = number[i];
  part.face = std::move(faces);
  return part;
}

Mesh mesh_of(const Polyhedron& part) {
  Mesh mesh;
  mesh.vertex = part.vertex;
  for (std::size_t f = 0; f < part.face.size(); ++f) {
    const Corners& face = part.face[f];
    std::vector<Vec3> corners;
    for (const std::int32_t i : face) corners.push_back(part.vertex[i]);
    if (face.size() > kMostCorners)
      throw Problem{
          fmt::format("{} corners", face.size()),
          fmt::format("a face of a body that is not convex has at most {} corners", kMostCorners),
          "give the body in convex parts, or with fewer corners"};
    for (const auto& t : triangles_of(corners)) {
      mesh.triangle.push_back({face[t[0]], face[t[1]], face[t[2]]});
      mesh.source.push_back(static_cast<int>(f));
    }
  }
  return mesh;
}

bool is_flat(const Facet& facet) { return facet.warp <= kFlatFace * std::sqrt(facet.area); }

// Whether the whole surface with flattened faces is convex within `close` [m].
bool is_convex(const Polyhedron& part, double close) {
  for (const Corners& face : part.face) {
    const Facet facet = facet_of(part, face);
    if (facet.area == 0) continue;
    if (!is_flat(facet)) return false;
    for (const Vec3 v : part.vertex)
      if (dot(v - facet.centre, facet.normal) > close) return false;
  }
  return true;
}

// --- coplanar neighbours become one face

class FaceJoiner {
 public:
  FaceJoiner(Polyhedron& part, std::vector<int> source)
      : part_(part), source_(std::move(source)), edges_(edges_of(part.face)) {
    for (const Corners& face : part.face) facets_.push_back(facet_of(part, face));
  }

  void run() {
    const auto flat = groups([&](int f, int g) { return is_one(f, g) || is_flat_edge(f, g); });
    const auto alone = groups([&](int f, int g) { return is_flat_edge(f, g); });
    std::vector<Corners> joined;
    bool changed = false;
    for (const std::vector<int>& group : flat) changed = add(group, alone, joined) || changed;
    if (!changed) return;
    drop_straight_corners(joined);
    part_ = with_used_corners(part_.vertex, std::move(joined));
  }

 private:
  [[nodiscard]] bool is_one(int f, int g) const { return source_[f] == source_[g]; }
  [[nodiscard]] bool is_flat_edge(int f, int g) const {
    const Facet &a = facets_[f], &b = facets_[g];
    if (a.area == 0 || b.area == 0) return true;
    return dot(a.normal, b.normal) > 0 && norm(cross(a.normal, b.normal)) <= kFlatEdge;
  }

  // Sets of faces connected through edges where `one` is true; in order of their first face.
  template <class One>
  std::vector<std::vector<int>> groups(One one) const {
    std::vector<bool> taken(part_.face.size(), false);
    std::vector<std::vector<int>> all;
    for (std::size_t first = 0; first < taken.size(); ++first) {
      if (taken[first]) continue;
      taken[first] = true;
      std::vector<int> found = {static_cast<int>(first)};
      for (std::size_t i = 0; i < found.size(); ++i) {
        const Corners& face = part_.face[found[i]];
        for (std::size_t k = 0; k < face.size(); ++k) {
          const auto other = edges_.find({face[(k + 1) % face.size()], face[k]});
          if (other == edges_.end()) continue;
          const int g = other->second.front();
          if (taken[g] || !one(found[i], g)) continue;
          taken[g] = true;
          found.push_back(g);
        }
      }
      std::sort(found.begin(), found.end());
      all.push_back(std::move(found));
    }
    return all;
  }

  // Adds the group as one face; else its coplanar sets, else its faces one by one. True where any were joined.
  bool add(const std::vector<int>& group, const std::vector<std::vector<int>>& alone,
           std::vector<Corners>& joined) const {
    if (group.size() == 1) {
      joined.push_back(part_.face[group.front()]);
      return false;
    }
    if (const Corners one = outline(group); !one.empty()) {
      joined.push_back(one);
      return true;
    }
    bool changed = false;
    for (const std::vector<int>& set : alone) {
      if (!std::binary_search(group.begin(), group.end(), set.front())) continue;
      const Corners one = set.size() > 1 ? outline(set) : Corners{};
      changed = changed || !one.empty();
      if (!one.empty()) joined.push_back(one);
      for (std::size_t i = 0; one.empty() && i < set.size(); ++i)
        joined.push_back(part_.face[set[i]]);
    }
    return changed;
  }

  // The border of a set of faces as one plane convex polygon; empty where it is none.
  [[nodiscard]] Corners outline(const std::vector<int>& set) const {
    std::map<std::int32_t, std::int32_t> next;
    for (const int f : set) {
      const Corners& face = part_.face[f];
      for (std::size_t k = 0; k < face.size(); ++k) {
        const Edge edge = {face[k], face[(k + 1) % face.size()]};
        const int other = edges_.at({edge.second, edge.first}).front();
        if (std::binary_search(set.begin(), set.end(), other)) continue;
        if (!next.emplace(edge).second) return {};
      }
    }
    Corners loop;
    if (next.empty()) return loop;
    const std::int32_t start = next.begin()->first;
    for (std::int32_t v = start;;) {
      loop.push_back(v);
      v = next[v];
      if (v == start) break;
      if (loop.size() > next.size()) return {};
    }
    if (loop.size() != next.size()) return {};
    const Facet facet = facet_of(part_, loop);
    if (facet.area == 0 || !is_flat(facet)) return {};
    const PlaneAxes axes = axes_of(facet.centre, facet.normal);
    Convex flat;
    for (const Vec3 p : facet.corner) flat.push_back(axes.flat(p));
    if (!wythe::geometry::is_convex(flat, kWidestStraight * std::sqrt(facet.area))) return {};
    return loop;
  }

  // Removes corners used by two faces only, where the edge is straight: they lie on one edge of both.
  void drop_straight_corners(std::vector<Corners>& faces) const {
    std::vector<int> uses(part_.vertex.size(), 0);
    for (const Corners& face : faces)
      for (const std::int32_t v : face) ++uses[v];
    std::vector<bool> idle(uses.size(), false);
    for (const Corners& face : faces)
      for (std::size_t i = 0; i < face.size(); ++i) {
        const std::size_t n = face.size();
        const Vec3 p = part_.vertex[face[(i + n - 1) % n]], q = part_.vertex[face[i]],
                   r = part_.vertex[face[(i + 1) % n]];
        const double off = norm(cross(r - p, q - p));
        idle[face[i]] = uses[face[i]] == 2 && off <= kWidestStraight * dot(r - p, r - p);
      }
    for (Corners& face : faces)
      if (face.size() > 3) std::erase_if(face, [&](std::int32_t v) { return idle[v]; });
  }

  static constexpr double kWidestStraight = 1e-4;

  Polyhedron& part_;
  std::vector<int> source_;
  std::map<Edge, std::vector<int>> edges_;
  std::vector<Facet> facets_;
};

std::vector<int> counted(std::size_t n) {
  std::vector<int> numbers(n);
  for (std::size_t i = 0; i < n; ++i) numbers[i] = static_cast<int>(i);
  return numbers;
}

// Faces of one solid: the following search compares them in pairs, which takes a second or two for so many.
constexpr std::size_t kMostOfOneSolid = 10'000;

void check_numbers(const Polyhedron& part) {
  for (const Vec3 v : part.vertex)
    if (!std::isfinite(v.x) || !std::isfinite(v.y) || !std::isfinite(v.z))
      throw Problem{shown(v), "has a corner that is no finite number", "correct the corner"};
  if (part.vertex.size() < 4 || part.face.size() < 4)
    throw Problem{fmt::format("{} corners, {} faces", part.vertex.size(), part.face.size()),
                  "encloses no space", "a solid has at least 4 corners and 4 faces"};
  if (std::max(part.vertex.size(), part.face.size()) > kMostOfOneSolid)
    throw Problem{fmt::format("{} corners, {} faces", part.vertex.size(), part.face.size()),
                  fmt::format("has more than {} corners or faces", kMostOfOneSolid),
                  "simplify its surface, or cut it into blocks (docs/reference/limits.md)"};
  for (const Corners& face : part.face)
    for (const std::int32_t i : face)
      if (i < 0 || static_cast<std::size_t>(i) >= part.vertex.size())
        throw Problem{std::to_string(i), "a face names a corner that is not there",
                      fmt::format("name corners 0 to {}", part.vertex.size() - 1)};
}

void check_closed(const std::vector<Vec3>& vertex, const std::vector<Corners>& all) {
  const auto edges = edges_of(all);
  for (const auto& [edge, faces] : edges) {
    const std::size_t users_of = faces.size() + users(edges, {edge.second, edge.first});
    if (users_of == 2) continue;
    const std::string where = shown(vertex[edge.first], vertex[edge.second]);
    if (users_of == 1)
      throw Problem{where, "is open: this edge has one face only",
                    "close the surface; corners at one place must have the same coordinates"};
    throw Problem{where, fmt::format("touches itself: {} faces meet at this edge", users_of),
                  "give each solid as a body or part of its own"};
  }
}

}  // namespace

// --- one body

class BodyMender {
 public:
  BodyMender(Preparation& all, const std::string& id) : all_(all), id_(id) {}

  std::vector<Polyhedron> mend(const std::vector<Polyhedron>& given) {
    if (given.empty()) throw Problem{"", "has no part", "give it corners and faces"};
    for (const Polyhedron& part : given) take(part);
    for (std::size_t p = 0; p < pieces_.size(); ++p) turn_out(pieces_[p]);
    std::vector<Polyhedron> parts;
    for (Polyhedron& piece : pieces_) add_convex(std::move(piece), parts);
    refuse_nested(parts);
    if (repeated_) all_.repeated_.add(id_);
    if (turned_) all_.turned_.add(id_);
    if (parts.size() > pieces_.size()) {
      all_.cut_.add(id_);
      all_.parts_ += static_cast<int>(parts.size());
    }
    note_faces(parts);
    return parts;
  }

 private:
  // Takes the closed pieces of one given part, consistently oriented.
  void take(const Polyhedron& given) {
    check_numbers(given);
    Polyhedron part = given;
    drop_idle(part.face);
    repeated_ = drop_repeated(part.face) || repeated_;
    if (!is_closed(part.face)) {
      weld_corners(part.vertex, part.face);
      drop_idle(part.face);
      repeated_ = drop_repeated(part.face) || repeated_;
    }
    for (std::vector<Corners>& faces : pieces_of(part)) {
      check_closed(part.vertex, faces);
      if (!turn_alike(faces, turned_))
        throw Problem{"", "has a surface with one side only", "give it as a closed solid"};
      pieces_.push_back(with_used_corners(part.vertex, std::move(faces)));
    }
  }

  void turn_out(Polyhedron& piece) {
    const double volume = solid_moments(piece).volume, size = box_of(piece.vertex).longest();
    if (std::abs(volume) <= 1e-9 * size * size * size)
      throw Problem{fmt::format("{:.3g} m^3", volume), "is flat: it encloses no volume",
                    "give it a thickness, or leave it out"};
    if (volume > 0) return;
    for (const Polyhedron& other : pieces_)
      if (&other != &piece && is_inside(piece, other))
        throw Problem{shown(piece.vertex.front()), "has a hollow inside",
                      "give it as several convex parts"};
    for (Corners& face : piece.face) std::reverse(face.begin(), face.end());
    turned_ = true;
  }

  static bool is_inside(const Polyhedron& a, const Polyhedron& b) {
    const Box3 x = box_of(a.vertex), y = box_of(b.vertex);
    return x.low.x > y.low.x && x.low.y > y.low.y && x.low.z > y.low.z && x.high.x < y.high.x &&
           x.high.y < y.high.y && x.high.z < y.high.z;
  }

  void add_convex(Polyhedron piece, std::vector<Polyhedron>& parts) {
    const double close = kConvexPart * box_of(piece.vertex).longest();
    if (is_convex(piece, close)) {
      FaceJoiner(piece, counted(piece.face.size())).run();
      parts.push_back(std::move(piece));
      return;
    }
    note_bent(piece);
    const Mesh mesh = mesh_of(piece);
    if (const auto edge = crossing_edge(mesh))
      throw Problem{shown((*edge)[0], (*edge)[1]), "runs through itself at this edge",
                    "correct the corners, or give the body as several convex parts"};
    std::vector<Mesh> cut;
    const auto is_done = [close](const Mesh& own) { return is_convex(part_of(own), close); };
    const std::string problem = cut_into_convex(mesh, is_done, cut);
    if (!problem.empty())
      throw Problem{"", "is not convex, and " + problem, "give it as several convex parts"};
    for (const Mesh& own : cut) parts.push_back(part_of(own));
  }

  // A piece of the cut with its coplanar neighbours joined.
  static Polyhedron part_of(const Mesh& mesh) {
    Polyhedron part{mesh.vertex, {}};
    for (const auto& t : mesh.triangle) part.face.push_back({t[0], t[1], t[2]});
    FaceJoiner(part, mesh.source).run();
    return part;
  }

  // Refuses nested parts: their common volume would count twice, as would a hollow listed as a solid.
  static void refuse_nested(const std::vector<Polyhedron>& parts) {
    for (std::size_t i = 0; i < parts.size(); ++i)
      for (std::size_t k = i + 1; k < parts.size(); ++k) {
        const Box3 a = box_of(parts[i].vertex), b = box_of(parts[k].vertex);
        const double most = kDeepestOverlap * std::min(a.longest(), b.longest());
        if (!near(a, b, 0)) continue;
        const double depth = depth_of(parts[i], parts[k]);
        if (depth > most)
          throw Problem{millimetres(depth) + " deep", "has parts or pieces that lie in each other",
                        "parts of a body touch at most; a hollow is made of parts around it"};
      }
  }

  // Notes faces that are bent more than flattening allows.
  void note_bent(const Polyhedron& piece) {
    double worst = 0;
    for (const Corners& face : piece.face) {
      const Facet facet = facet_of(piece, face);
      if (!is_flat(facet)) worst = std::max(worst, facet.warp);
    }
    if (worst == 0) return;
    all_.bent_.add(id_);
    if (worst <= all_.worst_bend_) return;
    all_.worst_bend_ = worst;
    all_.worst_bent_ = id_;
  }

  void note_faces(const std::vector<Polyhedron>& parts) {
    double worst = 0, size = 0;
    for (const Polyhedron& part : parts) {
      size = std::max(size, box_of(part.vertex).longest());
      for (const Corners& face : part.face) worst = std::max(worst, facet_of(part, face).warp);
    }
    if (worst <= 1e-6 * size) return;
    all_.flattened_.add(id_);
    if (worst <= all_.worst_warp_) return;
    all_.worst_warp_ = worst;
    all_.worst_warped_ = id_;
  }

  Preparation& all_;
  const std::string& id_;
  std::vector<Polyhedron> pieces_;
  bool repeated_ = false, turned_ = false;
};

void Preparation::take(BodySpec& body, FaultList& faults) {
  try {
    body.part = BodyMender(*this, body.id).mend(body.part);
  } catch (const Problem& problem) {
    add_fault(faults, "wall.blocks." + body.id, problem.value, problem.problem, problem.cure);
  }
}

void Preparation::say(std::vector<Message>& notes) const {
  const auto add = [&](const char* code, const Count& count, std::vector<Argument> more) {
    if (count.bodies == 0) return;
    std::vector<Argument> arguments = {{"count", count.bodies}, {"body", count.first}};
    for (Argument& argument : more) arguments.push_back(std::move(argument));
    notes.push_back({code, std::move(arguments)});
  };
  add("space.faces_repeated", repeated_, {});
  add("space.bodies_turned", turned_, {});
  add("space.faces_bent", bent_, {{"bend_mm", worst_bend_ * 1e3}, {"worst", worst_bent_}});
  add("space.bodies_cut", cut_, {{"parts", parts_}});
  add("space.faces_flattened", flattened_,
      {{"warp_mm", worst_warp_ * 1e3}, {"worst", worst_warped_}});
}

}  // namespace wythe::geometry
