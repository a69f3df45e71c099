// The honest limit: one step of a plane wall in the paper's law, written by hand for two points a
// face with no engine around it. Same arithmetic as src/dynamics + src/contact (full law: crushing,
// tension, shear with coupled damage, energies; large rotation; local damping), plain arrays of the
// real wall's topology. If it finds a faster way, the engine should take it over.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "contact/law.h"
#include "wythe/model.h"

namespace wythe::bench {

// Everything one joint needs, in one row.
struct BareJoint {
  std::int32_t a, b, material, ground;
  double ax, ay, bx, by, ex, ey, tx, ty, share;
};
struct BarePoint {
  double kappa = 0, crush = 0, plastic = 0, slip = 0, ds = 0;
};
struct BareForce {
  double fx = 0, fy = 0, ma = 0, mb = 0;
};
struct BareBlock {
  double ux, uy, theta, vx, vy, omega, c, s;
};

class BareWall {
 public:
  BareWall(const Model& m, const State& state,
           const std::vector<contact::LawConstants<double>>& law)
      : m_(m), law_(law), force_(static_cast<std::size_t>(m.n_joint)) {
    for (std::size_t j = 0; j < static_cast<std::size_t>(m.n_joint); ++j)
      joint_.push_back({m.joint_a[j], m.joint_b[j], m.joint_material[j], m.joint_a[j] < 0 ? 1 : 0,
                        m.arm_a_x[j], m.arm_a_y[j], m.arm_b_x[j], m.arm_b_y[j], m.half_x[j],
                        m.half_y[j], m.tangent_x[j], m.tangent_y[j], 0.5 * m.area[j]});
    for (std::size_t p = 0; p < static_cast<std::size_t>(m.n_point()); ++p)
      point_.push_back({state.kappa[p], state.crush[p], state.plastic_slip[p], state.slip[p],
                        state.shear_damage[p]});
    for (std::size_t i = 0; i < static_cast<std::size_t>(m.n_block); ++i)
      block_.push_back({state.ux[i], state.uy[i], state.theta[i], state.vx[i], state.vy[i],
                        state.omega[i], std::cos(0.5 * state.theta[i]),
                        std::sin(0.5 * state.theta[i])});
  }

  void step(double dt, double lambda, double gy) {
    for (std::size_t j = 0; j < joint_.size(); ++j) joint(j);
    for (std::size_t i = 0; i < block_.size(); ++i) block(i, dt, lambda, gy);
  }

  double friction = 0, fracture = 0, crushing = 0;

 private:
  // The paper's law with plain branches: closed and intact points leave at once.
  void point(const contact::LawConstants<double>& m, BarePoint& h, double w, double s, double share,
             double& fn, double& ft) {
    double we = w + h.crush;
    const double fc = h.crush > 0 ? m.fc * std::max(0.0, 1 - h.crush * m.inv_p_full) : m.fc;
    const double excess = -m.kn * we - fc;
    if (excess > 0) {
      double p = h.crush + excess * m.crush_gain;
      if (p > m.p_full) p = std::max(h.crush, -w);
      const double after = m.fc * std::max(0.0, 1 - p * m.inv_p_full);
      crushing +=
          share * 0.5 * (fc + after) * (std::min(p, m.p_full) - std::min(h.crush, m.p_full));
      h.crush = p;
      we = w + p;
    }
    const double kappa0 = h.kappa;
    if (we > kappa0) h.kappa = we;
    const double dt = std::min(1.0, std::max(0.0, (h.kappa - m.tension_onset) * m.tension_rate));
    const double left = 1 - dt, ds0 = h.ds;
    double sigma = m.kn * we, inv = 0;
    if (we > 0) {
      inv = 1 / std::max(h.kappa, 1e-30);
      sigma = we * std::min(m.kn, m.ft * left * (1 - ds0) * inv);
    }
    const double sn = -sigma;
    const double residual = we > 0 && left <= 0 ? 0.0 : m.c_res + sn * m.tan_res;
    const double drop = (m.c_drop + sn * m.tan_drop) * left;
    const double rate = std::max(0.0, m.c_drop + std::max(sn, 0.0) * m.tan_drop) * m.half_inv_GII;
    h.ds = std::max(h.ds, std::min(1.0, h.slip * rate));
    double tau = m.ks * (s - h.plastic);
    const double trial = std::fabs(tau);
    const double start = std::max(0.0, residual + drop * (1 - h.ds));
    if (trial > start) {
      double d = (trial - residual - drop * (1 - h.ds)) * m.inv_ks;
      if ((h.slip + d) * rate > h.ds) {
        d = (trial - residual - drop * (1 - h.slip * rate)) / (m.ks - drop * rate);
        if ((h.slip + d) * rate >= 1) d = (trial - residual) * m.inv_ks;
      }
      d = std::max(0.0, std::min(d, trial * m.inv_ks));
      h.slip += d;
      h.plastic += tau > 0 ? d : -d;
      h.ds = std::max(h.ds, std::min(1.0, h.slip * rate));
      tau = m.ks * (s - h.plastic);
      const double work = 0.5 * (start + std::fabs(tau)) * d;
      const double rub = std::min(work, std::max(0.0, residual) * d);
      friction += share * rub;
      fracture += share * (work - rub);
    }
    if (we > 0) {
      const double left0 =
          1 - std::min(1.0, std::max(0.0, (kappa0 - m.tension_onset) * m.tension_rate));
      const double n0 = m.ft * left0 * (1 - ds0), n1 = m.ft * left * (1 - h.ds);
      const double from = std::max(kappa0, std::min(h.kappa, n0 * m.inv_kn));
      const double s0 = std::min(n0, m.kn * from), s1 = std::min(n1, m.kn * h.kappa);
      const double freed = we > kappa0 ? s0 * h.kappa - s1 * from : (s0 - s1) * we * we * inv;
      fracture += share * 0.5 * std::max(0.0, freed);
      sigma = we * std::min(m.kn, n1 * inv);
    }
    fn = sigma * share;
    ft = tau * share;
  }

  void joint(std::size_t j) {
    const BareJoint& q = joint_[j];
    const contact::LawConstants<double>& law = law_[static_cast<std::size_t>(q.material)];
    const BareBlock& B = block_[static_cast<std::size_t>(q.b)];
    const double db = -2 * B.s * B.s, sb = 2 * B.s * B.c;
    const double bx = db * q.bx - sb * q.by, by = sb * q.bx + db * q.by;
    double jx = B.ux + bx, jy = B.uy + by;
    double hx = db * q.ex - sb * q.ey, hy = sb * q.ex + db * q.ey;
    double dx = hx, dy = hy, tx = q.tx, ty = q.ty, ax = 0, ay = 0;
    if (q.ground == 0) {
      const BareBlock& A = block_[static_cast<std::size_t>(q.a)];
      const double da = -2 * A.s * A.s, sa = 2 * A.s * A.c;
      ax = da * q.ax - sa * q.ay;
      ay = sa * q.ax + da * q.ay;
      jx -= A.ux + ax;
      jy -= A.uy + ay;
      const double gx = da * q.ex - sa * q.ey, gy = sa * q.ex + da * q.ey;
      dx -= gx;
      dy -= gy;
      hx = 0.5 * (hx + gx);
      hy = 0.5 * (hy + gy);
      const double c = A.c * B.c - A.s * B.s, s = A.s * B.c + A.c * B.s;
      tx = c * q.tx - s * q.ty;
      ty = s * q.tx + c * q.ty;
    }
    hx += q.ex;
    hy += q.ey;
    const double jn = jy * tx - jx * ty, jt = jx * tx + jy * ty;
    const double dn = dy * tx - dx * ty, dt = dx * tx + dy * ty;
    double n0, t0, n1, t1;
    point(law, point_[2 * j], jn - dn, jt - dt, q.share, n0, t0);
    point(law, point_[2 * j + 1], jn + dn, jt + dt, q.share, n1, t1);
    const double fn = n0 + n1, ft = t0 + t1, gn = n1 - n0, gt = t1 - t0;
    const double fx = ft * tx - fn * ty, fy = ft * ty + fn * tx;
    const double couple = hx * (gt * ty + gn * tx) - hy * (gt * tx - gn * ty);
    BareForce& f = force_[j];
    f.fx = fx;
    f.fy = fy;
    if (q.ground != 0) {
      f.mb = (q.by + by) * fx - (q.bx + bx) * fy - couple;
      return;
    }
    f.ma = (q.ax + ax + 0.5 * jx) * fy - (q.ay + ay + 0.5 * jy) * fx + couple;
    f.mb = (q.by + by - 0.5 * jy) * fx - (q.bx + bx - 0.5 * jx) * fy - couple;
  }

  void block(std::size_t i, double dt, double lambda, double gy) {
    double fx = 0, fy = m_.heavy_mass[i] * gy, fm = 0;
    for (auto e = m_.block_begin[i]; e < m_.block_begin[i + 1]; ++e) {
      const auto entry = m_.block_entry[static_cast<std::size_t>(e)];
      const BareForce& f = force_[static_cast<std::size_t>(entry >> 1)];
      const bool b = (entry & 1) != 0;
      fx += b ? -f.fx : f.fx;
      fy += b ? -f.fy : f.fy;
      fm += b ? f.mb : f.ma;
    }
    BareBlock& q = block_[i];
    const auto damped = [&](double f, double v) {
      return f - lambda * std::fabs(f) * ((v > 0 ? 1.0 : 0.0) - (v < 0 ? 1.0 : 0.0));
    };
    q.vx += dt / m_.mass[i] * damped(fx, q.vx);
    q.vy += dt / m_.mass[i] * damped(fy, q.vy);
    q.omega += dt / m_.inertia[i] * damped(fm, q.omega);
    q.ux += dt * q.vx;
    q.uy += dt * q.vy;
    q.theta += dt * q.omega;
    const double z = 0.25 * q.theta * q.theta, h = 0.5 * q.theta;  // |theta| < 1/4 here
    q.s = h * (1 - z / 6 * (1 - z / 20 * (1 - z / 42 * (1 - z / 72))));
    q.c = 1 - 0.5 * z * (1 - z / 12 * (1 - z / 30 * (1 - z / 56 * (1 - z / 90))));
  }

  const Model& m_;
  const std::vector<contact::LawConstants<double>>& law_;
  std::vector<BareJoint> joint_;
  std::vector<BarePoint> point_;
  std::vector<BareForce> force_;
  std::vector<BareBlock> block_;
};

}  // namespace wythe::bench
