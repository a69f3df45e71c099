#include "scenes/whole_result.h"

#include <fmt/format.h>

#include <initializer_list>

namespace wythe::scenes {
namespace {

std::string bits(std::initializer_list<double> numbers) {
  std::string text;
  for (const double number : numbers) text += fmt::format(" {:a}", number);
  return text;
}

std::string bits(const std::vector<double>& numbers) {
  std::string text;
  for (const double number : numbers) text += fmt::format(" {:a}", number);
  return text;
}

std::string rows(const std::vector<CurveRow>& curve) {
  static_assert(sizeof(CurveRow) % sizeof(double) == 0);
  constexpr std::size_t kNumbers = sizeof(CurveRow) / sizeof(double);
  std::string text;
  for (const CurveRow& row : curve) {
    const auto* number = reinterpret_cast<const double*>(&row);
    text += "row" + bits(std::vector<double>(number, number + kNumbers)) + "\n";
  }
  return text;
}

std::string states(const char* what, const std::vector<Snapshot>& snapshots) {
  std::string text;
  for (const Snapshot& s : snapshots)
    text += fmt::format("{} \"{}\"{} {}\n", what, s.label,
                        bits({s.displacement, s.reaction, s.asked}), whole(s.state));
  return text;
}

std::string direction(const DirectionReadings& d) {
  std::string text =
      bits({d.peak_reaction, d.displacement_at_peak, d.displacement_at_80, d.displacement_max,
            d.initial_stiffness, d.bilinear.stiffness, d.bilinear.ultimate_displacement}) +
      fmt::format(" {} {}\n", d.censored_80, d.censored_max);
  for (const BackbonePoint& point : d.backbone)
    text += "backbone" + bits({point.displacement, point.reaction}) + "\n";
  return text;
}

std::string readings(const Responses& r) {
  std::string text = fmt::format("\"{}\" {} {} {} \"{}\"", text_of(r.peak_reason), r.censored_peak,
                                 r.censored_80, r.censored_max, text_of(r.collapse.criterion));
  text += bits({r.peak_reaction, r.displacement_at_peak, r.peak_raw, r.displacement_at_peak_raw,
                r.displacement_at_80, r.displacement_max, r.initial_stiffness, r.load_height,
                r.work_to_peak, r.work_to_80, r.work_total, r.bilinear.force, r.bilinear.ductility,
                r.collapse.displacement, r.cyclic.work}) +
          "\n";
  for (const Cycle& c : r.cyclic.cycles)
    text += "cycle " + c.kind +
            bits({c.displacement_max, c.displacement_min, c.reaction_max, c.reaction_min,
                  c.residual_max, c.dissipated, c.stiffness, c.kept}) +
            "\n";
  return text + direction(r.cyclic.positive) + direction(r.cyclic.negative);
}

}  // namespace

std::string whole(const State& s) {
  return fmt::format("{} {} {} {} load scales{}", state_hash(s), s.stage, s.step, s.progress.target,
                     bits(s.load_scale)) +
         fmt::format(" {}", s.progress.first_step) +
         bits({s.time,
               s.progress.time,
               s.gravity_x,
               s.gravity_y,
               s.progress.body_factor,
               s.progress.load_factor,
               s.progress.balance,
               s.progress.drive_displacement,
               s.progress.travelled,
               s.progress.turn_time,
               s.progress.pace,
               s.progress.last_growth,
               s.progress.moved_then,
               s.energy.work_loads,
               s.energy.work_drive,
               s.energy.work_damping,
               s.energy.dissipated_friction,
               s.energy.dissipated_fracture,
               s.energy.dissipated_crushing,
               s.energy.lost_in_hand_over});
}

std::string whole(const Result& r) {
  std::string text = fmt::format("{}: {}\n{} {} steps", to_string(r.status), text_of(r.reason),
                                 r.state_hash, r.steps) +
                     bits({r.load_factor, r.top_displacement, r.time_step}) + "\n";
  for (const StageReport& s : r.stages)
    text += fmt::format("stage {} {} {}", s.name, s.steps, s.settled) +
            bits({s.time, s.unbalance_ratio}) + "\n";
  text += rows(r.curve);
  for (const RisePoint& point : r.rise)
    text += "rise" + bits({point.displacement, point.force}) + "\n";
  for (const LinkRow& row : r.strengthening.links)
    text += "link" + bits({row.force, row.elongation, row.plastic}) + "\n";
  for (const FrameRow& row : r.strengthening.frame_rows)
    text += "frame" + bits({row.normal, row.shear, row.moment}) + "\n";
  for (const LayerRow& row : r.strengthening.layer_rows)
    text += "layer" + bits({row.use, row.detached, row.broken, row.x, row.y}) + "\n";
  text += readings(r.responses);
  const EnergyLedger& e = r.energy;
  text += "energy" +
          bits({e.loads, e.drive, e.kinetic, e.elastic, e.friction, e.fracture, e.crushing,
                e.damping, e.gap, e.hand_over}) +
          "\n";
  text += fmt::format("{} {}", r.quasi_static.judgement, text_of(r.quasi_static.verdict)) +
          bits({r.quasi_static.shear_gap, r.quasi_static.damping_share, r.quasi_static.lift}) +
          "\n";
  text += fmt::format("validity {} {}", r.validity.joints, text_of(r.validity.where)) +
          bits({r.validity.overlap_lost}) + "\n";
  for (const Event& event : r.events)
    text += fmt::format("event {} {} {}", text_of(event.name), text_of(event.where),
                        event.is_beyond_limit) +
            bits({event.displacement, event.reaction}) + "\n";
  text += "cracked" + bits(r.joint_crack_displacement) + "\n";
  for (const ShakeRow& row : r.history.row)
    text += "shake" +
            bits({row.time, row.base_acceleration[0], row.base_displacement[0], row.base_force[0],
                  row.base_force[1], row.drift, row.opening, row.slip, row.kinetic}) +
            "\n";
  for (const PointMotion& u : r.history.motion) text += "moved" + bits({u[0], u[1], u[2]}) + "\n";
  return text + states("snapshot", r.states.snapshots) + states("reading", r.states.readings) +
         states("frame", r.states.frames);
}

}  // namespace wythe::scenes
