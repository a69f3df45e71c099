// The overlap of two bodies is the largest depth of any pair of their convex parts. A depth is the minimum over separating
// axes: normals of both parts, then cross products of their edges. The tolerance grows by the warps of both bodies. A body
// is supported if joints connect it to a fixed one.
#include "geometry/bodies/body_checks.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <fmt/format.h>

#include "core/limits.h"
#include "geometry/bodies/convex_parts.h"
#include "geometry/text.h"

namespace wythe::geometry {
namespace {

std::string path_of(const BodySpec& body) { return "wall.blocks." + body.id; }

double surface_of(const BodySpec& body) {
  double sum = 0;
  for (const Polyhedron& part : body.part)
    for (const auto& face : part.face) sum += facet_of(part, face).area;
  return sum;
}

double thickness_of(const BodySpec& body, const SolidMoments& moments) {
  const double surface = surface_of(body);
  return surface > 0 ? 6 * moments.volume / surface : 0;
}

// Largest distance of a body's corners from the planes of its faces.
double warp_of(const BodySpec& body) {
  double worst = 0;
  for (const Polyhedron& part : body.part)
    for (const auto& face : part.face) worst = std::max(worst, facet_of(part, face).warp);
  return worst;
}

// A convex part for the separating-axis test: corners, and directions of faces and edges, each once.
struct Hull {
  std::vector<Vec3> corner, normal, edge;
};

void add_direction(std::vector<Vec3>& list, Vec3 v) {
  const Vec3 u = unit(v);
  if (dot(u, u) == 0) return;
  const auto same = [&](Vec3 w) { return norm(cross(u, w)) < 1e-6; };
  if (std::none_of(list.begin(), list.end(), same)) list.push_back(u);
}

Hull hull_of(const Polyhedron& part) {
  Hull hull;
  hull.corner = part.vertex;
  for (const auto& face : part.face) {
    add_direction(hull.normal, facet_of(part, face).normal);
    for (std::size_t i = 0; i < face.size(); ++i)
      add_direction(hull.edge, part.vertex[face[(i + 1) % face.size()]] - part.vertex[face[i]]);
  }
  return hull;
}

// The shorter displacement along an axis that separates a from b.
double depth_along(const Hull& a, const Hull& b, Vec3 axis) {
  const auto range = [&](const Hull& hull) {
    double low = dot(hull.corner.front(), axis), high = low;
    for (const Vec3 p : hull.corner) {
      low = std::min(low, dot(p, axis));
      high = std::max(high, dot(p, axis));
    }
    return std::pair{low, high};
  };
  const auto [a0, a1] = range(a);
  const auto [b0, b1] = range(b);
  return std::min(a1 - b0, b1 - a0);
}

// Depth of penetration [m]. The search stops once the depth is at most `enough`.
double depth_between(const Hull& a, const Hull& b, double enough) {
  double least = std::numeric_limits<double>::infinity();
  const auto takes = [&](Vec3 axis) {
    least = std::min(least, depth_along(a, b, axis));
    return least <= enough;
  };
  for (const Vec3 n : a.normal)
    if (takes(n)) return least;
  for (const Vec3 n : b.normal)
    if (takes(n)) return least;
  for (const Vec3 p : a.edge)
    for (const Vec3 q : b.edge) {
      const Vec3 axis = cross(p, q);
      if (norm(axis) > 1e-3 && takes(unit(axis))) return least;
    }
  return least;
}

bool same_body(const SpaceAssembly& assembly, int i, int k) {
  const SolidMoments &a = assembly.moments[i], &b = assembly.moments[k];
  const Box3 x = box_of(assembly.body[i]), y = box_of(assembly.body[k]);
  const double close = 1e-3 * x.longest();
  return norm(a.centroid - b.centroid) < close && norm(x.low - y.low) < close &&
         norm(x.high - y.high) < close && std::abs(a.volume - b.volume) < 1e-2 * a.volume;
}

class OverlapCheck {
 public:
  OverlapCheck(const SpaceAssembly& assembly, FaultList& faults)
      : assembly_(assembly), faults_(faults) {
    for (std::size_t i = 0; i < assembly.body.size(); ++i) {
      hulls_.emplace_back();
      for (const Polyhedron& part : assembly.body[i].part) hulls_[i].push_back(hull_of(part));
      thickness_.push_back(thickness_of(assembly.body[i], assembly.moments[i]));
      warp_.push_back(warp_of(assembly.body[i]));
      boxes_.push_back(box_of(assembly.body[i]));
    }
  }

  void run() {
    for (const auto& [i, k] : near_pairs(boxes_, 0)) {
      if (enough(faults_)) return;
      if (assembly_.body[i].fixed && assembly_.body[k].fixed) continue;
      if (!assembly_.span[i].meets(assembly_.span[k])) continue;
      const double most =
          kDeepestOverlap * std::min(thickness_[i], thickness_[k]) + warp_[i] + warp_[k];
      double depth = 0;
      for (const Hull& a : hulls_[i])
        for (const Hull& b : hulls_[k]) depth = std::max(depth, depth_between(a, b, most));
      if (depth > most) refuse(i, k, depth, most);
    }
  }

 private:
  void refuse(int i, int k, double depth, double most) {
    const BodySpec &a = assembly_.body[i], &b = assembly_.body[k];
    if (same_body(assembly_, i, k))
      return add_fault(faults_, path_of(b), "", "is the same body as " + a.id,
                       "leave one of the two out");
    add_fault(faults_, path_of(b), millimetres(depth) + " deep",
              "lies in body " + a.id + ", by more than " + millimetres(most),
              "move them apart; bodies that touch share a plane and no volume");
  }

  const SpaceAssembly& assembly_;
  FaultList& faults_;
  std::vector<std::vector<Hull>> hulls_;
  std::vector<double> thickness_, warp_;
  std::vector<Box3> boxes_;
};

// Sets of bodies that joints connect.
class Groups {
 public:
  explicit Groups(std::size_t n) : above_(n) {
    for (std::size_t i = 0; i < n; ++i) above_[i] = static_cast<int>(i);
  }
  int root(int i) {
    while (above_[i] != i) i = above_[i] = above_[above_[i]];
    return i;
  }
  void join(int a, int b) {
    const int x = root(a), y = root(b);
    above_[std::max(x, y)] = std::min(x, y);
  }

 private:
  std::vector<int> above_;
};

std::string some_of(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t i = 0; i < names.size() && i < 8; ++i) text += (i ? ", " : "") + names[i];
  if (names.size() > 8) text += fmt::format(" and {} more", names.size() - 8);
  return text;
}

}  // namespace

bool prepare_bodies(std::vector<BodySpec>& bodies, std::vector<Message>& notes, FaultList& faults) {
  const std::size_t before = faults.all().size();
  if (bodies.empty()) add_fault(faults, "wall.blocks", "", "there is no body", "list at least one");
  std::set<std::string> seen;
  Preparation preparation;
  for (BodySpec& body : bodies) {
    if (enough(faults)) break;
    if (!seen.insert(body.id).second)
      add_fault(faults, path_of(body), "\"" + body.id + "\"", "two bodies have this id",
                "give every body its own id");
    preparation.take(body, faults);
  }
  preparation.say(notes);
  return faults.all().size() == before;
}

void check_sizes(const SpaceAssembly& assembly, FaultList& faults) {
  std::vector<double> sides;
  for (const BodySpec& body : assembly.body) sides.push_back(box_of(body).longest());
  std::vector<double> sorted = sides;
  std::nth_element(sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2),
                   sorted.end());
  const double median = sorted[sorted.size() / 2];
  for (std::size_t i = 0; i < sides.size() && !enough(faults); ++i) {
    const BodySpec& body = assembly.body[i];
    const double thickness = thickness_of(body, assembly.moments[i]);
    if (sides[i] < kTiniestBody * median)
      add_fault(faults, path_of(body), millimetres(sides[i]) + " long",
                "is tiny beside the other bodies, whose median is " + metres(median) +
                    "; the smallest body determines the time step",
                "leave it out, or join it to a neighbour");
    else if (thickness < kThinnestBody * sides[i])
      add_fault(
          faults, path_of(body), millimetres(thickness) + " thick",
          "is flat: thinner than " + metres(kThinnestBody * sides[i]) + ", 1/500 of its length",
          "give it a thickness, or leave it out");
  }
}

void check_overlaps(const SpaceAssembly& assembly, FaultList& faults) {
  OverlapCheck(assembly, faults).run();
}

void check_support(SpaceAssembly& assembly, FaultList& faults) {
  const auto& body = assembly.body;
  const bool any_fixed =
      std::any_of(body.begin(), body.end(), [](const auto& b) { return b.fixed; });
  if (!any_fixed) {
    assembly.notes.push_back({"space.none_fixed", {{"count", body.size()}}});
    return;
  }
  Groups groups(body.size());
  const auto goes = [&](int i) { return !body[i].cut.empty(); };
  for (const JointFace& face : assembly.faces)  // masonry that a stage cuts out carries nothing
    if (!goes(face.a) && !goes(face.b)) groups.join(face.a, face.b);
  for (const SpaceFrame& frame : assembly.frames)
    for (std::size_t k = 1; k < frame.placed.segments.size(); ++k)
      groups.join(static_cast<int>(frame.first_body), static_cast<int>(frame.first_body + k));
  std::vector<bool> held(body.size(), false);
  for (const SpaceFrame& frame : assembly.frames)
    if (frame.holds_feet()) held[groups.root(static_cast<int>(frame.first_body))] = true;
  for (std::size_t i = 0; i < body.size(); ++i)
    if (body[i].fixed) held[groups.root(static_cast<int>(i))] = true;
  std::vector<std::vector<std::string>> names(body.size());
  for (std::size_t i = 0; i < body.size(); ++i) {
    const int root = groups.root(static_cast<int>(i));
    if (!held[root] && !goes(static_cast<int>(i))) names[root].push_back(body[i].id);
  }
  const std::string lost =
      assembly.lost_faces == 0
          ? ""
          : fmt::format("; {} faces nearly touch and are lost", assembly.lost_faces);
  for (std::size_t i = 0; i < body.size() && !enough(faults); ++i) {
    if (names[i].size() == 1)
      add_fault(faults, path_of(body[i]), "", "touches no other body" + lost,
                "let a face of it lie on a face of its neighbour, or fix it");
    else if (!names[i].empty())
      add_fault(faults, path_of(body[i]), some_of(names[i]),
                "no joint leads from these bodies to a fixed one" + lost,
                "let them touch what carries them, or fix one of them");
  }
}

double depth_of(const Polyhedron& a, const Polyhedron& b) {
  return depth_between(hull_of(a), hull_of(b), -std::numeric_limits<double>::infinity());
}

}  // namespace wythe::geometry
