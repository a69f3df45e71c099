// Views each facet of the other part along the normal of the reference facet, and clips it at the plane and sides of that
// facet. Over the rest it adds exact integrals (docs/theory/contacts.md, 13.6 and 13.7, without kn). A clipped side
// stores the side that clipped it, for the force of that side. A polygon has room for 64 corners; further ones are
// dropped.
#include "contact/convex_contact_in_space.h"

#include <array>

namespace wythe::contact {
namespace {

Vec vec(const Vec3& v) { return {v.x, v.y, v.z}; }
Vec unit(const Vec& v) { return (1 / square_root(dot(v, v))) * v; }

// A convex polygon about `normal` with each side moved inwards by `inset`, by less where the polygon is small.
std::vector<Vec> inset_of(const std::vector<Vec>& corner, const Vec& normal, double inset) {
  const std::size_t n = corner.size();
  double shortest = 1e300;
  for (std::size_t i = 0; i < n; ++i) {
    const Vec edge = corner[(i + 1) % n] - corner[i];
    shortest = minimum(shortest, square_root(dot(edge, edge)));
  }
  const double by = minimum(inset, 0.1 * shortest);
  std::vector<Vec> out;
  for (std::size_t i = 0; i < n; ++i) {
    const Vec before = unit(corner[i] - corner[(i + n - 1) % n]);
    const Vec after = unit(corner[(i + 1) % n] - corner[i]);
    // corner of both sides moved inwards: displaced by (after - before) / sine of the angle
    const double sine = dot(normal, cross(before, after));
    out.push_back(sine > 1e-6 ? corner[i] + (by / sine) * (after - before)
                              : corner[i] + by * cross(normal, after));
  }
  return out;
}

FacetSide side_of(const Facet& f, const Vec* corner, int k) {
  const int n = f.end - f.begin;
  const Vec p = corner[f.begin + k] - f.origin, q = corner[f.begin + (k + 1) % n] - f.origin;
  const double px = dot(f.x, p), py = dot(f.y, p), qx = dot(f.x, q), qy = dot(f.y, q);
  const double dx = qx - px, dy = qy - py, length = square_root(dx * dx + dy * dy);
  const double nx = dy / length, ny = -dx / length;
  return {nx, ny, nx * px + ny * py};
}

}  // namespace

void SpaceParts::add(const Polyhedron& part, const Vec3& centre, double inset) {
  std::vector<Vec> vertex;
  std::vector<double> key{inset};
  for (const Vec3& v : part.vertex) {
    const Vec seen = vec(v) - vec(centre);
    vertex.push_back({on_grid(seen.x), on_grid(seen.y), on_grid(seen.z)});
    key.insert(key.end(), {vertex.back().x, vertex.back().y, vertex.back().z});
  }
  for (const std::vector<std::int32_t>& face : part.face) {
    key.push_back(static_cast<double>(face.size()));
    key.insert(key.end(), face.begin(), face.end());
  }
  const auto [place, is_new] =
      known.try_emplace(key, static_cast<std::int32_t>(facet_begin.size()) - 1);
  shape.push_back(place->second);
  if (is_new) add_shape(vertex, part, inset);
}

void SpaceParts::add_shape(const std::vector<Vec>& vertex, const Polyhedron& part, double inset) {
  for (const std::vector<std::int32_t>& face : part.face) {
    std::vector<Vec> corners;
    for (const std::int32_t v : face) corners.push_back(vertex[v]);
    Vec area{0, 0, 0}, middle{0, 0, 0};
    for (std::size_t i = 0; i < corners.size(); ++i) {
      area = area + cross(corners[i] - corners[0], corners[(i + 1) % corners.size()] - corners[0]);
      middle = middle + (1.0 / static_cast<double>(corners.size())) * corners[i];
    }
    Facet f;
    f.z = unit(area);
    f.origin = middle;
    const Vec along = corners[1] - corners[0];
    f.x = unit(along - dot(along, f.z) * f.z);
    f.y = cross(f.z, f.x);
    f.begin = static_cast<std::int32_t>(corner.size());
    for (const Vec& c : inset_of(corners, f.z, inset)) corner.push_back(c);
    f.end = static_cast<std::int32_t>(corner.size());
    for (int k = 0; k < f.end - f.begin; ++k) side.push_back(side_of(f, corner.data(), k));
    facet.push_back(f);
  }
  facet_begin.push_back(static_cast<std::int32_t>(facet.size()));
}

SpaceFrame seen_from(const SpaceFrame& a, const SpaceFrame& b) {
  const Quaternion<double> back{a.turn.w, -1.0 * a.turn.v};
  return {turned_back(a.turn, b.at - a.at), back * b.turn};
}

namespace {

// Pose of the other part in the axes of a facet: p = o + r v.
struct FacetView {
  Vec o, rx, ry, rz;

  FacetView(const Facet& f, const SpaceFrame& seen, double inset = 0) {
    const Vec to = seen.at - f.origin;
    o = {dot(f.x, to), dot(f.y, to), dot(f.z, to) + inset};
    rx = turned_back(seen.turn, f.x);
    ry = turned_back(seen.turn, f.y);
    rz = turned_back(seen.turn, f.z);
  }
  [[nodiscard]] double height(const Vec& v) const { return o.z + dot(rz, v); }
  [[nodiscard]] Vec place(const Vec& v) const {
    return {o.x + dot(rx, v), o.y + dot(ry, v), o.z + dot(rz, v)};
  }
};

// A polygon during clipping: its corners, and for the side after each corner which side of the facet it lies on.
constexpr int kMostCorners = 64;
struct Cut {
  std::array<Vec, kMostCorners> corner;
  std::array<int, kMostCorners> side;
  int n = 0;
  void push(const Vec& c, int s) {
    if (n < kMostCorners) corner[n] = c, side[n] = s, ++n;
  }
};

// Keeps the part with level(corner) <= 0; the new side gets `name`. Reads `polygon`, returns it or `room`.
template <class Level>
Cut& cut(Cut& polygon, Cut& room, int name, const Level& level) {
  std::array<double, kMostCorners> levels;
  bool whole = true;
  for (int i = 0; i < polygon.n; ++i) {
    const std::size_t k = i;
    levels[k] = level(polygon.corner[k]);
    whole = whole && levels[k] <= 0;
  }
  if (whole) return polygon;
  room.n = 0;
  for (int i = 0; i < polygon.n; ++i) {
    const std::size_t k = i;
    const std::size_t next = i + 1 == polygon.n ? 0 : i + 1;
    const Vec &p = polygon.corner[k], &q = polygon.corner[next];
    const double lp = levels[k], lq = levels[next];
    const auto crossing = [&] { return p + (lp / (lp - lq)) * (q - p); };
    if (lp <= 0) {
      room.push(p, polygon.side[k]);
      if (lq > 0) room.push(crossing(), name);  // from here along the cut
    } else if (lq < 0) {
      room.push(crossing(), polygon.side[k]);
    }
  }
  return room;
}

// Sums over the covered area, for its spread.
struct Cover {
  double x = 0, y = 0, square = 0;
};

// Adds a polygon below the facet, seen along z; (nx, ny, nz) is its own normal.
void add_piece(const Cut& polygon, const Vec& normal, SpaceOverlap& sum, Cover& cover) {
  double squares = 0;
  for (int i = 1; i + 1 < polygon.n; ++i) {
    const Vec &a = polygon.corner[0], &b = polygon.corner[i], &c = polygon.corner[i + 1];
    // its normal points down: clockwise seen from above
    const double area = -0.5 * ((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x));
    const double da = -a.z, db = -b.z, dc = -c.z, all = da + db + dc;
    const double xs = a.x + b.x + c.x, ys = a.y + b.y + c.y;
    sum.cover += area;
    sum.force.z += area * all / 3;
    const double square = area * (da * da + db * db + dc * dc + da * db + db * dc + dc * da) / 6;
    squares += square;
    sum.moment.x += area / 12 * (ys * all + a.y * da + b.y * db + c.y * dc);
    sum.moment.y -= area / 12 * (xs * all + a.x * da + b.x * db + c.x * dc);
    cover.x += area * xs / 3;
    cover.y += area * ys / 3;
    cover.square +=
        area / 12 *
        (xs * xs + a.x * a.x + b.x * b.x + c.x * c.x + ys * ys + a.y * a.y + b.y * b.y + c.y * c.y);
  }
  sum.energy += 0.5 * squares;
  // a tilted facet inclines its force: d = -z, dd/dx = nx / nz
  sum.moment.x -= 0.5 * squares * (normal.y / normal.z);
  sum.moment.y += 0.5 * squares * (normal.x / normal.z);
}

// Adds the force of the facet's sides on what extends beyond them.
void add_side(const Vec& p, const Vec& q, const FacetSide& side, SpaceOverlap& sum) {
  const double dx = q.x - p.x, dy = q.y - p.y, length = square_root(dx * dx + dy * dy);
  const double d0 = -p.z, d1 = -q.z;
  const double second = length * (d0 * d0 + d0 * d1 + d1 * d1) / 6;
  const double third = length * (d0 * d0 * d0 + d0 * d0 * d1 + d0 * d1 * d1 + d1 * d1 * d1) / 8;
  const double w0 = length * (3 * d0 * d0 + 2 * d0 * d1 + d1 * d1) / 24;
  const double w1 = length * (d0 * d0 + 2 * d0 * d1 + 3 * d1 * d1) / 24;
  sum.force.x += side.nx * second;
  sum.force.y += side.ny * second;
  sum.moment.x += side.ny * third;
  sum.moment.y -= side.nx * third;
  sum.moment.z += (p.x * w0 + q.x * w1) * side.ny - (p.y * w0 + q.y * w1) * side.nx;
}

}  // namespace

SpaceOverlap overlap_on(const SpacePart& ref, int number, const SpacePart& other,
                        const SpaceFrame& seen, double inset, bool with_polygon) {
  const Facet& facet = ref.facet[number];
  const FacetSide* const side = ref.side + facet.begin;
  const FacetView view(facet, seen, inset);
  SpaceOverlap sum;
  sum.lowest = 1e300;
  Cover cover;
  double largest = 0;
  const int sides = facet.end - facet.begin;
  Cut pieces[2];
  for (int g = 0; g < other.facets; ++g) {
    const Facet& face = other.facet[g];
    double lowest = 1e300;
    for (auto c = face.begin; c < face.end; ++c)
      lowest = minimum(lowest, view.height(other.corner[c]));
    sum.lowest = minimum(sum.lowest, lowest);
    if (!(lowest < 0)) continue;
    const Vec normal{dot(view.rx, face.z), dot(view.ry, face.z), dot(view.rz, face.z)};
    if (!(normal.z < -1e-9)) continue;
    Cut* piece = &pieces[0];
    piece->n = 0;
    for (auto c = face.begin; c < face.end; ++c) piece->push(view.place(other.corner[c]), -1);
    const auto keep = [&](int name, const auto& level) {
      piece = &cut(*piece, pieces[piece == &pieces[0] ? 1 : 0], name, level);
    };
    keep(-2, [](const Vec& p) { return p.z; });
    for (int k = 0; k < sides && piece->n > 2; ++k)
      keep(k, [&](const Vec& p) { return side[k].level(p); });
    const Cut& polygon = *piece;
    if (polygon.n < 3) continue;
    const double before = sum.cover;
    add_piece(polygon, normal, sum, cover);
    for (int i = 0; i < polygon.n; ++i)
      if (const int k = polygon.side[i]; k >= 0)
        add_side(polygon.corner[i], polygon.corner[i + 1 == polygon.n ? 0 : i + 1], side[k], sum);
    if (with_polygon && sum.cover - before > largest) {
      largest = sum.cover - before;
      sum.polygon.assign(polygon.corner.begin(), polygon.corner.begin() + polygon.n);
    }
  }
  if (sum.cover > 0)
    sum.spread = maximum(0.0, cover.square / sum.cover - (cover.x * cover.x + cover.y * cover.y) /
                                                             (sum.cover * sum.cover));
  return sum;
}

double lowest_over(const SpacePart& ref, int facet, const SpacePart& other,
                   const SpaceFrame& seen) {
  const FacetView view(ref.facet[facet], seen);
  const auto first = other.facet[0].begin, last = other.facet[other.facets - 1].end;
  double lowest = 1e300;
  for (auto c = first; c < last; ++c) lowest = minimum(lowest, view.height(other.corner[c]));
  return lowest;
}

Separation separation_of(const SpacePart& ref, const SpacePart& other, const SpaceFrame& seen) {
  Separation best;
  for (int e = 0; e < ref.facets; ++e)
    if (const double lowest = lowest_over(ref, e, other, seen); lowest > best.distance)
      best = {lowest, e};
  return best;
}

Face face_of(const SpacePart& a, const SpacePart& b, const SpaceFrame& b_from_a,
             const SpaceFrame& a_from_b, std::int32_t last, double slop) {
  const Separation of_a = separation_of(a, b, b_from_a), of_b = separation_of(b, a, a_from_b);
  Face best{of_a.distance, of_a.edge};
  // the separation test must not depend on the slop
  const bool parts = of_b.distance >= 0 && of_b.distance > of_a.distance;
  if (parts || of_b.distance > of_a.distance + slop) best = {of_b.distance, -1 - of_b.edge};
  if (last == kNoFeature || last == best.feature) return best;
  const double kept =
      last >= 0 ? lowest_over(a, last, b, b_from_a) : lowest_over(b, -1 - last, a, a_from_b);
  return kept + slop >= best.distance ? Face{kept, last} : best;
}

}  // namespace wythe::contact
