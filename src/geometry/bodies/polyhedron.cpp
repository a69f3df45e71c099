// Sums exact integrals over tetrahedra (docs/theory/space.md, "Mass and inertia"). They start from a corner of the
// body, since a distant origin would cost digits. The normal of a facet is Newell's sum about the mean of its corners.
#include "geometry/bodies/polyhedron.h"

#include <algorithm>

namespace wythe::geometry {
namespace {

// Sums over tetrahedra from the origin: volume, first and second moments (xx yy zz xy xz yz).
struct Sums {
  double volume = 0;
  Vec3 first;
  std::array<double, 6> second{};

  // Integrals over the tetrahedron (0, a, b, c): V = a . (b x c) / 6, int x = V (a + b + c) / 4,
  // int x y = V / 20 (sum of products of the corners + product of their sums).
  void add(Vec3 a, Vec3 b, Vec3 c) {
    const double v = dot(a, cross(b, c)) / 6;
    const Vec3 s = a + b + c;
    volume += v;
    first = first + (v / 4) * s;
    const double w = v / 20;
    second[0] += w * (a.x * a.x + b.x * b.x + c.x * c.x + s.x * s.x);
    second[1] += w * (a.y * a.y + b.y * b.y + c.y * c.y + s.y * s.y);
    second[2] += w * (a.z * a.z + b.z * b.z + c.z * c.z + s.z * s.z);
    second[3] += w * (a.x * a.y + b.x * b.y + c.x * c.y + s.x * s.y);
    second[4] += w * (a.x * a.z + b.x * b.z + c.x * c.z + s.x * s.z);
    second[5] += w * (a.y * a.z + b.y * b.z + c.y * c.z + s.y * s.z);
  }

  void add(const Polyhedron& part, Vec3 origin) {
    std::vector<Vec3> corner;
    for (const std::vector<std::int32_t>& face : part.face) {
      corner.clear();
      for (const std::int32_t i : face) corner.push_back(part.vertex[i] - origin);
      if (corner.size() == 3) {
        add(corner[0], corner[1], corner[2]);
        continue;
      }
      const Vec3 middle = mean(corner);
      for (std::size_t i = 0; i < corner.size(); ++i)
        add(middle, corner[i], corner[(i + 1) % corner.size()]);
    }
  }

  [[nodiscard]] SolidMoments about(Vec3 origin) const {
    SolidMoments m;
    m.volume = volume;
    if (volume == 0) return m;
    const Vec3 c = first / volume;
    m.centroid = origin + c;
    const double xx = second[0] - volume * c.x * c.x, yy = second[1] - volume * c.y * c.y,
                 zz = second[2] - volume * c.z * c.z;
    m.inertia = {yy + zz,
                 xx + zz,
                 xx + yy,
                 volume * c.x * c.y - second[3],
                 volume * c.x * c.z - second[4],
                 volume * c.y * c.z - second[5]};
    return m;
  }
};

Vec3 least(Vec3 a, Vec3 b) { return {std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)}; }
Vec3 most(Vec3 a, Vec3 b) { return {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)}; }

}  // namespace

SolidMoments solid_moments(const BodySpec& body) {
  Sums sums;
  Vec3 origin;  // near the body, so that a distant body keeps its digits
  for (const Polyhedron& part : body.part)
    if (!part.vertex.empty()) {
      origin = part.vertex.front();
      break;
    }
  for (const Polyhedron& part : body.part) sums.add(part, origin);
  return sums.about(origin);
}

SolidMoments solid_moments(const Polyhedron& part) {
  Sums sums;
  const Vec3 origin = part.vertex.empty() ? Vec3{} : part.vertex.front();
  sums.add(part, origin);
  return sums.about(origin);
}

Facet measured(std::vector<Vec3> corners) {
  Facet f;
  f.corner = std::move(corners);
  const std::size_t n = f.corner.size();
  const Vec3 middle = mean(f.corner);
  Vec3 twice;
  for (std::size_t i = 0; i < n; ++i)
    twice = twice + cross(f.corner[i] - middle, f.corner[(i + 1) % n] - middle);
  f.area = norm(twice) / 2;
  f.normal = unit(twice);
  f.centre = middle;
  if (f.area > 0) {
    Vec3 shift;
    for (std::size_t i = 0; i < n; ++i) {
      const Vec3 p = f.corner[i] - middle, q = f.corner[(i + 1) % n] - middle;
      shift = shift + (dot(cross(p, q), f.normal) / 6) * (p + q);
    }
    f.centre = middle + shift / f.area;
  }
  for (const Vec3 p : f.corner) f.warp = std::max(f.warp, std::abs(dot(p - middle, f.normal)));
  return f;
}

Facet facet_of(const Polyhedron& part, std::span<const std::int32_t> corners) {
  std::vector<Vec3> at;
  at.reserve(corners.size());
  for (const std::int32_t i : corners) at.push_back(part.vertex[i]);
  return measured(std::move(at));
}

Box3 box_of(std::span<const Vec3> points) {
  Box3 box;
  if (points.empty()) return box;
  box.low = box.high = points.front();
  for (const Vec3 p : points) {
    box.low = least(box.low, p);
    box.high = most(box.high, p);
  }
  return box;
}

Box3 box_of(const BodySpec& body) {
  Box3 box;
  bool first = true;
  for (const Polyhedron& part : body.part) {
    if (part.vertex.empty()) continue;
    const Box3 own = box_of(part.vertex);
    box = first ? own : join(box, own);
    first = false;
  }
  return box;
}

Box3 join(const Box3& a, const Box3& b) { return {least(a.low, b.low), most(a.high, b.high)}; }

bool near(const Box3& a, const Box3& b, double margin) {
  return a.low.x <= b.high.x + margin && b.low.x <= a.high.x + margin &&
         a.low.y <= b.high.y + margin && b.low.y <= a.high.y + margin &&
         a.low.z <= b.high.z + margin && b.low.z <= a.high.z + margin;
}

}  // namespace wythe::geometry
