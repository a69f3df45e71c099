// point_stresses(): the law evaluated at rest on the present state, for files and pictures.
#include <algorithm>
#include <cmath>

#include "contact/parameters.h"
#include "core/real.h"
#include "wythe/result.h"

namespace wythe {
namespace {

using contact::LawConstants;

// Kinematics of joint j at xi, as in dynamics/passes/joints.h but in plain steps.
struct PointMotion {
  double w, s, x, y;
};

struct Turned {
  double x, y;
};
Turned turn(double angle, double x, double y) {
  const SinCos<double> r = sin_cos(angle);
  return {r.cos * x - r.sin * y, r.sin * x + r.cos * y};
}

PointMotion point_motion(const Model& m, const State& s, std::size_t j, double xi) {
  const auto b = static_cast<std::size_t>(m.joint_b[j]);
  const bool on_ground = m.joint_a[j] == kGroundBlock;
  const double bx0 = m.arm_b_x[j] + xi * m.half_x[j], by0 = m.arm_b_y[j] + xi * m.half_y[j];
  const Turned rb = turn(s.theta[b], bx0, by0);
  const double pbx = s.ux[b] + rb.x - bx0, pby = s.uy[b] + rb.y - by0;
  double pax = 0, pay = 0, phi = 0;
  if (!on_ground) {
    const auto a = static_cast<std::size_t>(m.joint_a[j]);
    const double ax0 = m.arm_a_x[j] + xi * m.half_x[j], ay0 = m.arm_a_y[j] + xi * m.half_y[j];
    const Turned ra = turn(s.theta[a], ax0, ay0);
    pax = s.ux[a] + ra.x - ax0;
    pay = s.uy[a] + ra.y - ay0;
    phi = 0.5 * (s.theta[a] + s.theta[b]);
  }
  const Turned t = turn(phi, m.tangent_x[j], m.tangent_y[j]);
  const double jx = pbx - pax, jy = pby - pay;
  const double x0 = m.centroid_x[b] + bx0, y0 = m.centroid_y[b] + by0;
  const double share = on_ground ? 1.0 : 0.5;
  return {jy * t.x - jx * t.y, jx * t.x + jy * t.y, x0 + pbx - (1 - share) * jx,
          y0 + pby - (1 - share) * jy};
}

}  // namespace

std::vector<PointStress> point_stresses(const Model& m, const State& s) {
  std::vector<LawConstants<double>> law;
  for (const JointMaterial& material : m.materials) law.push_back(contact::constants_of(material));
  std::vector<PointStress> points(static_cast<std::size_t>(m.n_point()));
  for (std::size_t p = 0; p < points.size(); ++p) {
    const std::size_t j = p / static_cast<std::size_t>(m.n_face_point);
    const PointMotion at =
        point_motion(m, s, j, m.point_xi[p % static_cast<std::size_t>(m.n_face_point)]);
    contact::History<double> h{s.kappa[p], s.crush[p],        s.plastic_slip[p],
                               s.slip[p],  s.shear_damage[p], s.tension_set[p]};
    const auto material = static_cast<std::size_t>(m.joint_material[j]);
    const contact::Answer<double> now =
        contact::with_variant(law[material].choice, [&](auto variant) {
          return contact::update<decltype(variant)>(law[material], at.w, at.s, h);
        });
    points[p] = {at.w,
                 at.s,
                 now.sigma,
                 now.tau,
                 now.tension_damage,
                 h.shear_damage,
                 now.damage,
                 std::min(1.0, h.crush * law[material].inv_p_full),
                 at.x,
                 at.y};
  }
  return points;
}

namespace {

// Whether a place on the ground or on a fixed block still has a face under it. The ground of a wall
// without fixed blocks goes on; a fixed block ends.
bool is_on_support(const Anatomy& a, double x, double y) {
  if (a.support_begin.size() < 2) return true;
  bool inside = false;
  for (std::size_t s = 0; s + 1 < a.support_begin.size(); ++s) {
    const auto from = static_cast<std::size_t>(a.support_begin[s]);
    const auto to = static_cast<std::size_t>(a.support_begin[s + 1]);
    for (std::size_t p = from, q = to - 1; p < to; q = p++) {
      const double yp = a.support_y[p], yq = a.support_y[q];
      if ((yp > y) == (yq > y)) continue;
      const double xp = a.support_x[p], xq = a.support_x[q];
      if (x < xp + (y - yp) / (yq - yp) * (xq - xp)) inside = !inside;
    }
  }
  return inside;
}

}  // namespace

bool has_slid_off(const Model& m, const std::vector<PointStress>& points, JointId joint) {
  const auto j = static_cast<std::size_t>(joint);
  const auto per = static_cast<std::size_t>(m.n_face_point);
  if (m.anatomy.joint_kind[j] == JointKind::kLintelChain) return false;  // one piece of timber
  double slip = 0;
  bool pressed = false;
  for (std::size_t k = 0; k < per; ++k) {
    slip += m.point_weight[k] * points[j * per + k].slip;
    pressed = pressed || points[j * per + k].opening < 0;
  }
  const double reach = std::hypot(m.half_x[j], m.half_y[j]);  // half the face
  if (!pressed || std::fabs(slip) <= reach) return false;
  if (m.joint_a[j] != kGroundBlock) return true;
  // into the ground by a hundredth of the face, where the middle of the face is now
  const auto b = static_cast<std::size_t>(m.joint_b[j]);
  const double tx = m.tangent_x[j], ty = m.tangent_y[j], deep = 0.02 * reach;
  return !is_on_support(m.anatomy, m.centroid_x[b] + m.arm_b_x[j] + slip * tx + deep * ty,
                        m.centroid_y[b] + m.arm_b_y[j] + slip * ty - deep * tx);
}

}  // namespace wythe
