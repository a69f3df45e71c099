// Builds the static programme (forces in equilibrium) and the kinematic one (velocities that flow) of a wall in space.
// Both use the same points of faces. The solver handles the friction circle, so no planes approximate it. Unknowns are
// divided by the mean dead load of a block and the mean size of a face, so that they are near 1.
#include "limit/in_space.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/elementary.h"
#include "wythe/parts/error.h"

namespace wythe::limit {
namespace {

constexpr double kNothing = 1e-7;  // share of the force unit: a smaller circle resists nothing

// Arms of a joint's point from the centroids, and the axes of its face.
struct Place {
  Vec3 arm_a, arm_b, t1, t2, n;
};
Place place_of(const Model& m, int joint, int point) {
  const Space& s = m.space;
  Place p;
  p.t1 = s.tangent[joint];
  p.n = s.normal[joint];
  p.t2 = cross(p.n, p.t1);
  const Vec3 r = s.point_r1[point] * p.t1 + s.point_r2[point] * p.t2;
  p.arm_a = s.arm_a[joint] + r;
  p.arm_b = s.arm_b[joint] + r;
  return p;
}

bool moves(const Model& m, BlockId block) { return block != kGroundBlock && block < m.n_block; }

std::array<double, 6> parts(const Vec3& force, const Vec3& moment, double length) {
  return {force.x, force.y, force.z, moment.x / length, moment.y / length, moment.z / length};
}

// Unit vectors normal to a push.
std::array<Vec3, 2> across(const Vec3& push) {
  const Vec3 other = std::fabs(push.x) < 0.9 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
  Vec3 first = cross(push, other);
  first = first / length(first);
  return {first, cross(push, first)};
}

double capacity_of(const Model& m, const JointYield& y, int point, double compression) {
  return y.cohesion * m.space.point_share[point] + y.friction * compression;
}

bool slides(const JointYield& y) { return !std::isinf(y.cohesion); }
// Whether a point resists sliding; otherwise its circle is a point.
bool resists(const JointYield& y) { return y.cohesion > 0 || y.friction > 0; }

// Direction of link k from a to b, and its ends relative to the centroids.
struct LinkPlace {
  Vec3 way, arm_a, arm_b;
};
LinkPlace link_place(const Links& l, std::size_t k) {
  const Vec3 span{l.span_x[k], l.span_y[k], l.span_z[k]};
  return {span / length(span),
          {l.arm_a_x[k], l.arm_a_y[k], l.arm_a_z[k]},
          {l.arm_b_x[k], l.arm_b_y[k], l.arm_b_z[k]}};
}

// Columns: load | p, s1, s2 of each point | forces of links | restraints of driven blocks. Rows: equilibrium of each block (force,
// moment), friction circles.
class StaticProgramme : public StaticRows<6> {
 public:
  StaticProgramme(const Model& m, const SpaceLoads& loads, const SpaceYield& y, const Units& u)
      : StaticRows(m, u, loads.is_force), loads_(loads), y_(y) {}

  // For kUnbalanced, unbalanced forces have a cost.
  void build(Purpose purpose) {
    add_load(purpose);
    for (int j = 0; j < m_.n_joint; ++j) add_joint(j);
    for (std::size_t k = 0; k < y_.link.size(); ++k) add_link(k);
    add_loads();
    if (purpose == Purpose::kUnbalanced) add_slack();
    for (std::size_t i = 0; i < loads_.dead.size(); ++i) {
      const auto wanted = parts(loads_.dead[i].force, loads_.dead[i].moment, u_.length);
      for (std::size_t c = 0; c < 6; ++c)
        balance_row_.push_back(
            lp_.add_row(balance_[6 * i + c], -wanted[c] / u_.force, -wanted[c] / u_.force));
    }
    if (!sum_.empty()) lp_.add_row(sum_, 0, 0);
    add_circles();
  }

  void add_circles() {
    for (int j = 0; j < m_.n_joint; ++j) {
      const JointYield& y = y_.joint[j];
      if (!slides(y) || !resists(y)) continue;
      for (int p = m_.space.point_begin[j]; p < m_.space.point_begin[j + 1]; ++p)
        lp_.add_circle({{{{column(p), y.friction}}, {{column(p) + 1, 1}}, {{column(p) + 2, 1}}}},
                       capacity_of(m_, y, p, 0) / u_.force);
    }
  }

  SpaceStaticSolution solve(const Monitor& monitor, const Tolerance& tolerance) {
    SpaceStaticSolution answer;
    const auto first = [this](int joint) { return column(m_.space.point_begin[joint]); };
    if (!solve_for(answer, monitor, tolerance, first)) return answer;
    const std::vector<double>& x = lp_.solution();
    for (int p = 0; p < m_.n_point(); ++p) {
      answer.compression.push_back(x[column(p)] * u_.force);
      answer.shear_1.push_back(x[column(p) + 1] * u_.force);
      answer.shear_2.push_back(x[column(p) + 2] * u_.force);
    }
    add_motion(answer.dual);
    return answer;
  }

 private:
  void add_motion(SpaceKinematicSolution& m) const {
    const double scale = loads_.is_force ? 1.0 : 1.0 / u_.force;
    const auto velocity = [&](std::size_t block, std::size_t axis) {
      return lp_.multipliers()[balance_row_[6 * block + axis]];
    };
    for (std::size_t i = 0; i < loads_.dead.size(); ++i) {
      const BodyForce& f = loads_.dead[i];
      m.velocity.push_back(scale * Vec3{velocity(i, 0), velocity(i, 1), velocity(i, 2)});
      m.spin.push_back(scale / u_.length * Vec3{velocity(i, 3), velocity(i, 4), velocity(i, 5)});
      m.dissipation += dot(f.force, m.velocity[i]) + dot(f.moment, m.spin[i]);
    }
  }

  [[nodiscard]] static int column(int point) { return 1 + 3 * point; }

  void act(BlockId block, int column, const Vec3& force, const Vec3& arm) {
    if (!moves(m_, block)) return;
    put(block, column, parts(force, cross(arm, force), u_.length));
  }
  void put(BlockId block, int column, const std::array<double, 6>& values) {
    for (std::size_t c = 0; c < 6; ++c)
      if (values[c] != 0)
        balance_[6 * static_cast<std::size_t>(block) + c].push_back({column, values[c]});
  }

  void add_joint(int j) {
    const JointYield& y = y_.joint[j];
    for (int p = m_.space.point_begin[j]; p < m_.space.point_begin[j + 1]; ++p) {
      const double share = m_.space.point_share[p] / u_.force;
      const Place place = place_of(m_, j, p);
      const Vec3 ways[] = {place.n, place.t1, place.t2};
      const double shear = slides(y) && !resists(y) ? 0 : kFree;
      for (int c = 0; c < 3; ++c) {
        const int k = c == 0 ? lp_.add_column(-y.tension * share, y.compression * share, 0)
                             : lp_.add_column(-shear, shear, 0);
        act(m_.joint_b[j], k, ways[c], place.arm_b);
        act(m_.joint_a[j], k, -1.0 * ways[c], place.arm_a);
      }
    }
  }

  // Columns of links directly follow those of points.
  void add_link(std::size_t k) {
    const LinkPlace link = link_place(m_.links, k);
    const int column =
        lp_.add_column(-y_.link[k].compression / u_.force, y_.link[k].tension / u_.force, 0);
    act(m_.links.a[k], column, link.way, link.arm_a);
    act(m_.links.b[k], column, -1.0 * link.way, link.arm_b);
  }

  // A unit force and unit couples of the test rig on a block.
  void hold(BlockId block, const Vec3& force, const Vec3& moment) {
    put(block, lp_.add_column(-kFree, kFree, 0), parts(force, moment, 1));
  }

  void add_loads() {
    const double scale = loads_.is_force ? 1.0 : 1.0 / u_.force;
    for (int i = 0; i < m_.n_block; ++i) {
      const BodyForce& g = loads_.growing[i];
      put(i, load_, parts(scale * g.force, scale * g.moment, u_.length));
    }
    if (!loads_.is_force) return;
    const FixitySpec fixity = fixity_of(loads_.stage->spec);
    std::vector<Entry> sum{{load_, -1.0}};
    for (const BlockId b : loads_.stage->driven) {
      if (loads_.together) {
        const int k = lp_.add_column(-kFree, kFree, 0);
        put(b, k, parts(loads_.push, {}, 1));
        sum.push_back({k, 1.0});
      }
      if (fixity.across == Freedom::kBlocked)
        for (const Vec3& way : across(loads_.push)) hold(b, way, {});
      if (fixity.rotation == Freedom::kBlocked)
        for (const Vec3& axis : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}) hold(b, {}, axis);
    }
    if (loads_.together) sum_ = sum;
  }

  const SpaceLoads& loads_;
  const SpaceYield& y_;
};

// Largest relative excess of a shear force over its circle.
double friction_excess(const Model& m, const Units& units, const SpaceStaticSolution& answer,
                       const SpaceYield& yield) {
  double most = 0;
  for (int j = 0; j < m.n_joint; ++j) {
    const JointYield& y = yield.joint[j];
    if (!slides(y)) continue;
    for (int p = m.space.point_begin[j]; p < m.space.point_begin[j + 1]; ++p) {
      const double s = elementary::hypot(answer.shear_1[p], answer.shear_2[p]);
      const double radius = capacity_of(m, y, p, answer.compression[p]);
      if (s - radius > kNothing * units.force)
        most = std::fmax(most, radius > 0 ? s / radius - 1 : 1.0);
    }
  }
  return most;
}

// Columns: velocity and angular velocity of each block | multipliers >= 0. Rows: slip and opening of each point follow from
// the multipliers; the load has unit power; motions that a rig prevents are zero.
class SpaceProgramme {
 public:
  SpaceProgramme(const Model& m, const SpaceLoads& loads, const SpaceYield& y, const Units& u)
      : m_(m), loads_(loads), y_(y), u_(u) {}

  void build() {
    for (const BodyForce& f : loads_.dead)
      for (const double part : parts(f.force, f.moment, u_.length))
        lp_.add_column(-kFree, kFree, -part / u_.force);
    for (int j = 0; j < m_.n_joint; ++j)
      for (int p = m_.space.point_begin[j]; p < m_.space.point_begin[j + 1]; ++p) add_point(j, p);
    for (std::size_t k = 0; k < y_.link.size(); ++k) add_link(k);
    add_unit_power();
  }

  SpaceKinematicSolution solve(const Monitor& monitor) {
    SpaceKinematicSolution answer;
    answer.status = lp_.solve(monitor);
    answer.accuracy = lp_.accuracy();
    if (answer.status != ProgrammeStatus::kOptimal) return answer;
    answer.load = lp_.objective() * (loads_.is_force ? u_.force : 1.0);
    const std::vector<double>& x = lp_.solution();
    const double scale = loads_.is_force ? 1.0 : 1.0 / u_.force;
    for (int i = 0; i < m_.n_block; ++i) {
      const double* v = &x[6 * static_cast<std::size_t>(i)];
      answer.velocity.push_back(scale * Vec3{v[0], v[1], v[2]});
      answer.spin.push_back(scale / u_.length * Vec3{v[3], v[4], v[5]});
    }
    for (std::size_t k = 0; k < capacity_.size(); ++k)
      answer.dissipation += capacity_[k] * x[6 * static_cast<std::size_t>(m_.n_block) + k];
    answer.dissipation *= u_.force * scale;
    return answer;
  }

 private:
  int add_multiplier(double capacity) {
    capacity_.push_back(capacity / u_.force);
    return lp_.add_column(0, kFree, capacity / u_.force);
  }

  // Amount of slip of a point, and its slip vector.
  int add_circle(double capacity) {
    capacity_.insert(capacity_.end(), {capacity / u_.force, 0, 0});
    return lp_.add_circle_columns(capacity / u_.force);
  }

  void add_motion(std::vector<Entry>& row, BlockId block, double sign, const Vec3& way,
                  const Vec3& arm) const {
    if (!moves(m_, block)) return;
    const auto values = parts(way, cross(arm, way), u_.length);
    for (int c = 0; c < 6; ++c) row.push_back({6 * block + c, sign * values[c]});
  }
  [[nodiscard]] std::vector<Entry> jump(int j, const Place& place, const Vec3& way) const {
    std::vector<Entry> row;
    add_motion(row, m_.joint_b[j], 1, way, place.arm_b);
    add_motion(row, m_.joint_a[j], -1, way, place.arm_a);
    return row;
  }

  void add_point(int j, int p) {
    const JointYield& y = y_.joint[j];
    const Place place = place_of(m_, j, p);
    const double share = m_.space.point_share[p];
    std::vector<Entry> slip_1 = jump(j, place, place.t1), slip_2 = jump(j, place, place.t2),
                       opening = jump(j, place, place.n);
    if (slides(y) && resists(y)) {
      const int multiplier = add_circle(capacity_of(m_, y, p, 0));
      slip_1.push_back({multiplier + 1, 1});
      slip_2.push_back({multiplier + 2, 1});
      opening.push_back({multiplier, -y.friction});
    }
    if (!std::isinf(y.tension)) opening.push_back({add_multiplier(y.tension * share), -1.0});
    if (!std::isinf(y.compression)) opening.push_back({add_multiplier(y.compression * share), 1.0});
    if (!slides(y) || resists(y)) {
      lp_.add_row(slip_1, 0, 0);
      lp_.add_row(slip_2, 0, 0);
    }
    lp_.add_row(opening, 0, 0);
  }

  // A link changes its length at its limit forces; an unlimited one keeps its length.
  void add_link(std::size_t k) {
    const LinkPlace link = link_place(m_.links, k);
    std::vector<Entry> row;
    add_motion(row, m_.links.b[k], 1, link.way, link.arm_b);
    add_motion(row, m_.links.a[k], -1, link.way, link.arm_a);
    if (!std::isinf(y_.link[k].tension)) row.push_back({add_multiplier(y_.link[k].tension), -1.0});
    if (!std::isinf(y_.link[k].compression))
      row.push_back({add_multiplier(y_.link[k].compression), 1.0});
    lp_.add_row(row, 0, 0);
  }

  void stand(BlockId block, const Vec3& velocity, const Vec3& spin, double value) {
    const auto values = parts(velocity, spin, 1);
    std::vector<Entry> row;
    for (int c = 0; c < 6; ++c) row.push_back({6 * block + c, values[c]});
    lp_.add_row(row, value, value);
  }

  void add_unit_power() {
    const double scale = loads_.is_force ? 1.0 : 1.0 / u_.force;
    if (!loads_.together) {
      std::vector<Entry> power;
      for (int i = 0; i < m_.n_block; ++i) {
        const BodyForce& g = loads_.growing[i];
        const auto values = parts(scale * g.force, scale * g.moment, u_.length);
        for (int c = 0; c < 6; ++c) power.push_back({6 * i + c, values[c]});
      }
      lp_.add_row(power, 1, 1);
    }
    if (!loads_.is_force) return;
    const FixitySpec fixity = fixity_of(loads_.stage->spec);
    for (const BlockId b : loads_.stage->driven) {
      if (loads_.together) stand(b, loads_.push, {}, 1);
      if (fixity.across == Freedom::kBlocked)
        for (const Vec3& way : across(loads_.push)) stand(b, way, {}, 0);
      if (fixity.rotation == Freedom::kBlocked)
        for (const Vec3& axis : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}})
          stand(b, {}, axis, 0);
    }
  }

  const Model& m_;
  const SpaceLoads& loads_;
  const SpaceYield& y_;
  Units u_;
  LinearProgramme lp_;
  std::vector<double> capacity_;  // of each multiplier, in force units
};

}  // namespace

SpaceLoads space_loads(const Model& model, double secant, bool loads_are_masses) {
  SpaceLoads loads;
  const auto refuse = [](std::string problem, std::string cure) {
    throw InputError({{"", "stage", "", std::move(problem), std::move(cure), 0}});
  };
  loads.stage = growing_stage(model);
  if (loads.stage == nullptr)
    refuse("no stage has a load that grows", "add a push on blocks, or a body_force stage");
  const Stage& grows = *loads.stage;
  loads.is_force = !is_factor(grows);
  if (loads.is_force && !grows.driven.empty() && grows.driven.front() >= model.n_block)
    refuse("what grows moves a support, and a limit load needs a force",
           "run it, or add a push on blocks or a body_force stage");
  loads.dead.resize(model.n_block);
  loads.growing.resize(model.n_block);
  const Vec3 gravity = gravity_before(model, loads.stage);
  for (std::size_t i = 0; i < loads.dead.size(); ++i)
    loads.dead[i].force = model.gravity_mass[i] * gravity;
  for (const Stage& stage : model.stages) {
    if (&stage == loads.stage) break;
    for (const PointLoad& p : stage.loads) {
      BodyForce& f = loads.dead[p.block];
      const Vec3 force = secant * Vec3{p.fx, p.fy, p.fz};
      f.force = f.force + force;
      f.moment = f.moment + cross(Vec3{p.arm_x, p.arm_y, p.arm_z}, force);
    }
  }
  loads.push = (goes_back(grows) ? -1.0 : 1.0) * grows.drive();
  if (!loads.is_force) {
    for (std::size_t i = 0; i < loads.growing.size(); ++i)
      loads.growing[i].force = model.solve.gravity * model.gravity_mass[i] * grows.drive();
    for (const Stage& stage : model.stages) {
      if (&stage == loads.stage || !loads_are_masses) break;
      for (const PointLoad& p : stage.loads) {
        if (!(p.fy < 0)) continue;  // an uplift is no mass
        const Vec3 force = -p.fy * grows.drive();
        BodyForce& f = loads.growing[p.block];
        f.force = f.force + force;
        f.moment = f.moment + cross(Vec3{p.arm_x, p.arm_y, p.arm_z}, force);
      }
    }
    return loads;
  }
  loads.together = grows.moves_each();
  const auto n = static_cast<double>(grows.driven.size());
  for (std::size_t k = 0; k < grows.driven.size() && !loads.together; ++k)
    loads.growing[grows.driven[k]].force = (grows.driven_share[k] / n) * loads.push;
  return loads;
}

SpaceYield space_yield(const Model& model, const LimitOptions& options, double times) {
  SpaceYield yield;
  for (std::size_t k = 0; k < model.links.a.size(); ++k)
    yield.link.push_back({times * model.links.tension[k], times * model.links.compression[k]});
  for (int j = 0; j < model.n_joint; ++j) {
    const JointMaterial& m = model.materials[model.joint_material[j]];
    yield.joint.push_back(yield_of_joint(m, times * model.area[j], options));
  }
  return yield;
}

Units units_of(const Model& model, const SpaceLoads& loads) {
  Units units{0, 0};
  for (const BodyForce& f : loads.dead) units.force += length(f.force);
  for (const double area : model.area) units.length += std::sqrt(area);
  units.force /= std::max(1, model.n_block);
  units.length /= std::max(1, model.n_joint);
  if (!(units.force > 0)) units.force = 1000;
  if (!(units.length > 0)) units.length = 1;
  return units;
}

SpaceStaticSolution solve_static(const Model& model, const SpaceLoads& loads,
                                 const SpaceYield& yield, const Units& units,
                                 const Monitor& monitor, const Tolerance& tolerance) {
  StaticProgramme programme(model, loads, yield, units);
  programme.build(Purpose::kLoad);
  SpaceStaticSolution answer = programme.solve(monitor, tolerance);
  if (answer.status == ProgrammeStatus::kOptimal)
    answer.friction_excess = friction_excess(model, units, answer, yield);
  return answer;
}

SpaceKinematicSolution solve_kinematic(const Model& model, const SpaceLoads& loads,
                                       const SpaceYield& yield, const Units& units,
                                       const Monitor& monitor) {
  SpaceProgramme programme(model, loads, yield, units);
  programme.build();
  return programme.solve(monitor);
}

ProgrammeStatus find_rest(const Model& model, const SpaceLoads& loads, const SpaceYield& yield,
                          const Units& units, const Monitor& monitor) {
  StaticProgramme programme(model, loads, yield, units);
  programme.build(Purpose::kRest);
  return programme.stands(monitor);
}

Unbalanced find_unbalanced(const Model& model, const SpaceLoads& loads, const SpaceYield& yield,
                           const Units& units, const Monitor& monitor) {
  StaticProgramme programme(model, loads, yield, units);
  programme.build(Purpose::kUnbalanced);
  return programme.worst(monitor);
}

}  // namespace wythe::limit
