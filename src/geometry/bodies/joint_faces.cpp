// Projects facing facets of near bodies into their mean plane and computes their common parts; those of one pair of bodies are
// united. A common part covers both faces. Faces between parts of one body cover each other without a joint, and so do faces of
// fixed bodies. Uncovered areas become outer faces. Slivers and narrow gaps count as lost, with one note for all.
#include "geometry/bodies/joint_faces.h"

#include <algorithm>
#include <cmath>

#include "geometry/bodies/body_checks.h"
#include "geometry/bodies/polygon_in_space.h"

namespace wythe::geometry {
namespace {

struct Face {
  int part = 0;
  Facet facet;
  Box3 box;
  PlaneAxes axes;
  std::vector<Convex> free;  // uncovered area, in `axes`; not used while `whole`
  bool whole = true;

  // Removes the area under a polygon that is (nearly) in this plane.
  void cover(const std::vector<Vec3>& polygon, double tolerance) {
    if (whole) free = {flat_corners()};
    whole = false;
    Convex shadow;
    for (const Vec3 p : polygon) shadow.push_back(axes.flat(p));
    if (area_of(shadow) < 0) std::reverse(shadow.begin(), shadow.end());
    std::vector<Convex> left;
    for (const Convex& piece : free) {
      if (common_part(piece, shadow, tolerance).empty()) {
        left.push_back(piece);
        continue;
      }
      for (Convex& rest : rest_of(piece, shadow, tolerance)) left.push_back(std::move(rest));
    }
    free = std::move(left);
  }
  [[nodiscard]] Convex flat_corners() const {
    Convex corners;
    for (const Vec3 p : facet.corner) corners.push_back(axes.flat(p));
    return corners;
  }
};

struct Piece {
  std::vector<Vec3> polygon;
  Vec3 normal;
};

struct Overlap {
  enum Kind { kNone, kLost, kTouch } kind = kNone;
  Piece piece;
  double gap = 0;  // largest distance at a corner [m], of lost faces
};

// Distance of the plane of `face` from a point of the mean plane, along the normal of the latter.
double height_of(const Facet& face, Vec3 point, Vec3 normal) {
  return dot(face.centre - point, face.normal) / dot(normal, face.normal);
}

Overlap overlap_of(const Facet& a, const Facet& b, double finest) {
  Overlap found;
  if (dot(a.normal, b.normal) >= 0 || norm(cross(a.normal, b.normal)) > kParallelFaces)
    return found;
  const double size = std::sqrt(std::min(a.area, b.area));
  const double touch = std::max(finest, kWidestTouch * size);
  const Vec3 normal = unit(a.normal - b.normal);
  const PlaneAxes axes = axes_of(a.centre, normal);
  if (std::abs(height_of(b, a.centre, normal)) >
      kWidestMiss * size + touch + std::sqrt(a.area) * kParallelFaces)
    return found;
  Convex pa, pb;
  for (const Vec3 p : a.corner) pa.push_back(axes.flat(p));
  for (auto p = b.corner.rbegin(); p != b.corner.rend(); ++p) pb.push_back(axes.flat(*p));
  const Convex common = common_part(pa, pb, 1e-3 * finest);
  if (common.empty() || breadth_of(common) <= touch) return found;

  double widest = 0;
  for (const Vec2 p : common) {
    const Vec3 at = axes.raised(p);
    widest = std::max(widest, std::abs(height_of(b, at, normal) - height_of(a, at, normal)));
  }
  if (widest > std::max(kWidestMiss * size, touch)) return found;
  found.gap = widest;
  const bool sliver = area_of(common) < kSliverFace * std::min(a.area, b.area);
  found.kind = sliver || widest > touch ? Overlap::kLost : Overlap::kTouch;
  if (found.kind == Overlap::kLost) return found;
  const Vec3 middle = axes.raised(centroid_of(common));
  const double level = (height_of(a, middle, normal) + height_of(b, middle, normal)) / 2;
  found.piece.normal = normal;
  for (const Vec2 p : common) found.piece.polygon.push_back(axes.raised(p, level));
  return found;
}

// Unites two coplanar polygons that share an edge and are convex together.
bool unite(Piece& a, const Piece& b, double tolerance) {
  if (dot(a.normal, b.normal) <= 0 || norm(cross(a.normal, b.normal)) > kWidestTouch) return false;
  const PlaneAxes axes = axes_of(a.polygon.front(), a.normal);
  Convex pa, pb;
  for (const Vec3 p : a.polygon) pa.push_back(axes.flat(p));
  for (const Vec3 p : b.polygon) {
    if (std::abs(dot(p - axes.origin, axes.normal)) > tolerance) return false;
    pb.push_back(axes.flat(p));
  }
  const auto both = united(pa, pb, tolerance);
  if (!both) return false;
  a.polygon.clear();
  for (const Vec2 p : *both) a.polygon.push_back(axes.raised(p));
  return true;
}

void unite_all(std::vector<Piece>& pieces, double tolerance) {
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t i = 0; i < pieces.size(); ++i)
      for (std::size_t k = i + 1; k < pieces.size(); ++k)
        if (unite(pieces[i], pieces[k], tolerance)) {
          pieces.erase(pieces.begin() + static_cast<std::ptrdiff_t>(k));
          changed = true;
          --k;
        }
  }
}

class FaceFinder {
 public:
  explicit FaceFinder(SpaceAssembly& out) : out_(out), size_(model_size(out.body)) {
    faces_.resize(out.body.size());
    for (std::size_t i = 0; i < out.body.size(); ++i) take_faces(out.body[i], faces_[i]);
  }

  void run() {
    for (std::vector<Face>& own : faces_) cover_inner_faces(own);
    std::vector<Box3> boxes;
    for (const BodySpec& body : out_.body) boxes.push_back(box_of(body));
    for (const auto& [i, k] : near_pairs(boxes, 2 * widest_miss())) match(i, k);
    std::stable_sort(out_.faces.begin(), out_.faces.end(), [](const auto& x, const auto& y) {
      return x.a != y.a ? x.a < y.a : x.b < y.b;
    });
    for (std::size_t i = 0; i < faces_.size(); ++i)
      for (const Face& face : faces_[i]) add_outer(static_cast<int>(i), face);
    if (out_.lost_faces > 0) say_lost();
  }

 private:
  [[nodiscard]] double finest() const { return kFinestTouch * size_; }
  [[nodiscard]] double widest_miss() const { return kWidestMiss * widest_face_; }

  void take_faces(const BodySpec& body, std::vector<Face>& faces) {
    for (std::size_t p = 0; p < body.part.size(); ++p)
      for (const auto& corners : body.part[p].face) {
        Face face;
        face.part = static_cast<int>(p);
        face.facet = facet_of(body.part[p], corners);
        if (face.facet.area == 0) continue;
        face.box = box_of(face.facet.corner);
        face.axes = axes_of(face.facet.centre, face.facet.normal);
        widest_face_ = std::max(widest_face_, std::sqrt(face.facet.area));
        faces.push_back(std::move(face));
      }
  }

  // Faces between the parts of one body are neither joints nor outer faces.
  void cover_inner_faces(std::vector<Face>& own) {
    for (std::size_t i = 0; i < own.size(); ++i)
      for (std::size_t k = i + 1; k < own.size(); ++k) {
        if (own[i].part == own[k].part || !near(own[i].box, own[k].box, finest())) continue;
        const Overlap inner = overlap_of(own[i].facet, own[k].facet, finest());
        if (inner.kind != Overlap::kTouch) continue;
        own[i].cover(inner.piece.polygon, finest());
        own[k].cover(inner.piece.polygon, finest());
      }
  }

  void match(int i, int k) {
    if (!out_.span[i].meets(out_.span[k]) || are_of_one_frame(i, k)) return;
    const bool swapped = out_.body[k].fixed && !out_.body[i].fixed;
    const bool both_fixed = out_.body[k].fixed && out_.body[i].fixed;
    const int a = swapped ? k : i, b = swapped ? i : k;
    std::vector<Piece> pieces;
    for (Face& fa : faces_[a])
      for (Face& fb : faces_[b]) {
        if (dot(fa.facet.normal, fb.facet.normal) > -0.9) continue;
        if (!near(fa.box, fb.box, 2 * widest_miss())) continue;
        Overlap found = overlap_of(fa.facet, fb.facet, finest());
        if (found.kind == Overlap::kLost && !both_fixed) note_lost(a, b, found.gap);
        if (found.kind != Overlap::kTouch) continue;
        fa.cover(found.piece.polygon, finest());
        fb.cover(found.piece.polygon, finest());
        if (!both_fixed) pieces.push_back(std::move(found.piece));
      }
    unite_all(pieces, finest());
    for (Piece& piece : pieces) add_joint(a, b, std::move(piece));
  }

  [[nodiscard]] bool are_of_one_frame(int i, int k) const {
    if (out_.frames.empty()) return false;
    const int a = frame_of(out_, i), b = frame_of(out_, k);
    if (a >= 0 && b >= 0) return a == b;
    const int frame = std::max(a, b);
    return frame >= 0 && out_.frames[frame].holds_feet() &&
           (out_.body[i].fixed || out_.body[k].fixed);
  }

  void add_joint(int a, int b, Piece piece) {
    const Facet facet = measured(piece.polygon);
    out_.faces.push_back({.a = a,
                          .b = b,
                          .polygon = std::move(piece.polygon),
                          .normal = facet.normal,
                          .centre = facet.centre,
                          .area = facet.area});
  }

  void add_outer(int body, const Face& face) {
    if (face.whole) {
      out_.outer.push_back({body, face.facet.corner, face.facet.normal, face.facet.area});
      return;
    }
    for (const Convex& piece : face.free) {
      const double area = area_of(piece);
      if (area < kSliverFace * face.facet.area) continue;
      OuterFace outer{.body = body, .polygon = {}, .normal = face.facet.normal, .area = area};
      for (const Vec2 p : piece) outer.polygon.push_back(face.axes.raised(p));
      out_.outer.push_back(std::move(outer));
    }
  }

  void note_lost(int a, int b, double gap) {
    ++out_.lost_faces;
    if (gap < lost_gap_) return;
    lost_gap_ = gap;
    lost_a_ = a;
    lost_b_ = b;
  }

  void say_lost() {
    out_.notes.push_back({"space.faces_lost",
                          {{"count", out_.lost_faces},
                           {"a", out_.body[lost_a_].id},
                           {"b", out_.body[lost_b_].id},
                           {"gap_mm", lost_gap_ * 1e3}}});
  }

  SpaceAssembly& out_;
  double size_;
  double widest_face_ = 0;
  std::vector<std::vector<Face>> faces_;
  double lost_gap_ = -1;
  int lost_a_ = 0, lost_b_ = 0;
};

// Stages in which a body stands; unknown names of stages are refused where stages are read.
StageSpan span_of(const BodySpec& body, const std::vector<std::string>& stages) {
  StageSpan span;
  for (std::size_t k = 0; k < stages.size(); ++k) {
    if (!body.put_in.empty() && stages[k] == body.put_in) span.from = static_cast<int>(k);
    if (!body.cut.empty() && stages[k] == body.cut) span.until = static_cast<int>(k);
  }
  return span;
}

double along(Vec3 v, int axis) { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; }

// The axis along which the centres of the boxes spread most.
int widest_axis(const std::vector<Box3>& boxes) {
  Box3 spread;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const Vec3 middle = 0.5 * (boxes[i].low + boxes[i].high);
    const Box3 own{middle, middle};
    spread = i == 0 ? own : join(spread, own);
  }
  const Vec3 d = spread.high - spread.low;
  if (d.x >= d.y && d.x >= d.z) return 0;
  return d.y >= d.z ? 1 : 2;
}

}  // namespace

int frame_of(const SpaceAssembly& assembly, int body) {
  const std::size_t at = body;
  for (std::size_t k = 0; k < assembly.frames.size(); ++k) {
    const SpaceFrame& frame = assembly.frames[k];
    if (at >= frame.first_body && at < frame.first_body + frame.placed.segments.size())
      return static_cast<int>(k);
  }
  return -1;
}

std::vector<std::pair<int, int>> near_pairs(const std::vector<Box3>& boxes, double margin) {
  const int axis = widest_axis(boxes);
  std::vector<int> order(boxes.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<int>(i);
  const auto low = [&](int i) { return along(boxes[i].low, axis); };
  const auto high = [&](int i) { return along(boxes[i].high, axis); };
  std::stable_sort(order.begin(), order.end(), [&](int i, int k) { return low(i) < low(k); });
  std::vector<std::pair<int, int>> pairs;
  for (std::size_t p = 0; p < order.size(); ++p)
    for (std::size_t q = p + 1; q < order.size(); ++q) {
      if (low(order[q]) > high(order[p]) + margin) break;
      const auto [i, k] = std::minmax(order[p], order[q]);
      if (near(boxes[i], boxes[k], margin)) pairs.emplace_back(i, k);
    }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

double model_size(const std::vector<BodySpec>& bodies) {
  Box3 box;
  bool first = true;
  for (const BodySpec& body : bodies) {
    if (body.part.empty()) continue;
    box = first ? box_of(body) : join(box, box_of(body));
    first = false;
  }
  return box.longest();
}

SpaceAssembly assemble(const std::vector<BodySpec>& bodies, FaultList& faults,
                       const std::vector<std::string>& stages, std::vector<SpaceFrame> frames) {
  SpaceAssembly out;
  out.body = bodies;
  out.frames = std::move(frames);
  for (const BodySpec& body : bodies) out.span.push_back(span_of(body, stages));
  if (!prepare_bodies(out.body, out.notes, faults)) return out;
  for (const BodySpec& body : out.body) out.moments.push_back(solid_moments(body));
  check_sizes(out, faults);
  check_overlaps(out, faults);
  FaceFinder(out).run();
  check_support(out, faults);
  return out;
}

}  // namespace wythe::geometry
