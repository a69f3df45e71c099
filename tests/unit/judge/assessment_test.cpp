// The assessment against numbers by hand: masses, limit states,
// fragilities; also refusals, bounds, and results that must not be signed.
#include "wythe/parts/assessment.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "unit/assessed_wall.h"
#include "wythe/parts/io.h"
#include "wythe/parts/solve.h"
#include "wythe/parts/statistics.h"

namespace wythe::assessment_test {
namespace {

using namespace test;

constexpr double kPi = 3.14159265358979323846;
constexpr double kRound = 1e-12;  // relative: a few operations in double

SpectrumSpec en(const std::string& ground, const std::string& shape, double ag) {
  SpectrumSpec spec;
  spec.kind = SpectrumKind::kEn1998;
  spec.ground_acceleration = ag, spec.ground = ground, spec.shape = shape;
  return spec;
}

struct Pushed {
  explicit Pushed(const Made& made = {}) : curve(curve_of(made)), responses(read_responses(curve)) {
    push.judgement = "slow enough";
    push.mechanism = "flexure";
  }
  std::vector<CurveRow> curve;
  Responses responses;
  JudgedPush push{.curve = curve, .responses = responses};
};

MassAndShape mass_of(double) {
  return {.blocks = 9000, .loads = 1000, .participating = 8000, .participation = 1.25};
}

AssessmentSpec asked(const std::string& code = "circolare_2019") {
  AssessmentSpec spec;
  spec.code = code;
  spec.spectrum = en("B", "1", 1.0);
  return spec;
}

const LimitStateCheck& state_of(const CodeAssessment& a, LimitState state) {
  for (const LimitStateCheck& check : a.limit_states)
    if (check.state == state) return check;
  throw std::out_of_range("no such limit state");
}

// The force falls to 0.8 at 24 mm. Area up to there: 20 kN (22 mm + 0.9 4 mm - ...) as below.
TEST(Assessment, of_a_plain_curve_is_the_one_by_hand) {
  const Pushed p;
  const CodeAssessment a = assess(asked("en1998_3"), p.push, mass_of);
  const LimitStateCheck& collapse = state_of(a, LimitState::kNearCollapse);
  EXPECT_NEAR(collapse.displacement, 24e-3, 1e-5);
  EXPECT_EQ(collapse.governing, "force drop");
  const double k = 20e3 / 2e-3;
  const double area = 20e3 * (1e-3 + 18e-3 + 0.9 * 4e-3);
  const double force = k * (24e-3 - std::sqrt(24e-3 * 24e-3 - 2 * area / k));
  EXPECT_NEAR(a.bilinear.force, force, 1e-3 * force);
  EXPECT_NEAR(a.bilinear.stiffness, k, 1e-3 * k);
  EXPECT_NEAR(a.system.force, a.bilinear.force / 1.25, 1e-6);
  EXPECT_NEAR(a.system.period(), 2 * kPi * std::sqrt(8000 / a.bilinear.stiffness), kRound);
  EXPECT_NEAR(state_of(a, LimitState::kLifeSafety).displacement, 0.75 * collapse.displacement,
              kRound);
  EXPECT_NEAR(state_of(a, LimitState::kDamageLimitation).displacement,
              a.bilinear.yield_displacement, kRound);
  EXPECT_TRUE(a.may_be_signed);
}

TEST(Assessment, at_the_acceleration_of_a_limit_state_has_no_reserve) {
  const Pushed p;
  for (const char* code : {"circolare_2019", "en1998_3"}) {
    AssessmentSpec spec = asked(code);
    const CodeAssessment first = assess(spec, p.push, mass_of);
    for (const LimitStateCheck& check : first.limit_states) {
      ASSERT_GT(check.scale, 0);
      spec.spectrum.ground_acceleration = asked().spectrum.ground_acceleration * check.scale;
      const CodeAssessment again = assess(spec, p.push, mass_of);
      EXPECT_NEAR(state_of(again, check.state).scale, 1, 1e-9);
      if (check.governing != "q*") {
        EXPECT_NEAR(state_of(again, check.state).ratio, 1, 1e-9);
      }
      EXPECT_NEAR(check.acceleration, 1.2 * check.rock_acceleration, 1e-12);
    }
  }
}

// Twice the mass and twice the force: the same period and q*, so the same answer.
TEST(Assessment, of_a_wall_twice_as_heavy_and_strong_is_the_same) {
  const Pushed one, two(Made{.peak = 40e3});
  const auto twice = [](double d) {
    MassAndShape m = mass_of(d);
    m.participating *= 2;
    return m;
  };
  const CodeAssessment a = assess(asked(), one.push, mass_of), b = assess(asked(), two.push, twice);
  EXPECT_NEAR(a.system.period(), b.system.period(), 1e-12);
  for (std::size_t i = 0; i < a.limit_states.size(); ++i)
    EXPECT_NEAR(a.limit_states[i].scale / b.limit_states[i].scale, 1, 1e-9);
}

// Circolare 7/2019, C8.7.1.3.1: 3 at life safety, 4 at near collapse; EN 1998-3 has no such bound.
TEST(Assessment, by_the_italian_code_ends_where_q_is_three_and_four) {
  const Pushed weak(Made{.peak = 2e3});
  const CodeAssessment a = assess(asked(), weak.push, mass_of),
                       other = assess(asked("en1998_3"), weak.push, mass_of);
  for (const auto& [state, q] :
       {std::pair{LimitState::kLifeSafety, 3.0}, std::pair{LimitState::kNearCollapse, 4.0}}) {
    const LimitStateCheck& check = state_of(a, state);
    EXPECT_EQ(check.governing, "q*");
    EXPECT_NEAR(demand_of(a.system, a.spectrum, check.scale).q, q, 1e-9);
    EXPECT_NE(state_of(other, state).governing, "q*");
    EXPECT_GT(state_of(other, state).scale, check.scale);
  }
  EXPECT_NE(state_of(a, LimitState::kDamageLimitation).governing, "q*");
  AssessmentSpec spec = asked();
  spec.spectrum.ground_acceleration *= 1.17 * a.asked()->scale;  // q* 3.5
  const CodeAssessment more = assess(spec, weak.push, mass_of);
  EXPECT_EQ(more.verdict, AssessmentVerdict::kFails);
  EXPECT_TRUE(says(more.sentence, "q* is above 3")) << text_of(more.sentence);
}

// Each limit state against the earthquake of its own return period; the verdict is that of the least reserve.
TEST(Assessment, compares_each_limit_state_with_its_own_spectrum) {
  const Pushed p;
  AssessmentSpec spec = asked();
  const CodeAssessment one = assess(spec, p.push, mass_of);
  EXPECT_EQ(one.limit_states.size(), 3u);
  EXPECT_EQ(one.verdict, AssessmentVerdict::kHolds);
  EXPECT_EQ(one.deciding(), one.asked());
  const LimitStateCheck& damage = state_of(one, LimitState::kDamageLimitation);
  EXPECT_FALSE(damage.is_checked);
  spec.spectra.damage_limitation = en("B", "1", 1.25 * damage.rock_acceleration);
  spec.spectra.operational = en("A", "1", 0.1);
  const CodeAssessment all = assess(spec, p.push, mass_of);
  ASSERT_EQ(all.limit_states.size(), 4u);
  EXPECT_EQ(all.verdict, AssessmentVerdict::kFails);
  EXPECT_EQ(all.deciding()->state, LimitState::kDamageLimitation);
  EXPECT_NEAR(all.deciding()->scale, 0.8, 1e-9);
  EXPECT_NEAR(all.deciding()->acceleration, damage.acceleration, 1e-9);
  EXPECT_TRUE(says(all.sentence, "damage limitation is not met")) << text_of(all.sentence);
  EXPECT_NEAR(all.asked()->scale, one.asked()->scale, 1e-12);
  const LimitStateCheck& operational = state_of(all, LimitState::kOperational);
  EXPECT_NEAR(operational.displacement, 2 * damage.displacement / 3, kRound);
  EXPECT_NEAR(operational.demand_acceleration, 0.1, kRound);
  EXPECT_EQ(operational.verdict, AssessmentVerdict::kHolds);
  // a spectrum of the asked state among them stands for `spectrum`
  AssessmentSpec own = asked();
  own.spectra.life_safety = own.spectrum;
  own.spectrum = {};
  const CodeAssessment same = assess(own, p.push, mass_of);
  EXPECT_EQ(same.asked()->scale, one.asked()->scale);
  EXPECT_EQ(text_of(same.sentence), text_of(one.sentence));
}

// Two piers of one storey: the weak one is at its strength from 1 mm on, the other between 2 and 3 mm; with the
// curve's three quarters at 1.5 mm damage begins at 2 mm at the earliest, before the yield of a slow rise.
TEST(Assessment, damage_begins_where_all_piers_of_a_storey_are_at_their_shear_strength) {
  Pushed p(Made{.yield = 4e-3});
  const CodeAssessment without = assess(asked(), p.push, mass_of);
  EXPECT_TRUE(std::any_of(without.notes.begin(), without.notes.end(), [](const Message& note) {
    return note.code == "assessment.note.strengths";
  }));
  const auto pier = [](const char* mark, int storey, double at) {
    PierDrift out{.mark = mark, .mechanism = "flexure", .drifts = {}, .element = mark};
    out.storey = storey;
    for (int mm = 1; mm <= 40; ++mm)
      out.drifts.push_back({1e-3 * mm, 1e-5 * mm, 10e3 * std::fmin(1, mm / at)});
    return out;
  };
  const auto damage = [&](std::vector<PierDrift> piers) {
    p.push.piers = std::move(piers);
    return state_of(assess(asked(), p.push, mass_of), LimitState::kDamageLimitation);
  };
  const double yield = without.bilinear.yield_displacement;
  ASSERT_NEAR(yield, 4e-3, 0.3e-3);
  const LimitStateCheck early = damage({pier("P1", 1, 1), pier("P2", 1, 3.1)});
  EXPECT_NEAR(early.displacement, 3e-3, 1e-5);  // three quarters of the force
  EXPECT_EQ(early.governing, "shear strength of piers");
  // a second storey that is at its strength later changes nothing, one pier of the first that is does
  EXPECT_EQ(damage({pier("P1", 1, 1), pier("P2", 1, 3.1), pier("P3", 2, 20)}).displacement,
            early.displacement);
  EXPECT_EQ(damage({pier("P1", 1, 1), pier("P2", 1, 20)}).governing, "yield");
  p.push.piers = {pier("P1", 1, 1)};
  EXPECT_EQ(state_of(assess(asked("en1998_3"), p.push, mass_of), LimitState::kDamageLimitation)
                .criteria.size(),
            1u);
}

// --- drifts

TEST(Assessment, ends_at_the_drift_of_shear_before_the_force_falls) {
  Pushed p(Made{.height = 2});  // 0.5 % of 2 m: 10 mm
  p.push.mechanism = "shear";
  const LimitStateCheck check =
      state_of(assess(asked(), p.push, mass_of), LimitState::kNearCollapse);
  EXPECT_NEAR(check.displacement, 10e-3, 1e-9);
  EXPECT_EQ(check.governing, "storey drift, shear");
}

// Clauses of the Circolare were read, those of EN 1998 are recalled (docs/theory/assessment.md).
TEST(Assessment, says_which_clauses_were_read) {
  const Pushed p(Made{.height = 2});
  const auto warns = [](const CodeAssessment& a) {
    return std::any_of(a.notes.begin(), a.notes.end(),
                       [](const Message& m) { return m.code == "assessment.note.clauses"; });
  };
  for (const char* code : {"circolare_2019", "en1998_3"}) {
    const bool is_read = std::string(code) == "circolare_2019";
    AssessmentSpec spec = asked(code);
    spec.spectrum.kind = SpectrumKind::kEn1998;
    const CodeAssessment a = assess(spec, p.push, mass_of);
    for (const LimitStateCheck& check : a.limit_states)
      for (const Criterion& c : check.criteria) EXPECT_EQ(c.verified, is_read) << c.clause;
    EXPECT_TRUE(warns(a)) << "the spectrum is of EN 1998-1";
    spec.spectrum.kind = SpectrumKind::kNtc2018;
    spec.spectrum.amplification = 2.5, spec.spectrum.corner_period = 0.3;
    EXPECT_EQ(warns(assess(spec, p.push, mass_of)), !is_read);
  }
}

TEST(Assessment, takes_the_lesser_drift_where_the_mechanism_is_not_known) {
  Pushed p(Made{.height = 2});
  p.push.mechanism = "";
  const CodeAssessment a = assess(asked(), p.push, mass_of);
  EXPECT_EQ(state_of(a, LimitState::kNearCollapse).governing, "storey drift, shear");
}

// In space the kind of failure is read at one state: before it nobody knows it.
TEST(Assessment, of_a_whole_wall_does_not_look_ahead_for_its_kind_of_failure) {
  Pushed p(Made{.height = 2});  // 0.5 % is 10 mm, 1 % 20 mm
  const auto near_collapse = [&](double from) {
    p.push.mechanism_from = from;
    AssessmentSpec spec = asked();
    spec.spectrum = {};  // no q* in the way
    return state_of(assess(spec, p.push, mass_of), LimitState::kNearCollapse);
  };
  EXPECT_NEAR(near_collapse(0).displacement, 20e-3, 1e-9);
  EXPECT_NEAR(near_collapse(5e-3).displacement, 20e-3, 1e-4);  // rows of the curve lie between
  EXPECT_NEAR(near_collapse(30e-3).displacement, 10e-3, 1e-9);
  EXPECT_EQ(near_collapse(30e-3).governing, "storey drift, shear");
  p.push.mechanism = "out of plane";
  EXPECT_EQ(near_collapse(0).governing, "force drop");
  EXPECT_NEAR(near_collapse(30e-3).displacement, 10e-3, 1e-9);
}

// --- what tests say of drift

// Tests of shear fell at 0.2 to 0.4 % of 2 m, 4 to 8 mm: the accelerations of the same curve that ends there.
TEST(Assessment, states_what_the_wall_carries_at_the_drifts_of_tests) {
  Pushed p(Made{.height = 2});
  p.push.mechanism = "shear";
  p.push.tests = {{"shear", false, 79, 0.002, 0.004}, {"flexure", false, 18, 0.003, 0.02}};
  const CodeAssessment a = assess(asked(), p.push, mass_of);
  EXPECT_EQ(a.tests.size(), 2U);
  for (const auto& [displacement, tested] :
       {std::pair(4e-3, &LimitStateCheck::tested_low), {8e-3, &LimitStateCheck::tested_high}}) {
    Pushed ends(Made{.height = 2});
    ends.push.mechanism = "shear";
    ends.responses.displacement_at_80 = displacement;
    ends.responses.censored_80 = false;
    const CodeAssessment b = assess(asked(), ends.push, mass_of);
    for (const LimitState state : {LimitState::kLifeSafety, LimitState::kNearCollapse})
      EXPECT_NEAR(state_of(a, state).*tested, state_of(b, state).acceleration, 1e-9);
  }
  // how it fails is not known: the least and the largest of all
  p.push.mechanism = "";
  const CodeAssessment unknown = assess(asked(), p.push, mass_of);
  EXPECT_EQ(state_of(unknown, LimitState::kLifeSafety).tested_low,
            state_of(a, LimitState::kLifeSafety).tested_low);
  EXPECT_GT(state_of(unknown, LimitState::kLifeSafety).tested_high,
            state_of(a, LimitState::kLifeSafety).tested_high);
  // beyond the push there is no upper end; out of the plane no test speaks
  p.push.mechanism = "flexure";
  p.push.tests.back().high = 0.09;
  Pushed brief(Made{.until = 15e-3, .height = 2});
  brief.push.tests = p.push.tests;
  EXPECT_TRUE(std::isinf(
      state_of(assess(asked(), brief.push, mass_of), LimitState::kLifeSafety).tested_high));
  p.push.mechanism = "out of plane";
  EXPECT_TRUE(
      std::isnan(state_of(assess(asked(), p.push, mass_of), LimitState::kLifeSafety).tested_low));
}

TEST(Assessment, by_en_1998_3_takes_flexure_by_the_slenderness_of_piers) {
  Pushed p(Made{.height = 2});
  p.push.pier_slenderness = 0.5;  // 0.8 % 0.5 2 m = 8 mm
  const CodeAssessment a = assess(asked("en1998_3"), p.push, mass_of);
  EXPECT_NEAR(state_of(a, LimitState::kLifeSafety).displacement, 0.75 * 32e-3 / 3, 1e-6);
  EXPECT_NEAR(state_of(a, LimitState::kNearCollapse).displacement, 32e-3 / 3, 1e-6);
}

TEST(Assessment, takes_the_drift_of_a_storey_rather_than_of_the_whole_wall) {
  Pushed p;  // 5 m: 0.5 % is 25 mm, beyond the fall of the force
  p.push.mechanism = "shear";
  p.push.storeys_known = true;
  p.push.drifts = {{10e-3, 0.004}, {20e-3, 0.008}, {40e-3, 0.016}};
  const LimitStateCheck check =
      state_of(assess(asked(), p.push, mass_of), LimitState::kNearCollapse);
  EXPECT_NEAR(check.displacement, 12.5e-3, 1e-12);
}

TEST(Assessment, ends_at_the_first_pier_that_reaches_the_limit_of_its_own_mechanism) {
  Pushed p;
  p.push.storeys_known = true;
  p.push.drifts = {{10e-3, 0.1}, {40e-3, 0.4}};  // of storeys: piers stand for them
  p.push.piers = {{"P1", "flexure", {{10e-3, 0.005}, {40e-3, 0.02}}},  // 1 % at 20 mm
                  {"P2", "shear", {{10e-3, 0.003}, {40e-3, 0.012}}},   // 0.5 % at 16.7 mm
                  {"P3", "", {{10e-3, 0.0001}, {40e-3, 0.0004}}}};     // never
  const CodeAssessment a = assess(asked(), p.push, mass_of);
  const LimitStateCheck& check = state_of(a, LimitState::kNearCollapse);
  EXPECT_NEAR(check.displacement, 50e-3 / 3, 1e-12);
  bool named = false;
  for (const Criterion& c : check.criteria)
    named = named || (c.name == "pier drift, shear" && says(c.words, "P2"));
  EXPECT_TRUE(named);
  p.push.piers = {{"P3", "", {{10e-3, 0.0001}, {40e-3, 0.0004}}}};
  const CodeAssessment none = assess(asked("en1998_3"), p.push, mass_of);
  EXPECT_EQ(state_of(none, LimitState::kNearCollapse).governing, "force drop");
}

// A pier that rocks and shears later: up to there its limit is that of flexure, however far the wall was pushed.
TEST(Assessment, a_limit_state_does_not_depend_on_what_comes_after_it) {
  const auto pier = [](double until, double shear_from) {
    PierDrift out{.mark = "P1", .mechanism = "", .drifts = {}, .element = "left pier"};
    out.flexure_from = 2e-3;
    out.shear_from = shear_from;
    for (int mm = 1; mm <= std::lround(1e3 * until); ++mm)
      out.drifts.push_back({1e-3 * mm, 0.5 * 1e-3 * mm});  // 1 % at 20 mm, 0.5 % at 10 mm
    return out;
  };
  const double never = std::numeric_limits<double>::infinity();
  Pushed p(Made{.fall = 40e-3, .until = 60e-3});
  const auto near_collapse = [&](const PierDrift& of, CodeAssessment& a) {
    p.push.piers = {of};
    AssessmentSpec spec = asked();
    spec.spectrum = {};  // no q* in the way
    a = assess(spec, p.push, mass_of);
    return state_of(a, LimitState::kNearCollapse);
  };
  CodeAssessment shortly, longer, between;
  const LimitStateCheck brief = near_collapse(pier(27e-3, never), shortly),
                        far = near_collapse(pier(60e-3, 33e-3), longer);
  EXPECT_NEAR(brief.displacement, 20e-3, 1e-9);
  EXPECT_EQ(far.displacement, brief.displacement);
  EXPECT_EQ(far.governing, "pier drift, flexure");
  EXPECT_TRUE(shortly.may_be_signed);
  EXPECT_FALSE(longer.may_be_signed);  // but it is said
  EXPECT_TRUE(says(longer.sentence, "33.0 mm")) << text_of(longer.sentence);
  // it shears while its drift is beyond that limit already: there it ends
  EXPECT_NEAR(near_collapse(pier(60e-3, 14e-3), between).displacement, 14e-3, 1e-9);
  EXPECT_TRUE(between.may_be_signed);
  // before anything shows the lesser limit holds, never a kind that is seen later
  PierDrift late = pier(60e-3, never);
  late.flexure_from = 12e-3;
  EXPECT_NEAR(near_collapse(late, between).displacement, 10e-3, 1e-9);
}

// --- what must not be signed

TEST(Assessment, says_which_strengths_nobody_divided_by_the_confidence_factor) {
  Pushed p;
  AssessmentSpec spec = asked();
  p.push.undivided = {as_text("masonry.masonry_strength 7.9 MPa")};
  EXPECT_TRUE(assess(spec, p.push, mass_of).may_be_signed);  // none is stated
  spec.confidence_factor = 1.35;
  const CodeAssessment a = assess(spec, p.push, mass_of);
  EXPECT_FALSE(a.may_be_signed);
  EXPECT_TRUE(says(a.sentence, "masonry.masonry_strength 7.9 MPa")) << text_of(a.sentence);
  for (const Message& note : a.notes) EXPECT_FALSE(says(note, "taken to be divided")) << note.code;
  p.push.undivided.clear();
  EXPECT_TRUE(assess(spec, p.push, mass_of).may_be_signed);
  p.push.knowledge_level = "LC1";
  const CodeAssessment divided = assess(spec, p.push, mass_of);
  EXPECT_TRUE(divided.may_be_signed);
  EXPECT_TRUE(std::any_of(divided.notes.begin(), divided.notes.end(), [](const Message& note) {
    return says(note, "took the typology's values for LC1 and divided its strengths");
  }));
}

TEST(Assessment, of_a_push_that_ended_early_is_a_lower_bound) {
  const Pushed whole, early(Made{.until = 15e-3});
  AssessmentSpec spec = asked();
  spec.spectrum.ground_acceleration = 6;
  const CodeAssessment a = assess(spec, early.push, mass_of), b = assess(spec, whole.push, mass_of);
  EXPECT_FALSE(a.may_be_signed);
  EXPECT_TRUE(says(a.sentence, "not to be signed"));
  EXPECT_TRUE(says(a.sentence, "at least"));
  EXPECT_TRUE(text_of(a.sentence, "it").find("almeno") != std::string::npos);
  for (std::size_t i = 0; i < a.limit_states.size(); ++i) {
    EXPECT_TRUE(a.limit_states[i].at_least);
    EXPECT_LT(a.limit_states[i].scale, b.limit_states[i].scale);
  }
  EXPECT_EQ(b.verdict, AssessmentVerdict::kFails);
  EXPECT_EQ(a.verdict, AssessmentVerdict::kNotShown);  // a bound below the demand is no failure
}

TEST(Assessment, of_a_curve_that_never_yields_gives_no_number) {
  const Pushed p(Made{.until = 1.9e-3});
  const CodeAssessment a = assess(asked(), p.push, mass_of);
  EXPECT_EQ(a.verdict, AssessmentVerdict::kNotKnown);
  EXPECT_EQ(a.reason.code, "assessment.still_rising");
  EXPECT_TRUE(a.limit_states.empty());
  EXPECT_FALSE(a.may_be_signed);
}

TEST(Assessment, of_too_fast_a_push_says_so_before_any_number) {
  Pushed p;
  p.push.displacement = {"not known", {"promise.force"}};
  CodeAssessment unknown = assess(asked(), p.push, mass_of);
  ASSERT_EQ(unknown.cautions.size(), 1u);
  EXPECT_EQ(unknown.cautions.front().code, "assessment.caution.drift");
  EXPECT_FALSE(unknown.may_be_signed);
  p.push.displacement = {"slow enough", {}};
  p.push.mode = {"not known", {"promise.force"}};
  for (const char* mechanism : {"flexure", "shear", ""}) {
    p.push.mechanism = mechanism;
    EXPECT_EQ(assess(asked(), p.push, mass_of).may_be_signed, p.push.mechanism != "flexure")
        << mechanism;
  }
  p.push.mode = {};
  for (const char* judgement : {"too fast", "unknown", ""}) {
    p.push.judgement = judgement;
    const CodeAssessment a = assess(asked(), p.push, mass_of);
    EXPECT_FALSE(a.may_be_signed);
    EXPECT_EQ(text_of(a.sentence).rfind("not to be signed", 0), 0u) << judgement;
  }
  p.push.judgement = "usable";
  EXPECT_TRUE(assess(asked(), p.push, mass_of).may_be_signed);
}

TEST(Assessment, of_an_unfinished_run_or_of_blocks_that_slid_off_is_not_signed) {
  Pushed p;
  p.push.status = SolveStatus::kInterrupted;
  EXPECT_FALSE(assess(asked(), p.push, mass_of).may_be_signed);
  p.push.status = SolveStatus::kCollapsed;
  EXPECT_TRUE(assess(asked(), p.push, mass_of).may_be_signed);
  p.push.overlap_lost = 5e-3;
  EXPECT_FALSE(assess(asked(), p.push, mass_of).may_be_signed);
  p.push.overlap_lost = 39e-3;  // beyond the limit state
  EXPECT_TRUE(assess(asked(), p.push, mass_of).may_be_signed);
}

TEST(Assessment, refuses_by_name_what_has_no_push_one_way) {
  Pushed p;
  const auto reason = [&] { return assess(asked(), p.push, mass_of).reason.code; };
  p.push.curve_of = StageKind::kBodyForce;
  EXPECT_EQ(reason(), "assessment.of_body_force");
  p.push.curve_of = StageKind::kTilt;
  EXPECT_EQ(reason(), "assessment.of_tilt");
  p.push.curve_of = StageKind::kHold;
  EXPECT_EQ(reason(), "assessment.without_push");
  p.push.curve_of = StageKind::kPush;
  p.push.is_horizontal = false;
  EXPECT_EQ(reason(), "assessment.not_horizontal");
  p.push.is_horizontal = true;
  p.responses.cyclic.sense = 1;
  EXPECT_EQ(reason(), "assessment.of_cycles");
  p.responses.cyclic.sense = 0;
  p.responses.peak_reaction = kUnset;
  EXPECT_EQ(reason(), "assessment.without_peak");
}

TEST(Assessment, without_mass_or_stiffness_gives_no_number) {
  Pushed p;
  for (const double mass : {0.0, -1.0, kUnset, std::numeric_limits<double>::infinity()}) {
    const auto none = [&](double) {
      return MassAndShape{.participating = mass, .participation = 1};
    };
    EXPECT_EQ(assess(asked(), p.push, none).reason.code, "assessment.without_mass");
  }
  p.responses.bilinear.stiffness = kUnset;
  EXPECT_EQ(assess(asked(), p.push, mass_of).reason.code, "assessment.without_stiffness");
}

TEST(Assessment, of_a_period_beyond_its_table_gives_no_number) {
  const Pushed p;
  AssessmentSpec spec = asked();
  spec.spectrum = {.kind = SpectrumKind::kTable,
                   .corner_period = 0.05,
                   .periods = {0, 0.1},
                   .accelerations = {2, 5}};
  const CodeAssessment a = assess(spec, p.push, mass_of);
  EXPECT_EQ(a.reason.code, "assessment.period_beyond_table");
  EXPECT_TRUE(a.limit_states.empty());
}

TEST(Assessment, without_a_spectrum_tells_the_capacity_alone) {
  const Pushed p;
  AssessmentSpec spec = asked();
  spec.spectrum = {};
  const CodeAssessment a = assess(spec, p.push, mass_of);
  EXPECT_EQ(a.verdict, AssessmentVerdict::kNoDemand);
  EXPECT_TRUE(std::isnan(a.asked()->ratio));
  EXPECT_GT(a.asked()->displacement, 0);
}

TEST(Assessment, always_says_that_local_out_of_plane_is_not_modelled) {
  Pushed p;
  for (const bool refused : {false, true}) {
    p.push.is_horizontal = !refused;
    const CodeAssessment a = assess(asked(), p.push, mass_of);
    ASSERT_FALSE(a.notes.empty());
    EXPECT_TRUE(says(a.notes.front(), "out-of-plane"));
  }
}

// --- a wall

// 1 m x 1 m x 0.2 m of 2000 kg/m3: 400 kg, m* = 400 times the mean height over the load's height.
// The floor: 19.62 kN on the top, 2000 kg at 1 m. Added: 300 kg at the height of the load.
TEST(MassAndShape, that_grows_with_height_is_the_one_by_hand) {
  const ModelSpec spec = parse_model(wall_text(kAssessed), "wall.toml");
  const MassAndShape m = mass_and_linear_shape(spec.assessment, compile(spec));
  EXPECT_NEAR(m.blocks, 400, 1e-9);
  EXPECT_NEAR(m.loads, 2000, 1e-9);
  EXPECT_NEAR(m.added, 300, 1e-9);
  const double h = 0.875;
  EXPECT_NEAR(m.participating, 400 * 0.5 / h + 2000 / h + 300, 1e-9);
  // four courses of 100 kg with their centres at 1/8, 3/8, 5/8, 7/8 m
  const double square = 100 * (1 + 9 + 25 + 49) / 64.0 / (h * h) + 2000 / (h * h) + 300;
  EXPECT_NEAR(m.participation, m.participating / square, 1e-12);
}

// 20 kN/m over 1 m, on the course whose top is at 0.75 m; whether it has inertia in the run changes nothing.
TEST(MassAndShape, counts_a_floor_once_whether_its_inertia_is_on_or_off) {
  for (const char* inertia : {"", "mass = \"2000 kg/m\"\n"}) {
    const std::string floor =
        std::string("[[floor]]\ny = \"0.75 m\"\nload = \"20 kN/m\"\n") + inertia;
    const ModelSpec spec = parse_model(wall_text(kAssessed + floor), "wall.toml");
    const MassAndShape m = mass_and_linear_shape(spec.assessment, compile(spec));
    EXPECT_NEAR(m.loads, 2000 + 20e3 / 9.81, 1e-6);
    EXPECT_NEAR(m.blocks, 400, 1e-9);
    EXPECT_NEAR(m.participating,
                400 * 0.5 / 0.875 + (2000 * 1.0 + 20e3 / 9.81 * 0.75) / 0.875 + 300, 1e-6);
  }
}

TEST(MassAndShape, counts_the_share_of_the_masonry_alone) {
  ModelSpec spec = parse_model(wall_text(kAssessed), "wall.toml");
  spec.assessment.masonry_share = 0.5;
  const MassAndShape m = mass_and_linear_shape(spec.assessment, compile(spec));
  EXPECT_NEAR(m.blocks, 200, 1e-9);
  EXPECT_NEAR(m.loads, 2000, 1e-9);
}

// A post of 1 m of 100 kg/m beside the wall's end, from its foot to its top: its segments' heights are those of a rod.
TEST(MassAndShape, counts_the_mass_of_a_steel_frame_without_the_share_of_the_masonry) {
  const std::string frame = R"([[frame]]
line = [["1.05 m", "0 m"], ["1.05 m", "1 m"]]
feet = "fixed"
section = { height = "100 mm", width = "100 mm", area = "21 cm^2", shear_area = "8 cm^2", second_moment = "350 cm^4", plastic_modulus = "83 cm^3", mass = "100 kg/m" }
grade = "S235"
joint = "joint"
)";
  ModelSpec spec = parse_model(wall_text(kAssessed + frame), "wall.toml");
  spec.assessment.masonry_share = 0.5;
  const MassAndShape m = mass_and_linear_shape(spec.assessment, compile(spec));
  EXPECT_NEAR(m.blocks, 200 + 100, 1e-9);
  EXPECT_NEAR(m.participating, (200 + 100) * 0.5 / 0.875 + 2000 / 0.875 + 300, 1e-9);
}

// Slabs, ring beams and plates move with the wall as a whole.
TEST(MassAndShape, counts_what_is_no_masonry_without_its_share) {
  ModelSpec spec = parse_model(wall_text(kAssessed), "wall.toml");
  Model model = compile(spec);
  const double all = mass_and_linear_shape(spec.assessment, model).blocks;
  spec.assessment.masonry_share = 0.5;
  EXPECT_NEAR(mass_and_linear_shape(spec.assessment, model).blocks, 0.5 * all, 1e-9);
  for (const BlockRole role : {BlockRole::kSlab, BlockRole::kRingBeam, BlockRole::kPlate}) {
    for (BlockRole& of_block : model.anatomy.block_role) of_block = role;
    EXPECT_NEAR(mass_and_linear_shape(spec.assessment, model).blocks, all, 1e-9);
  }
}

Result pushed(const Model& model) {
  State state = initial_state(model);
  return solve(model, state);
}

// Readings lie a millimetre apart, the yield of a stiff wall at a tenth of that: its shape is that of the rise, not
// of the first millimetre, where its top has run ahead of the point that is followed.
TEST(MassAndShape, is_read_at_the_displacement_it_is_stated_for) {
  const ModelSpec spec = parse_model(wall_text(kAssessed), "wall.toml");
  const Model model = compile(spec);
  const Result result = pushed(model);
  ASSERT_GT(result.states.rise_shapes.size(), 50u);
  double before = 0;
  for (const MovedBlocks& shape : result.states.rise_shapes) {
    EXPECT_GT(shape.displacement, before);
    if (before > 0) {
      EXPECT_LT(shape.displacement - before, 0.051 * before + 2e-6);
    }
    before = shape.displacement;
  }
  EXPECT_NEAR(before, 12e-3, 1e-3);  // until readings are as close, at 20 mm
  // top course up to 0.2 mm straight, then ahead: the sums at 0.1 mm do not know what comes later
  Result made = result;
  made.states.readings.clear();
  made.states.rise_shapes.clear();
  const std::size_t n = result.states.rise_shapes.front().moved.size();
  for (const double d : {0.05e-3, 0.1e-3, 0.2e-3, 1e-3})
    made.states.rise_shapes.push_back({d, std::vector<double>(n, d > 0.5e-3 ? 5 * d : d)});
  const MassAndShape m = mass_and_shape(read_pushed_wall(spec, model, made), 0.15e-3);
  EXPECT_NEAR(m.read_at, 0.15e-3, 1e-15);
  EXPECT_NEAR(m.participation, 1, 1e-12);
  EXPECT_NEAR(m.participating, m.total(), 1e-9);
}

// A wall that falls may move back: what it is then belongs to no smaller displacement of its push.
TEST(PushedWall, holds_no_state_after_the_wall_has_moved_back) {
  const ModelSpec spec = parse_model(wall_text(kAssessed), "wall.toml");
  const Model model = compile(spec);
  const Result result = pushed(model);
  const PushedWall was = read_pushed_wall(spec, model, result);
  ASSERT_FALSE(was.piers.empty());
  Result fallen = result;
  fallen.states.readings.push_back(fallen.states.readings.back());
  fallen.states.readings.back().displacement = 2.5e-3;
  ++fallen.states.readings.back().state.step;
  const PushedWall is = read_pushed_wall(spec, model, fallen);
  EXPECT_EQ(is.moved.size(), was.moved.size());
  ASSERT_EQ(is.piers[0].drifts.size(), was.piers[0].drifts.size());
  EXPECT_EQ(is.piers[0].drifts.back().displacement, was.piers[0].drifts.back().displacement);
}

// The point that is followed swung back from 0.8 mm to 0.3 mm: the peak's state is known at 0.7 mm, none at 0.3 mm.
TEST(PushedWall, of_a_wall_that_fell_before_its_first_reading_has_the_state_of_its_peak) {
  const ModelSpec spec = parse_model(wall_text(kAssessed), "wall.toml");
  const Model model = compile(spec);
  Result fallen = pushed(model);
  std::erase_if(fallen.states.rise_shapes,
                [](const MovedBlocks& shape) { return shape.displacement > 0.8e-3; });
  std::erase_if(fallen.curve, [](const CurveRow& row) { return row.displacement > 0.8e-3; });
  Snapshot end = fallen.states.readings.back();
  end.displacement = 0.3e-3;
  fallen.states.readings = {end};
  for (Snapshot& s : fallen.states.snapshots)
    if (s.label == "peak") s.displacement = 0.7e-3;
  const PushedWall wall = read_pushed_wall(spec, model, fallen);
  ASSERT_FALSE(wall.piers.empty());
  ASSERT_EQ(wall.piers[0].drifts.size(), 1U);
  EXPECT_EQ(wall.piers[0].drifts[0].displacement, 0.7e-3);
  for (const MovedMass& m : wall.moved) EXPECT_NE(m.displacement, 0.3e-3);
  EXPECT_LE(wall.moved.back().displacement, 0.8e-3);
}

bool cautions(const CodeAssessment& a, const char* code) {
  return std::any_of(a.cautions.begin(), a.cautions.end(),
                     [&](const Message& caution) { return caution.code == code; });
}

// Ground floor 1 m, first floor 1 m: what is followed at the first floor's foot does not see the first floor fail.
TEST(Assessment, is_not_signed_where_the_control_point_lies_below_the_roof) {
  for (const auto& [y, below] : {std::pair{"0.9 m", true}, std::pair{"1.9 m", false}}) {
    std::string text = wall_text(kAssessed);
    const auto put = [&](const std::string& what, const std::string& by) {
      text.replace(text.find(what), what.size(), by);
    };
    put("height = \"1.0 m\"\n", "");
    put("at = { x = \"0 m\", y = \"0.9 m\" }",
        std::string("pattern = \"mass_height\"\nlevels = [\"1 m\", \"2 m\"]\ncontrol = { x = \"0.2 "
                    "m\", y = "
                    "\"") +
            y + "\" }");
    text +=
        "[[storey]]\nname = \"a\"\nheight = \"1 m\"\n[[storey]]\nname = \"b\"\nheight = \"1 m\"\n";
    const ModelSpec spec = parse_model(text, "wall.toml");
    const CodeAssessment a = assess_run(spec, compile(spec), {});
    EXPECT_EQ(cautions(a, "assessment.caution.control"), below) << y << ": " << text_of(a.sentence);
  }
}

// Without storeys the wall's top is the roof: levels at its foot alone push a wall that seems ever stronger.
TEST(Assessment, is_not_signed_where_the_highest_level_pushed_lies_far_below_the_top) {
  for (const auto& [levels, below] : {std::pair{"\"0.2 m\"", true}, std::pair{"\"0.9 m\"", false},
                                      std::pair{"\"0.2 m\", \"0.9 m\"", false},
                                      std::pair{"\"0.2 m\", \"0.9 m\"]\nshares = [1, 0", true},
                                      std::pair{"\"0.2 m\", \"0.9 m\"]\nshares = [1, 0.1", true},
                                      std::pair{"\"0.2 m\", \"0.9 m\"]\nshares = [1, 2", false}}) {
    std::string text = wall_text(kAssessed);
    const std::string at = "at = { x = \"0 m\", y = \"0.9 m\" }";
    text.replace(
        text.find(at), at.size(),
        std::string("pattern = ") +
            (std::string_view(levels).find("shares") == std::string_view::npos ? "\"mass_height\""
                                                                               : "\"given\"") +
            "\nlevels = [" + levels + "]");
    const ModelSpec spec = parse_model(text, "wall.toml");
    const CodeAssessment a = assess_run(spec, compile(spec), {});
    EXPECT_EQ(cautions(a, "assessment.caution.levels"), below)
        << levels << ": " << text_of(a.sentence);
  }
}

// Storeys of a file of blocks are levels that its writer states: those far below the top state no roof.
TEST(Assessment, is_not_signed_where_storeys_end_far_below_the_top_of_the_wall) {
  std::string text = wall_text(kAssessed);
  const std::string at = "at = { x = \"0 m\", y = \"0.9 m\" }";
  text.replace(text.find(at), at.size(), "pattern = \"mass_height\"\nlevels = [\"0.2 m\"]");
  ModelSpec spec = parse_model(text, "wall.toml");
  const Model model = compile(spec);
  spec.storey.resize(1);
  spec.storey[0].height = 0.25;
  EXPECT_TRUE(cautions(assess_run(spec, model, {}), "assessment.caution.levels"));
}

TEST(Assessment, is_not_signed_where_the_spectrum_is_damped_by_more_than_the_codes_take) {
  for (const double damping : {0.02, 0.05, 0.3}) {
    ModelSpec spec = parse_model(wall_text(kAssessed), "wall.toml");
    spec.assessment.spectrum.damping = damping;
    const CodeAssessment a = assess_run(spec, compile(spec), {});
    EXPECT_EQ(cautions(a, "assessment.caution.spectrum_damping"), damping > 0.05)
        << damping << text_of(a.sentence);
  }
}

TEST(Assessment, of_a_wall_pushed_to_the_left_is_that_of_its_mirror_image) {
  const ModelSpec right = parse_model(wall_text(kAssessed), "wall.toml"),
                  left = parse_model(wall_text(kAssessed, "1 m", "-x"), "wall.toml");
  const Model model_right = compile(right), model_left = compile(left);
  const CodeAssessment a = assess_run(right, model_right, pushed(model_right)),
                       b = assess_run(left, model_left, pushed(model_left));
  ASSERT_TRUE(a.reason.empty()) << a.reason;
  ASSERT_FALSE(a.limit_states.empty());
  // blocks of a dry wall rattle: its shape at a tenth of a millimetre is not mirrored to the bit
  EXPECT_NEAR(a.mass.participating / b.mass.participating, 1, 0.01);
  EXPECT_NEAR(a.asked()->displacement / b.asked()->displacement, 1, 1e-3);
  EXPECT_FALSE(a.mass.is_linear);
  EXPECT_GT(a.mass.participating, 0.5 * a.mass.total());
}

TEST(Assessment, of_a_run_stands_in_its_summary) {
  const ModelSpec spec = parse_model(wall_text(kAssessed), "wall.toml");
  const Model model = compile(spec);
  const Result result = pushed(model);
  const auto json = nlohmann::json::parse(summary_json(spec, model, result));
  EXPECT_EQ(json.at("project").at("title"), "School");
  const auto& a = json.at("assessment");
  EXPECT_EQ(a.at("limit_states").size(), 3u);
  for (const auto& check : a.at("limit_states"))
    for (const auto& c : check.at("criteria")) {
      EXPECT_FALSE(c.at("verified").get<bool>()) << "EN 1998-3 is recalled";
      EXPECT_FALSE(c.at("clause").get<std::string>().empty());
    }
  EXPECT_GT(a.at("equivalent").at("period_s"), 0);
  EXPECT_FALSE(nlohmann::json::parse(summary_json(model, result)).contains("assessment"));
}

// --- a campaign

const PgaFragility& asked_of(const CampaignAssessment& a) {
  for (const PgaFragility& f : a.fragility)
    if (f.is_checked) return f;
  throw std::out_of_range("none is checked");
}

TEST(CampaignAssessment, has_the_median_and_the_scatter_of_its_samples) {
  ModelSpec base = parse_model(wall_text(kAssessed), "wall.toml");
  const Model model = compile(base);
  const Campaign campaign = campaign_of(40);
  const CampaignAssessment a = assess_campaign(campaign, base, model);
  EXPECT_EQ(a.answered, 40);
  EXPECT_EQ(a.without_answer, 0);
  EXPECT_EQ(a.doubtful, 0);
  const PgaFragility& f = asked_of(a);
  ASSERT_EQ(f.n, 40);
  EXPECT_EQ(f.censored, 0);
  double mean = 0, square = 0;  // of the logarithms, from the samples' own steps
  for (const ExceedancePoint& p : f.point) mean += std::log(p.value) / 40;
  for (const ExceedancePoint& p : f.point) square += std::pow(std::log(p.value) - mean, 2) / 40;
  ASSERT_EQ(f.point.size(), 40u);
  EXPECT_NEAR(f.median.value, std::exp(mean), 1e-6);
  EXPECT_NEAR(f.beta_capacity.value, std::sqrt(square), 1e-6);
  EXPECT_EQ(f.beta, f.beta_capacity.value);  // no scatter of records is stated: and that is said
  EXPECT_EQ(a.notes.back().code, "assessment.note.no_record_scatter");
  EXPECT_LT(f.median.interval.low, f.median.value);
  EXPECT_GT(f.median.interval.high, f.median.value);

  base.assessment.record_scatter = 0.3;
  const CampaignAssessment with = assess_campaign(campaign, base, model);
  EXPECT_NEAR(asked_of(with).beta, std::hypot(f.beta_capacity.value, 0.3), 1e-12);
  EXPECT_EQ(asked_of(with).median.value, f.median.value);
}

// The spectrum of EN 1998-1 keeps its shape whatever ag: what the wall carries does not change.
TEST(CampaignAssessment, carries_the_same_whatever_is_asked) {
  ModelSpec base = parse_model(wall_text(kAssessed), "wall.toml");
  const Model model = compile(base);
  const Campaign campaign = campaign_of(25);
  const PgaFragility one = asked_of(assess_campaign(campaign, base, model));
  base.assessment.spectrum.ground_acceleration *= 2;
  const PgaFragility two = asked_of(assess_campaign(campaign, base, model));
  EXPECT_NEAR(one.median.value / two.median.value, 1, 1e-9);
  EXPECT_NEAR(two.demand / one.demand, 2, 1e-12);
  EXPECT_GE(two.at_demand.value, one.at_demand.value);
}

TEST(CampaignAssessment,
     takes_pushes_that_ended_early_as_bounds_and_counts_those_without_an_answer) {
  const ModelSpec base = parse_model(wall_text(kAssessed), "wall.toml");
  const Model model = compile(base);
  Campaign campaign = campaign_of(30);
  const Campaign early = campaign_of(30, 4e-3), rising = campaign_of(3, 1.9e-3);
  for (int i = 0; i < 30; i += 3) campaign.records[i] = early.records[i];
  const auto with_bounds = assess_campaign(campaign, base, model);
  EXPECT_EQ(asked_of(with_bounds).censored, 10);
  campaign.records[1].quasi_static.judgement = "too fast";
  EXPECT_EQ(assess_campaign(campaign, base, model).doubtful, 1);
  for (const SampleRecord& record : rising.records) campaign.records.push_back(record);
  const auto a = assess_campaign(campaign, base, model);
  EXPECT_EQ(a.without_answer, 3);
  EXPECT_EQ(a.doubtful, 30);  // 3 of 33 lost: none is to be signed
  EXPECT_EQ(asked_of(a).n, 30);
  EXPECT_EQ(asked_of(a).median.value, asked_of(with_bounds).median.value);
  // bounds alone tell no median
  EXPECT_TRUE(std::isnan(asked_of(assess_campaign(early, base, model)).median.value));
}

TEST(CampaignAssessment, stands_in_statistics_json_where_it_is_asked_for) {
  const ModelSpec base = parse_model(wall_text(kAssessed), "wall.toml");
  const Campaign campaign = campaign_of(25);
  Statistics statistics = statistics_of(campaign);
  EXPECT_FALSE(nlohmann::json::parse(statistics_json(statistics)).contains("assessment"));
  statistics.assessment = assess_campaign(campaign, base, compile(base));
  const auto json = nlohmann::json::parse(statistics_json(statistics)).at("assessment");
  EXPECT_EQ(json.at("limit_states").size(), 3u);
  EXPECT_EQ(json.at("answered"), 25);
  EXPECT_GT(json.at("limit_states")[0].at("median_pga_g"), 0);
}

// --- the file

std::string faults_in(const std::string& more) {
  try {
    (void)parse_model(wall_text(more), "wall.toml");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}
void refuses(const std::string& table, const std::string& key, const std::string& problem) {
  const std::string said = faults_in("[assessment]\ncode = \"en1998_3\"\n" + table);
  EXPECT_NE(said.find(key), std::string::npos) << said;
  EXPECT_NE(said.find(problem), std::string::npos) << said;
}

TEST(AssessmentFile, refuses_a_spectrum_without_units_or_out_of_order) {
  const std::string table = "[assessment.spectrum]\nkind = \"table\"\ncorner_period = \"0.5 s\"\n";
  refuses(table + "periods = [0, 1]\naccelerations = [\"1 m/s^2\", \"2 m/s^2\"]\n", "periods",
          "unit");
  refuses(table + "periods = [\"0 s\", \"1 s\"]\naccelerations = [1, 2]\n", "accelerations",
          "unit");
  refuses(table +
              "periods = [\"0 s\", \"1 s\", \"1 s\"]\naccelerations = [\"1 m/s^2\", \"2 m/s^2\", "
              "\"1 m/s^2\"]\n",
          "periods", "must grow");
  refuses(table + "periods = [\"0.1 s\", \"1 s\"]\naccelerations = [\"1 m/s^2\", \"2 m/s^2\"]\n",
          "periods", "begin at 0 s");
  refuses(table + "periods = [\"0 s\", \"1 s\"]\naccelerations = [\"1 m/s^2\"]\n", "periods",
          "as many periods");
  refuses(
      "[assessment.spectrum]\nkind = \"table\"\nperiods = [\"0 s\", \"1 s\"]\naccelerations = "
      "[\"1 m/s^2\", \"2 m/s^2\"]\n",
      "corner_period", "is missing");
  refuses("[assessment.spectrum]\nkind = \"en1998\"\nground_acceleration = 1.5\n",
          "ground_acceleration", "unit");
}

TEST(AssessmentFile, names_what_a_spectrum_lacks_and_what_it_does_not_know) {
  refuses("[assessment.spectrum]\nkind = \"ntc2018\"\nground_acceleration = \"1 m/s^2\"\n",
          "amplification", "is missing");
  refuses(
      "[assessment.spectrum]\nkind = \"ntc2018\"\nground_acceleration = \"1 m/s^2\"\n"
      "amplification = 2.5\ncorner_period = \"30 s\"\n",
      "corner_period", "beyond TD");
  refuses(
      "[assessment.spectrum]\nkind = \"en1998\"\nground_acceleration = \"1 m/s^2\"\namplification "
      "= 2\n",
      "amplification", "no such key");
  refuses("[assessment.spectrum]\nground = \"B\"\n", "kind", "is missing");
  refuses("added_height = \"2 m\"\n", "added_height", "no added mass");
  const std::string spectrum = "kind = \"en1998\"\nground_acceleration = \"1 m/s^2\"\n";
  refuses("[assessment.spectrum]\n" + spectrum + "[assessment.spectra.life_safety]\n" + spectrum,
          "spectrum", "another in spectra");
  refuses("[assessment.spectra.operational]\n" + spectrum, "spectra", "no such limit state");
  refuses("[assessment.spectra.near_collapse]\nground = \"B\"\n", "kind", "is missing");
  EXPECT_NE(faults_in("[assessment]\nlimit_state = \"life_safety\"\n").find("code"),
            std::string::npos);
}

}  // namespace
}  // namespace wythe::assessment_test
