// Copies one wall in space from its state to the tables and back, both by each_number(), and contains its loads,
// links, drive and meters. A drive moves blocks in fixed shares, each block alike, or supports. The reaction of
// supports sums joints, free contacts and zones. Works use the mean of the velocities before and after a step.
#include "dynamics/space/wall.h"

#include <algorithm>
#include <cmath>

#include "contact/link.h"
#include "contact/parameters.h"
#include "dynamics/space/zones.h"

namespace wythe::dynamics::space {
namespace {

// Calls act(array of the state, entity, index in the tables) for all numbers that a step keeps of a wall.
template <class S, class Act>
void each_number(const WallView& w, const Model& m, S& s, const Act& act) {
  const Layout& l = *w.layout;
  for (int i = 0; i < m.n_block; ++i) {
    const auto four = [&](auto& array, double* rows, int c) {
      act(array[i], w.column_of(rows, i, c));
    };
    four(s.ux, w.t.shift, 0), four(s.uy, w.t.shift, 1), four(s.uz, w.t.shift, 2);
    four(s.qw, w.t.shift, 3);
    four(s.qx, w.t.turn, 0), four(s.qy, w.t.turn, 1), four(s.qz, w.t.turn, 2);
    act(s.vx[i], w.body(i, kV)), act(s.vy[i], w.body(i, kV + 1)), act(s.vz[i], w.body(i, kV + 2));
    act(s.lx[i], w.body(i, kL)), act(s.ly[i], w.body(i, kL + 1)), act(s.lz[i], w.body(i, kL + 2));
  }
  for (int i = 0; i < m.space.n_support; ++i) {
    act(s.support_x[i], w.column_of(w.t.support, i, 0));
    act(s.support_y[i], w.column_of(w.t.support, i, 1));
    act(s.support_z[i], w.column_of(w.t.support, i, 2));
  }
  for (int k = 0; k < w.links; ++k) {
    act(s.link_force[k], w.link(k, kLinkForce));
    act(s.link_plastic[k], w.link(k, kLinkPlastic));
    act(s.link_drawn[k], w.link(k, kLinkDrawn));
  }
  for (const Chunk& chunk : l.joints) {
    const auto history = [&](auto& array, int r) {
      for (int n = 0; n < chunk.n; ++n)
        for (int k = 0; k < chunk.points; ++k)
          act(array[m.space.point_begin[chunk.first + n] + k],
              w.t.history[l.point_number(chunk, chunk.history, n, k, chunk.rows, r, w.t.lanes) +
                          w.lane]);
    };
    for (const StateField& field : kStateFields)
      if (field.entity == Entity::kPoint && row_of(field.array) + 1 < chunk.rows)
        history(s.*field.array, row_of(field.array));
    history(s.plastic_slip_2, chunk.rows - 1);
    const auto element = [&](auto& array, MaxwellRow r) {
      for (int n = 0; chunk.elements >= 0 && n < chunk.n; ++n)
        for (int k = 0; k < chunk.points; ++k)
          act(array[m.space.point_begin[chunk.first + n] + k],
              w.t.element[l.point_number(chunk, chunk.elements, n, k, kMaxwellRowsInSpace, r,
                                         w.t.lanes) +
                          w.lane]);
    };
    element(s.maxwell_normal, kNormalElement);
    element(s.maxwell_shear, kShearElement);
    element(s.maxwell_shear_2, kSecondShearElement);
  }
}

void load_laws(const WallView& w, const Model& m) {
  const Layout& l = *w.layout;
  for (const Chunk& chunk : l.joints) {
    const int entries = chunk.graded ? chunk.end - chunk.begin : 1;
    for (int n = 0; n < entries * l.group(); ++n) {
      const int joint = chunk.first + (chunk.graded ? std::min(n, chunk.n - 1) : 0);
      const contact::LawConstants<double> law =
          contact::constants_of(m.materials[m.joint_material[joint]]);
      for (int k = 0; k < kLawRows; ++k) {
        const std::ptrdiff_t number = chunk.strengths + n / l.group() * kLawRows + k;
        const std::ptrdiff_t place =
            l.grouped() ? number * kGroup + n % kGroup : number * w.t.lanes;
        w.t.law[place + w.lane] = law.*contact::kConstants<double>[k];
      }
    }
  }
}

double length(const Vec& v) { return square_root(dot(v, v)); }

// Forces on block i: those of its joints, and the total with dead loads and gravity.
Load<double> sum_forces(std::ptrdiff_t i, const WallView& w) {
  const Load<double> contact = contact_load(w.t, i, w.lane);
  const Load<double> total{
      contact.f + (w.body_vector(i, kLoad) + w.body(i, kGravityMass) * w.gravity()),
      contact.m + w.body_vector(i, kLoadMoment)};
  w.store_still_vector(contact.f, i, kContact);
  w.store_still_vector(total.f, i, kTotal);
  w.store_still_vector(total.m, i, kTotalMoment);
  return total;
}

// Mean radius of gyration over all axes, which converts moments and rates of rotation.
double radius_of(std::ptrdiff_t i, const WallView& w) {
  const Vec inertia = w.still_vector(i, kBodyInertia);
  return square_root((inertia.x + inertia.y + inertia.z) / (3 * w.still(i, kBodyMass)));
}

const std::vector<BlockId> kNone;

// Supports move together. The reaction is the force of their joints on them.
double drive_supports(const Stage& push, const WallView& w, double velocity, WallWork& work) {
  const Vec p{push.drive_x, push.drive_y, push.drive_z};
  const double dt = w.wall_value(kStep);
  double reaction = 0;
  for (const Chunk& chunk : w.layout->joints) {
    if (!chunk.on_ground) continue;
    for (int n = 0; n < chunk.n; ++n) {
      const std::ptrdiff_t j = static_cast<std::ptrdiff_t>(chunk.begin) * w.layout->group() + n;
      if (!w.is_driven_support(w.t.joint_a[j])) continue;
      reaction -= dot(w.force(j), p);
    }
  }
  if (w.first_free >= 0)
    for (const BlockId id : push.driven) reaction -= dot(w.force(w.first_free + id), p);
  const std::vector<BlockId>& pressed = w.contact_block == nullptr ? kNone : *w.contact_block;
  for (std::size_t c = 0; c < pressed.size(); ++c) {
    const std::int32_t support = pressed[c] - w.blocks;
    if (support < 0 || !w.is_driven_support(support)) continue;
    reaction -= dot(w.force(w.layout->first_contact + static_cast<std::ptrdiff_t>(c)), p);
  }
  for (const BlockId id : push.driven)
    for (int c = 0; c < 3; ++c) {
      const double along[3] = {p.x, p.y, p.z};
      w.column_of(w.t.support, id - w.blocks, c) += dt * velocity * along[c];
    }
  // the mean of the steps before and after, as for blocks
  const Vec before{w.wall_value(kSupportStep), w.wall_value(kSupportStep + 1),
                   w.wall_value(kSupportStep + 2)};
  work.drive += reaction * 0.5 * (dot(before, p) + velocity * dt);
  return reaction;
}

// Motion of a block that the drive leaves free: across the push, and rotation.
struct Free {
  Vec v, mean_v, l, mean_rate;
  double damping;
};

Free move_freely(std::ptrdiff_t i, const Stage& push, const WallView& w, const Vec& p) {
  const double dt = w.wall_value(kStep), lambda = w.wall_value(kLambda), m = w.still(i, kBodyMass);
  const bool components = w.t.damps_components;
  const auto across = [&](const Vec& a) { return a - dot(a, p) * p; };
  Free now{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}, 0};
  if (fixity_of(push.spec).across == Freedom::kFree) {
    const Vec v0 = across(w.body_vector(i, kV)), f = across(w.still_vector(i, kTotal));
    const Vec damped = damping_of(f, v0, lambda, components);
    now.v = v0 + (dt / m) * (f + damped);
    now.mean_v = 0.5 * (v0 + now.v);
    now.damping += dt * dot(damped, now.mean_v);
  }
  if (fixity_of(push.spec).rotation == Freedom::kFree) {
    const Quaternion<double> q = w.turn(i);
    const Inertia<double> body = inertia_of(i, w);
    const Vec l0 = w.body_vector(i, kL), torque = w.still_vector(i, kTotalMoment);
    const Vec rate0 = turned(q, body.rate(turned_back(q, l0)));
    const Vec damped_moment = damping_of(torque, rate0, lambda, components);
    now.l = l0 + dt * (torque + damped_moment);
    now.mean_rate = 0.5 * (rate0 + turned(q, body.rate(turned_back(q, now.l))));
    now.damping += dt * dot(damped_moment, now.mean_rate);
  }
  return now;
}

}  // namespace

Inertia<double> inertia_of(std::ptrdiff_t i, const WallView& w) {
  Inertia<double> body;
  for (int k = 0; k < 3; ++k) {
    const auto axis = [&](int c) { return w.t.axes[w.layout->number(i, kAxisRows, 3 * k + c, 1)]; };
    body.axis[k] = {axis(0), axis(1), axis(2)};
    body.inverse[k] = w.body(i, kInverse + k);
  }
  return body;
}

WallView view_of(const Layout& layout, const Model& model, const Tables& tables, int lane) {
  WallView view;
  view.t = tables;
  view.layout = &layout;
  view.lane = lane;
  view.blocks = model.n_block;
  view.supports = model.space.n_support;
  view.links = layout.n_link;
  if (model.free.any()) view.first_free = layout.first_frame + layout.n_frame;
  view.bodies = model.free.any() ? model.n_block + model.free.n_fixed : 0;
  view.contact_block = &model.space.solids.contact_block;
  return view;
}

void load_lane(const WallView& w, const Model& m, const State& s) {
  // the history comes from outside, so no face counts as undamaged (passes/joints.h)
  std::fill_n(w.t.law_path, static_cast<std::ptrdiff_t>(w.layout->n_joint) * w.t.lanes,
              std::uint8_t{0});
  load_laws(w, m);
  load_links(w, m.links);
  for (int k = 0; k < w.links; ++k) {
    w.link(k, kLinkArmAZ) = m.links.arm_a_z[k];
    w.link(k, kLinkArmBZ) = m.links.arm_b_z[k];
    w.link(k, kLinkSpanZ) = m.links.span_z[k];
  }
  each_number(w, m, s, [](double of, double& to) { to = of; });
  for (int i = 0; i < m.n_block; ++i) {
    const Vec3& inertia = m.space.inertia[i];
    w.body(i, kGravityMass) = m.gravity_mass[i];
    w.body(i, kFree) = 1;
    w.store_body_vector({0, 0, 0}, i, kLoad);
    w.store_body_vector({0, 0, 0}, i, kLoadMoment);
    w.still(i, kBodyMass) = m.mass[i];
    w.store_still_vector(vec(inertia), i, kBodyInertia);
  }
  for (const Stage& stage : m.stages) {
    for (const PointLoad& load : stage.loads) w.special(load.block) = 1;
    for (const PointLoad& mass : stage.carried) w.special(mass.block) = 1;
    for (const BlockId block : stage.driven)
      if (block < m.n_block) w.special(block) = 1;
  }
}

void stand(const WallView& w, const Model& m, const State& s) {
  const auto clear_forces = [&](std::ptrdiff_t row) {
    for (double* rows : {w.t.force, w.t.moment_a, w.t.moment_b})
      std::fill_n(rows + 4 * row, 4, 0.0);
  };
  for (JointId j = 0; j < m.n_joint; ++j) {
    const std::int32_t place = w.layout->joint_place[j];
    const BlockId a = m.joint_a[j], b = m.joint_b[j];
    const bool on_ground = j >= m.n_pair, stands = m.standing.joins(a, b, s.stage);
    // else between the resting pose and itself, without an area
    const std::int32_t resting = on_ground ? m.space.n_support : w.t.n_block;
    w.t.joint_a[place] = !stands ? resting : on_ground ? a - m.n_block : a;
    w.t.joint_b[place] = stands ? b : w.t.n_block;
    w.t.face[w.layout->number(place, kFaceRows, kFaceArea, 1)] = stands ? m.area[j] : 0;
    clear_forces(place);
  }
  for (int k = 0; k < w.links; ++k) {
    const BlockId a = m.links.a[k], b = m.links.b[k];
    const bool stands = m.standing.joins(a, b, s.stage);
    w.t.link_a[k] = stands && a != kGroundBlock ? a : w.t.n_block;
    w.t.link_b[k] = stands ? b : w.t.n_block;
    w.link(k, kLinkJack) = stands && m.standing.begins(a, b, s.stage) ? m.links.jack[k] : 0;
    clear_forces(w.layout->n_joint + k);
  }
  for (int k = 0; k < w.layout->n_frame; ++k) clear_forces(w.layout->first_frame + k);
  for (int i = 0; i < m.n_block; ++i) {
    const double pulls = std::fabs(s.release_x[i]) + std::fabs(s.release_y[i]) +
                         std::fabs(s.release_z[i]) + std::fabs(s.release_mx[i]) +
                         std::fabs(s.release_my[i]) + std::fabs(s.release_m[i]);
    if (!m.standing.holds(i, s.stage) || pulls > 0) w.special(i) = 1;
  }
  hold_still(w, m, s.stage);
}

void hold_still(const WallView& w, const Model& m, int stage) {
  for (int i = 0; i < m.n_block; ++i) {
    if (m.standing.holds(i, stage)) continue;
    w.body(i, kFree) = 0;
    w.store_body_vector({0, 0, 0}, i, kV);
    w.store_body_vector({0, 0, 0}, i, kL);
  }
}

void release(const WallView& w, const State& s, double share) {
  for (int i = 0; i < w.blocks; ++i) {
    const Vec f{s.release_x[i], s.release_y[i], s.release_z[i]};
    const Vec m{s.release_mx[i], s.release_my[i], s.release_m[i]};
    w.store_body_vector(w.body_vector(i, kLoad) + share * f, i, kLoad);
    w.store_body_vector(w.body_vector(i, kLoadMoment) + share * m, i, kLoadMoment);
  }
}

void store_lane(const WallView& w, const Model& m, State& s) {
  each_number(w, m, s, [](double& to, double of) { to = of; });
}

contact::Pose<double> pose_before(std::ptrdiff_t i, const WallView& w) {
  const double dt = w.wall_value(kTimeBefore);
  const Quaternion<double> q = w.turn(i);
  return {w.shift(i) - dt * w.body_vector(i, kV),
          spin(q, turned_back(q, w.body_vector(i, kL)), inertia_of(i, w), -dt)};
}

void set_rates(const WallView& w, double dt, double mass_scaling) {
  const auto over = [](double a, double b) { return b > 0 ? a / b : 0.0; };
  for (int i = 0; i < w.blocks; ++i) {
    w.body(i, kMassRate) = over(dt, w.still(i, kBodyMass) * mass_scaling);
    for (int k = 0; k < 3; ++k)
      w.body(i, kInverse + k) = over(1, w.still(i, kBodyInertia + k) * mass_scaling);
  }
}

void choose_driven(const WallView& w, const std::vector<BlockId>& blocks) {
  for (int i = 0; i < w.blocks; ++i) {
    w.body(i, kFree) = 1;
    w.still(i, kLacking) = 0;
  }
  for (int i = 0; i < w.supports; ++i) w.column_of(w.t.support, i, kDriven) = 0;
  for (const BlockId block : blocks)
    if (block < w.blocks)
      w.body(block, kFree) = 0;
    else
      w.column_of(w.t.support, block - w.blocks, kDriven) = 1;
}

void clear_load(BlockId block, const WallView& w) {
  w.store_body_vector({0, 0, 0}, block, kLoad);
  w.store_body_vector({0, 0, 0}, block, kLoadMoment);
}

void add_load(const PointLoad& load, double scale, const WallView& w) {
  const Vec f = scale * Vec{load.fx, load.fy, load.fz};
  const Vec arm = turned(w.turn(load.block), Vec{load.arm_x, load.arm_y, load.arm_z});
  w.store_body_vector(w.body_vector(load.block, kLoad) + f, load.block, kLoad);
  w.store_body_vector(w.body_vector(load.block, kLoadMoment) + cross(arm, f), load.block,
                      kLoadMoment);
}

// As add_link_forces() in the plane (passes/links.h). The forces lie behind those of the joints.
LinkWork add_link_forces(const WallView& w, double set, double jacked) {
  LinkWork work;
  for (int k = 0; k < w.links; ++k) {
    const auto of = [&](int row) { return w.link(k, row); };
    const std::int32_t ia = w.t.link_a[k], ib = w.t.link_b[k];
    if (ib == w.t.n_block) continue;  // one of its ends does not stand
    const contact::SpaceLinkEnd a = contact::link_end(
        w.shift(ia), w.turn(ia), Vec{of(kLinkArmAX), of(kLinkArmAY), of(kLinkArmAZ)});
    const contact::SpaceLinkEnd b = contact::link_end(
        w.shift(ib), w.turn(ib), Vec{of(kLinkArmBX), of(kLinkArmBY), of(kLinkArmBZ)});
    const contact::SpaceLinkLine line = contact::link_line(
        Vec{of(kLinkSpanX), of(kLinkSpanY), of(kLinkSpanZ)}, of(kLinkFollows) > 0, a, b);
    const Vec f = update_link(w, k, line.elongation, set, jacked, work) * line.axis;
    const std::ptrdiff_t row = w.layout->n_joint + k;
    w.store_vector(f, w.t.force, row);
    w.store_vector(cross(a.arm, f), w.t.moment_a, row);
    w.store_vector(Vec{0, 0, 0} - cross(b.arm, f), w.t.moment_b, row);
  }
  return work;
}

// As drive_blocks() in the plane (passes/drive.h). Either forces R r_i in fixed shares, with a
// prescribed mean of the velocities in these shares, or each block at the prescribed velocity.
double drive(const Stage& push, const WallView& w, double velocity, WallWork& work) {
  if (!push.driven.empty() && push.driven.front() >= w.blocks)
    return drive_supports(push, w, velocity, work);
  const Vec p{push.drive_x, push.drive_y, push.drive_z};
  const double dt = w.wall_value(kStep), lambda = w.wall_value(kLambda);
  const bool spread = !push.moves_each();
  const bool is_pattern = push.has_pattern();
  double reaction = 0, sum = 0, mobility = 0, squares = 0;
  for (std::size_t k = 0; k < push.driven.size(); ++k) {
    const BlockId i = push.driven[k];
    const double r = push.driven_share[k];
    sum += r * dot(sum_forces(i, w).f, p);
    squares += r * r;
    mobility += r * r / w.still(i, kBodyMass);
    reaction -= dot(w.still_vector(i, kContact), p);
  }
  const double balance = spread ? -sum / squares : 0.0;
  double missed = 0;
  for (std::size_t k = 0; k < push.driven.size(); ++k) {
    const BlockId i = push.driven[k];
    const double r = push.driven_share[k];
    const double f = dot(w.still_vector(i, kTotal), p) + r * balance;
    const double v = dot(w.body_vector(i, kV), p);
    missed += r * (velocity - accelerate(v, f, dt / w.still(i, kBodyMass), dt, lambda).velocity);
  }
  const double correction = missed / (mobility * dt);

  for (std::size_t k = 0; k < push.driven.size(); ++k) {
    const BlockId i = push.driven[k];
    const double r = push.driven_share[k], m = w.still(i, kBodyMass);
    const Vec total = w.still_vector(i, kTotal);
    const double along_f = dot(total, p), along_v = dot(w.body_vector(i, kV), p);
    double vp = velocity, force = 0;
    if (spread) {
      const double left = along_f + r * balance;
      const Moved<double> along = accelerate(along_v, left, dt / m, dt, lambda);
      vp = along.velocity + dt / m * (r * correction);
      force = r * (balance + correction);
      work.damping -= lambda * magnitude(left) * sign(along_v) * 0.5 * (along_v + vp) * dt;
      if (is_pattern) {
        w.still(i, kLacking) = length(left * p + (total - along_f * p));
        if (fixity_of(push.spec).rotation == Freedom::kFree)
          w.still(i, kLacking) += length(w.still_vector(i, kTotalMoment)) / radius_of(i, w);
      }
    } else {
      force = m * (vp - along_v) / dt - along_f;
    }
    const Free free = move_freely(i, push, w, p);
    const double mean_p = 0.5 * (along_v + vp);
    const Vec mean_v = mean_p * p + free.mean_v, load = total - w.still_vector(i, kContact);
    work.drive += force * mean_p * dt;
    work.damping += free.damping;
    work.loads += dt * (dot(load, mean_v) + dot(w.body_vector(i, kLoadMoment), free.mean_rate));

    const Vec v = vp * p + free.v;
    const Quaternion<double> q = w.turn(i);
    const Quaternion<double> q1 = spin(q, turned_back(q, free.l), inertia_of(i, w), dt);
    w.store_body_vector(v, i, kV);
    w.store_body_vector(free.l, i, kL);
    const double shift[4] = {v.x * dt, v.y * dt, v.z * dt, q1.w - q.w};
    for (int c = 0; c < 4; ++c) w.column_of(w.t.shift, i, c) += shift[c];
    w.column_of(w.t.shift, i, 3) = q1.w;
    w.store_vector(q1.v, w.t.turn, i);
  }
  return reaction;
}

double unbalance_of(const WallView& w, const Model& m, const ZoneRun* zones) {
  double unbalanced = 0, contact = 0;
  for (int i = 0; i < w.blocks; ++i) {
    if (!(w.body(i, kFree) > 0)) {
      unbalanced += w.still(i, kLacking);
      continue;
    }
    const Load<double> contact_now = contact_load(w.t, i, w.lane);
    const Vec load = w.body_vector(i, kLoad) + w.body(i, kGravityMass) * w.gravity();
    unbalanced += length(contact_now.f + load) +
                  length(contact_now.m + w.body_vector(i, kLoadMoment)) / radius_of(i, w);
  }
  for (int j = 0; j < m.n_joint; ++j) {
    const std::int32_t e = w.layout->joint_place[j];
    const double sides = j < m.n_pair ? 2.0 : 1.0;
    contact += sides * length(w.force(e));
  }
  for (int k = 0; k < w.links; ++k) {
    const double sides = w.t.link_a[k] == w.t.n_block ? 1.0 : 2.0;
    contact += sides * magnitude(w.link(k, kLinkForce));
  }
  for (int k = 0; k < w.layout->n_frame; ++k) {
    const std::ptrdiff_t row = w.layout->first_frame + k;
    const double sides = m.frames.a[k] == kGroundBlock ? 1.0 : 2.0;
    contact += sides * length(w.force(row));
  }
  for (int i = 0; w.first_free >= 0 && i < w.blocks; ++i)
    contact += w.column_of(w.t.force, w.first_free + i, 3);
  if (zones != nullptr) {
    unbalanced += zones->unbalanced();
    contact += zones->pressed(w);
  }
  if (contact > 0) return unbalanced / contact;
  return unbalanced > 0 ? 1.0 : 0.0;
}

double kinetic_of(const WallView& w, double mass_scaling) {
  double energy = 0;
  for (int i = 0; i < w.blocks; ++i) {
    const Vec v = w.body_vector(i, kV);
    const Vec l = turned_back(w.turn(i), w.body_vector(i, kL));
    const Inertia<double> body = inertia_of(i, w);
    energy += 0.5 * w.still(i, kBodyMass) * mass_scaling * dot(v, v) + 0.5 * dot(l, body.rate(l));
  }
  return energy;
}

double shear_of(const WallView& w, const Model& m, const Vec3& along) {
  double sum = 0;  // the force on side a, the support, resists with the opposite sign
  const auto add = [&](std::ptrdiff_t row) { sum += dot(w.force(row), vec(along)); };
  for (int j = m.n_pair; j < m.n_joint; ++j) {
    const std::int32_t e = w.layout->joint_place[j];
    if (!w.is_driven_support(w.t.joint_a[e])) add(e);
  }
  for (int k = 0; k < w.links; ++k)
    if (w.t.link_a[k] == w.t.n_block) add(w.layout->n_joint + k);
  for (int k = 0; k < w.layout->n_frame; ++k)
    if (m.frames.a[k] == kGroundBlock) add(w.layout->first_frame + k);
  for (int i = w.blocks; i < w.bodies; ++i) add(w.first_free + i);
  return sum;
}

BlockId runaway_of(const WallView& w) {
  constexpr double kFast = 100.0;  // [m/s], far beyond any free fall within a wall
  const auto finite = [](double x) { return x - x == 0; };
  for (int i = 0; i < w.blocks; ++i) {
    const Quaternion<double> q = w.turn(i);
    const Vec l = turned_back(q, w.body_vector(i, kL));
    const double rim = radius_of(i, w) * length(inertia_of(i, w).rate(l));
    if (!(length(w.body_vector(i, kV)) < kFast) || !finite(dot(q.v, q.v) + q.w) || !(rim < kFast))
      return i;
  }
  return -1;
}

Furthest furthest_of(const WallView& w) {
  Furthest far;
  for (int i = 0; i < w.blocks; ++i) {
    const double moved = length(w.shift(i));
    if (moved > far.distance) far = {moved, i};
  }
  return far;
}

}  // namespace wythe::dynamics::space
