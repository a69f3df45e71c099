// The mechanism of a body force from limit analysis: its rigid pieces,
// their weights, and the displacement at which they fall by themselves.
//
//   blocks of one twist (velocity at the origin, spin) are one piece; a weight of a piece acts at its common centroid
//
// docs/theory/local_mechanisms.md. Called by add_local_checks().
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "judge/assessment/assessment_parts.h"
#include "judge/local/local_parts.h"
#include "limit/limit_loads.h"
#include "wythe/parts/error.h"
#include "wythe/parts/reading.h"

namespace wythe::study {
namespace {

constexpr double kSame = 1e-6;  // of the largest velocity

struct MovingPiece {
  Vec3 at_origin, spin;  // per unit velocity of the load
  double weight = 0;     // [N]
  Vec3 sum;              // of weight and place
  double low = std::numeric_limits<double>::infinity();
  [[nodiscard]] Vec3 velocity(const Vec3& at) const { return at_origin + cross(spin, at); }
};
struct LyingPiece {
  std::size_t piece = 0;
  Vec3 at, force;
};

[[noreturn]] void refuse(std::string problem, std::string cure) {
  throw InputError({{.path = "stage", .problem = std::move(problem), .cure = std::move(cure)}});
}

class Mechanism {
 public:
  Mechanism(const Model& bare, const LimitResult& answer, const Stage& stage)
      : model_(with_rigid_bodies(bare)),
        rest_(initial_state(model_)),
        answer_(answer),
        along_(stage.drive()) {
    find_pieces();
    gather_loads();
  }

  // (21.7): for one piece that turns about a line per unit rotation, else per unit velocity of the load.
  [[nodiscard]] LocalCapacity capacity(double gravity) const {
    const MovingPiece* turning = moving() == 1 ? first_moving() : nullptr;
    const double spin = turning != nullptr ? length(turning->spin) : 0;
    const bool turns =
        spin > 0 && std::fabs(dot(turning->at_origin, turning->spin)) <= kSame * spin * fastest_;
    const double unit = turns ? 1 / spin : 1;
    std::vector<LocalWeight> weights;
    each_weight([&](const MovingPiece& p, const Vec3& at, double weight) {
      const Vec3 v = unit * p.velocity(at);
      LocalWeight w{.weight = weight, .pushed = weight, .travel = dot(v, along_), .rise = v.y};
      w.drop = -cross(unit * p.spin, v).y;
      weights.push_back(w);
    });
    // links and horizontal loads; friction of dry joints does no work, because it is associated
    double resisted = unit * answer_.dissipation;
    for (const LyingPiece& l : lying_) {
      const Vec3 v = unit * pieces_[l.piece].velocity(l.at);
      resisted -= l.force.x * v.x + l.force.z * v.z + std::max(l.force.y, 0.0) * v.y;
    }
    LocalCapacity c =
        overturning(weights, {}, resisted, unit * dot(top_velocity_, along_), gravity).front();
    if (std::fabs(c.alpha0 - answer_.load) > 1e-5 * std::fabs(answer_.load) + 1e-9)
      refuse(
          fmt::format("its mechanism explains a multiplier of {:.6g}, and its limit load is {:.6g}",
                      c.alpha0, answer_.load),
          "look for joints or blocks a thousand times smaller or stronger than the rest");
    if (turns) return c;
    c.displacement0 = c.rotation0 = c.top0 = c.alpha0_to_end = kUnset;
    c.is_one_body = moving() == 1;
    c.no_displacement = moving() == 1 ? Message{"local.slides"}
                                      : Message{"local.several_pieces", {{"pieces", moving()}}};
    return c;
  }

  // Angle between the mechanism's motion and the load, in plan [rad].
  [[nodiscard]] double off() const {
    Vec3 way;
    each_weight([&](const MovingPiece& p, const Vec3& at, double weight) {
      const Vec3 v = p.velocity(at);
      way = way + weight * Vec3{v.x, 0, v.z};
    });
    const double size = length(way);
    return size > 0 ? std::acos(std::clamp(dot(way, along_) / size, -1.0, 1.0)) : 0;
  }
  [[nodiscard]] double low() const {
    double low = std::numeric_limits<double>::infinity();
    for (const MovingPiece& p : pieces_)
      if (is_moving(p)) low = std::min(low, p.low);
    return low;
  }
  [[nodiscard]] double high() const { return high_; }
  [[nodiscard]] double masonry() const {
    double sum = 0;
    for (const MovingPiece& p : pieces_) sum += is_moving(p) ? p.weight : 0;
    return sum;
  }
  [[nodiscard]] double loads() const {
    double sum = 0;
    for (const LyingPiece& l : lying_)
      sum += is_moving(pieces_[l.piece]) ? std::max(0.0, -l.force.y) : 0;
    return sum;
  }
  // Whether joints or links do work. They count for the onset, but how long they last is not known.
  [[nodiscard]] bool is_held() const { return answer_.dissipation > 1e-6 * masonry(); }

 private:
  void find_pieces() {
    const std::size_t n = model_.n_block;
    if (answer_.vx.size() != n)
      refuse("its mechanism leaves out deformable blocks",
             "leave zones out, or give the lintel model = \"segments\", for this analysis");
    piece_of_.resize(n);
    for (std::size_t i = 0; i < n; ++i) fastest_ = std::max(fastest_, length(velocity(i)));
    if (!(fastest_ > 0)) refuse("no block moves in its mechanism", "look at its limit load");
    for (std::size_t i = 0; i < n; ++i) {
      const Vec3 at = place_of(static_cast<BlockId>(i));
      const Vec3 v = velocity(i), w = spin(i);
      const auto same = std::find_if(pieces_.begin(), pieces_.end(), [&](const MovingPiece& p) {
        const double size = size_of(static_cast<BlockId>(i));
        return length(p.velocity(at) - v) < kSame * fastest_ &&
               length(p.spin - w) * size < kSame * fastest_;
      });
      MovingPiece& piece = same != pieces_.end() ? *same : pieces_.emplace_back();
      if (piece.weight == 0) piece.at_origin = v - cross(w, at), piece.spin = w;
      piece_of_[i] = static_cast<std::size_t>(&piece - pieces_.data());
      const double weight = model_.solve.gravity * model_.gravity_mass[i];
      piece.weight += weight;
      piece.sum = piece.sum + weight * at;
      const Extent extent = extent_of(model_, static_cast<BlockId>(i));
      piece.low = std::min(piece.low, extent.low);
      if (extent.high > high_ && length(v) > kSame * fastest_)
        high_ = extent.high, top_velocity_ = v + cross(w, {0, extent.high - at.y, 0});
    }
  }
  // Calls act for moving pieces and loads on them. Parts that stand still do not count in M* and e*.
  template <class Each>
  void each_weight(Each each) const {
    for (const MovingPiece& p : pieces_)
      if (is_moving(p)) each(p, p.sum / p.weight, p.weight);
    for (const LyingPiece& l : lying_)
      if (l.force.y < 0 && is_moving(pieces_[l.piece])) each(pieces_[l.piece], l.at, -l.force.y);
  }

  [[nodiscard]] Vec3 place_of(BlockId b) const { return read_block(model_, rest_, b).start; }
  [[nodiscard]] Vec3 velocity(std::size_t i) const {
    return {answer_.vx[i], answer_.vy[i], answer_.vz.empty() ? 0 : answer_.vz[i]};
  }
  [[nodiscard]] Vec3 spin(std::size_t i) const {
    if (answer_.omega_x.empty()) return {0, 0, answer_.omega[i]};
    return {answer_.omega_x[i], answer_.omega_y[i], answer_.omega[i]};
  }
  [[nodiscard]] double size_of(BlockId b) const {
    const Extent extent = extent_of(model_, b);
    return extent.high - extent.low;
  }
  [[nodiscard]] bool is_moving(const MovingPiece& p) const {
    return p.weight > 0 && length(p.velocity(p.sum / p.weight)) > kSame * fastest_;
  }
  [[nodiscard]] int moving() const {
    return static_cast<int>(std::count_if(pieces_.begin(), pieces_.end(),
                                          [&](const MovingPiece& p) { return is_moving(p); }));
  }
  [[nodiscard]] const MovingPiece* first_moving() const {
    for (const MovingPiece& p : pieces_)
      if (is_moving(p)) return &p;
    return nullptr;
  }

  void gather_loads() {
    const Stage* grows = limit::growing_stage(model_);
    for (const Stage& stage : model_.stages) {
      if (&stage == grows) break;
      for (const PointLoad& load : stage.loads)
        lying_.push_back({piece_of_[load.block],
                          place_of(load.block) + Vec3{load.arm_x, load.arm_y, load.arm_z},
                          {load.fx, load.fy, load.fz}});
    }
  }

  const Model model_;
  const State rest_;
  const LimitResult& answer_;
  Vec3 along_, top_velocity_;
  double fastest_ = 0, high_ = -std::numeric_limits<double>::infinity();
  std::vector<MovingPiece> pieces_;
  std::vector<std::size_t> piece_of_;
  std::vector<LyingPiece> lying_;
};

}  // namespace

LocalCheck check_of_limit(const ModelSpec& spec, const Model& model, const NamedLimit& limit) {
  const Stage& stage = *limit::growing_stage(model);
  const Mechanism mechanism(model, limit.answer, stage);
  const double base = foot_of(model);
  LocalCheck out;
  out.name = stage.spec.name;
  out.by = limit.name;
  out.foot = mechanism.low() - base, out.head = mechanism.high() - base;
  out.building.height = out.foot;
  out.masonry = mechanism.masonry(), out.floors = mechanism.loads();
  constexpr double kAcross = 0.3;  // 17 degrees, as for a push across the plane of walls [rad]
  if (mechanism.off() > kAcross)
    out.cautions.push_back({"local.caution.direction",
                            {{"stage", stage.spec.name},
                             {"degrees", mechanism.off() * 180 / 3.14159265358979323846}}});
  if (out.floors > out.masonry)
    out.cautions.push_back(
        {"local.caution.heavy_floors",
         {{"floors_kN", 1e-3 * out.floors}, {"masonry_kN", 1e-3 * out.masonry}}});
  if (out.floors == 0) out.notes.push_back({"local.note.no_floors"});
  if (mechanism.is_held()) out.notes.push_back({"local.note.work_of_links"});
  for (std::vector<Message> cautions :
       {cautions_of_inputs(spec, model), cautions_of_demand(spec.assessment)})
    for (Message& caution : cautions) out.cautions.push_back(std::move(caution));
  conclude(spec, model, false, {mechanism.capacity(model.solve.gravity)}, out);
  return out;
}

}  // namespace wythe::study
