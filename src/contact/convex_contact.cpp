// Clips the lower side of the other part to the edge, piece by piece, and adds exact integrals (docs/theory/contacts.md,
// 13.1 to 13.4, without kn t). The face changes only if another is better by `slop`; whether the parts touch at all
// does not depend on that. Feature e >= 0 is edge e of a, and -1 - e is edge e of b. Parts of equal outline share
// corners.
#include "contact/convex_contact.h"

#include <map>

namespace wythe::contact {

PartEdges::PartEdges(const FreeShapes& shapes) {
  std::map<std::vector<double>, Range> known;
  for (std::size_t part = 0; part + 1 < shapes.corner_begin.size(); ++part) {
    const std::size_t first = shapes.corner_begin[part];
    const std::size_t last = shapes.corner_begin[part + 1];
    std::vector<double> outline;
    for (std::size_t i = first; i < last; ++i) {
      outline.push_back(shapes.corner_x[i]);
      outline.push_back(shapes.corner_y[i]);
    }
    const Range fresh{static_cast<std::int32_t>(edge.size()),
                      static_cast<std::int32_t>(last - first),
                      static_cast<std::int32_t>(shape.size())};
    const auto [place, is_new] = known.try_emplace(outline, fresh);
    range.push_back(place->second);
    if (!is_new) continue;
    shape.push_back(fresh);
    corner.insert(corner.end(), outline.begin(), outline.end());
    for (std::size_t i = first; i < last; ++i) {
      const std::size_t next = i + 1 == last ? first : i + 1;
      const double x = shapes.corner_x[next], y = shapes.corner_y[next];
      const double dx = x - shapes.corner_x[i], dy = y - shapes.corner_y[i];
      const double length = square_root(dx * dx + dy * dy);
      const double tx = dx / length, ty = dy / length;
      edge.push_back({x, y, -tx, -ty, ty, -tx, length});
    }
  }
}

namespace {

// Corners of `other` in the axes of an edge of `ref`: x = x0 + xx vx + xy vy, and so on.
struct EdgeView {
  double x0, y0, xx, xy, yx, yy, length;

  EdgeView(const EdgeAxes& e, const BodyFrame& seen, double inset = 0)
      : x0(e.ax * (seen.x - e.x) + e.ay * (seen.y - e.y)),
        y0(e.nx * (seen.x - e.x) + e.ny * (seen.y - e.y) + inset),
        xx(e.ax * seen.c + e.ay * seen.s),
        xy(e.ay * seen.c - e.ax * seen.s),
        yx(e.nx * seen.c + e.ny * seen.s),
        yy(e.ny * seen.c - e.nx * seen.s),
        length(e.length) {}
  [[nodiscard]] WYTHE_INLINE double x(double vx, double vy) const { return x0 + xx * vx + xy * vy; }
  [[nodiscard]] WYTHE_INLINE double y(double vx, double vy) const { return y0 + yx * vx + yy * vy; }
};

// Adds a piece of the other part's lower side from (xa, ya) to (xb, yb), xa < xb.
WYTHE_INLINE void add_piece(double xa, double ya, double xb, double yb, double length, double& left,
                            double& right, Overlap& sum) {
  const double slope = (yb - ya) / (xb - xa);
  // clip what lies beyond the ends of the edge
  if (xa < 0) ya = ya - xa * slope, xa = 0, left = maximum(0.0, -ya);
  if (xb > length) yb = yb + (length - xb) * slope, xb = length, right = maximum(0.0, -yb);
  // and what lies above it
  if (ya > 0) xa = xa - ya / slope, ya = 0;
  if (yb > 0) xb = xb - yb / slope, yb = 0;
  const double width = xb - xa;
  if (!(width > 0)) return;
  const double da = -ya, db = -yb;
  sum.cover += width;
  sum.area += 0.5 * width * (da + db);
  sum.moment += width * (1.0 / 6) * (xa * (2 * da + db) + xb * (da + 2 * db));
  sum.moment -= (1.0 / 6) * (db * db * db - da * da * da);  // a sloping piece inclines its force
  sum.energy += width * (1.0 / 6) * (da * da + da * db + db * db);
}

}  // namespace

Overlap overlap_on(const Part& ref, int edge, const Part& other, const BodyFrame& seen,
                   double inset) {
  const EdgeView view(axes_of(ref, edge), seen, inset);
  Overlap sum{std::numeric_limits<double>::infinity(), 0, 0, 0, 0, 0};
  const int last = other.corners - 1;
  const auto height = [&](int i) { return view.y(other.corner[2 * i], other.corner[2 * i + 1]); };
  for (int i = 0; i <= last; ++i) sum.lowest = minimum(sum.lowest, height(i));
  if (!(sum.lowest < 0)) return sum;
  double left = 0, right = 0, ya = height(last);
  for (int a = last, b = 0; b <= last; a = b++) {
    const double yb = height(b);
    if (ya < 0 || yb < 0) {
      const double xa = view.x(other.corner[2 * a], other.corner[2 * a + 1]);
      const double xb = view.x(other.corner[2 * b], other.corner[2 * b + 1]);
      const bool faces = xb > xa, over = xb > 0 && xa < view.length;
      if (faces && over) add_piece(xa, ya, xb, yb, view.length, left, right, sum);
    }
    ya = yb;
  }
  sum.side = 0.5 * (right * right - left * left);
  sum.moment += 0.5 * (right * right * right - left * left * left);
  return sum;
}

Separation separation_of(const Part& ref, const Part& other, const BodyFrame& seen) {
  Separation best;
  for (int e = 0; e < ref.corners; ++e) {
    const EdgeView view(axes_of(ref, e), seen);
    double lowest = std::numeric_limits<double>::infinity();
    for (int i = 0; i < other.corners; ++i)
      lowest = minimum(lowest, view.y(other.corner[2 * i], other.corner[2 * i + 1]));
    if (lowest > best.distance) best = {lowest, e};
  }
  return best;
}

Face face_of(const Part& a, const Part& b, const BodyFrame& b_from_a, const BodyFrame& a_from_b,
             std::int32_t last, double slop) {
  const Separation of_a = separation_of(a, b, b_from_a), of_b = separation_of(b, a, a_from_b);
  Face best{of_a.distance, of_a.edge};
  // the separation test must not depend on the slop
  const bool parts = of_b.distance >= 0 && of_b.distance > of_a.distance;
  if (parts || of_b.distance > of_a.distance + slop) best = {of_b.distance, -1 - of_b.edge};
  if (last == kNoFeature || last == best.feature) return best;
  const double kept = last >= 0 ? overlap_on(a, last, b, b_from_a).lowest
                                : overlap_on(b, -1 - last, a, a_from_b).lowest;
  return kept + slop >= best.distance ? Face{kept, last} : best;
}

FreeLaw free_law(const LawConstants<double>& law, double thickness) {
  return {law.kn, law.ks, law.tan_res, thickness};
}

}  // namespace wythe::contact
