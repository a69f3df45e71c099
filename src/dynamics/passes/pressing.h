// Pairs of parts in the plane that press along the same face as before, eight at a time. Overlap,
// friction and forces repeat contact/convex_contact.h and PlaneBodies::update_slip() operation by
// operation, so that a pair has the same bits in both places (docs/theory/contacts.md, 13.1 to 13.5).
//
// Data of all pairs lie in rows of four:
//
//   bodies   2 a body      x, y, cosine, sine of its frame; velocity, spin
//   edges    2 an edge     EdgeAxes: origin and axis; normal and length
//   corners  kCornerRows a shape: two corners a row, x beside y; the last corner fills them up
#pragma once

#include <vector>

#include "dynamics/passes/access.h"

namespace wythe::contact {
struct PartEdges;
}

namespace wythe::dynamics {

inline constexpr int kMostCorners = 16, kCornerRows = kMostCorners / 2;

struct PressTables {
  const double *bodies, *edges, *corners;
  double dt;
};

// Eight pairs. A place that is not needed holds a copy of another pair.
struct alignas(64) PressGroup {
  // rows; `ref` is the body that has the face
  std::int32_t ref[kGroup], other[kGroup], edge[kGroup], corners[kGroup];
  int corner_rows = 0;  // needed for the largest of the other parts
  double rest[kGroup], area[kGroup], slip[kGroup];
  double kn[kGroup], ks[kGroup], tan_friction[kGroup], thickness[kGroup];
  // results; `cover` is 0 where nothing presses along this face, and then the rest is invalid
  double cover[kGroup], area_now[kGroup], slip_now[kGroup], pressed[kGroup], stored[kGroup],
      friction[kGroup];
  double fx[kGroup], fy[kGroup], on_other[kGroup], on_ref[kGroup];  // force on `other`, moments
};

template <class Real>
struct Axes2 {  // x, y of a place or direction
  Real x, y;
};

// Eight pairs, computed with Reals of any width.
template <class R>
struct Pressing {
  using Real = R;
  using L = Lanes<Real>;

  const PressTables& t;
  PressGroup& g;
  int lane;  // the first lane that this Real takes

  struct Frame {
    Real x, y, c, s;
  };
  struct Rates {
    Real x, y, spin;
  };
  struct Edge {
    Real x, y, ax, ay, nx, ny, length;
  };
  struct Overlap {
    Real cover, area, moment, side, energy;
  };

  WYTHE_INLINE void run() const {
    const Frame ref = frame_of(g.ref), other = frame_of(g.other);
    const Edge edge = edge_of();
    update_slip(ref, other, edge, overlap(ref, other, edge));
  }

 private:
  [[nodiscard]] WYTHE_INLINE Real in(const double* row) const { return L::load(row + lane); }
  WYTHE_INLINE void out(Real value, double* row) const { L::store(value, row + lane); }
  [[nodiscard]] WYTHE_INLINE Rows<Real> rows(const double* table, const std::int32_t* first,
                                             int row) const {
    std::int32_t id[L::width];
    for (int k = 0; k < L::width; ++k) id[k] = first[lane + k] + row;
    return L::load_rows(table, id);
  }
  [[nodiscard]] WYTHE_INLINE Frame frame_of(const std::int32_t* body) const {
    const Rows<Real> r = rows(t.bodies, body, 0);
    return {r.c0, r.c1, r.c2, r.c3};
  }
  [[nodiscard]] WYTHE_INLINE Rates rates_of(const std::int32_t* body) const {
    const Rows<Real> r = rows(t.bodies, body, 1);
    return {r.c0, r.c1, r.c2};
  }
  [[nodiscard]] WYTHE_INLINE Edge edge_of() const {
    const Rows<Real> a = rows(t.edges, g.edge, 0), b = rows(t.edges, g.edge, 1);
    return {a.c0, a.c1, a.c2, a.c3, b.c0, b.c1, b.c2};
  }
  [[nodiscard]] WYTHE_INLINE static Axes2<Real> turned(const Frame& f, Real x, Real y) {
    return {f.c * x - f.s * y, f.s * x + f.c * y};
  }

  // contact::overlap_on()
  [[nodiscard]] WYTHE_INLINE Overlap overlap(const Frame& a, const Frame& b, const Edge& e) const {
    const Real zero(0.0);
    const Real dx = b.x - a.x, dy = b.y - a.y;
    const Frame seen{a.c * dx + a.s * dy, a.c * dy - a.s * dx, a.c * b.c + a.s * b.s,
                     a.c * b.s - a.s * b.c};
    const Real x0 = e.ax * (seen.x - e.x) + e.ay * (seen.y - e.y);
    const Real y0 = e.nx * (seen.x - e.x) + e.ny * (seen.y - e.y) + in(g.rest);
    const Real xx = e.ax * seen.c + e.ay * seen.s, xy = e.ay * seen.c - e.ax * seen.s;
    const Real yx = e.nx * seen.c + e.ny * seen.s, yy = e.ny * seen.c - e.nx * seen.s;
    Overlap sum{zero, zero, zero, zero, zero};
    Real left = zero, right = zero;
    const Rows<Real> last = rows(t.corners, g.corners, g.corner_rows - 1);
    Axes2<Real> from{x0 + xx * last.c2 + xy * last.c3, y0 + yx * last.c2 + yy * last.c3};
    for (int row = 0; row < g.corner_rows; ++row) {
      const Rows<Real> corner = rows(t.corners, g.corners, row);
      const Axes2<Real> p{x0 + xx * corner.c0 + xy * corner.c1,
                          y0 + yx * corner.c0 + yy * corner.c1};
      const Axes2<Real> q{x0 + xx * corner.c2 + xy * corner.c3,
                          y0 + yx * corner.c2 + yy * corner.c3};
      add_piece(from, p, e.length, left, right, sum);
      add_piece(p, q, e.length, left, right, sum);
      from = q;
    }
    sum.side = Real(0.5) * (right * right - left * left);
    sum.moment = sum.moment + Real(0.5) * (right * right * right - left * left * left);
    return sum;
  }
  WYTHE_INLINE static void add_piece(const Axes2<Real>& from, const Axes2<Real>& to, Real length,
                                     Real& left, Real& right, Overlap& sum) {
    const Real zero(0.0), two(2.0), sixth(1.0 / 6), minus(-1.0);
    Real xa = from.x, ya = from.y, xb = to.x, yb = to.y;
    const auto below = (ya < zero) | (yb < zero), over = (xb > zero) & (xa < length);
    const auto counts = below & (xb > xa) & over;
    if (!any(counts)) return;
    const Real slope = (yb - ya) / (xb - xa);
    const auto before = xa<zero, beyond = xb> length;
    ya = select(before, ya - xa * slope, ya);
    xa = select(before, zero, xa);
    left = select(counts & before, maximum(zero, minus * ya), left);
    yb = select(beyond, yb + (length - xb) * slope, yb);
    xb = select(beyond, length, xb);
    right = select(counts & beyond, maximum(zero, minus * yb), right);
    const auto rises_from = ya > zero, rises_to = yb > zero;
    xa = select(rises_from, xa - ya / slope, xa);
    ya = select(rises_from, zero, ya);
    xb = select(rises_to, xb - yb / slope, xb);
    yb = select(rises_to, zero, yb);
    const Real width = xb - xa, da = minus * ya, db = minus * yb;
    const auto adds = counts & (width > zero);
    const auto add = [&](Real & all, Real more) __attribute__((always_inline)) {
      all = select(adds, all + more, all);
    };
    add(sum.cover, width);
    add(sum.area, Real(0.5) * width * (da + db));
    add(sum.moment, width * sixth * (xa * (two * da + db) + xb * (da + two * db)));
    sum.moment = select(adds, sum.moment - sixth * (db * db * db - da * da * da), sum.moment);
    add(sum.energy, width * sixth * (da * da + da * db + db * db));
  }

  // Arms half a step ago, in the middle of the motion.
  [[nodiscard]] WYTHE_INLINE Axes2<Real> back(const Rates& rates, Real x, Real y) const {
    const Real half = Real(0.5 * t.dt) * rates.spin;
    return {x + half * y, y - half * x};
  }
  // PlaneBodies::update_slip()
  WYTHE_INLINE void update_slip(const Frame& ref, const Frame& other, const Edge& e,
                                const Overlap& overlap) const {
    const Real zero(0.0), half(0.5), minus(-1.0);
    const Rates of_ref = rates_of(g.ref), of_other = rates_of(g.other);
    const Axes2<Real> x = turned(ref, e.ax, e.ay), n = turned(ref, e.nx, e.ny);
    const Real place = select(overlap.area > zero, overlap.moment / overlap.area, zero);
    const Axes2<Real> arm = turned(ref, e.x + e.ax * place, e.y + e.ay * place);
    const Real ox = ref.x + arm.x - other.x, oy = ref.y + arm.y - other.y;
    const Axes2<Real> r = back(of_ref, arm.x, arm.y), o = back(of_other, ox, oy);
    const Axes2<Real> along_then = back(of_ref, x.x, x.y);
    const Real vx = (of_other.x - of_other.spin * o.y) - (of_ref.x - of_ref.spin * r.y);
    const Real vy = (of_other.y + of_other.spin * o.x) - (of_ref.y + of_ref.spin * r.x);

    const Real kn = in(g.kn), ks = in(g.ks), thickness = in(g.thickness);
    const Real k = kn * thickness, normal = k * overlap.area;
    const Real area_before = in(g.area), area = overlap.cover * thickness;
    Real slip = in(g.slip);
    const auto shear_energy = [&](Real over, Real by) __attribute__((always_inline)) {
      return half * ks * over * (by * by);
    };
    const Real energy = shear_energy(area_before, slip), held = ks * area_before * slip;
    const auto grows = (area > area_before) & (area_before > zero);
    slip = select(grows, slip * (area_before / area), slip);
    const Real stiff = ks * area, limit = in(g.tan_friction) * normal;
    const Real slip_step = Real(t.dt) * (vx * along_then.x + vy * along_then.y);
    slip = slip + slip_step;
    const Real trial = stiff * slip;
    slip = select(magnitude(trial) > limit, sign(trial) * limit / stiff, slip);
    const Real energy_now = shear_energy(area, slip);

    const Real along = k * overlap.side - stiff * slip;
    const Real fx = normal * n.x + along * x.x, fy = normal * n.y + along * x.y;
    const Axes2<Real> origin = turned(ref, e.x, e.y);
    const Real moment = k * overlap.moment;
    const Real gx = ref.x + origin.x - other.x, gy = ref.y + origin.y - other.y;
    out(overlap.cover, g.cover);
    out(area, g.area_now);
    out(slip, g.slip_now);
    out(normal, g.pressed);
    out(k * overlap.energy + energy_now, g.stored);
    out(half * (held + stiff * slip) * slip_step + (energy - energy_now), g.friction);
    out(fx, g.fx);
    out(fy, g.fy);
    out(moment + (gx * fy - gy * fx), g.on_other);
    out(minus * (moment + (origin.x * fy - origin.y * fx)), g.on_ref);
  }
};

using PressKernel = void (*)(const PressTables&, PressGroup&);

template <class Real>
void press(const PressTables& tables, PressGroup& group) {
  for (int lane = 0; lane < kGroup; lane += Lanes<Real>::width)
    Pressing<Real>{tables, group, lane}.run();
}

// The kernel for packs of a width, for this processor (executors/kernels.h).
[[nodiscard]] PressKernel press_kernel(int width);
// kCornerRows rows of two corners for each shape. They are not used for a shape with more corners.
[[nodiscard]] std::vector<double> rows_of_corners(const contact::PartEdges& edges);

}  // namespace wythe::dynamics
