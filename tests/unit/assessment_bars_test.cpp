// Where the assessment has no answer: its push must begin at rest and at no force, and samples must share
// mass and spectrum.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "unit/assessed_wall.h"
#include "wythe/solve.h"

namespace wythe {
namespace {

using namespace test;

// The wall of kAssessed with one more stage before its push.
std::string wall_with(const std::string& stage, const std::string& more = "") {
  std::string text = wall_text(kAssessed + more);
  const std::string push = "[[stage]]\nname = \"push\"\n";
  return text.insert(text.find(push), stage);
}
// Why a push of this file with a plain curve gets no answer.
Message why_not(const std::string& text) {
  const ModelSpec spec = parse_model(text, "wall.toml");
  Result result;
  result.curve = curve_of({});
  result.responses = read_responses(result.curve);
  const Model model = compile(spec);
  const CodeAssessment a = assess_run(spec, model, result);
  EXPECT_EQ(a.limit_states.empty(), !a.reason.empty());
  EXPECT_EQ(a.may_be_signed && !a.reason.empty(), false);
  return a.reason;
}

TEST(Assessment, has_no_answer_where_another_stage_drove_the_wall_before) {
  EXPECT_EQ(why_not(wall_with("")).code, "");
  EXPECT_EQ(why_not(wall_with("[[stage]]\nname = \"wait\"\nduration = \"0.1 s\"\n")).code, "");
  const Message pushed_twice =
      why_not(wall_with("[[stage]]\nname = \"first\"\nat = { x = \"0 m\", y = \"0.9 m\" }\n"
                        "direction = \"+x\"\nvelocity = \"20 mm/s\"\nuntil = \"2 mm\"\n"));
  EXPECT_EQ(pushed_twice.code, "assessment.driven_before");
  EXPECT_TRUE(says(pushed_twice, "first"));
  for (const char* direction : {"+x", "-x"}) {
    const std::string towards = std::string("direction = \"") + direction + "\"\n";
    EXPECT_EQ(
        why_not(wall_with("[[stage]]\nname = \"g\"\nrate = \"1 1/s\"\nfactor = 0.1\n" + towards))
            .code,
        "assessment.held_before");
    EXPECT_EQ(why_not(wall_with("[[stage]]\nname = \"g\"\ntilt_rate = \"1 deg/s\"\n"
                                "tilt_until = \"2 deg\"\n" +
                                towards))
                  .code,
              "assessment.held_before");
  }
}

TEST(Assessment, has_no_answer_where_a_dead_load_acts_along_the_push) {
  const auto floor = [](const std::string& name, const std::string& thrust) {
    return "[[floor]]\nname = \"" + name + "\"\ny = \"0.75 m\"\nload = \"20 kN/m\"\nthrust = \"" +
           thrust + "\"\n";
  };
  EXPECT_EQ(why_not(wall_with("", floor("a", "0 kN"))).code, "");
  EXPECT_EQ(why_not(wall_with("", floor("a", "2 kN"))).code, "assessment.thrust");
  EXPECT_EQ(why_not(wall_with("", floor("a", "-2 kN"))).code, "assessment.thrust");
  // what cancels in the sum still stands on the wall
  EXPECT_EQ(why_not(wall_with("", floor("a", "2 kN") + floor("b", "-2 kN"))).code,
            "assessment.thrust");
  // a tie that was drawn taut against a rigid anchor pulls at the wall too; one within it does not
  const std::string tie =
      "[[tie]]\nname = \"t\"\nfrom = { x = \"0.9 m\", y = \"0.6 m\" }\n"
      "area = \"100 mm^2\"\nyoungs_modulus = \"200 GPa\"\nprestress = \"50 MPa\"\n";
  EXPECT_EQ(
      why_not(wall_with("", tie + "anchored = true\nto = { x = \"2 m\", y = \"0.6 m\" }\n")).code,
      "assessment.thrust");
  EXPECT_EQ(why_not(wall_with("", tie + "to = { x = \"0.1 m\", y = \"0.6 m\" }\n")).code, "");
}

// All samples are judged with the mass and the spectrum of the base model: they must share them.
TEST(CampaignAssessment, has_no_answer_where_samples_do_not_share_mass_and_spectrum) {
  const ModelSpec base = parse_model(wall_text(kAssessed), "wall.toml");
  const Model model = compile(base);
  const auto assessed = [&](const Campaign& campaign) {
    Statistics statistics = statistics_of(campaign);
    statistics.assessment = assess_campaign(campaign, base, model);
    return nlohmann::json::parse(statistics_json(statistics)).at("assessment");
  };
  for (const char* path : {"material.joint.cohesion", "masonry.masonry_strength", "",
                           "stage.push.velocity", "stage.push.damping", "stage.push.until"}) {
    Campaign campaign = campaign_of(25);
    campaign.study.variable.emplace_back().path = path;
    EXPECT_EQ(assessed(campaign).at("limit_states").size(), 3u) << path;
  }
  const auto refused = [&](const Campaign& campaign, const std::string& path) {
    const auto json = assessed(campaign);
    EXPECT_TRUE(json.at("limit_states").empty()) << path;
    ASSERT_TRUE(json.contains("reason")) << path;
    EXPECT_NE(json.at("reason").dump().find(path), std::string::npos) << path;
    EXPECT_EQ(json.at("answered"), 0);
    EXPECT_EQ(json.at("not_to_be_signed"), 25);  // none beside a reason is
    EXPECT_NE(json.at("sentence").dump().find("has no answer"), std::string::npos);
    EXPECT_EQ(json.at("notes").dump().find("base_mass"), std::string::npos);
  };
  for (const char* path : {"floor.roof.load", "wall.thickness", "wall.unit.density",
                           "material.lintel.density", "storey.0.height", "stage.floor.pressure",
                           "assessment.spectrum.ground_acceleration", "solve.gravity"}) {
    Campaign campaign = campaign_of(25);
    campaign.study.variable.emplace_back().path = "material.joint.cohesion";
    Campaign of_dependent = campaign, of_field = campaign;
    campaign.study.variable.emplace_back().path = path;
    refused(campaign, path);
    of_dependent.study.dependent.emplace_back().path = path;
    refused(of_dependent, path);
    of_field.study.field.push_back({.name = "f", .path = path});
    refused(of_field, path);
  }
}

TEST(CampaignAssessment, has_no_answer_where_its_push_has_none) {
  const ModelSpec base = parse_model(
      wall_with("[[stage]]\nname = \"g\"\nrate = \"1 1/s\"\nfactor = 0.1\n"), "wall.toml");
  const CampaignAssessment a = assess_campaign(campaign_of(25), base, compile(base));
  EXPECT_TRUE(a.fragility.empty());
  EXPECT_EQ(a.answered, 0);
}

TEST(Assessment, with_mass_of_floors_that_nothing_counts_is_not_signed) {
  const auto cautioned = [](const std::string& more, double added_mass) {
    ModelSpec spec = parse_model(
        wall_text(kAssessed + std::string("[[floor]]\nname = \"f\"\ny = \"0.75 m\"\n") + more),
        "wall.toml");
    spec.assessment.added_mass = added_mass;
    const Model model = compile(spec);
    const CodeAssessment a = assess_run(spec, model, {});
    const bool found = !a.cautions.empty() && says(a.cautions.front(), "floors f");
    EXPECT_EQ(says(a.sentence, "floors f"), found);
    EXPECT_EQ(says(sentence_of(assess_campaign(campaign_of(25), spec, model)), "floors f"), found);
    return found;
  };
  // 1 m of wall
  EXPECT_TRUE(cautioned("mass = \"2000 kg/m\"\n", 0));
  EXPECT_TRUE(cautioned("mass = \"2000 kg/m\"\n", 300));
  EXPECT_FALSE(cautioned("mass = \"2000 kg/m\"\n", 2000));
  EXPECT_TRUE(cautioned("load = \"10 kN/m\"\nmass = \"2000 kg/m\"\n", 900));
  EXPECT_FALSE(cautioned("load = \"10 kN/m\"\nmass = \"2000 kg/m\"\n", 1000));
  EXPECT_FALSE(cautioned("load = \"10 kN/m\"\n", 0));
}

// Samples keep no motions, so the drift of their piers is not known; of one pier it is that of the wall.
TEST(CampaignAssessment, of_more_than_one_pier_says_first_that_drifts_are_of_the_whole_wall) {
  const auto assessed = [](const std::string& openings) {
    std::string text = wall_text(kAssessed);
    text = "[wall]\nlength = \"3.0 m\"\n" + text.substr(text.find("height = "));
    const ModelSpec base = parse_model(text + openings, "wall.toml");
    return assess_campaign(campaign_of(25), base, compile(base));
  };
  const CampaignAssessment one = assessed("");
  EXPECT_TRUE(cautions_of(one).empty());
  EXPECT_TRUE(says(sentence_of(one), "near collapse: half of the walls carry"))
      << text_of(sentence_of(one));
  ModelSpec base = parse_model(wall_text(kAssessed), "wall.toml");
  const CampaignAssessment none = assess_campaign(campaign_of(3, 1.9e-3), base, compile(base));
  EXPECT_EQ(none.doubtful, 3);
  EXPECT_TRUE(says(sentence_of(none), "no sample has one; the first: the force still rises"))
      << text_of(sentence_of(none));
  const CampaignAssessment two = assessed(
      "[[wall.opening]]\nname = \"o\"\nx = \"1 m\"\ny = \"0 m\"\nwidth = \"1 m\"\n"
      "height = \"0.5 m\"\n");
  EXPECT_EQ(two.doubtful, 25);
  EXPECT_EQ(text_of(sentence_of(two))
                .find("not to be signed: drifts of the samples are those of the whole"),
            0u)
      << text_of(sentence_of(two));
}

TEST(Assessment, notes_masses_and_spectra_that_are_more_often_a_slip) {
  const auto notes = [](ModelSpec spec) {
    const CodeAssessment a = assess_run(spec, compile(spec), {});
    std::string all;
    for (const Message& note : a.notes) all += note.code + " ";
    return all;
  };
  const auto has = [](const std::string& all, const char* what) {
    return all.find(std::string("assessment.note.") + what) != std::string::npos;
  };
  const std::string floor = "[[floor]]\nname = \"f\"\ny = \"0.75 m\"\n";
  ModelSpec spec = parse_model(wall_text(kAssessed), "wall.toml");
  for (const char* what :
       {"masonry_share", "low_amplification", "table_start", "floor_mass", "added_height"})
    EXPECT_FALSE(has(notes(spec), what)) << what;
  const auto with = [&](const std::string& more) {
    return notes(parse_model(wall_text(kAssessed + floor + more), "wall.toml"));
  };
  EXPECT_TRUE(has(with("mass = \"2000 kg/m\"\n"), "floor_mass"));
  EXPECT_TRUE(has(with("load = \"10 kN/m\"\nmass = \"2000 kg/m\"\n"), "floor_mass"));
  EXPECT_FALSE(has(with("load = \"10 kN/m\"\nmass = \"1000 kg/m\"\n"), "floor_mass"));
  spec.assessment.masonry_share = 0.5, spec.assessment.added_height = 1.5;
  EXPECT_TRUE(has(notes(spec), "masonry_share"));
  EXPECT_TRUE(has(notes(spec), "added_height"));
  SpectrumSpec& s = spec.assessment.spectrum;
  s.kind = SpectrumKind::kNtc2018, s.corner_period = 0.3, s.amplification = 1.5;
  EXPECT_TRUE(has(notes(spec), "low_amplification"));
  EXPECT_TRUE(faults_of(s).empty());
  s.amplification = 0.9;
  EXPECT_EQ(faults_of(s).size(), 1u);
  s.kind = SpectrumKind::kTable, s.periods = {0, 1}, s.accelerations = {0.01, 5};
  EXPECT_TRUE(has(notes(spec), "table_start"));
}

}  // namespace
}  // namespace wythe
