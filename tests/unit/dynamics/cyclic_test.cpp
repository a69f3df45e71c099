// Responses of cyclic pushes, on loops of closed form. Rows are made like those
// of the recorder: means of the force over windows that end where the push turns.
#include "dynamics/meters/cyclic.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "wythe/parts/io.h"

namespace wythe::cyclic_test {
namespace {

constexpr double kPi = std::numbers::pi;

// A force that answers displacements in turn and may remember them.
using Law = std::function<double(double)>;

std::vector<CurveRow> driven(const Law& law, const std::vector<double>& targets,
                             double window = 0.01) {
  constexpr double kStep = 1e-4;
  std::vector<CurveRow> curve(1);
  double at = 0;
  for (const double target : targets) {
    const int rows = std::max(1, static_cast<int>(std::lround(std::fabs(target - at) / window)));
    const int steps =
        std::max(10, static_cast<int>(std::lround(std::fabs(target - at) / rows / kStep)));
    const double step = (target - at) / rows / steps, from = at;
    for (int k = 0; k < rows; ++k) {
      double sum = 0;
      for (int i = 0; i < steps; ++i) sum += law(from + step * (k * steps + i + 0.5));
      CurveRow row;
      row.displacement = from + (target - from) * (k + 1) / rows;
      row.drift = row.displacement / 2;
      row.reaction = row.base_shear = sum / steps;
      curve.push_back(row);
    }
    at = target;
  }
  return curve;
}

Law elastic(double k) {
  return [=](double d) { return k * d; };
}

// Elastic to +-fy, then plastic; unloads with k.
Law elastic_plastic(double k, double fy) {
  return [=, set = 0.0](double d) mutable {
    const double f = std::clamp(k * (d - set), -fy, fy);
    set = d - f / k;
    return f;
  };
}

Law slider(double f) {
  return [=, last = 0.0, way = 1.0](double d) mutable {
    way = d > last   ? 1.0
          : d < last ? -1.0
                     : -way;  // the middles of steps before and after a turn agree
    last = d;
    return way * f;
  };
}

// Stiff up to the rocking force, which falls with the displacement; comes back the way it went.
Law rocking(double force, double lost_at) {
  return [=](double d) {
    const double f = std::min(1e3 * std::fabs(d), force * (1 - std::fabs(d) / lost_at));
    return d < 0 ? -f : f;
  };
}

// Along a backbone for the first time, straight back to the origin and out again where it went;
// every return to a displacement loses a tenth.
Law damaging(const std::function<double(double)>& backbone) {
  struct Side {
    double far = 0, force = 0;
    bool away = false;
  };
  return [=, side = std::array<Side, 2>{}](double d) mutable {
    Side& s = side[d < 0 ? 1 : 0];
    const double x = std::fabs(d);
    double f = 0;
    if (x >= s.far) {
      s.far = x, s.away = false;
      f = s.force = backbone(x);
    } else {
      f = s.force * x / s.far;
    }
    return d < 0 ? -f : f;
  };
}

std::vector<CurveRow> mirror(std::vector<CurveRow> curve) {
  for (CurveRow& row : curve)
    for (double* value : {&row.displacement, &row.drift, &row.reaction, &row.base_shear})
      *value = -*value;
  return curve;
}

// --- what is cyclic

TEST(Cyclic, a_push_that_never_turns_back_is_none) {
  EXPECT_FALSE(dynamics::is_cyclic(driven(elastic(1), {5})));
  EXPECT_FALSE(dynamics::is_cyclic(driven(elastic(1), {2, 4, 6})));
  EXPECT_FALSE(dynamics::is_cyclic({}));
  EXPECT_FALSE(dynamics::is_cyclic(std::vector<CurveRow>(20)));
  EXPECT_EQ(read_responses(driven(elastic(1), {5})).cyclic.sense, 0);
}

TEST(Cyclic, one_way_back_or_below_zero_is_enough) {
  EXPECT_TRUE(dynamics::is_cyclic(driven(elastic(1), {10, 0})));
  EXPECT_TRUE(dynamics::is_cyclic(driven(elastic(1), {10, 9})));
  EXPECT_TRUE(dynamics::is_cyclic(driven(elastic(1), {-5})));
}

TEST(Cyclic, a_load_factor_whose_top_sways_back_is_none) {
  std::vector<CurveRow> curve = driven(elastic(1), {5, 3, 6});
  for (std::size_t i = 1; i < curve.size(); ++i) curve[i].load_factor = 0.1;
  EXPECT_FALSE(dynamics::is_cyclic(curve));
}

// --- loops of closed form

TEST(Cyclic, elastic_plastic_loops_damp_as_masing_says) {
  for (const double mu : {1.5, 2.0, 4.0, 10.0}) {
    const Responses r = read_responses(driven(
        elastic_plastic(100, 50), {0.5 * mu, -0.5 * mu, 0.5 * mu, -0.5 * mu, 0}, 0.5 * mu / 100));
    ASSERT_EQ(r.cyclic.cycles.size(), 2U) << mu;
    // The loop from turn to turn is closed only in the second cycle: the first begins unstrained. From
    // zero displacement to zero displacement the second begins and ends at one point of the loop.
    const Cycle& c = r.cyclic.cycles[1];
    EXPECT_EQ(c.kind, "full");
    EXPECT_EQ(c.repeat, 2);
    EXPECT_NEAR(c.kept, 1, 1e-12);
    EXPECT_NEAR(c.damping_ratio, 2 / kPi * (1 - 1 / mu), 0.01) << mu;
    EXPECT_NEAR(c.stiffness, 50 / (0.5 * mu), 1e-9);
    EXPECT_NEAR(c.residual_max, 0.5 * mu - 0.5, 0.02 * mu);
  }
}

TEST(Cyclic, a_slider_damps_two_over_pi_and_stays_where_it_is) {
  const Responses r = read_responses(driven(slider(50), {2, -2, 0}));
  ASSERT_EQ(r.cyclic.cycles.size(), 1U);
  const Cycle& c = r.cyclic.cycles[0];
  EXPECT_NEAR(c.dissipated, 50 * 8, 1e-6);
  EXPECT_NEAR(c.damping_ratio, 2 / kPi, 1e-6);
  EXPECT_NEAR(c.residual_max, 2, 1e-9);
  EXPECT_NEAR(c.residual_min, -2, 1e-9);
}

TEST(Cyclic, elastic_and_rocking_loops_do_not_damp) {
  for (const Law& law : {elastic(100), rocking(50, 20)}) {
    const Responses r = read_responses(driven(law, {1, -1, 4, -4, 0}, 0.2));
    ASSERT_EQ(r.cyclic.cycles.size(), 2U);
    for (const Cycle& c : r.cyclic.cycles) {
      EXPECT_NEAR(c.damping_ratio, 0, 1e-9);
      EXPECT_NEAR(c.residual_max, 0, 0.11);  // half a window
    }
  }
}

// Rows are work over path: the energy of a loop must not depend on how many there are.
TEST(Cyclic, loops_do_not_depend_on_the_rows) {
  const auto coarse = read_responses(driven(elastic_plastic(100, 50), {2, -2, 2, -2, 0}, 0.25));
  const auto fine = read_responses(driven(elastic_plastic(100, 50), {2, -2, 2, -2, 0}, 0.002));
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_NEAR(coarse.cyclic.cycles[k].dissipated, fine.cyclic.cycles[k].dissipated, 0.5);
    EXPECT_NEAR(coarse.cyclic.cycles[k].damping_ratio, fine.cyclic.cycles[k].damping_ratio, 0.002);
  }
  EXPECT_NEAR(coarse.cyclic.work, fine.cyclic.work, 0.5);
}

// Rows of a stored curve need not end where the push turns: what is lost is within a window a turn.
TEST(Cyclic, rows_on_both_sides_of_a_turn_lose_no_more_than_their_window) {
  constexpr int kTogether = 7;
  const auto fine = driven(slider(50), {2, -2, 2, -2, 0});
  std::vector<CurveRow> curve(1);
  for (std::size_t i = 1; i + kTogether <= fine.size(); i += kTogether) {
    CurveRow row = fine[i + kTogether - 1];
    row.reaction = 0;
    for (int k = 0; k < kTogether; ++k)
      row.reaction += fine[i + static_cast<std::size_t>(k)].reaction / kTogether;
    curve.push_back(row);
  }
  const Responses r = read_responses(curve);
  ASSERT_EQ(r.cyclic.cycles.size(), 2U);
  for (const Cycle& c : r.cyclic.cycles)
    EXPECT_NEAR(c.damping_ratio, 2 / kPi, 0.02 * 2 / kPi);  // 0.07 of a way of 4
}

TEST(Cyclic, half_a_cycle_damps_as_the_whole_of_two_such_halves) {
  const Responses r = read_responses(driven(slider(50), {3, 0}));
  ASSERT_EQ(r.cyclic.cycles.size(), 1U);
  const Cycle& c = r.cyclic.cycles[0];
  EXPECT_EQ(c.kind, "half");
  EXPECT_NEAR(c.dissipated, 50 * 6, 1e-6);
  EXPECT_NEAR(c.damping_ratio, 2 / kPi, 1e-6);
  EXPECT_TRUE(std::isnan(c.displacement_min));
  EXPECT_TRUE(std::isnan(c.reaction_min));
}

TEST(Cyclic, a_whisker_below_zero_does_not_change_the_damping) {
  const auto peak = [](double x) { return 50 * std::min(1.0, x); };
  const Responses half = read_responses(driven(damaging(peak), {4, 0, 4, 0}));
  const Responses full = read_responses(driven(damaging(peak), {4, -0.05, 4, -0.05, 0}));
  EXPECT_NEAR(half.cyclic.cycles[0].damping_ratio, (175 - 100) / (kPi * 50 * 4), 1e-3);
  EXPECT_NEAR(full.cyclic.cycles[0].damping_ratio, half.cyclic.cycles[0].damping_ratio, 0.01);
}

// Whatever the forces and amplitudes of its two directions, a loop fills no more than its box.
TEST(Cyclic, no_loop_damps_more_than_a_slider) {
  const auto lopsided = [last = 0.0](double d) mutable {
    const double way = d - last;
    last = d;
    return way >= 0 ? 10.0 : -1.0;
  };
  const Responses strong_way_short = read_responses(driven(lopsided, {1, -5, 1, -5, 0}));
  for (const Cycle& c : strong_way_short.cyclic.cycles) {
    EXPECT_GT(c.damping_ratio, 0.6);
    EXPECT_LE(c.damping_ratio, 2 / kPi + 1e-3);
  }
  const auto rebounds = [last = 0.0](double d) mutable {  // harder after each turn
    const double way = d - last;
    last = d;
    return (way >= 0 ? 1 : -1) * (std::fabs(d) > 1.5 && way * d < 0 ? 80.0 : 50.0);
  };
  const Responses r = read_responses(driven(rebounds, {2, -2, 2, 0}));
  for (const Cycle& c : r.cyclic.cycles) EXPECT_LE(c.damping_ratio, 2 / kPi + 1e-3);
}

// --- what is not a cycle says so

TEST(Cyclic, what_never_came_back_has_no_energy) {
  const Responses r = read_responses(driven(slider(50), {2, -2, 3}));
  ASSERT_EQ(r.cyclic.cycles.size(), 2U);
  EXPECT_EQ(r.cyclic.cycles[0].kind, "full");
  EXPECT_EQ(r.cyclic.cycles[1].kind, "unfinished");
  EXPECT_TRUE(std::isnan(r.cyclic.cycles[1].dissipated));
  EXPECT_TRUE(std::isnan(r.cyclic.cycles[1].damping_ratio));
  EXPECT_NEAR(r.cyclic.cycles[1].displacement_max, 3, 1e-9);
}

TEST(Cyclic, loops_on_one_side_have_an_area_but_no_damping_ratio) {
  const Responses r = read_responses(driven(slider(50), {2, 1, 4, 1, 4}));
  ASSERT_EQ(r.cyclic.cycles.size(), 3U);
  EXPECT_EQ(r.cyclic.cycles[0].kind, "partial");
  EXPECT_NEAR(r.cyclic.cycles[0].dissipated, 50 * 2, 1e-6);  // only what closes, beyond 1
  EXPECT_EQ(r.cyclic.cycles[1].kind, "partial");
  EXPECT_NEAR(r.cyclic.cycles[1].dissipated, 50 * 6, 1e-6);
  EXPECT_EQ(r.cyclic.cycles[2].kind, "unfinished");
  for (const Cycle& c : r.cyclic.cycles) EXPECT_TRUE(std::isnan(c.damping_ratio));
  EXPECT_NEAR(r.peak_reaction, 50, 1e-9);
  EXPECT_NEAR(r.displacement_max, 4, 1e-9);
}

TEST(Cyclic, a_way_of_few_rows_has_no_damping_ratio) {
  const Responses r = read_responses(driven(elastic_plastic(100, 50), {2, -2, 0}, 1.0));
  EXPECT_TRUE(std::isnan(r.cyclic.cycles[0].damping_ratio));
}

TEST(Cyclic, no_force_is_no_number) {
  const Responses r = read_responses(driven([](double) { return 0.0; }, {2, -2, 0}));
  EXPECT_EQ(r.cyclic.sense, 1);
  EXPECT_TRUE(std::isnan(r.cyclic.cycles[0].damping_ratio));
  EXPECT_EQ(r.cyclic.cycles[0].stiffness, 0);
  EXPECT_EQ(r.cyclic.cycles[0].kept, 1);
}

TEST(Cyclic, repeated_cycles_show_what_is_left) {
  // a slider whose friction is worn: 50, 40, 30 in the cycles to 2, then 30 to 3
  const auto worn = [cycle = 0, below = false, last = 0.0](double d) mutable {
    if (d < 0) below = true;
    if (d > 0 && below) below = false, ++cycle;
    const double f = std::max(30.0, 50.0 - 10.0 * cycle), way = d - last;
    last = d;
    return way >= 0 ? f : -f;
  };
  const Responses r = read_responses(driven(worn, {2, -2, 2, -2, 2, -2, 3, -3, 0}));
  ASSERT_EQ(r.cyclic.cycles.size(), 4U);
  const double kept[] = {1, 0.8, 0.6, 1};
  const std::int64_t repeat[] = {1, 2, 3, 1};
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_NEAR(r.cyclic.cycles[k].kept, kept[k], 1e-9) << k;
    EXPECT_EQ(r.cyclic.cycles[k].repeat, repeat[k]) << k;
  }
}

// --- the envelope, and what is read off it

// Rises to 100 at 2, falls to 40 at 8.
double humped(double x) { return x < 2 ? 50 * x : 100 - 10 * (x - 2); }

TEST(Cyclic, the_fixed_readings_are_those_of_a_push_along_the_envelope) {
  const Responses push = read_responses(driven(humped, {7}));
  const Responses r =
      read_responses(driven(damaging(humped), {1, -1, 1, -1, 3, -3, 3, -3, 5, -5, 7, -7, 0}));
  EXPECT_NEAR(r.peak_reaction, push.peak_reaction, 0.5);
  EXPECT_NEAR(r.displacement_at_peak, 2, 0.02);
  EXPECT_NEAR(r.displacement_at_80, 4, 0.03);
  EXPECT_FALSE(r.censored_80);
  EXPECT_NEAR(r.bilinear.force, push.bilinear.force, 1);
  EXPECT_NEAR(r.bilinear.ductility, push.bilinear.ductility, 0.1);
  EXPECT_NEAR(r.initial_stiffness, push.initial_stiffness, 0.5);
  EXPECT_NEAR(r.drift_at_80, r.displacement_at_80 / 2, 1e-12);
  EXPECT_NEAR(r.work_to_80, push.work_to_80, 2);
  EXPECT_NEAR(r.cyclic.negative.peak_reaction, r.cyclic.positive.peak_reaction, 0.5);
  EXPECT_NEAR(r.cyclic.negative.displacement_at_80, 4, 0.03);
}

TEST(Cyclic, unloading_at_the_end_changes_no_reading) {
  const Responses push = read_responses(driven(elastic_plastic(100, 50), {5}));
  const Responses r = read_responses(driven(elastic_plastic(100, 50), {5, 0}));
  EXPECT_EQ(r.peak_reaction, push.peak_reaction);
  EXPECT_EQ(r.displacement_at_80, push.displacement_at_80);
  EXPECT_TRUE(r.censored_80);
  EXPECT_TRUE(r.censored_max);
  EXPECT_EQ(r.bilinear.ductility, push.bilinear.ductility);
  EXPECT_EQ(r.work_total, push.work_total);
  EXPECT_TRUE(r.collapse.censored);
  EXPECT_EQ(r.cyclic.cycles.size(), 1U);
}

TEST(Cyclic, the_stronger_direction_is_the_one_read) {
  const auto lopsided = [](double d) { return d < 0 ? -2 * humped(-d) : humped(d); };
  const Responses r = read_responses(driven(lopsided, {7, -5, 0}));
  EXPECT_EQ(r.cyclic.sense, -1);
  EXPECT_NEAR(r.peak_reaction, 200, 1);
  EXPECT_NEAR(r.displacement_at_80, 4, 0.03);
  EXPECT_NEAR(r.displacement_max, 5, 1e-9);
  EXPECT_NEAR(r.cyclic.positive.peak_reaction, 100, 0.5);
  EXPECT_NEAR(r.cyclic.positive.displacement_max, 7, 1e-9);
  EXPECT_EQ(backbone_of(driven(lopsided, {7, -5, 0})).back().displacement, 5);
}

// 100 at 2, a dip to 60 from 3 on that is made good at 3.2, down to 40 at 8; against the push twice that without
// a dip, and a dip before its peak.
double dipped(double x) { return x > 3 && x < 3.2 ? 60 : humped(x); }
double dipped_before(double x) { return 2 * (x > 1.5 && x < 1.7 ? 40 : humped(x)); }

TEST(Cyclic, each_direction_has_all_readings_of_a_push_along_its_envelope) {
  const Law law = [](double d) { return d < 0 ? -dipped_before(-d) : dipped(d); };
  const Responses r = read_responses(driven(law, {1, -1, 7, -7, 0}));
  ASSERT_EQ(r.cyclic.sense, -1);
  for (const bool along : {true, false}) {
    const DirectionReadings& d = along ? r.cyclic.positive : r.cyclic.negative;
    const Responses push = read_responses(driven(along ? dipped : dipped_before, {7}));
    EXPECT_NEAR(d.displacement_at_80, push.displacement_at_80, 1e-9);
    EXPECT_NEAR(d.first_fall_80, push.first_fall_80, 1e-9);
    EXPECT_NEAR(d.last_fall_80, push.last_fall_80, 1e-9);
    EXPECT_EQ(d.censored_first_80, push.censored_first_80);
    EXPECT_EQ(d.censored_last_80, push.censored_last_80);
    ASSERT_EQ(d.dips.size(), 1U);
    ASSERT_EQ(push.dips.size(), 1U);
    EXPECT_EQ(d.dips[0].before_peak, !along);
    EXPECT_NEAR(d.dips[0].from, push.dips[0].from, 1e-9);
    EXPECT_NEAR(d.dips[0].lowest, push.dips[0].lowest, 1e-9);
    ASSERT_EQ(d.drift_capacity.size(), std::size(kSharesLeft));
    for (std::size_t k = 0; k < d.drift_capacity.size(); ++k) {
      const FallTo &own = d.drift_capacity[k], &alone = push.drift_capacity[k];
      EXPECT_NEAR(own.displacement, alone.displacement, 1e-9) << own.fraction;
      EXPECT_NEAR(own.first, alone.first, 1e-9) << own.fraction;
      EXPECT_NEAR(own.last, alone.last, 1e-9) << own.fraction;
      EXPECT_EQ(own.censored, alone.censored) << own.fraction;
      EXPECT_NEAR(own.drift, own.displacement / 2, 1e-12);
    }
  }
  EXPECT_LT(r.cyclic.positive.first_fall_80, r.cyclic.positive.displacement_at_80);
  EXPECT_EQ(r.dips.size(), 1U);
  EXPECT_EQ(r.first_fall_80, r.cyclic.negative.first_fall_80);
}

TEST(Cyclic, mirrored_pushes_have_mirrored_readings) {
  const auto lopsided = [](double d) { return d < 0 ? -1.3 * humped(-d) : humped(d); };
  const auto curve = driven(lopsided, {1, -2, 1, -2, 5, -6, 2});
  const Responses a = read_responses(curve), b = read_responses(mirror(curve));
  EXPECT_EQ(a.cyclic.sense, -b.cyclic.sense);
  EXPECT_EQ(a.peak_reaction, b.peak_reaction);
  EXPECT_EQ(a.displacement_at_80, b.displacement_at_80);
  EXPECT_EQ(a.bilinear.force, b.bilinear.force);
  EXPECT_EQ(a.cyclic.positive.peak_reaction, b.cyclic.negative.peak_reaction);
  ASSERT_EQ(a.cyclic.cycles.size(), b.cyclic.cycles.size());
  for (std::size_t k = 0; k < a.cyclic.cycles.size(); ++k) {
    const Cycle &p = a.cyclic.cycles[k], &q = b.cyclic.cycles[k];
    EXPECT_EQ(p.kind, q.kind);
    EXPECT_EQ(p.repeat, q.repeat);
    if (p.kind != "full") continue;
    EXPECT_EQ(p.displacement_max, -q.displacement_min);
    EXPECT_EQ(p.reaction_max, -q.reaction_min);
    EXPECT_EQ(p.dissipated, q.dissipated);
    EXPECT_EQ(p.damping_ratio, q.damping_ratio);
  }
}

TEST(Cyclic, a_push_against_the_direction_alone_is_read) {
  const Responses r = read_responses(driven([](double d) { return -humped(-d); }, {-6}));
  EXPECT_EQ(r.cyclic.sense, -1);
  EXPECT_NEAR(r.peak_reaction, 100, 0.5);
  EXPECT_NEAR(r.displacement_at_80, 4, 0.02);
  EXPECT_TRUE(std::isnan(r.cyclic.positive.peak_reaction));  // nothing resisted there
  ASSERT_EQ(r.cyclic.cycles.size(), 1U);
  EXPECT_EQ(r.cyclic.cycles[0].kind, "unfinished");
}

// Coming back to 2 the wall has 70 of the 100 it had there, and finds 100 again at 2.6: no fall to 80 %.
TEST(Cyclic, coming_back_weaker_and_regaining_is_no_fall) {
  const auto law = [far = 0.0](double d) mutable {
    const double x = std::fabs(d);
    const double f =
        far < 2 || x < far * 0.99 ? std::min(100.0, 50 * x) : std::min(100.0, 70 + 50 * (x - 2));
    far = std::max(far, x);
    return (d < 0 ? -1 : 1) * (far < 2 ? std::min(100.0, 50 * x) : f);
  };
  const auto curve = driven(law, {2, -2, 4, -4, 0});
  const Responses r = read_responses(curve);
  EXPECT_TRUE(r.censored_80);
  EXPECT_NEAR(r.displacement_at_80, 4, 1e-9);
}

TEST(Cyclic, coming_back_weaker_for_good_is_a_fall) {
  const auto law = [far = 0.0, turned = false, last = 0.0](double d) mutable {
    if (d < last) turned = true;
    last = d;
    far = std::max(far, d);
    return (turned ? 60 : 100) * std::clamp(d / 0.1, -1.0, 1.0);
  };
  const Responses r = read_responses(driven(law, {2, -2, 4, -4, 0}));
  EXPECT_NEAR(r.peak_reaction, 100, 1e-9);
  EXPECT_FALSE(r.censored_80);
  EXPECT_NEAR(r.displacement_at_80, 2, 0.02);
}

TEST(Cyclic, tiny_first_cycles_leave_the_readings_alone) {
  const Responses plain = read_responses(driven(damaging(humped), {6, -6, 0}));
  const Responses tiny =
      read_responses(driven(damaging(humped), {0.02, -0.02, 0.02, -0.02, 6, -6, 0}, 0.002));
  EXPECT_NEAR(tiny.peak_reaction, plain.peak_reaction, 0.5);
  EXPECT_NEAR(tiny.displacement_at_80, plain.displacement_at_80, 0.03);
  EXPECT_NEAR(tiny.initial_stiffness, plain.initial_stiffness, 0.5);
  ASSERT_EQ(tiny.cyclic.cycles.size(), 3U);
  EXPECT_NEAR(tiny.cyclic.cycles[0].damping_ratio, 0, 1e-9);
}

TEST(Cyclic, a_sway_of_a_thousandth_is_no_cycle) {
  EXPECT_FALSE(dynamics::is_cyclic(driven(elastic(1), {5, 4.996, 10}, 0.001)));
}

TEST(Cyclic, noise_moves_the_readings_by_no_more_than_itself) {
  std::mt19937 draw(7);
  std::uniform_real_distribution<double> noise(-1, 1);
  auto curve = driven(damaging(humped), {1, -1, 3, -3, 3, -3, 6, -6, 0});
  const Responses still = read_responses(curve);
  for (std::size_t i = 1; i < curve.size(); ++i) {
    curve[i].reaction += noise(draw);
    curve[i].base_shear = curve[i].reaction;
  }
  const Responses r = read_responses(curve);
  EXPECT_NEAR(r.peak_reaction, still.peak_reaction, 1);
  EXPECT_NEAR(r.displacement_at_80, still.displacement_at_80, 0.25);  // 1 + 1 on a slope of 10
  ASSERT_EQ(r.cyclic.cycles.size(), still.cyclic.cycles.size());
  for (std::size_t k = 0; k < r.cyclic.cycles.size(); ++k) {
    EXPECT_NEAR(r.cyclic.cycles[k].damping_ratio, still.cyclic.cycles[k].damping_ratio, 0.01);
    EXPECT_NEAR(r.cyclic.cycles[k].kept, still.cyclic.cycles[k].kept, 0.03);
  }
}

// A rebound of what is driven is felt by the reaction alone.
TEST(Cyclic, a_rebound_is_no_strength_and_its_cycle_says_so) {
  auto curve = driven(damaging(humped), {3, -3, 3, -3, 5, -5, 0});
  for (std::size_t i = 1; i < curve.size(); ++i)
    if (curve[i].displacement > 3.5 && curve[i].displacement < 3.6) curve[i].reaction += 200;
  const Responses r = read_responses(curve);
  EXPECT_NEAR(r.peak_reaction, 100, 0.5);
  ASSERT_EQ(r.cyclic.cycles.size(), 3U);
  EXPECT_TRUE(r.cyclic.cycles[0].in_balance);
  EXPECT_FALSE(r.cyclic.cycles[2].in_balance);
  for (CurveRow& row : curve) row.base_shear = 0.5 * row.reaction;
  const Responses fast = read_responses(curve);
  EXPECT_TRUE(std::isnan(fast.peak_reaction));
  EXPECT_FALSE(fast.peak_reason.empty());
  for (const Cycle& c : fast.cyclic.cycles) EXPECT_FALSE(c.in_balance);
}

// The stronger direction without a force in balance must not leave the weaker one as the strength.
TEST(Cyclic, an_unknown_strength_is_not_that_of_the_other_direction) {
  auto curve =
      driven([](double d) { return d < 0 ? -humped(-d) : 3 * humped(d); }, {5, -5, 5, -5, 0});
  for (CurveRow& row : curve)
    if (row.reaction > 0) row.base_shear = 0.8 * row.reaction;
  const Responses r = read_responses(curve);
  EXPECT_TRUE(std::isnan(r.peak_reaction));
  EXPECT_FALSE(r.peak_reason.empty());
  EXPECT_NEAR(r.cyclic.negative.peak_reaction, 100, 0.5);
  EXPECT_FALSE(r.cyclic.cycles[1].in_balance);
  EXPECT_TRUE(std::isnan(r.cyclic.cycles[1].kept));
}

TEST(Cyclic, a_direction_that_begins_under_force_has_no_stiffness) {
  const Responses r = read_responses(driven(slider(50), {2, -3, 0}));
  EXPECT_TRUE(std::isnan(r.cyclic.negative.initial_stiffness));
  EXPECT_TRUE(std::isnan(r.cyclic.negative.bilinear.ductility));
}

// --- collapse

TEST(Cyclic, only_the_side_on_which_the_wall_fell_has_come_to_its_end) {
  const auto lopsided = [](double d) { return d < 0 ? -80.0 : 100.0; };
  const Responses r = read_responses(driven(lopsided, {4, -3}),
                                     {.collapse = as_text("block c03 has moved 200 mm")});
  EXPECT_EQ(r.cyclic.sense, 1);
  EXPECT_TRUE(r.censored_80);  // along the push it held 4 mm, and nobody knows how much more
  EXPECT_TRUE(r.cyclic.positive.censored_80);
  EXPECT_FALSE(r.cyclic.negative.censored_80);
  EXPECT_NEAR(r.cyclic.negative.displacement_at_80, 3, 1e-9);
  EXPECT_FALSE(r.collapse.censored);
  EXPECT_NEAR(r.collapse.displacement, 3, 1e-9);
  EXPECT_EQ(text_of(r.collapse.criterion), "block c03 has moved 200 mm");
}

TEST(Cyclic, a_wall_that_falls_on_its_way_back_reached_what_it_reached) {
  const Responses r =
      read_responses(driven(slider(50), {8, 3}), {.collapse = as_text("a block fell")});
  EXPECT_NEAR(r.displacement_at_80, 8, 1e-9);
  EXPECT_FALSE(r.censored_80);
  EXPECT_NEAR(r.collapse.displacement, 8, 1e-9);
}

TEST(Cyclic, the_gap_between_reaction_and_base_shear_is_told_apart) {
  auto curve = driven(slider(50), {2, -2, 0});
  for (CurveRow& row : curve) row.base_shear = 0.9 * row.reaction;
  const Cycle c = read_responses(curve).cyclic.cycles[0];
  EXPECT_NEAR(c.drag, 0.1 * c.dissipated, 1e-9);
}

// --- where they are shown

Campaign campaign_of(const std::vector<CurveRow>& curve) {
  Campaign campaign;
  SampleRecord record;
  record.sample = 1;
  record.status = "completed";
  record.curve = curve;  // as out of the store: rows, and responses without their cycles
  record.responses = read_responses(curve);
  record.responses.cyclic = {};
  campaign.records.push_back(record);
  return campaign;
}

TEST(CyclicSamples, have_both_directions_in_columns_after_all_others) {
  const auto lopsided = [](double d) { return d < 0 ? -2e3 * humped(-d) : 1e3 * humped(d); };
  const std::string text = samples_csv(campaign_of(driven(lopsided, {7, -5, 0})));
  const std::string title = text.substr(0, text.find('\n'));
  EXPECT_NE(title.find("state_hash,read_in,peak_reaction_positive_kN,"), std::string::npos);
  const std::string row = text.substr(title.size() + 1);
  EXPECT_EQ(std::count(title.begin(), title.end(), ','), std::count(row.begin(), row.end(), ','));
  EXPECT_NE(row.find(",negative,99."), std::string::npos) << row;
}

TEST(CyclicSamples, other_campaigns_keep_their_columns) {
  const std::string text = samples_csv(campaign_of(driven(humped, {7})));
  EXPECT_EQ(text.find("read_in"), std::string::npos);
}

}  // namespace
}  // namespace wythe::cyclic_test
