// Cautions and doubts about one push that many adapting pushes replace: which pushes these are, and the advice for other pushes.
#include "statistics/one_push.h"

#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "scenes/places.h"
#include "scenes/scenes.h"
#include "wythe/parts/comparison.h"
#include "wythe/parts/model.h"

namespace wythe::one_push_test {
namespace {

// A push as the pages of evidence had them.
StageSpec waiting_push() {
  StageSpec push = scenes::push_stage("b1", Direction::kPlusX, 0.1e-3, 1e-3);
  push.get<PushStage>().fast_velocity = 5e-3, push.get<PushStage>().fast_below = 1e-4,
  push.damping = 0.2;
  return push;
}
Model model_with(const StageSpec& push) {
  ModelSpec spec = scenes::stack(2, 0.8, 0.1, scenes::elastic_joint(20e9, 8e9), 0.2, 2000);
  spec.stage = {push};
  return compile(spec);
}

TEST(OnePush, waits_at_cracks_as_those_that_were_compared_with_slow_ones) {
  EXPECT_TRUE(study::waits_at_cracks(model_with(waiting_push())));
  const auto waits = [](auto change) {
    StageSpec push = waiting_push();
    change(push);
    return study::waits_at_cracks(model_with(push));
  };
  EXPECT_TRUE(waits([](StageSpec& s) { s.damping = 0.02; }));
  EXPECT_FALSE(waits([](StageSpec& s) { s.damping = 0.8; }));  // pushes with it went another way
  EXPECT_FALSE(waits([](StageSpec& s) { s.get<PushStage>().fast_velocity = 20e-3; }));
  EXPECT_FALSE(waits([](StageSpec& s) { s.get<PushStage>().fast_velocity = kUnset; }));
  EXPECT_FALSE(waits([](StageSpec& s) { s.get<PushStage>().velocity = 1e-3; }));
  EXPECT_FALSE(waits([](StageSpec& s) { s.get<PushStage>().fast_below = 1; }));
  Model free = model_with(waiting_push());
  free.solve.contacts = Contacts::kFree;
  EXPECT_FALSE(study::waits_at_cracks(free));
}

Message caution_of(Message why) { return {"assessment.caution.drift", {{"why", std::move(why)}}}; }

TEST(OnePush, leaves_to_the_scatter_what_is_no_matter_of_its_speed) {
  const Model model = model_with(waiting_push());
  std::vector<Message> cautions = {
      caution_of({"promise.jump"}), caution_of({"promise.force"}), {"assessment.caution.overlap"}};
  study::leave_to_the_scatter(model, cautions);
  ASSERT_EQ(cautions.size(), 2U);
  EXPECT_NE(text_of(cautions[0]).find("not slow enough for its force"), std::string::npos);
}

// Whoever asked many walls needs no advice to ask many walls: of every reason that a promise may have.
TEST(OnePush, advises_nothing_that_is_done_already) {
  StageSpec fast = waiting_push();
  fast.get<PushStage>().velocity = 2e-3, fast.get<PushStage>().fast_velocity = kUnset;
  std::ifstream file(source_dir() + "/src/core/messages.json");
  const nlohmann::json messages = nlohmann::json::parse(file).at("messages");
  int reasons = 0;
  for (const bool may_wait : {true, false}) {
    Model model = model_with(fast);
    if (!may_wait) model.solve.contacts = Contacts::kFree;
    for (const auto& [code, words] : messages.items()) {
      if (!code.starts_with("promise.") || code.starts_with("promise.cure") ||
          code.ends_with(".page") || code == "promise.no_drift")
        continue;
      ++reasons;
      std::vector<Message> cautions = {caution_of(
          {code, {{"displacement_mm", 1}, {"cure", Message{"promise.cure", {{"velocity", 1}}}}}})};
      study::leave_to_the_scatter(model, cautions);
      ASSERT_EQ(cautions.size(), 1U);
      for (const char* language : {"en", "it"}) {
        const std::string said = text_of(cautions.front(), language);
        EXPECT_EQ(said.find("wythe"), std::string::npos) << said;
        EXPECT_EQ(said.find("{cure}"), std::string::npos) << said;
      }
    }
  }
  EXPECT_GE(reasons, 8);
}

// Walls whose force jumps at 2 mm while the push goes on, by 2.5 % of the displacement (promise.jump).
Campaign walls_that_jump(int walls, const std::string& judgement) {
  SampleRecord record{.sample = 1, .status = "completed"};
  for (int i = 0; i <= 400; ++i) {
    const double d = 0.01 * i;  // [mm]
    CurveRow row;
    row.displacement = 1e-3 * d;
    row.time = d;  // at 1 mm/s
    row.reaction = row.base_shear = d <= 1 ? 100 * d : d <= 2 ? 100 : d <= 3 ? 90 : 60;
    row.unbalance_ratio = i == 201 ? 0.012 : 2e-5;
    record.curve.push_back(row);
  }
  record.responses = read_responses(record.curve);
  record.quasi_static.judgement = judgement;
  record.failure_mode.read_at = 4e-3;
  Campaign campaign;
  for (; record.sample <= walls; ++record.sample) {
    campaign.samples.value.emplace_back();
    campaign.records.push_back(record);
  }
  return campaign;
}

TEST(OnePush, doubts_of_one_wall_and_of_many) {
  const Model waits = model_with(waiting_push());
  StageSpec fast = waiting_push();
  fast.get<PushStage>().velocity = 2e-3, fast.get<PushStage>().fast_velocity = kUnset;
  const Model hurries = model_with(fast);
  const auto one = doubts_of(walls_that_jump(1, "slow enough"), waits);
  ASSERT_EQ(one.size(), 1U);
  EXPECT_EQ(one.at(1).displacement.code, "promise.jump");
  EXPECT_TRUE(one.at(1).mode);
  EXPECT_TRUE(doubts_of(walls_that_jump(5, "slow enough"), waits).empty());
  EXPECT_EQ(doubts_of(walls_that_jump(5, "usable"), waits).at(5).displacement.code,
            "promise.force");
  EXPECT_EQ(doubts_of(walls_that_jump(5, "slow enough"), hurries).size(), 5U);
  // a load or a shake promises nothing, and a lost wall is lost already
  EXPECT_TRUE(doubts_of(walls_that_jump(1, "no push"), waits).empty());
  Campaign lost = walls_that_jump(1, "slow enough");
  lost.records[0].status = "unstable";
  EXPECT_TRUE(doubts_of(lost, waits).empty());
  // the cure is one for a comparison
  for (const char* language : {"en", "it", "de"}) {
    const std::string said = text_of(one.at(1).displacement, language);
    EXPECT_NE(said.find("[scatter]"), std::string::npos) << said;
    EXPECT_EQ(said.find("wythe run"), std::string::npos) << said;
  }
  const auto hurried = doubts_of(walls_that_jump(1, "slow enough"), hurries);
  for (const char* words : {"leave velocity", "[scatter]"})
    EXPECT_NE(text_of(hurried.at(1).displacement).find(words), std::string::npos) << words;
}

}  // namespace
}  // namespace wythe::one_push_test
