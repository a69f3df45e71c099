// Checks in this order: the force is slow enough, each jump has a short path (4.12b), and the drag is
// small. For the displacement it then checks whether a small error of the force would move it (4.12c). The
// first check that fails gives the reason. The path is judged only up to the displacement of the result.
#include "wythe/parts/slow_push.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "dynamics/meters/balance.h"
#include "dynamics/meters/responses.h"

namespace wythe {
namespace {

using Curve = std::vector<CurveRow>;

// Limits; docs/theory/integration.md says where each comes from.
constexpr double kFall = 0.02;         // of the peak: a smaller fall of the force is no jump
constexpr double kOutOfBalance = 2;    // times the median unbalance
constexpr double kBalanced = 1e-4;     // unbalance of a wall in balance, as for a push that adapts
constexpr double kAllowedWay = 0.01;   // path out of balance in a jump / displacement there
constexpr double kAllowedDrag = 0.01;  // of the peak
constexpr int kParts = 5;              // of the path; the drag is judged in each of them
constexpr double kShare = 0.8;         // of the peak: the displacement is read at this force

// A stretch of rows in which the force fell while the wall was out of balance.
struct Jump {
  double from = 0, to = 0;  // displacement [m]
  double way = 0;           // path out of balance, as a share of the displacement, at most 1
};

// Rows of a push up to a displacement, with the largest displacement up to each row.
class PushPath {
 public:
  PushPath(const Curve& rows, double peak, const Stage& stage, double up_to)
      : rows_(rows),
        peak_(peak),
        push_(stage.spec.get<PushStage>()),
        damping_(stage.spec.damping),
        up_to_(up_to) {
    for (const CurveRow& row : rows)
      far_.push_back(std::max(far_.empty() ? 0.0 : far_.back(), std::fabs(row.displacement)));
    end_ =
        static_cast<std::size_t>(std::lower_bound(far_.begin(), far_.end(), up_to) - far_.begin());
    end_ = std::min(end_, rows.size() - 1);
  }

  // The jumps that began before the end of the path.
  [[nodiscard]] std::vector<Jump> jumps() const {
    std::vector<double> all;
    for (std::size_t i = 1; i <= end_; ++i) all.push_back(rows_[i].unbalance_ratio);
    const double usual = median(std::move(all));
    const double limit = std::max(kOutOfBalance * usual, kBalanced);
    const auto is_out = [&](std::size_t i) { return rows_[i].unbalance_ratio > limit; };
    std::vector<Jump> found;
    for (std::size_t i = 1; i <= end_; ++i) {
      if (!is_out(i)) continue;
      const std::size_t before = i - 1;
      double least = carried(i), way = 0;
      for (; i < rows_.size() && is_out(i); ++i) {
        least = std::min(least, carried(i));
        way += (rows_[i].unbalance_ratio - usual) * driven(i);
      }
      if (i < rows_.size()) least = std::min(least, carried(i));
      if (carried(before) - least < kFall * peak_) continue;
      way /= dynamics::kUnbalance * (1 - damping_) * far_[before];
      found.push_back({far_[before], far_[i - 1], std::min(1.0, way)});
    }
    return found;
  }

  // Force of inertia and damping beside the wall's, as a share of the peak, in the worst part of the path.
  [[nodiscard]] double drag() const {
    double worst = 0;
    for (int part = 0; part < kParts; ++part) {
      std::vector<double> gap, damping;
      for (std::size_t i = 1; i <= end_; ++i) {
        const double at = std::fabs(rows_[i].displacement) / up_to_ * kParts;
        if (at <= part || at > part + 1) continue;
        gap.push_back(sense(i) * (rows_[i].reaction - rows_[i].base_shear) / peak_);
        const double moved = std::fabs(rows_[i].displacement - rows_[i - 1].displacement);
        if (moved > 0)
          damping.push_back((rows_[i].work_damping - rows_[i - 1].work_damping) / (moved * peak_));
      }
      worst = std::max({worst, std::fabs(median(std::move(gap))), median(std::move(damping))});
    }
    return worst;
  }

 private:
  static double median(std::vector<double> of) {
    if (of.empty()) return 0;
    const auto middle = of.begin() + static_cast<std::ptrdiff_t>(of.size() / 2);
    std::nth_element(of.begin(), middle, of.end());
    return *middle;
  }
  // How far the drive moved in a row [m]; a control block may run ahead of it.
  [[nodiscard]] double driven(std::size_t i) const {
    const double fastest = dynamics::adapts(push_) ? push_.fast_velocity : push_.velocity;
    return std::min(std::fabs(rows_[i].displacement - rows_[i - 1].displacement),
                    fastest * (rows_[i].time - rows_[i - 1].time));
  }
  [[nodiscard]] double sense(std::size_t i) const { return rows_[i].displacement < 0 ? -1 : 1; }
  // The larger of reaction and base shear: a force has fallen below a level only where both have.
  [[nodiscard]] double carried(std::size_t i) const {
    return std::max(sense(i) * rows_[i].reaction, sense(i) * rows_[i].base_shear);
  }

  const Curve& rows_;
  double peak_;
  const PushStage& push_;
  double damping_, up_to_;
  std::vector<double> far_;  // largest displacement so far
  std::size_t end_ = 0;      // first row at the displacement `up_to_`
};

const Stage* last_push(const Model& model) {
  for (auto stage = model.stages.rbegin(); stage != model.stages.rend(); ++stage)
    if (stage->push() != nullptr) return &*stage;
  return nullptr;
}

SlowPushVerdict not_known(Message why) { return {"not known", std::move(why)}; }

// The cure: a speed at which `excess`, the ratio to what is allowed, would be half as large.
Message cure(const PushStage& push, double excess) {
  const double slower = std::min(0.5, 0.5 / excess);
  if (dynamics::adapts(push))
    return {"promise.cure_adapted",
            {{"velocity", 1e3 * slower * push.fast_velocity}, {"below", 0.5 * push.fast_below}}};
  return {"promise.cure", {{"velocity", 1e3 * slower * push.velocity}}};
}

SlowPushVerdict of_jump(const Jump& jump, const PushStage& push) {
  return not_known({"promise.jump",
                    {{"displacement_mm", 1e3 * jump.from},
                     {"way_percent", 100 * jump.way},
                     {"limit_percent", 100 * kAllowedWay},
                     {"cure", cure(push, jump.way / kAllowedWay)}}});
}

std::optional<SlowPushVerdict> of_drag(const PushPath& path, const PushStage& push) {
  const double drag = path.drag();
  if (drag <= kAllowedDrag) return std::nullopt;
  return not_known({"promise.drag",
                    {{"drag_percent", 100 * drag},
                     {"limit_percent", 100 * kAllowedDrag},
                     {"cure", cure(push, drag / kAllowedDrag)}}});
}

// The verdict where there was no push or its force was not judged slow enough.
std::optional<SlowPushVerdict> without_judging(const Model& model, const JudgedCurve& curve,
                                               const Stage* push) {
  const std::string& force = curve.rate.judgement;
  if (push == nullptr || force.empty() || force == "no push" || curve.rows.size() < 2 ||
      curve.rate.verdict.code == "rate.load")
    return SlowPushVerdict{};
  const bool has_peak = curve.responses.peak_reaction > 0;
  if (!has_peak && dynamics::drives_supports(model, *push)) return SlowPushVerdict{};
  if (force != "slow enough" || !has_peak) return not_known({"promise.force"});
  return std::nullopt;
}

// The force may be wrong by as much as its verdict allows. That must not move the displacement by more than a tenth.
std::optional<SlowPushVerdict> of_threshold(const JudgedCurve& curve) {
  const double lift = curve.rate.lift, at = curve.responses.displacement_at_80;
  const Collapse& collapse = curve.responses.collapse;
  const Responses read =
      read_responses(curve.rows, {.fractions = {kShare * (1 + lift), kShare * (1 - lift)},
                                  .collapse = collapse.censored ? Message{} : collapse.criterion});
  if (read.falls.size() < 2) return std::nullopt;
  const double low = read.falls[0].displacement, high = read.falls[1].displacement;
  const double allowed = kLastingShare * at;
  if (at - low <= allowed && (curve.responses.censored_80 || high - at <= allowed))
    return std::nullopt;
  return not_known(
      {"promise.threshold",
       {{"lift_percent", 100 * lift}, {"low_mm", 1e3 * low}, {"high_mm", 1e3 * high}}});
}

}  // namespace

SlowPushVerdict displacement_of_slow_push(const Model& model, const JudgedCurve& curve) {
  const Stage* push = last_push(model);
  if (const auto said = without_judging(model, curve, push)) return *said;
  const double at = curve.responses.displacement_at_80;
  const PushPath path(curve.rows, curve.responses.peak_reaction, *push, at);
  for (const Jump& jump : path.jumps()) {
    // this jump is the fall itself: a slow push reaches its beginning on the same path and falls at least as far
    const bool is_fall =
        !curve.responses.censored_80 && jump.to >= at && at - jump.from <= kLastingShare * at;
    if (jump.way > kAllowedWay && !is_fall) return of_jump(jump, *push->push());
  }
  if (const auto said = of_drag(path, *push->push())) return *said;
  if (const auto said = of_threshold(curve)) return *said;
  return {"slow enough", {}};
}

SlowPushVerdict displacement_of_slow_push(const Model& model, const Result& result) {
  return displacement_of_slow_push(model, {result.curve, result.responses, result.quasi_static});
}

SlowPushVerdict mode_of_slow_push(const Model& model, const JudgedCurve& curve, double read_at,
                                  bool is_firm) {
  const Stage* push = last_push(model);
  if (const auto said = without_judging(model, curve, push)) return *said;
  if (!(std::fabs(read_at) > 0)) return not_known({"promise.no_mode"});
  const PushPath path(curve.rows, curve.responses.peak_reaction, *push, std::fabs(read_at));
  for (const Jump& jump : path.jumps())
    if (jump.way > kAllowedWay) return of_jump(jump, *push->push());
  if (const auto said = of_drag(path, *push->push())) return *said;
  if (!is_firm) return not_known({"promise.name"});
  return {"slow enough", {}};
}

Message warning_of(const Model& model, const Result& result) {
  if (Message warning = warning_of(result); !warning.empty()) return warning;
  if (result.quasi_static.judgement == "usable") return {};  // this verdict covers all
  const SlowPushVerdict drift = displacement_of_slow_push(model, result);
  return drift.is_missing() ? Message{"promise.no_drift", {{"why", drift.reason}}} : Message{};
}

bool adapts(const Model& model) {
  const Stage* push = last_push(model);
  return push != nullptr && dynamics::adapts(*push->push());
}

}  // namespace wythe
